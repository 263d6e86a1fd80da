"""Collisions along a line: the coefficient of restitution, the two-body problem, and the contact of a spring."""

from __future__ import annotations

from corollary.law.law import Law, law


def restitution(r: object, *, A: tuple, B: tuple) -> Law:
    """The relative velocity is turned round and shrinks by r (12.62); A and B are (velocity before, velocity after)."""
    return law("Coefficient of restitution", "v_B1 - v_A1 = -r*(v_B0 - v_A0)", source="(12.62)",
               r=r, v_A0=A[0], v_A1=A[1], v_B0=B[0], v_B1=B[1])  # fmt: skip


def reduced_mass(mu: object, m_A: object, m_B: object) -> Law:
    """Two bodies that act on each other move against each other like one of this mass."""
    return law("Reduced mass", "mu = m_A*m_B/(m_A + m_B)", source="", holds="no external force acts", mu=mu, m_A=m_A, m_B=m_B)


def half_oscillation(T: object, m: object, k: object) -> Law:
    """A contact with a linear spring lasts half a period of the oscillation."""
    return law("Half a period", "T = pi*sqrt(m/k)", source="(12.137) with q = 1", holds="the contact force is linear, q = 1", T=T, m=m, k=k)
