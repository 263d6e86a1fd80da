"""One of several options, by its letter."""
