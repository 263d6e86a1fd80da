"""A ball meets a floor that pushes back with k overlap^q, weight included (example 12.3.1)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from falls_and_swings import EXACT, fallen
from flint import acb, acb_poly, arb

from corollary.formula.ball import Ball
from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, one
from corollary.scenes.film import NAIL, Film, film
from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.forces.fields import Weight
from corollary.scenes.line_collision import collide
from corollary.scenes.models.certain import (
    Balls,
    Evaluated,
    balls,
    double_of,
    found,
    geometric,
    integral,
    root,
    sign,
)
from corollary.scenes.models.two_bodies import (
    BETA,
    CONSERVED,
    FADES,
    Hit,
    damped,
    largest_overlap,
    swings,
    undamped,
)
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import (
    NEVER_PART,
    ROUNDING,
    BadSetting,
    Model,
    Observed,
    Run,
    by_relative_errors,
)
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("m", "mass of the ball", "kg", 0.1, above=0.0),
    Setting("k", "contact constant", "N/m^q", 1e6, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.5, least=1.0, most=10.0),
    Setting("R", "radius of the ball", "m", 0.02, above=0.0),
    Setting("y0", "height of the centre at the start", "m", 0.021),
    Setting("v0", "velocity at the start (up positive)", "m/s", -2.8),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("eta", "damping of the contact", "kg/s", 0.0, least=0.0),
)


# From this many times the critical damping on, spring and weight have no say until the ball is at rest: they change its way by the
# inverse square of that number, times its logarithm, times the share of the spring that is met at all.
OVERDAMPED = 1e5
# A smaller share of what weight does in the contact is rounding of it.
NO_FALL = 1e-15


def play(settings: Settings, tolerance: float) -> Run:
    """Rebound speed and impulse of the floor when the ball leaves y = R; peak force of the floor; duration of the contact."""
    m, contact, speed, g = _fallen(settings)
    (v0,) = numbers(settings, "v0")
    if v0 >= 0.0 and g == 0.0:
        return found(lambda: _missed(Ball(v0)))
    if contact.eta > 0.0 and not (g == 0.0 and contact.q == 1.0):
        return _damped(m, contact, speed, g, tolerance)
    return found(lambda: _evaluated(settings, contact))


def _fallen(settings: Settings) -> tuple[float, Contact, float, float]:
    """Mass, contact, the speed at the floor, weight. Raises BadSetting."""
    m, k, q, r, y0, v0, g, eta = numbers(settings, "m", "k", "q", "R", "y0", "v0", "g", "eta")
    if y0 < r:
        raise BadSetting(
            f"ball_on_floor: y0 = {y0:g} m is inside the floor; the centre must start at R = {r:g} m or higher."
        )
    speed = math.sqrt(v0 * v0 + 2.0 * g * (y0 - r))
    if eta > 0.0 and g > 0.0 and speed == 0.0:
        raise BadSetting(
            "ball_on_floor: the ball lies on the floor at the start: with damping, eta, it has no speed to compare with; start it above R."
        )
    return m, Contact(k, q, eta), speed, g


def _missed(v0: Ball) -> Evaluated:
    values: dict[str, Balls] = dict.fromkeys(
        ("duration", "peak_force", "impulse", "largest_overlap"), Ball(0)
    )
    return Evaluated(
        "missed", values | {"velocities": (v0,)}, "conservation", "the ball never meets the floor"
    )


def _evaluated(settings: Settings, contact: Contact) -> Evaluated:
    """Without damping; or a spring with a dashpot without weight."""
    m, g = balls(settings, "m", "g")
    speed = _meets(settings)
    model: Model = "quadrature" if contact.eta == 0.0 else "piecewise exact"
    if g > 0:
        hit = bounce(contact, m, speed, g) if sign(speed) else laid_down(contact, m, g)
        why = "one body, no damping: energy gives the deepest point, a rigorous integral over the energy the duration"
    elif contact.eta == 0.0:
        hit, why = undamped(m, Ball(contact.k), Ball(contact.q), speed), BETA
    else:
        turns = swings((math.inf, one(settings, "m")), contact)
        hit, why = damped(m, Ball(contact.k), Ball(contact.eta), speed, turns), FADES
    conserved = ("velocities", "rebound_speed", "energy_ratio") if contact.eta == 0.0 else ()
    return _observed(hit, m, speed, g, model, why, dict.fromkeys(conserved, ("conservation", CONSERVED)))


def _meets(settings: Settings) -> Ball:
    """The speed at the floor."""
    r, y0, v0, g = balls(settings, "R", "y0", "v0", "g")
    return (v0 * v0 + 2 * g * (y0 - r)).sqrt()


def _observed(
    hit: Hit, m: Ball, speed: Ball, g: Ball, model: Model, why: str, by: Mapping[str, tuple[Model, str]]
) -> Evaluated:
    back = hit.restitution
    values: dict[str, Balls] = {
        "velocities": (back * speed,),
        "peak_force": hit.force,
        "impulse": (1 + back) * m * speed + (m * g * hit.duration if hit.duration is not None else 0),
        "largest_overlap": hit.overlap,
        "rebound_speed": back * speed,
        "energy_ratio": back * back,
    }
    if not sign(speed):  # it lay there, and had no energy
        del values["energy_ratio"]
    if hit.duration is None:
        return Evaluated("sticks", values, model, why, warnings=(NEVER_PART,))
    return Evaluated("released", values | {"duration": hit.duration}, model, why, by)


def depth_of(contact: Contact, m: float, v: float, g: float) -> float:
    """The largest overlap (m) without damping, as a double; with weight where there is some."""
    if g == 0.0:
        return largest_overlap(m, contact.k, contact.q, v)
    return double_of(lambda: deepest(contact, arb(m), arb(v), arb(g)))


def deepest(contact: Contact, mass: arb, speed: arb, weight: arb) -> arb:
    """The overlap where a body that meets the floor at `speed` and is pulled on by `weight` (m/s^2) comes to rest.

    speed^2 + 2 g x = 2 k x^(q+1) / ((q+1) m): the root lies between the larger of those without either term on the left and its double.
    """
    p = arb(contact.q) + 1
    stiff = 2 * arb(contact.k) / (p * mass)
    unit = ((speed * speed / stiff) ** (1 / p)).max((2 * weight / stiff) ** (1 / arb(contact.q)))
    unit = unit.lower()

    def lacking(x: arb) -> arb:
        return stiff * x**p - 2 * weight * x - speed * speed

    return root(lacking, unit / 2, 2 * unit)


def bounce(contact: Contact, mass: arb, speed: arb, weight: arb) -> Hit:
    """The contact of a body that meets the floor at `speed` (> 0) and feels `weight` (> 0) meanwhile.

    With x = X w^s and w = 1 - y^2, the square of the speed is y^2 times a sum of powers of w with positive coefficients: nothing
    cancels, and the integrand is smooth at the deepest point X and at the touch.
    """
    s, q = max(smoothing_power(contact), 2), contact.q
    top = deepest(contact, mass, speed, weight)
    square, fall = acb(speed * speed), acb(2 * weight * top)

    powers = s * (Fraction(q) + 1), s * Fraction(q)
    whole = powers[0].denominator == 1
    sums = acb_poly([square] * round(powers[0])) + acb_poly([0] * s + [fall] * round(powers[1]))

    def per_y(y: acb, analytic: bool) -> acb:
        w = 1 - y * y
        if whole:
            rate = sums(w)
        else:
            rate = square * geometric(w, powers[0], analytic)
            rate += fall * w**s * geometric(w, powers[1], analytic)
        return w ** (s - 1) / rate.sqrt(analytic=analytic)

    duration = 4 * s * top * integral(per_y, arb(0), arb(1))
    return Hit(arb(1), top, arb(contact.k) * top ** arb(q), duration)


def laid_down(contact: Contact, mass: arb, weight: arb) -> Hit:
    """The same for a body that only touches the floor and is at rest: it sinks in, and comes back to where it was, at rest.

    With u = x / X the square of the speed is 2 g X (u - u^(q+1)): a Beta function closes the duration.
    """
    q, k = arb(contact.q), arb(contact.k)
    top = ((q + 1) * mass * weight / k) ** (1 / q)
    half, part = arb(0.5), 1 / (2 * q)
    beta = half.gamma() * part.gamma() / (half + part).gamma()
    return Hit(arb(1), top, (q + 1) * mass * weight, (2 * top / weight).sqrt() * beta / q)


def second_way(settings: Settings, tolerance: float) -> Run | None:
    """The same fall and the same contact followed in steps, whatever else could be done; none where there is no contact."""
    m, contact, _, g = _fallen(settings)
    r, y0, v0 = numbers(settings, "R", "y0", "v0")
    speed = fallen(y0 - r, v0, g)
    if speed == 0.0 or (v0 >= 0.0 and g == 0.0):
        return None
    return _damped(m, contact, speed, g, tolerance, in_steps=True)


def _damped(
    m: float, contact: Contact, speed: float, g: float, tolerance: float, *, in_steps: bool = False
) -> Run:
    if not math.isfinite(speed):
        raise OverflowError
    deep = depth_of(contact, m, speed, g)
    thick = contact.eta / math.sqrt(contact.k * m * deep ** (contact.q - 1.0))
    if not in_steps and thick > OVERDAMPED and (contact.q > 1.0 or g > 0.0):
        change = 4.0 * math.log(thick) / thick**2 * (m * speed / contact.eta / deep) ** (contact.q - 1.0)
        return _overdamped(m, contact, speed, g, change)
    if speed * speed < NO_FALL * g * deep:
        raise BadSetting(
            "ball_on_floor: the ball all but lies on the floor at the start: it has no speed that could be told from rounding of what weight does. "
            "Start it higher above R, or raise k."
        )
    line = RowOfBodies((math.inf, m), (0.0, -speed), (0.0,), (contact,), weight=g)
    collided = collide(line, tolerance)
    result = collided.result
    # In steps the fall is, too.
    errors = {name: each + EXACT * in_steps for name, each in collided.errors.items()}
    rebound, lasts = result.velocities[1], result.duration if math.isfinite(result.duration) else 0.0
    observed: dict[str, Observed] = {
        "velocities": (rebound,),
        "duration": result.duration,
        "peak_force": result.forces[0],
        "impulse": m * (rebound + speed) + m * g * lasts,
        "largest_overlap": result.overlaps[0],
        "rebound_speed": rebound,
        "energy_ratio": (rebound / speed) ** 2,
    }
    if result.outcome == "sticks" and g:
        del observed["impulse"]  # weight goes on for ever
    sizes = {
        "velocities": errors["velocities"],
        "rebound_speed": errors["velocities"],
        "energy_ratio": 2.0 * errors["velocities"],
        "duration": errors["duration"],
        "peak_force": errors["forces"],
        "largest_overlap": errors["overlaps"],
        # Both a change of momentum and a time are in it.
        "impulse": errors["velocities"] + errors["duration"] * g * lasts / speed,
    }
    scales = {"velocities": speed, "rebound_speed": speed, "impulse": m * speed, "energy_ratio": 1.0}
    return collided.observed(observed, scales, sizes)


def _overdamped(m: float, contact: Contact, speed: float, g: float, change: float) -> Run:
    """So much damping that it alone stops the ball, in the way m v/eta; weight then lets it sink to where the floor carries it.

    Critical damping already keeps it down for ever. It pushes hardest when it begins, and sinks to its resting place without ever
    passing it. `change` is what spring and weight can change of the way to its stop, as a part of it.
    """
    rest = (m * g / contact.k) ** (1.0 / contact.q)
    stopped = m * speed / contact.eta
    observed: dict[str, Observed] = {
        "velocities": (0.0,),
        "peak_force": max(contact.eta * speed, m * g),
        "largest_overlap": max(rest, stopped),
        "rebound_speed": 0.0,
        "energy_ratio": 0.0,
    }
    if not g:
        observed["impulse"] = m * speed
    errors = dict.fromkeys(observed, ROUNDING)
    if stopped > rest:
        errors["largest_overlap"] = max(ROUNDING, change)
    if m * g > contact.eta * speed:  # it sinks ever slower: that takes a little more than its weight
        slows = contact.q * contact.k * m * rest ** (contact.q - 1.0) / contact.eta**2
        errors["peak_force"] = max(ROUNDING, slows)
    why = "the damping is so much above the critical one that it alone decides"
    overdamped = by_relative_errors(observed, errors, "conservation", why, 0, "sticks")
    return replace(overdamped, warnings=(NEVER_PART,))


def filmed(settings: Settings) -> Film | None:
    m, k, q, radius, y0, v0, g, eta = numbers(settings, "m", "k", "q", "R", "y0", "v0", "g", "eta")
    meets = math.sqrt(max(v0 * v0 + 2.0 * g * (y0 - radius), 0.0))
    if v0 > 0.0 or meets == 0.0:
        return None
    # It comes from four radii above at least, with what it then had.
    fallen = min(max(y0 - radius, 4.0 * radius), meets * meets / (2.0 * g) if g else math.inf)
    begins = math.sqrt(max(meets * meets - 2.0 * g * fallen, 0.0))
    takes = (meets - begins) / g if g else fallen / meets
    ball = Body(m, (radius + fallen,), (-begins,), radius, "A")
    floor = Body(math.inf, (0.0,), (0.0,), name=NAIL)
    forces = Contact(k, q, eta), *((Weight(g),) if g else ())
    edge = 2.0 * fallen
    ground = ((-edge, 0.0), (edge, 0.0))
    return film((ball, floor), [(forces, 2.0 * takes)], upright=True, lines=(ground,))


SCENE = SceneDefinition(
    "a ball meets the floor: contact force k overlap^q, weight included",
    SETTINGS,
    play,
    second_way=second_way,
    film=filmed,
)
