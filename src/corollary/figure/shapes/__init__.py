"""Shapes of figures, one file a topic."""

from corollary.figure.shapes import bodies, circuits, graphs, lines, optics, surfaces

__all__ = ["bodies", "circuits", "graphs", "lines", "optics", "surfaces"]
