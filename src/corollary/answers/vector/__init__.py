"""A quantity with components."""
