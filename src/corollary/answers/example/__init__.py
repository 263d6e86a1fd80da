"""Numbers of the student's own that must have a property."""
