"""Shapes of figures, one file a topic."""

from corollary.figure.shapes import bodies, circuits, lines, optics, surfaces

__all__ = ["bodies", "circuits", "lines", "optics", "surfaces"]
