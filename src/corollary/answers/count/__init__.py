"""One quantity: a number with a unit, or the formula for it."""
