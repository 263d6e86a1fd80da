"""Geometry that collisions need: lengths and angles of vectors, the line of centres, the height of a pendulum."""

from __future__ import annotations

from typing import Any

from corollary.laws.law import Law, law


def angle_between(psi: object, *, a: tuple[Any, ...], b: tuple[Any, ...], lengths: tuple[Any, ...]) -> Law:
    """The angle between two vectors in the plane, from their scalar product.

    `a*b*cos(psi) = a_x*b_x + a_y*b_y`
    """
    return law(
        "Scalar product",
        "a*b*cos(psi) = a_x*b_x + a_y*b_y",
        a=lengths[0],
        b=lengths[1],
        psi=psi,
        a_x=a[0],
        a_y=a[1],
        b_x=b[0],
        b_y=b[1],
    )


def line_of_centres(n: tuple[Any, ...], *, s: object, D: object) -> tuple[Law, Law]:
    """The unit vector from centre to centre as two spheres touch: across the motion the centres are s apart, in all D.

    `n_y = s/D`; `n_x = sqrt(1 - n_y^2)`
    """
    return (
        law(
            "Line of centres",
            "n_y = s/D",
            holds="the centres are D apart when the spheres touch",
            n_y=n[1],
            s=s,
            D=D,
        ),
        law(
            "Unit vector",
            "n_x = sqrt(1 - n_y^2)",
            holds="A comes along +x, so that B lies ahead of it",
            n_x=n[0],
            n_y=n[1],
        ),
    )


def rope_height(h: object, L: object, theta: object) -> Law:
    """How far the end of a rope of length L has risen when the rope makes the angle theta with the vertical.

    `h = L*(1 - cos(theta))`
    """
    return law(
        "Geometry of the rope", "h = L*(1 - cos(theta))", holds="the rope stays tight", h=h, L=L, theta=theta
    )
