"""General laws that belong to no chapter: equality, and the normal force on a level floor."""

from __future__ import annotations

from corollary.laws.law import Law, law


def same(x: object, y: object, because: str = "") -> Law:
    """Two names for one quantity.

    `x = y`
    """
    return law("Equality", "x = y", holds=because, x=x, y=y)


def level_floor(N: object, m: object, g: object) -> Law:
    """On a level floor the normal force carries the weight.

    `N = m*g` (12.16)
    """
    return law(
        "Newton's second law",
        "N = m*g",
        source="(12.16)",
        holds="nothing accelerates vertically",
        N=N,
        m=m,
        g=g,
    )
