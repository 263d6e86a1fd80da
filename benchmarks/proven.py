"""What proven bounds cost, how narrow they are, and where they cannot be had; writes benchmarks/results/proven.md.

python benchmarks/proven.py
"""

from __future__ import annotations

import time
from pathlib import Path

from corollary.scenes.catalogue import run
from corollary.scenes.run import BadSetting, GuardFailed, Run, components

RESULTS = Path(__file__).parent / "results" / "proven.md"
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


def timed(scene: str, settings: dict[str, object], *, proven: bool) -> tuple[Run, float]:
    begin = time.process_time()
    found = run(scene, settings, proven=proven)
    return found, time.process_time() - begin


def row(label: str, scene: str, settings: dict[str, object]) -> str:
    """One line: times with an estimate and with a bound, the widest bound over the value's size, the estimate against what is proven."""
    run(scene, settings, 1e-9)  # what is loaded and compiled once counts for nobody
    usual, quick = timed(scene, settings, proven=False)
    begin = time.process_time()
    try:
        proven, slow = timed(scene, settings, proven=True)
    except (BadSetting, GuardFailed) as refused:
        return f"| {label} | {quick * 1e3:.1f} | {time.process_time() - begin:.2f} | refused: {refused} | |"
    widest = max(
        (error / each.size for each in proven.measured.values() for error in components(each.error)),
        default=0.0,
    )
    ratio = max(
        abs(x - y) / (error or 5e-324)
        for name, each in proven.measured.items()
        for x, y, error in zip(
            components(each.value),
            components(usual.observed[name]),
            components(usual.errors[name]),
            strict=True,
        )
    )
    return f"| {label} | {quick * 1e3:.1f} | {slow:.2f} | {widest:.1e} | {ratio:.2g} |"


def main() -> None:
    lines = [
        "# Proven bounds: what they cost",
        "",
        "`python benchmarks/proven.py`: processor time of one run as usual (tolerance 1e-12, an estimate) and of one with `--proven`, the",
        "widest bound as a share of its value's size (a double is known to 1.1e-16), and the true error of the usual run over the one it states.",
        "",
        "| contact | usual, ms | proven, s | widest bound | usual: true/stated |",
        "| --- | ---: | ---: | ---: | ---: |",
    ]
    for label, scene, settings in MEASURED:
        lines.append(row(label, scene, dict(settings)))
        print(lines[-1], flush=True)
        RESULTS.write_text("\n".join([*lines, ""]), encoding="utf-8")


if __name__ == "__main__":
    main()
