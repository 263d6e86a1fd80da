"""Units and dimensions: what a quantity measures, and what students and authors call it."""

from corollary.units.unit_table import register

__all__ = ["register"]
