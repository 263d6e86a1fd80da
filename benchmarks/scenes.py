"""Scenes raced in one run: the planned route against the chapter's loop, scipy and heyoka at equal error.

python benchmarks/scenes.py [--error 1e-9] [--json] [--speed]

Times are the processor's, best of several, so only ratios within one run mean anything. heyoka and numba are optional: what is
missing is left out, with the reason. Compilation is never counted.

The planned route is timed in four ways: `steps` is one run that keeps the error, as for every other method; `asked` is what a
user gets who asks for the scene at that tolerance, its error found by a second, finer run; `again` is the same asked once more,
which is only looked up; `compiled` is the one run in compiled steps.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table
from trade import cradles, solvers, spheres, taylor
from trade.case import Answer, Case, Program, Reference, error_of
from trade.race import PLANNED
from trade.references import SPHERES, SPHERES_DAMPED

from corollary.scenes.catalogue import run
from corollary.scenes.collision import collide

REFERENCES = Path(__file__).resolve().parent.parent / "tests" / "scenes" / "references.json"
LONGEST = 60_000
TARGETS = {
    "steps": {"book loop": 50.0, "book arrays": 50.0, "DOP853, events": 1.0},
    "compiled": {"book loop": 1000.0, "book arrays": 1000.0, "DOP853, events": 40.0},
}


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--error", type=float, default=1e-9, help="the error at which methods are compared")
    options.add_argument("--json", action="store_true", help="one JSON document instead of tables")
    options.add_argument(
        "--speed", action="store_true", help="instead: rows and pairs beside what is written by hand"
    )
    asked = options.parse_args()
    if asked.speed:
        beside_what_is_written_by_hand()
        return
    rows = [compared(case, asked.error) for case in cases()]
    result = {
        "error": asked.error,
        "scenes": rows,
        "momentum": momentum(),
    }
    if asked.json:
        print(json.dumps(result))
    else:
        show(result)


def beside_what_is_written_by_hand() -> None:
    """Writes the table of `speed`; the loop in lists is continued by its order, as everywhere here."""
    import speed  # numba is for this only

    def lists(count: int, wanted: float, truth: Any) -> float:
        reference = Reference(tuple(truth), 14, "the finest steps")
        return book_loop(cradles.case(count, speed.Q, reference), wanted)["seconds"]

    speed.RESULTS.write_text(speed.report(timed, lists), encoding="utf-8")


def cases() -> list[Case]:
    known = json.loads(REFERENCES.read_text(encoding="utf-8"))
    rows = [
        cradles.case(count, q, Reference(tuple(known[f"{count} {q:g}"]), 18, "tests/scenes/references.json"))
        for count in (3, 5)
        for q in (1.0, 1.5, 3.0)
    ]
    return [*rows, spheres.case(0.0, SPHERES), spheres.case(1.0, SPHERES_DAMPED)]


def compared(case: Case, wanted: float) -> dict[str, Any]:
    """The cheapest run of each method that keeps the error, as a multiple of the planned route's time."""
    planned = PLANNED[run(case.ready, case.settings).model]
    bought = solvers.routes(case)
    times = {"planned": cheapest(case, case.own[planned].run, case.own[planned].settings, wanted)}
    times["book loop"] = book_loop(case, wanted)
    slower = timed(lambda: book_arrays(case.program, 1000), 0.02) / timed(
        lambda: book(case.program, 1000), 0.02
    )
    times["book arrays"] = times["book loop"] | {"seconds": slower * times["book loop"]["seconds"]}
    for label, name in (
        ("DOP853", "scipy_dop853"),
        ("LSODA", "scipy_lsoda"),
        ("DOP853, events", "scipy_dop853_events"),
    ):
        times[label] = cheapest(case, bought[name].run, bought[name].settings, wanted) if bought else None
    times["heyoka"], reason = series(case)
    base = times["planned"]
    assert base is not None
    own = {
        "steps": base["seconds"],
        "asked": timed(lambda: asked(case, wanted)),
        "again": timed(lambda: again(case, wanted)),
    }
    if (compiled := case.own.get("regularised_compiled")) and (
        found := cheapest(case, compiled.run, compiled.settings, wanted)
    ):
        own["compiled"] = found["seconds"]
    return {
        "scene": case.name,
        "planned": planned,
        "milliseconds": 1e3 * base["seconds"],
        "error": base["error"],
        "own": own,
        "methods": {name: found for name, found in times.items() if found},
        "ratios": {
            name: found["seconds"] / base["seconds"]
            for name, found in times.items()
            if found and name != "planned"
        },
        "heyoka": reason,
    }


def asked(case: Case, wanted: float) -> None:
    """What a user asks for, as if for the first time."""
    collide.cache_clear()
    again(case, wanted)


def again(case: Case, wanted: float) -> None:
    run(case.ready, case.settings, wanted)


def cheapest(
    case: Case, route: Callable[[float], Answer], settings: tuple[float, ...], wanted: float
) -> dict[str, Any] | None:
    """The first setting, from the coarsest, from which on every run keeps the error."""
    good = None
    for setting in reversed(settings):
        answer = route(setting)
        if error_of(case, answer) > wanted:
            break
        good = setting, answer
    if good is None:
        return None
    setting, answer = good
    return {
        "seconds": timed(lambda: route(setting)),
        "evaluations": answer.evaluations,
        "error": error_of(case, answer),
    }


def timed(call: Callable[[], object], least: float = 0.05) -> float:
    """The least processor time of one call, over three calls or more."""
    call()
    best, spent, count = math.inf, 0.0, 0
    while count < 3 or (spent < least and count < 50):
        begin = time.thread_time()
        call()
        taken = time.thread_time() - begin
        best, spent, count = min(best, taken), spent + taken, count + 1
    return best


def book(program: Program, steps: int) -> Answer:
    """The chapter's program: Euler-Cromer in a plain loop."""
    x, v, dt = list(program.x), list(program.v), program.until / steps
    for _ in range(steps):
        a = program.acceleration(x, v)
        for i in range(len(x)):
            v[i] += a[i] * dt
            x[i] += v[i] * dt
    return Answer(program.read(x, v), steps)


def book_arrays(program: Program, steps: int) -> Answer:
    """The same as the chapter writes it: every time a row of an array."""
    x, v, dt = (
        np.zeros((steps + 1, len(program.x))),
        np.zeros((steps + 1, len(program.x))),
        program.until / steps,
    )
    x[0], v[0] = program.x, program.v
    for i in range(steps):
        a = np.array(program.acceleration(x[i], v[i]))
        v[i + 1] = v[i] + a * dt
        x[i + 1] = x[i] + v[i + 1] * dt
    return Answer(program.read(x[-1].tolist(), v[-1].tolist()), steps)


def book_loop(case: Case, wanted: float) -> dict[str, Any]:
    """Steps doubled until the error is kept; where that takes too long, continued by the order of the last runs."""
    steps, errors = 500, []
    while steps <= LONGEST:
        # Neighbouring step counts average out where the touch falls between two steps.
        errors.append(
            (steps, math.sqrt(sum(error_of(case, book(case.program, steps + i)) ** 2 for i in (0, 1, 3)) / 3))
        )
        if errors[-1][1] <= wanted:
            break
        steps *= 2
    (n, last), (first_n, first) = errors[-1], errors[max(len(errors) - 4, 0)]
    each = timed(lambda: book(case.program, 2000), 0.02) / 2000
    if last <= wanted:
        return {"seconds": each * n, "evaluations": n, "error": last, "extrapolated": False}
    order = math.log(first / last) / math.log(n / first_n)
    needed = n * (last / wanted) ** (1.0 / order)
    return {
        "seconds": each * needed,
        "evaluations": round(needed),
        "error": wanted,
        "extrapolated": True,
        "order": order,
    }


def series(case: Case) -> tuple[dict[str, Any] | None, str]:
    """heyoka, compiled before it is timed; and why not, where it cannot."""
    try:
        route = taylor.route(case)
    except taylor.NoSeries as reason:
        return None, str(reason)
    answer = route.run(route.settings[0])
    seconds = timed(lambda: route.run(route.settings[0]))
    return {
        "seconds": seconds,
        "evaluations": answer.evaluations,
        "error": error_of(case, answer),
    }, "terminal events"


def momentum() -> float:
    """The largest relative change of momentum over cradles of every size and exponent, and the spheres."""
    lost = []
    for count in (2, 3, 5, 10):
        for q in (1.0, 1.5, 3.0, 5.0):
            velocities = run("cradle", {"N": count, "q": q}).observed["velocities"]
            assert isinstance(velocities, tuple)
            lost.append(abs(math.fsum(velocities) - 1.0))
    for eta in (0.0, 1.0, 5.0):
        ax, ay, bx, by = run("spheres", {"eta": eta}).observed["velocities"]  # pyright: ignore[reportGeneralTypeIssues]
        lost += [abs(ax + bx - 1.0), abs(ay + by)]
    return max(lost)


def gain(row: dict[str, Any], way: str, other: str) -> float:
    """How many times as fast as another method the planned route is, timed in one of its ways."""
    return row["ratios"][other] * row["own"]["steps"] / row["own"][way]


def own_times(rows: list[dict[str, Any]]) -> Table:
    table = Table(
        title="The planned route four ways: milliseconds, and times as fast as plain loop | chapter's arrays | DOP853 and events"
    )
    for heading in ("scene", "steps", "asked", "again", "compiled"):
        table.add_column(heading, justify="left" if heading == "scene" else "right")
    for row in rows:
        cells = []
        for way in ("steps", "asked", "again", "compiled"):
            others = (
                other for other in ("book loop", "book arrays", "DOP853, events") if other in row["ratios"]
            )
            gains = (
                " | ".join(f"{gain(row, way, other):.3g}" for other in others) if way in row["own"] else ""
            )
            cells.append(f"{1e3 * row['own'][way]:.3f}: {gains}" if gains else "")
        table.add_row(row["scene"], *cells)
    return table


def show(result: dict[str, Any]) -> None:
    console = Console(width=190)
    names = ("book loop", "book arrays", "DOP853", "LSODA", "DOP853, events", "heyoka")
    table = Table(
        title=f"Time at an error of {result['error']:g}, as a multiple of the planned route's (pure Python)"
    )
    for heading in ("scene", "planned", "ms", "its error", *names):
        table.add_column(heading, justify="left" if heading in {"scene", "planned"} else "right")
    for row in result["scenes"]:
        cells = []
        for name in names:
            mark = "*" if row["methods"].get(name, {}).get("extrapolated") else ""
            cells.append(f"{row['ratios'][name]:.3g}{mark}" if name in row["ratios"] else "")
        table.add_row(
            row["scene"], row["planned"], f"{row['milliseconds']:.2f}", f"{row['error']:.0e}", *cells
        )
    console.print(table)
    console.print("* continued by the measured order from the longest run")
    for row in result["scenes"]:
        if "heyoka" not in row["ratios"]:
            console.print(f"heyoka on {row['scene']}: {row['heyoka']}")
    console.print(own_times(result["scenes"]))
    for way, targets in TARGETS.items():
        for target, least in targets.items():
            faster = [
                gain(row, way, target)
                for row in result["scenes"]
                if way in row["own"] and target in row["ratios"]
            ]
            met = sum(times >= least for times in faster)
            console.print(
                f"{way}: at least {least:g} times as fast as {target}: {met} of {len(faster)} scenes"
            )
    console.print(f"momentum kept to {result['momentum']:.1e} of itself")


if __name__ == "__main__":
    main()
