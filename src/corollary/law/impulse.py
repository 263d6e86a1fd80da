"""Impulse, mean force, and Newton's third law."""

from __future__ import annotations

from corollary.law.law import Law, law


def impulse_momentum(J: object, dp: object) -> Law:
    """The impulse of the net force is the change of momentum (12.19), (12.20)."""
    return law("Impulse", "J = dp", source="(12.19), (12.20)", holds="J is the impulse of the net force", J=J, dp=dp)


def mean_force(F: object, J: object, dt: object) -> Law:
    """The time-averaged force is the impulse divided by the time it acts (12.22)."""
    return law("Mean force", "F = J/dt", source="(12.22)", F=F, J=J, dt=dt)


def third_law(on_other: object, on_this: object) -> Law:
    """What A does to B is opposite to what B does to A (12.44); for impulses as for forces."""
    return law("Newton's third law", "J_AB = -J_BA", source="(12.44)", J_AB=on_other, J_BA=on_this)
