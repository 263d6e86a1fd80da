"""A ratio of two numbers."""
