"""The name of this distribution and its version."""

DISTRIBUTION = "corollary-physics"  # what pip installs; `corollary` is the import and the command
__version__ = "1.0.0"
