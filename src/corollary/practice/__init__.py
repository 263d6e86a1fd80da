"""Practice: exercises posed one by one, answered part by part, with hints and another try."""
