"""Thousands of variants of a cradle or of two spheres in one call, each with its own errors."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from corollary.scenes import collision
from corollary.scenes.catalogue import SCENES
from corollary.scenes.definition import Setting, settle
from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.integrate import contact_motion, row_motion
from corollary.scenes.integrate.lines import follow_lines
from corollary.scenes.integrate.regularised import MOST_COMPILED
from corollary.scenes.integrate.single_contact import MOST_STEPS
from corollary.scenes.library import spheres
from corollary.scenes.progress import part, with_bar
from corollary.scenes.run import ROUNDING, BadSetting, two_runs
from corollary.scenes.sound import refuse_tolerance, short_text

Array = NDArray[np.float64]
OUTCOMES = np.array(["released", "missed", "sticks", "refused"])
RELEASED, MISSED, STICKS, REFUSED = range(4)
ONE_FOR_ALL = {"N", "q", "balls_in"}
SHARES = (0.0, 0.4), (0.4, 1.0)  # of the coarser run, and of the finer


@dataclass(frozen=True, slots=True, eq=False)
class Ensemble:
    """What became of n variants: `observed[name]` and `errors[name]` (absolute, SI, estimates) have a line for each.

    `outcomes` (n,) is `released`, `missed`, `sticks` or `refused` (spheres that overlap at the start, too: play these alone); a variant
    that is refused has nan everywhere, and the duration of one that sticks is infinite. Where a ball of a row is left with no velocity
    relative to its neighbour that is known, or two runs count touches differently, the variant is `undecided` (n,): its duration is
    without a later, slow touch. `evaluations` counts the forces evaluated for all of them, those for the errors included.
    """

    observed: dict[str, Array]
    errors: dict[str, Array]
    outcomes: NDArray[np.str_]
    undecided: NDArray[np.bool_]
    evaluations: int


def ensemble(name: str, given: Mapping[str, Any], tolerance: float = 1e-9) -> Ensemble:
    """Play the variants of `cradle` or `spheres`; any setting but N, q and balls_in is one value for all or an array of n (SI).

    A row of values (masses, gaps: N or N - 1; vA, vB: 2) is one line for all, or n lines. Each is followed twice, and the difference
    is its error; with numba as a compiled loop, else in plain Python. Who waits for it at a terminal sees a bar. Raises BadSetting.
    """
    if name not in PLAYED:
        raise BadSetting(f"An ensemble is of {' or '.join(PLAYED)}, not of {name!r}; play others one by one.")
    refuse_tolerance(name, tolerance, 1e-13, 0.01)
    # What is no number is refused, variant by variant.
    with np.errstate(all="ignore"), with_bar(f"ensemble {name}"):
        return PLAYED[name](*_settings(name, given), two_runs(tolerance))


def _settings(name: str, given: Mapping[str, Any]) -> tuple[dict[str, Array], int]:
    """Every setting as an array with a line for each variant, and their number. Raises BadSetting."""
    known = {setting.name: setting for setting in SCENES[name].settings}
    arrays = {key: _numbers(name, known[key], value) for key, value in given.items() if key in known}
    several = {key for key, a in arrays.items() if a.ndim > known[key].many and key not in ONE_FOR_ALL}
    counts = {len(arrays[key]) for key in several}
    if len(counts) > 1:
        raise BadSetting(f"{name}: {', '.join(sorted(several))} have different numbers of variants.")
    alone = {key: value for key, value in given.items() if key not in several}
    settled = settle(name, known.values(), {k: _as_setting(v) for k, v in alone.items()})
    count = counts.pop() if counts else 1
    for key in several:
        _check(name, known[key], arrays[key])
    return {
        key: arrays[key] if key in several else np.broadcast_to(value, (count, *np.shape(value)))
        for key, value in settled.items()
    }, count


def _numbers(name: str, setting: Setting, value: Any) -> Array:
    """Raises BadSetting for what is no array of numbers that a double holds, or an empty one."""
    try:
        found = np.asarray(value, dtype=float)
        if np.asarray(value).dtype == bool:
            raise TypeError
    except (TypeError, ValueError, OverflowError):
        raise BadSetting(
            f"{name}: {setting.name} = {short_text(value)} is no number, and no array of numbers, that a double holds."
        ) from None
    if found.ndim > setting.many + 1:
        shape = " x ".join(map(str, found.shape))
        raise BadSetting(
            f"{name}: {setting.name} is a table of {shape}; give one value, or one for each variant."
        )
    if not found.size and setting.value:
        raise BadSetting(f"{name}: {setting.name} is empty; give one value, or one for each variant.")
    return found


def _as_setting(value: Any) -> Any:
    return tuple(value.tolist()) if isinstance(value, np.ndarray) and value.ndim else value


def _check(name: str, setting: Setting, values: Array) -> None:
    good = np.isfinite(values) & (values > setting.above) & (values >= setting.least)
    good &= (values < setting.below) & (values <= setting.most)
    if not good.all():
        worst = float(values[~good].flat[0])
        settle(name, [setting], {setting.name: worst})  # says what is wrong with it
        raise BadSetting(f"{name}: {setting.name} = {worst:g} cannot be.")


def _cradle(settings: dict[str, Array], n: int, tolerances: tuple[float, float]) -> Ensemble:
    count, coming, q = (float(settings[key][0]) for key in ("N", "balls_in", "q"))
    count, coming = round(count), round(coming)
    masses = settings["masses"] if settings["masses"].size else settings["m"][:, None] * np.ones(count)
    gaps = settings["gaps"]
    gaps = gaps[:, None] * np.ones(count - 1) if gaps.ndim == 1 else gaps
    if masses.shape[1:] != (count,) or gaps.shape[1:] != (count - 1,):
        raise BadSetting(f"cradle: {count} balls have {count} masses and {count - 1} gaps.")
    mass = (1.0 / (1.0 / masses[:, :-1] + 1.0 / masses[:, 1:])).max(axis=1)
    speed, k = settings["v0"], settings["k"]
    length = (mass * speed**2 / k) ** (1.0 / (q + 1.0))
    start = np.zeros((n, 2 * count - 1))
    start[:, 0 : 2 * coming : 2], start[:, 1::2] = 1.0, -gaps / length[:, None]
    inverse = np.ascontiguousarray(mass[:, None] / masses)
    stiff = np.ones((n, count - 1))
    power = np.full(count - 1, smoothing_power(Contact(1.0, q)))
    runs: list[tuple[Array, ...]] = []
    spent = 0
    for allowed, share in zip(tolerances, SHARES, strict=True):
        y, deepest, hardest, seen = start.copy(), np.zeros_like(stiff), np.zeros_like(stiff), np.zeros((n, 4))
        arrays = [y, np.zeros(count - 1, dtype=bool), inverse, np.zeros(count), stiff, np.full(count - 1, q)]
        arrays += [np.zeros(count - 1), power, deepest, hardest, seen]
        room = row_motion.ROOM, 2 * count - 1
        with part(*share):
            spent += follow_lines("row_motion", arrays, allowed, MOST_COMPILED, room=room)
        lasted, strains, openings, ends = seen.T
        runs.append((ends, openings, strains, y[:, ::2], lasted, deepest.max(axis=1), hardest.max(axis=1)))
    (ended, touched, _, *coarse), (ends, openings, strains, *fine) = runs
    weights = 1.0 / inverse
    had, has = (weights * start[:, ::2] ** 2).sum(axis=1), (weights * fine[0] ** 2).sum(axis=1)
    shift = np.abs((weights * (fine[0] - start[:, ::2])).sum(axis=1)) / (weights * np.abs(fine[0])).sum(
        axis=1
    )
    lost = np.abs(has / had - 1.0) > 1e3 * tolerances[0] + 1e-12 * count
    refused = (ended != ends) | (ends > row_motion.MISSED) | lost | (shift > 1e-12)
    units = {
        "velocities": speed,
        "duration": length / speed,
        "largest_overlap": length,
        "peak_force": mass * speed**2 / length,
    }
    sure = collision.SAFE, collision.SHARED, ROUNDING
    found = _gathered(units, coarse, fine, np.where(refused, REFUSED, ends), sure, spent, strains)
    slow = np.abs(np.diff(found.observed["velocities"], axis=1)) <= found.errors["velocities"][:, 1:]
    undecided = (openings > 0) & (slow.any(axis=1) | (openings != touched))
    return replace(found, undecided=undecided)


def _gathered(
    units: dict[str, Array],
    coarse: Any,
    fine: Any,
    ends: Array,
    sure: tuple[float, float, Any],
    spent: int,
    strains: Array | float = 0.0,
) -> Ensemble:
    """Values and errors (SI) of two runs in their natural `units`.

    As where one is played alone (`collision`), a difference counts some times (`sure`), at least a share of the largest that there is of
    any value, and never less than rounding; a duration is strained by slow touches.
    """
    safe, shared, least = sure
    found = [np.reshape(value, (len(ends), -1)) for value in fine]
    sizes = [np.maximum(np.abs(value).max(axis=1), 1.0) for value in found]
    apart = [
        np.abs(value - np.reshape(rough, value.shape)).max(axis=1) / size
        for rough, value, size in zip(coarse, found, sizes, strict=True)
    ]
    # What leaves the range of a computer is refused; the duration of what sticks is not looked at.
    good = [
        np.isfinite(value).all(axis=1) & np.isfinite(unit)
        for value, unit in zip(found, units.values(), strict=True)
    ]
    ends = np.where(np.all(good, axis=0), ends, REFUSED)
    together, lost = shared * np.max(apart, axis=0), ends == REFUSED
    apart[1] = np.maximum(apart[1], collision.STRAINED * strains * apart[0] * sizes[0] / sizes[1])
    observed: dict[str, Array] = {}
    errors: dict[str, Array] = {}
    for (name, unit), value, size, own in zip(units.items(), fine, sizes, apart, strict=True):
        error = np.maximum(safe * np.maximum(own, together), least) * size * unit
        wide = (np.newaxis,) * (value.ndim - 1)
        observed[name] = np.where(lost[:, *wide], math.nan, value * unit[:, *wide])
        errors[name] = np.broadcast_to(np.where(lost, math.nan, error)[:, *wide], value.shape)
    observed["duration"] = np.where(ends == STICKS, math.inf, observed["duration"])
    return Ensemble(observed, errors, OUTCOMES[ends.astype(int)], np.zeros(len(ends), dtype=bool), spent)


def _spheres(settings: dict[str, Array], n: int, tolerances: tuple[float, float]) -> Ensemble:
    for key in ("vA", "vB"):
        if settings[key].shape[1:] not in ((), (2,)):
            raise BadSetting(
                f"spheres: {key} has {settings[key].shape[-1]} numbers, but there are 2 components; for several variants give a pair for each."
            )
    ma, mb, k, eta = (np.asarray(settings[key]) for key in ("mA", "mB", "k", "eta"))
    q, reach = float(settings["q"][0]), 2.0 * settings["R"]
    va, vb = (np.broadcast_to(settings[key].T, (2, n)) for key in ("vA", "vB"))
    x, y, (u, v) = settings["dx"], settings["dy"], vb - va
    mass, speed = ma / (ma + mb) * mb, np.hypot(u, v)
    spin, radial = x * v - y * u, x * u + y * v
    fast = np.maximum(speed, np.abs(np.concatenate([va, vb])).max(axis=0))
    fast = np.where(fast > 0.0, fast, 1.0)
    # Where the pair passes at nearly the reach, what rounding does to the difference is part of the error.
    clear = reach * speed - np.abs(spin)
    inside, meets = np.hypot(x, y) < reach, (radial < 0.0) & (clear > 0.0)
    safe = np.where(meets & ~inside, clear, reach * speed)
    doubt = 4.4e-16 * (reach * speed + np.abs(x * v) + np.abs(y * u)) / safe
    root = np.sqrt(safe * (reach * speed + np.abs(spin)))
    inward = np.where(meets, root / reach, 1.0)
    angle = np.arctan2(-root * v - spin * u, -root * u + spin * v)
    depth = ((q + 1.0) * mass * inward**2 / (2.0 * k)) ** (1.0 / (q + 1.0))
    depth = np.minimum(depth, inward**2 * reach**3 / (2.0 * spin**2))
    depth = np.minimum(np.minimum(depth, mass * inward / eta), reach)
    across = np.where(meets, spin / (reach * inward), 0.0)
    groups = np.stack(
        [
            np.full(n, q),
            k * depth ** (q + 1.0) / (mass * inward**2),
            eta * depth / (mass * inward),
            across,
            depth / reach,
        ],
        axis=1,
    )
    runs: list[tuple[Array, ...]] = []
    smoothing, spent = smoothing_power(Contact(1.0, q)), 0
    for allowed, share in zip(tolerances, SHARES, strict=True):
        state, each = np.tile([0.0, 1.0, 1.0, 0.0, 0.0], (n, 1)), np.zeros((n, 3))
        room = contact_motion.ROOM, contact_motion.SIZE
        arrays = [state, groups, each]
        with part(*share):
            spent += follow_lines("contact_motion", arrays, smoothing, allowed, MOST_STEPS, room=room)
        overlaps, forces, ends = each.T
        stuck = (ends == contact_motion.STICKS) | ~meets
        turned = angle + state[:, contact_motion.TURN]
        out, side = -state[:, contact_motion.P] * inward, spin / reach * state[:, contact_motion.SPIN]
        after = [out * np.cos(turned) - side * np.sin(turned), out * np.sin(turned) + side * np.cos(turned)]
        change = np.array([np.where(stuck, 0.0, a) - before for a, before in zip(after, (u, v), strict=True)])
        change = np.where(meets, change, 0.0)
        share = mb / (ma + mb)
        then = np.concatenate([va - share * change, vb + (1.0 - share) * change])
        lasted = np.where(stuck, 0.0, state[:, contact_motion.TIME])
        seen = (then / fast).T, lasted, overlaps * meets, forces * meets, (change / fast).T
        runs.append((ends, *seen))
    (ended, *coarse), (ends, *fine) = runs
    found = np.where(ends == contact_motion.STICKS, STICKS, RELEASED)
    refused = inside | (meets & ((ended != ends) | (ends > contact_motion.STICKS)))
    found = np.where(refused, REFUSED, np.where(meets, found, MISSED))
    units = {
        "velocities": fast,
        "duration": depth / inward,
        "largest_overlap": depth,
        "peak_force": mass * inward**2 / depth,
        "impulse": mass * fast,
    }
    least = np.where(meets, spheres.SAFE * max(5e-15, spheres.LUCK * tolerances[0]) + doubt, 0.0)
    all_of_them = _gathered(units, coarse, fine, found, (spheres.SAFE, 1.0, least), spent)
    missed = found == MISSED  # those keep their velocities, to the last place
    all_of_them.observed["velocities"][missed] = np.concatenate([va, vb]).T[missed]
    return all_of_them


PLAYED = {"cradle": _cradle, "spheres": _spheres}
