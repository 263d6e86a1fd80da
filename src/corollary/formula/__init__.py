"""Numbers with units and certified digits: how they are written, read, and evaluated."""
