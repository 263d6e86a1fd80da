"""An interval of numbers: from where to where."""
