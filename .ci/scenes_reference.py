"""Writes docs/ready_scenes.md: every ready-made scene, what it takes and what it observes, from the code.

`python .ci/scenes_reference.py` writes it, `--check` says whether it is up to date (a test asks).
"""

from __future__ import annotations

import sys
from collections.abc import Iterator

from reference_page import table, written

from corollary.derive.ready_scenes import ready_scenes, run
from corollary.scenes.definition import Setting
from corollary.scenes.run import Run, components

SCENES = ready_scenes()

OPENING = """\
# Ready-made scenes

Made from the code by `python .ci/scenes_reference.py`. `corollary scene NAME --set q=1.5` plays one, `corollary scene NAME --settings`
tells the same as its table here, `corollary scene` lists all; from Python it is `corollary.play("NAME", q=1.5)`. How sure the values
are: [scenes](scenes.md#ready-made-scenes).

Where a body is caught (`absorbed_drop`, `ballistic_pendulum`, `bullet_block`, `snowball`) a dashpot lets the relative velocity fade by
e⁻⁴⁰ in the time `dt`; `peak_force` and `depth` go by `dt`. `gaps` of a `cradle` are between all neighbours.

All numbers are SI, angles in rad. A row is written `masses=0.1,0.2,0.1`, from Python `(0.1, 0.2, 0.1)`; one number in place of a row
serves all. *Takes* is what a number must be by itself; what does not go together is refused in a sentence. *Error* says what is
stated with the defaults: a proven *bound* or an *estimate*; a dash, where the value is observed with other settings only.
"""
# What each scene observes, in words: all that it may, also with other settings than those left out.
TOUCH = {
    "duration": "from the first touch to the last opening (s)",
    "largest_overlap": "the largest between any two bodies (m)",
    "peak_force": "the largest contact force between any two bodies, drag included (N)",
    "energy_ratio": "kinetic energy at the end over that at the start",
}
OBSERVED: dict[str, dict[str, str]] = {
    "absorbed_drop": {
        "velocities": "of body and drop after the time t (m/s)",
        "momentum_change": "of both together in that time (kg m/s)",
        "peak_force": "the largest pull of the dashpot between them (N)",
    },
    "atom": {
        "period": "time between two returns of the distance to its smallest value (s), where the atom stays",
        "turning_points": "distances at which it turns back, smallest first (m); places on a line",
        "escapes": "1 if it leaves, 0 if it stays",
        "angle": "turned in one period, in a plane (rad)",
        "velocities": "far away, where it leaves (m/s)",
        "duration": "from the start until it leaves the well (s)",
    },
    "ball_on_floor": {
        "velocities": "of the ball when it leaves the floor (m/s, up positive)",
        "peak_force": "the largest force of the floor (N)",
        "impulse": "of the floor (kg m/s); none for a ball that stays there with its weight",
        "largest_overlap": TOUCH["largest_overlap"],
        "rebound_speed": "at which it leaves (m/s)",
        "energy_ratio": "kinetic energy when it leaves over that when it came",
        "duration": TOUCH["duration"],
    },
    "ballistic_pendulum": {
        "velocities": "of bullet and block when the bullet is stuck (m/s)",
        "height": "to which they swing (m)",
        "angle": "of the rope there (rad)",
        "energy_change": "of the hit (J); negative",
    },
    "bouncing_ball": {
        "heights": "after each of the n bounces (m)",
        "rebound_speed": "after the last of them (m/s)",
        "duration": "from the drop to the last of them (s)",
        "rests_after": "time of all bounces, without end (s), where r < 1",
    },
    "bullet_block": {
        "velocities": "of bullet and block when the bullet is stuck (m/s)",
        "energy_change": "of the hit (J); negative",
        "distance": "that the block slides (m)",
        "duration": "of the slide (s)",
        "depth": "to which the bullet gets in (m)",
        "peak_force": "the largest pull of the dashpot between them (N)",
    },
    "chain": {
        "impulse": "of the hand until the last link hangs (kg m/s)",
        "mean_force": "while one link is lifted about y (N)",
        "work": "of the hand (J)",
        "energy_lost": "in all the jerks (J)",
    },
    "cradle": {"velocities": "of the balls after the last opening (m/s)"}
    | {name: TOUCH[name] for name in ("duration", "largest_overlap", "peak_force")},
    "growing_drop": {
        "velocities": "after the time t, downwards (m/s)",
        "way": "fallen (m)",
        "mass": "then (kg)",
    },
    "ions": {
        "turning_points": "the closest distance (m)",
        "peak_force": "there (N)",
        "far_speed": "relative speed far away (m/s)",
        "escapes": "1: they always part",
    },
    "kick": {
        "velocities": "after the push (m/s)",
        "impulse": "of the push, with the sign of F (kg m/s)",
        "peak_force": "size of the largest force (N)",
        "way": "made meanwhile (m)",
    },
    "pendulum_block": {
        "speed_before": "of the sphere at the bottom (m/s)",
        "velocities": "of sphere and block after the hit (m/s)",
        "height": "that the sphere then reaches (m)",
        "duration": "of the touch (s)",
    },
    "railway_car": {
        "mean_force": "of the pull (N)",
        "impulse": "of the pull in the time t (kg m/s)",
        "work": "of the pull in that time (J)",
        "energy_lost": "as the sand is brought to the car's speed (J)",
    },
    "rocket": {
        "velocities": "the middle of `bracket`, in which a steady burn ends; its bound is how far the ends are (m/s)",
        "bracket": "the end velocity if each puff leaves with v_rel relative to the rocket after it, and before it (m/s)",
    },
    "snowball": {
        "momentum": "of the ball in flight, (level, up) (kg m/s)",
        "velocities_after_throw": "yours and your son's, toward your son (m/s)",
        "velocities": "the same after the catch (m/s)",
        "peak_force": "the largest of the throw, its upward part included, and of the dashpot that catches (N)",
    },
    "spheres": {
        "velocities": "(A x, A y, B x, B y) once they are apart (m/s)",
        **{name: TOUCH[name] for name in ("duration", "largest_overlap", "peak_force")},
        "impulse": "on B, (x, y) (kg m/s)",
        "energy_ratio": TOUCH["energy_ratio"],
    },
    "super_ball": {
        "velocities": "of the lower and the upper ball after the last opening (m/s, up positive)",
        "heights": "to which they then rise, counted from where they are when the lower one meets the floor (m)",
        "duration": TOUCH["duration"],
        "peak_force": "the largest contact force, without their weight (N)",
    },
    "touching_spheres": {
        "velocities": "(A x, A y, B x, B y) after the time t (m/s)",
        "duration": "for which they touch in that time (s)",
        "largest_overlap": TOUCH["largest_overlap"],
        "energy_ratio": TOUCH["energy_ratio"],
        "momentum": "of both, (x, y) (kg m/s)",
        "mean_force": "of B on A in that time, (x, y) (N), where they touch",
        "momentum_change": "of both, (x, y) (kg m/s), where there is weight",
    },
    "two_blocks": {
        "velocities": "of A and B after the collision (m/s)",
        **TOUCH,
        "impulse": "on B (kg m/s)",
    },
    "wall": {
        "velocities": "after the reflection, (along the wall, away from it) (m/s)",
        "momentum_change": "of the ball, the same way (kg m/s)",
        "impulse": "on the wall, the same way (kg m/s)",
        "mean_force": "on the ball, the same way (N)",
        **{name: TOUCH[name] for name in ("peak_force", "largest_overlap", "duration", "energy_ratio")},
    },
}

# What the table of its settings does not say.
NOTES = {
    "atom": "Beyond b + d nothing pulls; at b - d is a hard core, and it starts there or farther out.",
    "absorbed_drop": "A dashpot catches the drop; it goes on to act after dt, as long as they are watched.",
    "ball_on_floor": "y0 is at least R.",
    "ballistic_pendulum": "A dashpot brakes the bullet; after dt it is held fast. dt is at most 0.1 sqrt(L/g), and the block does not rise above the rope's fixing.",
    "bullet_block": "A dashpot brakes the bullet; after dt it is held fast, and the rough region begins.",
    "chain": "The links are picked up one by one; N does not come out in the values, which are sums and means over all of them.",
    "cradle": "`masses` has N numbers, `gaps` N - 1: between all neighbours, those that come in together included.",
    "railway_car": "Shovels of sand are brought to the car's speed one by one; N does not come out in the values.",
    "snowball": "A constant force throws, without weight; a dashpot along the ice catches; after dt the ball is held fast.",
    "spheres": "Damping acts against the whole relative velocity of the centres.",
    "super_ball": "With a gap the lower ball has left the floor before they meet; without one all touch at once.",
    "touching_spheres": "Damping acts against the whole relative velocity of the centres.",
    "wall": "The wall gives like a spring, whose contact lasts dt.",
}


def page() -> str:
    """The whole page. Raises KeyError where a scene observes what there are no words for."""
    return "\n".join([OPENING, *(line for name in SCENES for line in _scene(name))]) + "\n"


def _scene(name: str) -> Iterator[str]:
    scene, found = SCENES[name], run(name, {})
    yield f"## `{name}`\n"
    note = f" {NOTES[name]}" if name in NOTES else ""
    yield f"{scene.meaning[0].upper()}{scene.meaning[1:]}.{note}\n"
    yield from table(("setting", "what it is", "unit", "default", "takes"), map(_setting, scene.settings))
    words = OBSERVED[name]
    if strange := found.measured.keys() - words.keys():
        raise KeyError(f"{name} observes {', '.join(sorted(strange))}: say in OBSERVED what it is.")
    yield from table(
        ("observed", "what it is", "error"), ((f"`{n}`", w, _error(found, n)) for n, w in words.items())
    )


def _setting(setting: Setting) -> tuple[str, ...]:
    usual = ", ".join(f"{x:.6g}" for x in components(setting.value))
    return f"`{setting.name}`", setting.meaning, setting.unit, usual or "none", setting.takes or "any number"


def _error(found: Run, name: str) -> str:
    return found.measured[name].error_is if name in found.measured else "–"


if __name__ == "__main__":
    sys.exit(written("ready_scenes.md", page(), sys.argv[1:]))
