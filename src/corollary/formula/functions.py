"""The functions a formula of this course may use: a fixed list."""

from __future__ import annotations

ARGUMENTS = {
    "sqrt": 1, "abs": 1, "sin": 1, "cos": 1, "tan": 1, "asin": 1, "acos": 1, "atan": 1, "atan2": 2, "exp": 1, "ln": 1,
    "log10": 1, "sinh": 1, "cosh": 1, "tanh": 1, "gamma": 1, "min": 2, "max": 2,
}  # fmt: skip
ANGLE_IN = frozenset({"sin", "cos", "tan"})
"""Functions of an angle."""

SPELLINGS = {name: name for name in ARGUMENTS} | {
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2", "lg": "log10", "tg": "tan", "Gamma": "gamma",
}  # fmt: skip
"""What may be typed, and which function is meant; `log` is missing because it may be ln or log10."""
