"""A bank of mechanics: `problems/` and `solutions/` lie beside this file."""
