"""Motion in a potential: the truncated harmonic well, turning points, and the well seen from a turning plane."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import sympy

from corollary.laws.law import Law, law


def depth_of_well(U_0: object, *, k: object, d: object) -> Law:
    """The energy at the edge of a harmonic well of half width d.

    `U_0 = k*d^2/2` (12.139)
    """
    return law("Potential energy at the edge", "U_0 = k*d^2/2", source="(12.139)", U_0=U_0, k=k, d=d)


def turning_points(x: object, *, E: object, k: object, b: object) -> Law:
    """Where all the energy is potential energy of the well; x may be both places.

    `E = k*(x - b)^2/2`
    """
    return law(
        "Conservation of mechanical energy",
        "E = k*(x - b)^2/2",
        holds="at a turning point the kinetic energy is zero",
        E=E,
        k=k,
        x=x,
        b=b,
    )


def energy_between(*, m: object, v_0: object, U_0: object, v_1: object, U_1: object) -> Law:
    """Kinetic and potential energy of one body at two moments.

    `m*v_0^2/2 + U_0 = m*v_1^2/2 + U_1`
    """
    return law(
        "Conservation of mechanical energy",
        "m*v_0^2/2 + U_0 = m*v_1^2/2 + U_1",
        holds="the force is conservative",
        m=m,
        v_0=v_0,
        U_0=U_0,
        v_1=v_1,
        U_1=U_1,
    )


def angular_momentum(*, m: object, w_0: object, r_0: object, w_1: object, r_1: object) -> Law:
    """A central force keeps m r times the velocity across the radius.

    `m*w_0*r_0 = m*w_1*r_1`
    """
    return law(
        "Conservation of angular momentum",
        "m*w_0*r_0 = m*w_1*r_1",
        holds="the force points to the centre; w is the velocity across the radius",
        m=m,
        w_0=w_0,
        r_0=r_0,
        w_1=w_1,
        r_1=r_1,
    )


def oscillation(T: object, *, m: object, k: object) -> Law:
    """The period of a body on a linear spring.

    `T = 2*pi*sqrt(m/k)`
    """
    return law(
        "Harmonic oscillation",
        "T = 2*pi*sqrt(m/k)",
        holds="the force is -k (x - b) all the way",
        T=T,
        m=m,
        k=k,
    )


def far_turning_point(r: object, *, b: object, kappa: object) -> Law:
    """The far turning point after a start at r = b across the radius, with kappa = m v²/(k b²).

    With r = b y, energy and angular momentum leave y³ - y² - kappa y - kappa = 0 beside y = 1. It has one positive root, which is
    this (Cardano) as long as kappa < 11; a start with more than kappa = 4/3 leaves any well with d < b.

    `r = b/3*(1 + (1 + 18*kappa + sqrt((1 + 18*kappa)^2 - (1 + 3*kappa)^3))^(1/3) + (1 + 18*kappa - sqrt((1 + 18*kappa)^2 - (1 + 3*kappa)^3))^(1/3))`
    """
    return law(
        "Root of the cubic",
        "r = b/3*(1 + (1 + 18*kappa + sqrt((1 + 18*kappa)^2 - (1 + 3*kappa)^3))^(1/3)"
        " + (1 + 18*kappa - sqrt((1 + 18*kappa)^2 - (1 + 3*kappa)^3))^(1/3))",
        holds="energy and angular momentum at the turning point say $y^3 - y^2 - \\kappa y - \\kappa = 0$ for $y = r/b$",
        r=r,
        b=b,
        kappa=kappa,
    )


def small_excess(x: object, *, m: sympy.Expr, k: sympy.Expr, b: sympy.Expr, v: sympy.Expr) -> Law:
    """How far beyond b the turning point lies for a small speed v across the radius, to the lowest order in v.

    Energy and angular momentum at r = b + x give k x (b + x)² = m v² (2 b + x); its slope at v² = 0 is found here.

    `x = c*v^2`
    """
    excess, square = sympy.symbols("x q", positive=True, cls=sympy.Dummy)
    exact = k * excess * (b + excess) ** 2 - m * square * (2 * b + excess)
    slope = (-sympy.diff(exact, square) / sympy.diff(exact, excess)).subs({excess: 0, square: 0})
    return law(
        "Turning point, lowest order",
        "x = c*v^2",
        holds="the speed is small; c is the slope of x against $v^2$, from $k x (b + x)^2 = m v^2 (2b + x)$",
        x=x,
        c=sympy.cancel(slope),
        v=v,
    )
