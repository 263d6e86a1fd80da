"""`corollary scene`: a ready-made scene, played."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from corollary.cli.ending import FAILS, HOLDS, answer, refuse, say
from corollary.cli.given_values import from_options
from corollary.derive.ready_scenes import definition, play, ready_scenes
from corollary.grading.from_json import finite
from corollary.problem.bank import Bank, open_bank
from corollary.scenes.run import GuardFailed, Observed, components

FORM = "name=number, such as q=1.5, or masses=0.1,0.2,0.1"


def run(
    name: str | None,
    settings: list[str],
    tolerance: float,
    explained: bool,
    bank: Path | None,
    as_json: bool,
) -> int:
    place = open_bank(bank)
    if name is None:
        if settings or explained:
            refuse("name a scene; without a name this lists all there are")
        return _list(place, as_json)
    if explained:
        if settings:
            refuse("--settings only lists what the scene takes; leave out --set")
        return _explain(place, name, as_json)
    chosen = _chosen(settings)
    begin = time.perf_counter()
    try:
        found = play(name, chosen, tolerance, bank=place)
    except GuardFailed as error:
        say(f"corollary: {error}")
        return FAILS
    if as_json:
        answer(
            {
                "scene": found.scene,
                "set": {name: _number_or_row(value) for name, value in found.settings.items()},
                "observed": {name: _number_or_row(value) for name, value in found.observed.items()},
                "errors": {name: _number_or_row(error) for name, error in found.errors.items()},
                "error_is": found.error_is,
                "errors_are": {name: each.error_is for name, each in found.measured.items()},
                "error": finite(found.error),
                "models": {name: each.model for name, each in found.measured.items()},
                "conditions": {
                    name: finite(each.condition)
                    for name, each in found.measured.items()
                    if each.condition is not None
                },
                "warnings": list(found.warnings),
                "model": found.model,
                "why": found.why,
                "evaluations": found.evaluations,
                "seconds": found.seconds,
                "outcome": found.outcome,
            }
        )
        return HOLDS
    print(f"{found.scene}: {found.outcome}, by {found.model}: {found.why}")
    for observed, each in found.measured.items():
        values = ", ".join(f"{x:.12g}" for x in components(each.value))
        error, sign = max(components(each.error), default=0.0), "<=" if each.error_is == "bound" else "~"
        print(f"  {observed:18} {values}   error {sign} {error:.1e}")
    for warning in found.warnings:
        print(f"  note: {warning}")
    waited = time.perf_counter() - begin
    print(
        f"  {found.evaluations} evaluations, {found.seconds * 1e3:.1f} ms; {waited * 1e3:.1f} ms with the runs that tell what hangs on the settings"
    )
    return HOLDS


def _list(bank: Bank, as_json: bool) -> int:
    meanings = {name: scene.meaning for name, scene in ready_scenes(bank).items()}
    if as_json:
        answer([{"scene": name, "meaning": meaning} for name, meaning in meanings.items()])
        return HOLDS
    for name, meaning in meanings.items():
        print(f"{name:20}{meaning}")
    print("\ncorollary scene NAME --settings tells what one takes")
    return HOLDS


def _explain(bank: Bank, name: str, as_json: bool) -> int:
    """Every setting of a scene: what it means, its unit, the value it has when nothing is said, and what it must be."""
    scene = definition(name, bank)
    if as_json:
        settings = [
            {
                "name": each.name,
                "meaning": each.meaning,
                "unit": each.unit,
                "default": _number_or_row(each.value),
                "takes": each.takes,
            }
            for each in scene.settings
        ]
        answer({"scene": name, "meaning": scene.meaning, "settings": settings})
        return HOLDS
    print(f"{name}: {scene.meaning}")
    for each in scene.settings:
        unit = "" if each.unit == "1" else f" {each.unit}"
        usual = ",".join(f"{x:.6g}" for x in components(each.value))
        usual = f" = {usual}{unit}" if usual else f" [{each.unit}]"
        print(f"  {each.name + usual:28} {each.meaning}{f' ({each.takes})' if each.takes else ''}")
    return HOLDS


def _chosen(options: list[str]) -> dict[str, float | tuple[float, ...]]:
    return {name: _numbers(name, text) for name, text in from_options(options, FORM).items()}


def _numbers(name: str, text: str) -> float | tuple[float, ...]:
    try:
        numbers = tuple(float(each) for each in text.strip("[]() ").split(",") if each.strip())
    except ValueError:
        numbers = ()
    # Python reads 1_5 as fifteen, and figures of every script; who types such a thing has slipped.
    if not numbers or "_" in text or not text.isascii():
        refuse(f"--set {name}={text}: write it as {FORM}")
    return numbers if "," in text else numbers[0]


def _number_or_row(value: Observed) -> Any:
    """A value as JSON has it: a number, or a list of them; one that is not finite as text."""
    return [finite(float(each)) for each in value] if isinstance(value, tuple) else finite(float(value))
