"""Words, read and marked by a person."""
