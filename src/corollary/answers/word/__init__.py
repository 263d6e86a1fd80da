"""A word from a list."""
