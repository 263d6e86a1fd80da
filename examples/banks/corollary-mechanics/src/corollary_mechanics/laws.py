"""Laws of mechanics that many problems share and Corollary's own library does not have."""

from __future__ import annotations

from corollary.laws import Law, law


def velocity_at(v: object, *, v_0: object, a: object, t: object) -> Law:
    """Constant acceleration: the velocity grows in proportion to the time.

    `v = v_0 + a*t`
    """
    return law("Velocity", "v = v_0 + a*t", holds="the acceleration is constant", v=v, v_0=v_0, a=a, t=t)


def position_at(x: object, *, x_0: object = 0, v_0: object, a: object, t: object) -> Law:
    """Constant acceleration: where something is.

    `x = x_0 + v_0*t + a*t^2/2`
    """
    return law(
        "Position",
        "x = x_0 + v_0*t + a*t^2/2",
        holds="the acceleration is constant",
        x=x,
        x_0=x_0,
        v_0=v_0,
        a=a,
        t=t,
    )


def without_time(v: object, *, v_0: object, a: object, s: object) -> Law:
    """Constant acceleration: velocities and the way between them.

    `v^2 = v_0^2 + 2*a*s`
    """
    return law(
        "Velocity and way",
        "v^2 = v_0^2 + 2*a*s",
        holds="the acceleration is constant",
        v=v,
        v_0=v_0,
        a=a,
        s=s,
    )


def second_law(net: object, *, m: object, a: object) -> Law:
    """The net force along an axis is mass times acceleration.

    `F = m*a`
    """
    return law("Newton's second law", "F = m*a", F=net, m=m, a=a)


def balance(up: object, down: object, holds: str = "nothing accelerates along this axis") -> Law:
    """What pulls one way is as large as what pulls the other way.

    `F_1 = F_2`
    """
    return law("Equilibrium of forces", "F_1 = F_2", holds=holds, F_1=up, F_2=down)


def torques(one_way: object, other_way: object, holds: str = "nothing begins to turn") -> Law:
    """The torques that turn one way are as large as those that turn the other way, about any axis.

    `M_1 = M_2`
    """
    return law("Equilibrium of torques", "M_1 = M_2", holds=holds, M_1=one_way, M_2=other_way)


def kinetic_friction(f: object, *, mu: object, N: object) -> Law:
    """Friction of surfaces that slide.

    `f = mu*N`
    """
    return law("Kinetic friction", "f = mu*N", holds="the surfaces slide on each other", f=f, mu=mu, N=N)


def energy_and_work(*, before: object, work: object, after: object, holds: str = "") -> Law:
    """The mechanical energy afterwards is that from before, and the work of all forces that have no potential.

    `E_0 + W = E_1`
    """
    return law("Energy and work", "E_0 + W = E_1", holds=holds, E_0=before, W=work, E_1=after)


def gravitation(F: object, *, G: object, M: object, m: object, r: object) -> Law:
    """Newton's law of gravitation between two bodies, r from centre to centre.

    `F = G*M*m/r^2`
    """
    return law(
        "Law of gravitation",
        "F = G*M*m/r^2",
        holds="r is the distance of the centres",
        F=F,
        G=G,
        M=M,
        m=m,
        r=r,
    )


def rolling(v: object, *, omega: object, R: object) -> Law:
    """What rolls without slipping goes forward by its circumference in a turn.

    `v = omega*R`
    """
    return law("Rolling", "v = omega*R", holds="it does not slip", v=v, omega=omega, R=R)


def angular_second_law(torque: object, *, I: object, alpha: object) -> Law:  # noqa: E741 - the field's letter
    """The net torque about a fixed axis is moment of inertia times angular acceleration.

    `M = I*alpha`
    """
    return law(
        "Newton's second law for rotation",
        "M = I*alpha",
        holds="the axis is fixed",
        M=torque,
        I=I,
        alpha=alpha,
    )
