"""A course from beginning to end: problem sets made, given out, and marked."""
