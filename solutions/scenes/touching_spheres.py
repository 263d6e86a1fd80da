"""Two spheres watched for a time while they push each other and both fall: the weight is the one force from outside (12.4, 12.6)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from spheres import pair_of

from corollary.formula.ball import Ball
from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers
from corollary.scenes.measure import measured
from corollary.scenes.models.certain import decided
from corollary.scenes.models.pair import Pair, Vector, loaded_speed, refuse_too_soft, touch
from corollary.scenes.run import (
    ROUNDING,
    BadSetting,
    Observable,
    Observed,
    Run,
    by_relative_errors,
    components,
)
from corollary.scenes.scene import Body, Scene

SETTINGS = (
    Setting("mA", "mass of A", "kg", 0.2, above=0.0),
    Setting("mB", "mass of B", "kg", 0.3, above=0.0),
    Setting("R", "radius of each sphere", "m", 0.05, above=0.0),
    Setting("k", "contact constant", "N/m^q", 1.2e4, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.0, least=1.0, most=10.0),
    Setting("eta", "viscous constant", "kg/s", 0.0, least=0.0),
    Setting("dx", "x of B seen from A at the start", "m", 0.06),
    Setting("dy", "y of B seen from A at the start, up", "m", 0.08),
    Setting("vA", "velocity of A (x, y)", "m/s", (3.0, 4.0), many=True),
    Setting("vB", "velocity of B (x, y)", "m/s", (-0.75, -1.0), many=True),
    Setting("g", "acceleration of gravity, against y", "m/s^2", 9.8, least=0.0),
    Setting("t", "time for which they are watched", "s", 0.01, above=0.0),
)
# So many times the drag alone would have stopped the spheres: steps as short as that would not come to an end.
MOST_FADING = 1e4
# In roundings of the reach: what is squeezed less is told only beside the speeds that both have together.
LEAST_SQUEEZE = 1e5
APART = "they do not touch while they are watched: each falls alone"
TOUCH = "before the touch nothing acts but weight, and who falls with them sees none: the contact alone, step by step"


@dataclass(frozen=True, slots=True)
class Meeting:
    """The spheres when they begin to touch, or at the start, if they do: B is in the unit direction `toward` from A.

    They overlap by `overlap` (m); seen from A, B moves `along` this direction and `across` it (m/s, counter-clockwise). From then on they
    are watched for `left` (s).
    """

    toward: Vector
    overlap: float
    along: float
    across: float
    left: float


def met_within(pair: Pair, t: float) -> Meeting | None:
    """Their meeting, where it is within the time t (s). Raises GuardFailed when no digits tell whether they meet."""
    return decided(
        lambda: _met_within(pair, Ball(t)),
        "Two spheres that graze each other by less than any digits tell; move one of them a little.",
    )


def _met_within(pair: Pair, t: Ball) -> Meeting | None:
    met = touch(pair)
    # At the very moment of the touch nothing has come of it.
    if met is None or not float(t - met.after) > 0.0:
        return None
    x, y = met.direction
    length, distance = (x * x + y * y).sqrt(), Ball(pair.reach) - met.overlap
    return Meeting(
        (float(x / length), float(y / length)),
        *map(float, (met.overlap, -met.inward, met.spin / distance, t - met.after)),
    )


def play(settings: Settings, tolerance: float) -> Run:
    """After the time t: `velocities` (A x, A y, B x, B y), the total `momentum` (x, y), and the kinetic energy over that at the start.

    `duration` is how long they touched while they were watched.
    `momentum_change` (x, y) is that of both together; `mean_force` (x, y) is that of B on A while they were watched, without the
    weight. Each is there only if its force is, and the energy only if something moved at the start.
    """
    pair = pair_of(settings, "touching_spheres")
    g, t = numbers(settings, "g", "t")
    ma, mb, (va, vb) = pair.mass_a, pair.mass_b, pair.velocities
    met = met_within(pair, t)
    run, pushed = _followed(pair, met, g, tolerance) if met else (None, (0.0,) * 4)
    falls = 0.0, -g * t, 0.0, -g * t
    after = tuple(map(math.fsum, zip((*va, *vb), pushed, falls, strict=True)))
    if not all(map(math.isfinite, after)):
        raise OverflowError
    fast = max(map(abs, (*va, *vb, *pushed, *falls)))
    off = ROUNDING * fast + (max(components(run.measured["velocities"].error)) if run else 0.0)
    heavy, weight = max(ma, mb), (ma + mb) * g
    observed: dict[str, Observed] = {
        "velocities": after,
        "duration": run.observed["duration"] if run else 0.0,
        "largest_overlap": run.observed["largest_overlap"] if run else 0.0,
        "momentum": (ma * va[0] + mb * vb[0], ma * va[1] + mb * vb[1] - weight * t),
    }
    errors = {name: run.relative_error(name) if run else 0.0 for name in ("duration", "largest_overlap")}
    scales = {name: run.measured[name].size if run else 0.0 for name in errors}
    errors["velocities"], scales["velocities"] = off / fast if fast else 0.0, fast
    errors["momentum"], scales["momentum"] = ROUNDING, 2.0 * heavy * fast
    had, has = (
        ma * math.hypot(*a) ** 2 + mb * math.hypot(*b) ** 2 for a, b in ((va, vb), (after[:2], after[2:]))
    )
    if had:
        observed["energy_ratio"] = ratio = has / had
        # The energy goes with the squares of the velocities, those of the body that moves fast too.
        swift = ma * math.hypot(*after[:2]) + mb * math.hypot(*after[2:])
        scales["energy_ratio"] = ratio or 1.0
        errors["energy_ratio"] = 2.0 * swift * off / had / scales["energy_ratio"] + ROUNDING
    touched = run is not None and components(run.observed["largest_overlap"])[0] > 0.0
    if touched:
        observed["mean_force"] = push = ma * pushed[0] / t, ma * pushed[1] / t
        scales["mean_force"] = max(map(abs, push)) or heavy * fast / t
        errors["mean_force"] = off * heavy / t / scales["mean_force"]
    if g:
        observed["momentum_change"], errors["momentum_change"] = (0.0, -weight * t), ROUNDING
    if run is None:
        return by_relative_errors(observed, errors, "conservation", APART, 0, "missed", scales)
    return by_relative_errors(
        observed,
        errors,
        run.model,
        run.why,
        run.evaluations,
        "released" if touched else "missed",
        scales,
        run.warnings,
    )


def _followed(pair: Pair, met: Meeting, g: float, tolerance: float) -> tuple[Run, tuple[float, ...]]:
    """The contact, B on the first axis as it begins, seen from the centre of mass; and what it changes in velocities (A x, A y, B x, B y).

    Raises BadSetting, and as `measured` does.
    """
    ma, mb, reach, contact = pair.mass_a, pair.mass_b, pair.reach, pair.contact
    if contact.eta * met.left * (1.0 / ma + 1.0 / mb) > MOST_FADING:
        raise BadSetting(
            "touching_spheres: the drag has stopped the spheres long before the time t; lower eta, or t."
        )
    speed = max(math.hypot(met.along, met.across), loaded_speed(pair, met.overlap))
    squeeze = (pair.mass * speed / contact.k * speed) ** (1.0 / (contact.q + 1.0))
    drift = 0.0
    if squeeze < LEAST_SQUEEZE * math.ulp(reach):
        drift = max(*(math.hypot(*v) for v in pair.velocities), min(math.sqrt(reach * g), g * met.left))
    shares = -mb / (ma + mb), ma / (ma + mb)
    bodies = tuple(
        Body(m, (x, 0.0), (part * met.along, part * met.across + drift), 0.5 * reach, name)
        for m, x, part, name in zip((ma, mb), (0.0, reach - met.overlap), shares, "AB", strict=True)
    )
    balls = Scene(bodies, (contact,), until=met.left, name="touching_spheres")
    run = measured(
        balls, {Observable.VELOCITIES, Observable.DURATION, Observable.LARGEST_OVERLAP}, tolerance, TOUCH
    )
    refuse_too_soft(components(run.observed["largest_overlap"])[0], reach)
    then, (x, y) = components(run.observed["velocities"]), met.toward
    changes = [(then[2 * i] - b.velocity[0], then[2 * i + 1] - b.velocity[1]) for i, b in enumerate(bodies)]
    return run, tuple(each for u, w in changes for each in (u * x - w * y, u * y + w * x))


SCENE = SceneDefinition("two spheres push each other while both fall", SETTINGS, play)
