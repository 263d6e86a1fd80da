"""Obligations of a derivation, for all numbers that can be drawn, and how each is settled."""
