"""How long ready scenes take to answer or to refuse over their range, as `corollary scene` is waited for at a terminal.

    python benchmarks/scene_times.py [--draws 20] [--seconds 30] [--scene NAME] [--write]

Every scene with its own settings, with draws of benchmarks/calibration.py, and with each setting moved by up to 1, 3, 12 or 300 powers of
ten, in one process: so many of each kind, for so many seconds a scene at most. `--write` writes benchmarks/results/scene_times.md. Times
are the processor's; the bar is looked for on what the terminal was shown.
"""

from __future__ import annotations

import argparse
import io
import random
import statistics
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))

from calibration import FAMILIES

from corollary.cli import scene as command
from corollary.cli.ending import HOLDS
from corollary.derive.ready_scenes import ready_scenes
from corollary.scenes.definition import Setting
from corollary.scenes.run import BadSetting

SCENES = ready_scenes()

RESULTS = Path(__file__).parent / "results" / "scene_times.md"
TOLERANCE = 1e-12  # the command's own
SPREADS = 1.0, 3.0, 12.0, 300.0
LONG = 1.0


class Terminal(io.StringIO):
    """What a person at a terminal is shown, and when the first of it."""

    first: float | None = None

    def isatty(self) -> bool:
        return True

    def write(self, s: str, /) -> int:
        if self.first is None:
            self.first = time.perf_counter()
        return super().write(s)


@dataclass(frozen=True, slots=True)
class Asked:
    """`shown` is after how many seconds of the clock a bar was there, none if there was none; `lasted` until when."""

    options: tuple[str, ...]
    seconds: float
    answered: bool
    shown: float | None
    lasted: float


def asked(scene: str, options: Sequence[str]) -> Asked:
    terminal = Terminal()
    begin, clock = time.thread_time(), time.perf_counter()
    with redirect_stderr(terminal), redirect_stdout(io.StringIO()):
        try:
            answered = command.run(scene, list(options), TOLERANCE, explained=False, as_json=True) == HOLDS
            # A refusal is said where the bar was: that is no bar.
            silent = not answered and terminal.getvalue().startswith("corollary: ")
        except BadSetting:
            answered, silent = False, not terminal.getvalue()
    seconds, lasted = time.thread_time() - begin, time.perf_counter() - clock
    shown = None if silent or terminal.first is None else terminal.first - clock
    return Asked(tuple(options), seconds, answered, shown, lasted)


def options(given: dict[str, Any]) -> list[str]:
    """Settings as they are typed."""
    return [
        f"{name}={','.join(map(repr, value)) if isinstance(value, tuple) else repr(value)}"
        for name, value in given.items()
        if value != ()
    ]


def moved(scene: str, rng: random.Random, spread: float) -> dict[str, Any]:
    """Settings at random powers of ten about their own values (those of zero about one), three in five of them."""
    given: dict[str, Any] = {}
    for setting in SCENES[scene].settings:
        if rng.random() < 0.4:
            continue
        own = setting.value
        if own == ():
            count = int(given.get("N", 3.0))
            given[setting.name] = tuple(_near(setting, 0.1, rng, spread) for _ in range(count))
        elif isinstance(own, tuple):
            given[setting.name] = tuple(_near(setting, x, rng, spread) for x in own)
        else:
            given[setting.name] = _near(setting, own, rng, spread)
    return given


def _near(setting: Setting, own: float, rng: random.Random, spread: float) -> float:
    power = rng.uniform(-spread, spread)
    if setting.whole:  # anything that there can be
        most = min(setting.most, 1e6)
        return float(round(max(setting.least, min(most, (own or 1.0) * 10.0 ** min(power, 6.0)))))
    return min(max((own or 1.0) * 10.0 ** max(min(power, 307.0), -320.0), setting.least), setting.most)


def draws(scene: str, count: int) -> Iterator[list[str]]:
    """The same every time: one of each kind after the other."""
    yield []
    families = [family for family in FAMILIES if family.scene == scene and not family.second_way]
    for number in range(count):
        for family in families:
            yield options(family.draw(random.Random(f"{family.name} {number}")))
        for spread in SPREADS:
            yield options(moved(scene, random.Random(f"{scene} {spread} {number}"), spread))


def timed(scene: str, count: int, seconds: float) -> list[Asked]:
    command.run(scene, [], TOLERANCE, explained=False, as_json=True)  # modules and caches
    found: list[Asked] = []
    spent = 0.0
    for each in draws(scene, count):
        found.append(asked(scene, each))
        spent += found[-1].seconds
        if spent > seconds:
            break
    return found


def table(seen: dict[str, list[Asked]]) -> str:
    lines = [
        "# How long ready scenes are waited for",
        "",
        "Seconds of the processor for `corollary scene NAME` with its conditions, warm, at the tolerance 1e-12; `python "
        "benchmarks/scene_times.py --write`.",
        "Settings are a scene's own, drawn as for its calibration, and moved by up to 300 powers of ten. The slowest are the slowest of "
        "these: rarer settings take longer.",
        "",
        "| scene | answered | refused | median answer | slowest answer | slowest refusal | over 1 s, with a bar | without |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for scene, found in seen.items():
        answers, refusals = (
            [each.seconds for each in found if each.answered is kind] for kind in (True, False)
        )
        bars = [each.shown is not None for each in found if each.seconds > LONG]
        lines.append(
            f"| {scene} | {len(answers)} | {len(refusals)} | {statistics.median(answers):.3f} | {max(answers):.2f} "
            f"| {max(refusals, default=0.0):.2f} | {sum(bars)} | {len(bars) - sum(bars)} |"
        )
    every = [each for found in seen.values() for each in found]
    late = [each.shown for each in every if each.shown is not None]
    lines += ["", f"{len(every)} asked; the latest bar after {max(late, default=0.0):.2f} s of the clock."]
    return "\n".join([*lines, ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--draws", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--scene", choices=list(SCENES))
    parser.add_argument("--write", action="store_true")
    chosen = parser.parse_args()
    seen: dict[str, list[Asked]] = {}
    for scene in SCENES:
        if chosen.scene in (None, scene):
            with redirect_stdout(io.StringIO()):
                seen[scene] = timed(scene, chosen.draws, chosen.seconds)
    print(table(seen))
    for scene, found in seen.items():
        for each in sorted(found, key=lambda each: -each.seconds)[:5]:
            if each.seconds > LONG:
                verb = "answers" if each.answered else "refuses"
                words = " ".join(f"--set {option}" for option in each.options)
                print(f"{verb} after {each.seconds:.1f} s: corollary scene {scene} {words:.300}")
    if chosen.write:
        RESULTS.write_text(table(seen), encoding="utf-8")


if __name__ == "__main__":
    main()
