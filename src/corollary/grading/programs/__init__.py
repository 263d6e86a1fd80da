"""Students' programs and figures, one family a file: what a function is called with, how what it returns is judged, usual bugs.

`FAMILIES` lists what solutions may use of each; `corollary.author` offers all of it.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

FAMILIES = {
    "catch": ("catch_inputs", "judge_catch"),
    "floor": ("bounce_inputs", "judge_bounce"),
    "floor_figure": ("judge_bounce_plot",),
    "ions": ("ion_inputs", "judge_ions"),
    "orbit": ("orbit_inputs", "judge_orbit"),
    "orbit_figure": ("judge_orbit_plot", "judge_potential_plot"),
    "row": ("cradle_inputs", "judge_cradle", "judge_contact"),
    "row_figure": ("judge_velocity_plot",),
    "spheres": ("sphere_inputs", "judge_spheres"),
    "spheres_figure": ("judge_spheres_plot",),
}


def member(name: str) -> Callable[..., Any] | None:
    """What a family offers under this name, imported when it is first called: families bring the scenes, which take a while."""
    family = next((family for family, names in FAMILIES.items() if name in names), None)
    if family is None:
        return None

    def call(*given: Any, **named: Any) -> Any:
        return getattr(import_module(f"{__name__}.{family}"), name)(*given, **named)

    call.__name__ = name
    return call
