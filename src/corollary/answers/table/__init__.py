"""A table of quantities, or a matrix."""
