"""Forces in a plane: a push along the line of centres, a spring towards a circle, and what a circle needs."""

from __future__ import annotations

from typing import Any

from corollary.laws.law import Law, law


def distance(r: object, place: tuple[Any, ...]) -> Law:
    """The length of the vector (x, y).

    `r = sqrt(x^2 + y^2)`
    """
    x, y = place
    return law("Distance", "r = sqrt(x^2 + y^2)", r=r, x=x, y=y)


def overlap(delta: object, *, R: object, r: object) -> Law:
    """By how much two equal spheres overlap; negative while they are apart.

    `delta = 2*R - r`
    """
    return law("Overlap", "delta = 2*R - r", delta=delta, R=R, r=r)


def within(theta: object, room: object, holds: str) -> Law:
    """1 where there is room left, 0 beyond the edge; on the edge itself it is 0/0 and has no value.

    `theta = (1 + delta/abs(delta))/2`
    """
    return law("Switch", "theta = (1 + delta/abs(delta))/2", holds=holds, theta=theta, delta=room)


def sphere_contact(
    F: object,
    *,
    theta: object,
    k: object,
    delta: object,
    eta: object,
    apart: tuple[Any, ...],
    r: object,
    passing: tuple[Any, ...],
) -> Law:
    """What sphere B does to sphere A: a push along the line of centres, and a drag; `apart` and `passing` are B less A.

    `F = theta*(-k*abs(delta)^(3/2)*dr/r + eta*dv)` (program of section 12.6)
    """
    return law(
        "Contact of two spheres",
        "F = theta*(-k*abs(delta)^(3/2)*dr/r + eta*dv)",
        source="(program of section 12.6)",
        holds="$\\theta$ is 1 while they overlap and 0 otherwise",
        F=F,
        theta=theta,
        k=k,
        delta=delta,
        eta=eta,
        dr=apart,
        r=r,
        dv=passing,
    )


def ionic(F: object, *, C: object, apart: tuple[Any, ...], r: object) -> Law:
    """What ion B does to ion A, which it repels; `apart` is the place of B less that of A.

    `F = -(C/r^2)*(dr/r)` (section 12.6)
    """
    return law("Ionic force", "F = -(C/r^2)*(dr/r)", source="(section 12.6)", F=F, C=C, dr=apart, r=r)


def towards_circle(F: object, *, k: object, b: object, place: tuple[Any, ...], r: object) -> Law:
    """A spring that pulls to the distance b from the origin, along the radius.

    `F = -k*(r - b)*s/r` (project 12.15 f)
    """
    return law(
        "Central force",
        "F = -k*(r - b)*s/r",
        source="(project 12.15 f)",
        holds="b - d < r < b + d; s is the vector from the molecule to the atom",
        F=F,
        k=k,
        b=b,
        r=r,
        s=place,
    )


def on_a_circle(F: object, *, m: object, v: object, r: object) -> Law:
    """What must pull inwards for a circle at constant speed.

    `F = m*v^2/r`
    """
    return law(
        "Newton's second law",
        "F = m*v^2/r",
        holds="F is the force towards the centre of the circle",
        F=F,
        m=m,
        v=v,
        r=r,
    )
