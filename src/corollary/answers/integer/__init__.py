"""An integer: a whole number of either sign, in a unit or none."""
