"""Equations as polynomials: what follows from what, decided exactly and within limits."""
