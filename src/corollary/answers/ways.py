"""Directions in a vertical plane by their words: absolute ones, and those along a slope; in English and in the language spoken."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from corollary.answers.spellings import MARK, main_spelling
from corollary.messages import N_, catalogue

_ = catalogue(__name__)

WAYS: Final = MappingProxyType(
    {
        "up": N_("up | upwards | upward | vertically up | vertically upwards | straight up"),
        "down": N_("down | downwards | downward | vertically down | vertically downwards | straight down"),
        "left": N_("left | to the left | leftwards | horizontally to the left"),
        "right": N_("right | to the right | rightwards | horizontally to the right"),
        "up the slope": N_(
            "up the slope | up slope | upslope | up the incline | uphill | up along the slope"
        ),
        "down the slope": N_(
            "down the slope | down slope | downslope | down the incline | downhill | down along the slope"
        ),
        "away from the slope": N_(
            "away from the slope | away from the incline | out of the slope | perpendicular to the slope, away from it"
        ),
        "into the slope": N_("into the slope | into the incline | perpendicular to the slope, into it"),
    }
)
"""Each direction and the ways to write it."""
DEGREES: Final = MappingProxyType(
    {
        "up": 90, "down": 270, "left": 180, "right": 0,
        "up the slope": 0, "down the slope": 180, "away from the slope": 90, "into the slope": 270,
    }
)  # fmt: skip
"""Counter-clockwise from the right; for those of a slope, from the direction up the slope."""


def of_a_slope(way: str) -> bool:
    """Whether the direction turns with the slope."""
    return way.endswith("slope")


def spellings(with_slope: bool) -> Mapping[str, str]:
    """The directions that there are, each with the ways to write it in the language spoken and in English."""
    return {
        way: f"{_(english)} {MARK} {english}"
        for way, english in WAYS.items()
        if with_slope or not of_a_slope(way)
    }


def in_words(way: str) -> str:
    """A direction in the language spoken."""
    return main_spelling(_(WAYS[way]))
