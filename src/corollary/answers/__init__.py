"""Ways to ask, and to answer: one file for each kind."""
