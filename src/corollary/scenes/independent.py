"""Ready scenes found a second way, which shares no formula with the first: Newton's second law step by step, or bodies one after another."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from corollary.scenes.collisions_in_turn import chain, cradle, rocket, second_run, two_blocks, wall
from corollary.scenes.definition import Settings, numbers, one
from corollary.scenes.falls_and_swings import bouncing_ball, pendulum_block
from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.spring import FADING, Spring, catching
from corollary.scenes.forces.weight import Weight
from corollary.scenes.forces.well import Well
from corollary.scenes.run import (
    STEPS,
    BadSetting,
    GuardFailed,
    Observable,
    Observed,
    Run,
    by_relative_errors,
    components,
)
from corollary.scenes.scene import Body, Force, Scene


def _followed(
    scene: Scene, observe: Collection[Observable], tolerance: float, times: Sequence[float] = ()
) -> Run:
    from corollary.scenes.measure import measured  # here, since it brings scipy

    return measured(scene, observe, tolerance, STEPS, times)


def _after(
    bodies: Sequence[Body], forces: Sequence[Force], until: float, tolerance: float
) -> tuple[tuple[float, ...], tuple[float, ...], float]:
    """Velocities and places at a time, and the relative error of the worse."""
    seen = {Observable.VELOCITIES, Observable.TRAJECTORY}
    run = _followed(Scene(tuple(bodies), tuple(forces), until=until), seen, tolerance, (until,))
    velocities, places = (components(run.observed[name]) for name in ("velocities", "trajectory"))
    return velocities, places, max(run.relative_error("velocities"), run.relative_error("trajectory"))


def absorbed_drop(settings: Settings, tolerance: float) -> Run:
    m, dm, v, u, force, t, dt = numbers(settings, "m", "dm", "v", "u", "F", "t", "dt")
    # The dashpot's fading is followed only as long as it lasts; then they move as one.
    way = 10.0 * (abs(v) + abs(u) + abs(force) / m * t) * max(t, dt) + 1.0
    short = min(t, dt)
    a, b = Body(m, (0.0,), (v,)), Body(dm, (way,), (u,))
    push = ForceFunction(0, lambda at, x, w: (force,))
    pushed = (push,) if force else ()
    (body, drop), _, error = _after((a, b), (catching(m, dm, dt), *pushed), short, tolerance)
    if t > short:
        # They go on as one, the drop as far behind as it is then.
        both = Body(m + dm, (0.0,), (body,))
        (later,), _, more = _after((both,), (push,), t - short, tolerance)
        body, drop, error = later, drop + (later - body), max(error, more)
    change = m * (body - v) + dm * (drop - u)
    fastest = max(abs(body), abs(v), abs(drop), abs(u))
    scales = {"velocities": fastest, "momentum_change": (m + dm) * fastest}
    return second_run({"velocities": (body, drop), "momentum_change": change}, error, scales=scales)


def bullet_block(settings: Settings, tolerance: float) -> Run:
    m, block, v, mu, g, dt = numbers(settings, "m", "M", "v", "mu", "g", "dt")
    a, b = Body(m, (0.0,), (v,)), Body(block, (10.0 * v * dt + 1.0,), (0.0,))
    (bullet, stuck), _, error = _after((a, b), (catching(m, block, dt),), dt, tolerance)
    sliding = Body(m + block, (0.0,), (stuck,))
    _, (way,), more = _after((sliding,), (Friction(0, mu, g),), 2.0 * stuck / (mu * g), tolerance)
    lost = 0.5 * m * (bullet * bullet - v * v) + 0.5 * block * stuck * stuck
    observed: dict[str, Observed] = {"velocities": (bullet, stuck), "energy_change": lost, "distance": way}
    scales = {"velocities": v, "energy_change": m * v * v, "distance": 2.0 * way * v / stuck}
    return second_run(observed, 2.0 * max(error, more), scales=scales)


def snowball(settings: Settings, tolerance: float) -> Run:
    you, son, ball, v, theta, dt = numbers(settings, "M", "Ms", "m", "v", "theta", "dt")
    along, up = ball * v * math.cos(theta) / dt, ball * v * math.sin(theta) / dt
    # The ice carries what the throw does to you vertically.
    forces = ForceFunction(0, lambda t, x, w: (along, up)), ForceFunction(1, lambda t, x, w: (-along, 0.0))
    thrower = Body(ball, (1.0, 0.0), (0.0, 0.0)), Body(you, (0.0, 0.0), (0.0, 0.0))
    (level, rising, yours, _), _, error = _after(thrower, forces, dt, tolerance)
    a, b = Body(ball, (0.0,), (level,)), Body(son, (10.0 * v * dt + 1.0,), (0.0,))
    grip = catching(ball, son, dt)
    (_, sons), _, more = _after((a, b), (grip,), dt, tolerance)
    observed: dict[str, Observed] = {
        "momentum": (ball * level, ball * rising),
        "velocities_after_throw": (yours, 0.0),
        "velocities": (yours, sons),
        "peak_force": max(math.hypot(ball * level, ball * rising) / dt, grip.damping * level),
    }
    fastest = max(abs(level), abs(rising), abs(yours))
    scales = {"velocities_after_throw": fastest, "velocities": fastest, "peak_force": grip.damping * fastest}
    return second_run(observed, max(error, more), scales=scales)


def kick(settings: Settings, tolerance: float) -> Run:
    m, v0, force, dt, pulse = numbers(settings, "m", "v0", "F", "dt", "pulse")
    power, nodes = round(pulse), 1000
    # The mean of the pulse by the trapezoidal rule, exact for so smooth a period.
    mean = math.fsum(math.sin(math.pi * i / nodes) ** power for i in range(nodes)) / nodes
    if power % 2:
        mean = math.prod(2.0 * i / (2.0 * i + 1.0) for i in range(1, power // 2 + 1)) * 2.0 / math.pi
    peak = force / mean
    push = ForceFunction(0, lambda t, x, v: (peak * math.sin(math.pi * min(t / dt, 1.0)) ** power,))
    (after,), (way,), error = _after((Body(m, (0.0,), (v0,)),), (push,), dt, tolerance)
    return second_run(
        {"velocities": (after,), "impulse": m * (after - v0), "way": way, "peak_force": abs(peak)},
        error,
        scales={"impulse": m * max(abs(after), abs(v0))},
    )


def ions(settings: Settings, tolerance: float) -> Run:
    strength, ma, mb, v, r0, s = numbers(settings, "C", "mA", "mB", "v", "r0", "s")
    # Seen from where both meet in the end if nothing acts: each turns there as the other does, at distances that add up.
    far, share, rest = math.sqrt((r0 - s) * (r0 + s)), mb / (ma + mb), ma / (ma + mb)
    a = Body(ma, (-share * far, -share * s), (share * v, 0.0))
    b = Body(mb, (rest * far, rest * s), (-rest * v, 0.0))
    runs = [
        _followed(
            Scene(bodies, (InverseSquare((0, 1), -strength),), until=4.0 * r0 / v),
            {Observable.TURNING_POINTS},
            tolerance,
        )
        for bodies in ((a, b), (b, a))
    ]
    turned = [components(run.observed["turning_points"]) for run in runs]
    if not all(turned):
        raise GuardFailed(
            f"ions: whether they near each other before they part is not told from {r0:g} m; begin farther away."
        )
    nearest = math.fsum(distances[0] for distances in turned)
    error = max(run.relative_error("turning_points") for run in runs) * max(
        1.0, *(run.measured["turning_points"].size / nearest for run in runs)
    )
    return second_run({"turning_points": (nearest,), "peak_force": strength / nearest**2}, 2.0 * error)


def atom(settings: Settings, tolerance: float) -> Run:
    from corollary.scenes.library.atom import start  # here, since a scene is loaded when it is asked for

    plane, m = one(settings, "dimension") == 2.0, one(settings, "m")
    well, axes = Well(*numbers(settings, "k", "b", "d")), 2 if plane else 1
    place, velocity = start(settings, well, plane)
    if not any(velocity) and math.hypot(*place) >= well.edge:  # nothing acts on it
        return second_run({"velocities": velocity[:axes], "escapes": 1.0}, 0.0)
    body = Body(m, place[:axes], velocity[:axes])
    swing, speed = 2.0 * math.pi * math.sqrt(m / well.k), math.hypot(*velocity) or 1.0
    # A period is no longer than a swing on a line; it is seen when the distance has come back twice.
    long = Scene((body,), (well,), until=2.1 * swing)
    run = _followed(long, {Observable.VELOCITIES}, tolerance)
    if run.outcome == "escaped":  # beyond the edge nothing changes its velocity any more
        return second_run(run.observed | {"escapes": 1.0}, run.relative_error("velocities"))
    try:
        run = _followed(long, {Observable.PERIOD, Observable.TURNING_POINTS}, tolerance)
    except BadSetting:
        gone = Scene((body,), (well,), until=4.0 * swing + 4.0 * (math.hypot(*place) + well.edge) / speed)
        run = _followed(gone, {Observable.VELOCITIES, Observable.TURNING_POINTS}, tolerance)
        escapes = {"escapes": float(run.outcome == "escaped")}
        if run.outcome != "escaped":  # round a circle, where the distance never turns
            return replace(run, measured=run.measured | second_run(escapes, 0.0).measured)
        return second_run(run.only(["velocities"]).observed | escapes, run.relative_error("velocities"))
    more: dict[str, Observed] = {"escapes": 0.0}
    if plane:
        # After a period the distance is the same, and the direction has turned.
        times = 0.0, components(run.observed["period"])[0]
        seen = _followed(long, {Observable.TRAJECTORY}, tolerance, times).observed["trajectory"]
        x, y, later_x, later_y = components(seen)
        sense = math.copysign(1.0, x * velocity[1] - y * velocity[0])
        turned = sense * math.atan2(x * later_y - y * later_x, x * later_x + y * later_y)
        more["angle"] = sense * (turned % (2.0 * math.pi))
    return replace(run, measured=run.measured | second_run(more, run.error).measured)


def railway_car(settings: Settings, tolerance: float) -> Run:
    v, rate, u, t = numbers(settings, "v", "R", "ux", "t")
    count = 1000
    shovel, dt = rate * t / count, t / count
    if shovel == 0.0:
        return second_run(dict.fromkeys(("mean_force", "impulse", "work", "energy_lost"), 0.0), 0.0)
    # One shovel that a dashpot brings to the speed of a car that nothing slows down.
    sand, car = Body(shovel, (0.0,), (u,)), Body(math.inf, (10.0 * (abs(u) + abs(v)) * dt + 1.0,), (v,))
    dashpot = Spring((0, 1), 0.0, damping=FADING * shovel / dt)
    (after, _), _, error = _after((sand, car), (dashpot,), dt, tolerance)
    impulse = count * shovel * (after - u)
    lost = impulse * v - count * 0.5 * shovel * (after - u) * (after + u)
    observed: dict[str, Observed] = {
        "mean_force": impulse / t,
        "impulse": impulse,
        "work": impulse * v,
        "energy_lost": lost,
    }
    fast, mass = max(abs(u), abs(v)), count * shovel
    thrown, hot = mass * fast, mass * fast**2
    scales = {"impulse": thrown, "mean_force": mass * fast / t, "work": hot, "energy_lost": hot}
    return second_run(observed, 4.0 * error, scales=scales)


def growing_drop(settings: Settings, tolerance: float) -> Run:
    """Each moment the vapour, slower by v - u, pulls with R (v - u)."""
    m, v, rate, u, g, t = numbers(settings, "m", "v", "R", "u", "g", "t")
    forces = Weight(g), Absorption(0, (-u,), rate)
    drop = Scene((Body(m, (0.0,), (-v,)),), forces, until=t, name="growing_drop")
    run = _followed(drop, {Observable.VELOCITIES, Observable.TRAJECTORY}, tolerance, (t,))
    fallen, gone = run.measured["velocities"], run.measured["trajectory"]
    (fall,), (place,) = components(fallen.value), components(gone.value)
    observed: dict[str, Observed] = {"velocities": (-fall,), "way": -place, "mass": m + rate * t}
    errors = {"velocities": fallen.relative_error, "way": gone.relative_error, "mass": 2e-16}
    # A drop that is blown up and falls again may end where it began: its errors are those of the way that it went.
    scales = {"velocities": fallen.size, "way": gone.size}
    why = "a force that depends on velocity and time, a mass that grows: Newton's second law, step by step"
    return by_relative_errors(observed, errors, run.model, why, run.evaluations, "bound", scales)


def ball_on_floor(settings: Settings, tolerance: float) -> Run | None:
    from corollary.scenes.library.ball_on_floor import (
        stepped,  # here, since a scene is loaded when it is asked for
    )

    return stepped(settings, tolerance)


def ballistic_pendulum(settings: Settings, tolerance: float) -> Run:
    from corollary.scenes.library.ballistic_pendulum import play

    return play(settings, tolerance, in_steps=True)


def super_ball(settings: Settings, tolerance: float) -> Run:
    from corollary.scenes.library.super_ball import play

    return play(settings, tolerance, in_steps=True)


def spheres(settings: Settings, tolerance: float) -> Run | None:
    """From start to end as an author's own scene, two bodies of their own; none for damping, whose contact is followed in steps."""
    from corollary.scenes.library.spheres import NAMES, pair_of

    pair = pair_of(settings, "spheres")
    if pair.contact.eta:
        return None
    bodies = tuple(
        Body(m, x, v, 0.5 * pair.reach)
        for m, x, v in zip((pair.mass_a, pair.mass_b), ((0.0, 0.0), pair.apart), pair.velocities, strict=True)
    )
    observe = {each for each in Observable if each.value in NAMES}
    run = _followed(Scene(bodies, (pair.contact,), name="spheres"), observe, tolerance)
    given = run.measured["impulse"]
    value, error = components(given.value)[2:], components(given.error)[2:]
    return replace(run, measured=run.measured | {"impulse": replace(given, value=value, error=error)})


SECOND_WAYS: dict[str, Callable[[Settings, float], Run | None]] = {
    each.__name__: each
    for each in (
        absorbed_drop,
        atom,
        ball_on_floor,
        ballistic_pendulum,
        bouncing_ball,
        bullet_block,
        chain,
        cradle,
        growing_drop,
        ions,
        kick,
        pendulum_block,
        railway_car,
        rocket,
        snowball,
        spheres,
        super_ball,
        two_blocks,
        wall,
    )
}
"""By scene: none for what is followed step by step in any case. They raise BadSetting and GuardFailed as the first way does."""
