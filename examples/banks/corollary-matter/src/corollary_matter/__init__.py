"""A bank on fluids, gases and heat: `problems/` and `solutions/` lie beside this file."""
