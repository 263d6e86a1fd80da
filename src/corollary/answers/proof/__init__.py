"""A chain of equations that shows something."""
