"""Two spheres in a plane to race on (section 12.6): the glancing hit, with damping and without, also in equal steps of an angle.

The contact runs from phase 0 to pi whatever the damping, as long as it ends; the force is smooth there at both ends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

from corollary.formula.ball import Ball
from corollary.grading.programs.fixed_step import RK4
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import contact_motion
from corollary.scenes.integrate.contact_motion import SIZE, SPIN, TIME, TURN, P, W
from corollary.scenes.integrate.runge_kutta import DOP853, Tableau, step
from corollary.scenes.integrate.single_contact import follow, groups_of
from corollary.scenes.models.certain import double_of
from corollary.scenes.models.pair import (
    Pair,
    Parting,
    Touching,
    after_parting,
    meet,
    turned_and_lasted,
)
from corollary.scenes.models.two_bodies import contact_time
from corollary.trade.raced_scene import (
    ONCE,
    SPHERES,
    SPHERES_DAMPED,
    TOLERANCES,
    MethodAnswer,
    MethodRoute,
    RacedScene,
    Reference,
    State,
    StepProgram,
)


def through(pair: Pair, met: Touching, table: Tableau, steps: int) -> Parting:
    """The contact in a number of equal steps of any method; it begins at zero overlap, and its damping lets it end."""
    groups, depth, speed = groups_of(pair, met)
    spent = 0

    def slope(phase: float, state: Sequence[float]) -> list[float]:
        nonlocal spent
        spent += 1
        rho, share, time, turn = state
        w, rate = rho * math.sin(phase), rho * math.cos(phase)
        rates = [0.0] * SIZE
        contact_motion.slope([w, rate, share, time, turn], rates, groups, False)  # pyright: ignore[reportUnknownMemberType]
        ahead = (rate * rates[W] - w * rates[P]) / (rho * rho)
        grown = (w * rates[W] + rate * rates[P]) / rho
        return [grown / ahead, rates[SPIN] / ahead, rates[TIME] / ahead, rates[TURN] / ahead]

    state, h = [met.inward / speed, 1.0, 0.0, 0.0], math.pi / steps
    for i in range(steps):
        state, _ = step(table, slope, i * h, state, h, slope(i * h, state))
    rho, share, time, turn = state
    return Parting(
        turned=turn,
        outward=rho * speed,
        spin=share * met.spin,
        duration=time * depth / speed,
        overlap=depth,
        force=math.nan,
        sticks=False,
        evaluations=spent,
    )


MASS, REACH, STIFFNESS = 0.1, 0.04, 2e4
START = (0.08, 0.018)


def pair(eta: float) -> Pair:
    return Pair(MASS, MASS, START, ((0.0, 0.0), (-1.0, 0.0)), REACH, Contact(STIFFNESS, 1.5, eta))


def oblique(pair: Pair, met: Touching) -> Parting:
    """An undamped contact by its two integrals, as doubles."""
    overlap, turned, duration = (
        double_of(lambda i=i: turned_and_lasted(pair, Ball(met.inward), Ball(met.spin))[i]) for i in range(3)
    )
    force = pair.contact.k * overlap**pair.contact.q
    return Parting(turned, met.inward, met.spin, duration, overlap, force, False, 0)


def program(eta: float, until: float) -> StepProgram:
    """As in the chapter: both spheres in the plane, the force along the line of centres, drag on the relative velocity."""

    def overlap(y: State) -> float:
        return REACH - math.hypot(y[2] - y[0], y[3] - y[1])

    def acceleration(x: State, v: State) -> list[float]:
        dx, dy = x[2] - x[0], x[3] - x[1]
        distance = math.hypot(dx, dy)
        deep = REACH - distance
        if deep <= 0.0:
            return [0.0, 0.0, 0.0, 0.0]
        push = STIFFNESS * deep**1.5 / distance
        fx = (push * dx - eta * (v[2] - v[0])) / MASS
        fy = (push * dy - eta * (v[3] - v[1])) / MASS
        return [-fx, -fy, fx, fy]

    return StepProgram(
        (0.0, 0.0, *START), (1.0, 0.0, 0.0, 0.0), acceleration, until, (overlap,), lambda x, v: tuple(v)
    )


def case(eta: float, reference: Reference) -> RacedScene:
    both = pair(eta)
    met = meet(both)
    assert met is not None
    own = {
        "regularised": MethodRoute(
            "tolerance", TOLERANCES, lambda tolerance: _answer(both, met, follow(both, met, tolerance))
        ),
        "regularised_rk4": MethodRoute("step", _parts(4, 400), partial(_phased, both, met, RK4)),
        "regularised_dop853": MethodRoute("step", _parts(4, 48), partial(_phased, both, met, DOP853)),
    }
    if eta == 0.0:
        own = {
            "quadrature": MethodRoute("tolerance", ONCE, lambda _: _answer(both, met, oblique(both, met))),
            **own,
        }
    return RacedScene(
        name=f"spheres eta={eta:g}",
        ready="spheres",
        settings={"eta": eta},
        observable="velocities",
        reference=reference,
        scales=(1.0,) * 4,
        contact_time=contact_time(0.5 * MASS, STIFFNESS, 1.5, met.inward),
        program=program(eta, met.after + 1.3 * follow(both, met, 1e-8).duration),
        own=own,
    )


def _parts(fewest: int, most: int) -> tuple[float, ...]:
    """Steps as parts of the contact, each a little shorter than the last."""
    counts = dict.fromkeys(round(fewest * 2.0 ** (i / 3.0)) for i in range(100))
    return tuple(1.0 / n for n in counts if n <= most)


def _phased(both: Pair, met: Touching, table: Tableau, part: float) -> MethodAnswer:
    return _answer(both, met, through(both, met, table, round(1.0 / part)))


def _answer(both: Pair, met: Touching, parted: Parting) -> MethodAnswer:
    u, v = after_parting(both, met, parted)
    # B seen from A; the centre of mass moves on at (1/2, 0).
    return MethodAnswer((0.5 - 0.5 * u, -0.5 * v, 0.5 + 0.5 * u, 0.5 * v), parted.evaluations)


def cases() -> tuple[RacedScene, ...]:
    return (case(0.0, SPHERES), case(1.0, SPHERES_DAMPED))
