"""A formula in the symbols of the problem."""
