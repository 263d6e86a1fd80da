"""What proven bounds cost, how narrow they are, and where they cannot be had; writes benchmarks/results/proven.md.

    python benchmarks/proven.py [--draws 40] [--seconds 500]

Besides the contacts that are named, so many of every kind are drawn at random. What is known of them already (proven.json beside the
table) is kept, so that the whole can be done in pieces of so many `--seconds`.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from collections.abc import Callable
from pathlib import Path
from random import Random
from statistics import median
from typing import Any

from corollary.scenes.catalogue import run
from corollary.scenes.run import BadSetting, GuardFailed, Run, components

RESULTS = Path(__file__).parent / "results" / "proven.md"
DRAWN = RESULTS.with_suffix(".json")
EXPONENTS = (1.0, 1.25, 1.5, 2.0, 2.7, 3.0)
MEASURED = (
    ("pair, q = 1, damped", "spheres", {"q": 1.0, "k": 1e4}),
    ("pair, q = 3/2, damped", "spheres", {}),
    ("pair, q = 3/2, damped, all but missed (b/D = 0.999998)", "spheres", {"eta": 0.1, "dy": 0.0399999}),
    ("pair, q = 3/2, from inside the contact", "spheres", {"dx": 0.03, "dy": 0.02, "vA": (0.3, 0.0)}),
    ("ball on a floor, q = 3/2, weight, damped", "ball_on_floor", {"eta": 3.0}),
    ("row of 3, q = 1", "cradle", {"N": 3.0, "q": 1.0}),
    ("row of 3, q = 3/2", "cradle", {"N": 3.0, "q": 1.5}),
    ("row of 3, q = 1.3", "cradle", {"N": 3.0, "q": 1.3}),
    ("row of 3, q = 3/2, gaps", "cradle", {"N": 3.0, "q": 1.5, "gaps": 1e-4}),
    (
        "row of 3, q = 3/2, middle ball a tenth",
        "cradle",
        {"N": 3.0, "q": 1.5, "masses": (0.1, 0.01, 0.1)},
    ),
    (
        "row of 3, q = 3/2, middle ball a hundredth",
        "cradle",
        {"N": 3.0, "q": 1.5, "masses": (0.1, 0.001, 0.1)},
    ),
    ("row of 5, q = 3/2", "cradle", {"N": 5.0, "q": 1.5}),
    ("row of 6, q = 3/2", "cradle", {"N": 6.0, "q": 1.5}),
    ("pair, damping above critical", "spheres", {"eta": 20.0}),
    ("two balls dropped on a floor", "super_ball", {}),
)


def pair(rng: Random) -> dict[str, Any]:
    """Two spheres from head-on to all but missed, damped by anything below what keeps them together."""
    ma, mb, q = 10 ** rng.uniform(-2, 0), 10 ** rng.uniform(-2, 0), rng.choice(EXPONENTS)
    speed, k = 10 ** rng.uniform(-0.5, 0.5), 10 ** rng.uniform(3.7, 4.3) * 0.002 ** (1.5 - q)
    share = rng.choice([rng.uniform(-0.98, 0.98), 1.0 - 10 ** rng.uniform(-6, -2)])
    mass = ma * mb / (ma + mb)
    # The damping that swallows the motion, for a contact about as deep as this one gets.
    deep = (mass * speed**2 / k) ** (1.0 / (q + 1.0))
    eta = 10 ** rng.uniform(-4, -0.3) * math.sqrt(mass * k * deep ** (q - 1.0))
    given = {"mA": ma, "mB": mb, "q": q, "k": k, "dx": 0.1, "dy": 0.04 * share, "vA": (speed, 0.0)}
    return given | {"eta": eta}


def inside(rng: Random) -> dict[str, Any]:
    """Two spheres that overlap at the start."""
    given = {"eta": 0.0, "q": rng.choice(EXPONENTS), "vA": (rng.uniform(-0.5, 0.5), 0.0), "k": 2e4}
    given["k"] *= 0.002 ** (1.5 - given["q"])
    return given | {"dx": rng.uniform(0.035, 0.039), "dy": rng.uniform(0.0, 0.005)}


def ball(rng: Random) -> dict[str, Any]:
    """A damped ball on a floor, with weight or without."""
    m, v, q = 10 ** rng.uniform(-2, 1), 10 ** rng.uniform(-1, 1), rng.choice(EXPONENTS)
    k = 10 ** rng.uniform(4, 8)
    deep = (m * v**2 / k) ** (1.0 / (q + 1.0))
    eta = 10 ** rng.uniform(-4, -0.3) * math.sqrt(m * k * deep ** (q - 1.0))
    given = {"m": m, "k": k, "v0": -v, "q": q, "R": 1.0, "y0": 1.0, "eta": eta}
    return given | {"g": rng.choice([0.0, 9.8])}


def three(rng: Random) -> dict[str, Any]:
    """Three balls, none more than twenty times lighter than its neighbours."""
    masses = tuple(0.1 * 10 ** rng.uniform(-0.6, 0.6) for _ in range(3))
    gaps = rng.choice([0.0, 10 ** rng.uniform(-6, -3), (0.0, 1e-4)])
    return {"N": 3.0, "masses": masses, "q": rng.choice(EXPONENTS), "gaps": gaps}


def more(rng: Random) -> dict[str, Any]:
    """Four to six balls, one or more of which come in."""
    count = rng.choice([4, 4, 5, 6])
    masses = tuple(0.1 * 10 ** rng.uniform(-0.3, 0.3) for _ in range(count))
    given = {"N": float(count), "masses": rng.choice([(), masses]), "q": rng.choice(EXPONENTS)}
    return given | {"balls_in": float(rng.randint(1, count - 1)), "gaps": rng.choice([0.0, 1e-4])}


KINDS: dict[str, tuple[str, Callable[[Random], dict[str, Any]]]] = {
    "pair, damped": ("spheres", pair),
    "pair, from inside the contact": ("spheres", inside),
    "ball on a floor, damped": ("ball_on_floor", ball),
    "row of 3": ("cradle", three),
    "row of 4 to 6": ("cradle", more),
}


def timed(scene: str, settings: dict[str, object], *, proven: bool) -> tuple[Run, float]:
    begin = time.process_time()
    found = run(scene, settings, proven=proven)
    return found, time.process_time() - begin


def compared(scene: str, settings: dict[str, Any]) -> dict[str, Any]:
    """Times with an estimate and with a bound, the widest bound over the value's size, the estimate's error as proven over the stated one."""
    run(scene, settings, 1e-9)  # what is loaded and compiled once counts for nobody
    usual, quick = timed(scene, settings, proven=False)
    found: dict[str, Any] = {"settings": settings, "quick": quick}
    begin = time.process_time()
    try:
        proven, slow = timed(scene, settings, proven=True)
    except (BadSetting, GuardFailed) as refused:
        return found | {"slow": time.process_time() - begin, "refused": str(refused)}
    widest = max(
        (error / each.size for each in proven.measured.values() for error in components(each.error) if error),
        default=0.0,
    )
    ratio = max(
        (abs(x - y) - bound) / (error or 5e-324)
        for name, each in proven.measured.items()
        for x, y, error, bound in zip(
            components(each.value),
            components(usual.observed[name]),
            components(usual.errors[name]),
            components(each.error),
            strict=True,
        )
    )
    return found | {"slow": slow, "widest": widest, "ratio": max(ratio, 0.0)}


def row(label: str, found: dict[str, Any]) -> str:
    quick = f"| {label} | {found['quick'] * 1e3:.1f} | {found['slow']:.2f} |"
    if "refused" in found:
        return f"{quick} refused: {found['refused']} | |"
    return f"{quick} {found['widest']:.1e} | {found['ratio']:.2g} |"


def summary(kind: str, drawn: list[dict[str, Any]]) -> str:
    """One line for a kind: how many, how many were enclosed, the median and longest time, the widest bound, the worst ratio."""
    held = [each for each in drawn if "refused" not in each]
    if not held:
        return f"| {kind} | {len(drawn)} | 0 | | | | |"
    seconds = [each["slow"] for each in held]
    widest, worst = (max(each[name] for each in held) for name in ("widest", "ratio"))
    return f"| {kind} | {len(drawn)} | {len(held)} | {median(seconds):.1f} | {max(seconds):.1f} | {widest:.1e} | {worst:.2g} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--draws", type=int, default=40)
    parser.add_argument("--seconds", type=float, default=math.inf)
    asked = parser.parse_args()
    known: dict[str, list[dict[str, Any]]] = (
        json.loads(DRAWN.read_text(encoding="utf-8")) if DRAWN.exists() else {}
    )
    begin = time.monotonic()
    for n in range(asked.draws):
        for kind, (scene, draw) in KINDS.items():
            drawn = known.setdefault(kind, [])
            if len(drawn) <= n and time.monotonic() - begin < asked.seconds:
                drawn.append(compared(scene, draw(Random(f"{kind} {n}"))))
                print(kind, n, summary(kind, drawn), flush=True)
                DRAWN.write_text(json.dumps(known, indent=1) + "\n", encoding="utf-8")
    lines = [
        "# Proven bounds: what they cost",
        "",
        "`python benchmarks/proven.py`: processor time of one run as usual (tolerance 1e-12, an estimate) and of one with `--proven`, the",
        "widest bound as a share of its value's size (a double is known to 1.1e-16), and the true error of the usual run over the one it states.",
        "",
        "| contact | usual, ms | proven, s | widest bound | usual: true/stated |",
        "| --- | ---: | ---: | ---: | ---: |",
    ]
    lines += [row(label, compared(scene, dict(settings))) for label, scene, settings in MEASURED]
    lines += [
        "",
        "Drawn at random: masses, exponent (1 to 3), stiffness, damping below what keeps them together, gaps, how squarely they meet.",
        "",
        "| kind | drawn | enclosed | median, s | longest, s | widest bound | usual: true/stated |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    lines += [summary(kind, drawn) for kind, drawn in known.items()]
    reasons = sorted({each["refused"] for drawn in known.values() for each in drawn if "refused" in each})
    lines += ["", *(f"Refused: {reason}" for reason in reasons)] if reasons else []
    RESULTS.write_text("\n".join([*lines, ""]), encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
