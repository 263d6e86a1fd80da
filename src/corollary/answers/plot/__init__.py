"""A figure that the student draws."""
