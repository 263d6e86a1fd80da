"""Bodies that take up or throw out mass: absorption, thrust, and the rocket equation."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false

from __future__ import annotations

import sympy

from corollary.laws.law import Law, law


def change_in_absorption(dp: object, *, m: object, dm: object, v: object, u: object, dv: object) -> Law:
    """What the momentum of body and drop changes by, while the drop of velocity u is taken up and the body gains dv (12.123).

    `dp = m*dv + (v - u)*dm + dm*dv`
    """
    return law(
        "Absorbed mass",
        "dp = m*dv + (v - u)*dm + dm*dv",
        source="(12.123)",
        holds="dp counts the drop before and after",
        dp=dp,
        m=m,
        dv=dv,
        v=v,
        u=u,
        dm=dm,
    )


def rocket_equation(F: object, *, m: object, a: object, v: object, u: object, R: object) -> Law:
    """External force, acceleration, and mass taken up at the rate R = dm/dt that arrives with the velocity u (12.126).

    `F = m*a + (v - u)*R`
    """
    return law(
        "Newton's second law for a changing mass",
        "F = m*a + (v - u)*R",
        source="(12.126)",
        holds="mass is taken up steadily, R = dm/dt",
        F=F,
        m=m,
        a=a,
        v=v,
        u=u,
        R=R,
    )


def thrust(F: object, v_rel: object, R: object) -> Law:
    """Mass thrown out with v_rel relative to the body, at the rate R = dm/dt (negative), pushes like a force (12.130).

    `F = v_rel*R`
    """
    return law(
        "Thrust",
        "F = v_rel*R",
        source="(12.130)",
        holds="R = dm/dt, negative when mass is thrown out",
        F=F,
        v_rel=v_rel,
        R=R,
    )


def burnt(*, v_0: object, v_1: object, v_rel: object, m_0: object, m_1: object) -> Law:
    """The rocket equation integrated from the mass m_0 to m_1, v_rel the speed of the exhaust relative to the rocket (12.136).

    `v_1 = v_0 + v_rel*ln(m_0/m_1)`
    """
    return law(
        "Rocket equation, integrated",
        "v_1 = v_0 + v_rel*ln(m_0/m_1)",
        source="(12.136)",
        holds="no external force acts, and the exhaust leaves straight backwards",
        v_0=v_0,
        v_1=v_1,
        v_rel=v_rel,
        m_0=m_0,
        m_1=m_1,
    )


def growing(m_1: object, *, m: object, R: object, t: object) -> Law:
    """The mass after a time t at a constant rate.

    `m_1 = m + R*t`
    """
    return law("Constant rate", "m_1 = m + R*t", m_1=m_1, m=m, R=R, t=t)


def impulse_of_growing_weight(
    J: object, *, m: sympy.Expr, R: sympy.Expr, g: sympy.Expr, t: sympy.Expr
) -> Law:
    """The integral of (m + R t) g over the time, worked out.

    `J = S` (12.20)
    """
    now = sympy.Dummy("t", positive=True)
    return law(
        "Impulse",
        "J = S",
        source="(12.20)",
        holds="the weight grows with the mass, (m + R t) g",
        J=J,
        S=sympy.integrate(sympy.expand((m + R * now) * g), (now, 0, t)),
    )
