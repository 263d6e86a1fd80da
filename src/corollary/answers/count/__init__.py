"""A count: a whole number without a unit."""
