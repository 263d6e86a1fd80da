"""A function that the student writes."""
