"""A body that turns about a fixed edge: angular momentum, and the energy of rotation."""

from __future__ import annotations

from corollary.laws.law import Law, law


def hit_on_hinge(*, m: object, h: object, before: object, after: object, I: object, omega: object) -> Law:  # noqa: E741 - the field's letter
    """A ball hits, at right angles and at the distance h from the edge, a body at rest that can turn about that edge.

    The edge may push as hard as it likes: its force has no torque about itself.

    `m*v_0*h = m*v_1*h + I*omega`
    """
    return law(
        "Conservation of angular momentum",
        "m*v_0*h = m*v_1*h + I*omega",
        holds="no outside force has a torque about the edge",
        m=m,
        v_0=before,
        v_1=after,
        h=h,
        I=I,
        omega=omega,
    )


def elastic_on_hinge(*, m: object, before: object, after: object, I: object, omega: object) -> Law:  # noqa: E741
    """An elastic hit keeps the kinetic energy; that of the turning body is I omega²/2.

    `m*v_0^2/2 = m*v_1^2/2 + I*omega^2/2`
    """
    return law(
        "Conservation of mechanical energy",
        "m*v_0^2/2 = m*v_1^2/2 + I*omega^2/2",
        holds="all forces that do work are conservative",
        m=m,
        v_0=before,
        v_1=after,
        I=I,
        omega=omega,
    )
