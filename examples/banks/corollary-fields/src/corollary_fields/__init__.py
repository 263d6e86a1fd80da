"""A bank on circuits and geometrical optics: `problems/` and `solutions/` lie beside this file."""
