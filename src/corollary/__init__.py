"""Corollary derives the answers to physics exercises from the laws, and marks what students hand in."""

__version__ = "0.1.0"
