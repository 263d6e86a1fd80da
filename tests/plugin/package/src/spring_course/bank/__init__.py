"""The bank of the course: `problems/` and `solutions/` lie beside this file."""
