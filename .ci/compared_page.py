"""Writes docs/compared.md: which typed answers six systems and Corollary take for right, features, and speed, from benchmarks/compared.

`python .ci/compared_page.py` writes it, `--check` says whether it is up to date (a test asks). What the others make of an answer is
data, with versions and sources; what Corollary makes of it is found by having it read and judged.
"""

from __future__ import annotations

import csv
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from reference_page import table, written

import corollary
from corollary.answers.read_case import read_case
from corollary.answers.verdict import Unread

DATA = Path(__file__).parents[1] / "benchmarks" / "compared"
OTHERS = ("edX", "PrairieLearn", "Numbas", "WeBWorK", "Moodle", "STACK")
MARKED = ("X12.5", "a")  # m v = 0.43 kg · 20 m/s: where a number with its unit is typed
KNOWN = {"right", "wrong", "refused", "asked", "by setting", "penalty", "no units", "not known"}
OPENING = """\
# Compared with other systems

For whoever chooses a system, or has one. Made by `python .ci/compared_page.py` from the data in `benchmarks/compared`; the column
*Corollary* is not data: the command has each answer read and judged.
"""
TYPED = """\
## Typed answers

A right answer counts only if it is read. We chose the answers: forms that students type, and wrong ones that must not count.

| outcome | means |
|---|---|
| right | full marks |
| by setting | full marks with another setting of the question, by default not |
| asked | the student is shown what it may mean, and types it again |
| refused | not taken; the student may type it again |
| penalty | the number counts, the unit is not known: the author's penalty for units is taken off |
| wrong | no marks |
| no units | the field takes a number alone |
| not known | not established: nobody ran it, and no source says so |
"""
FORMULAS = """\
### A formula

Letters are positive. The functions are typed as each system spells them (`arcsin`, `asin`). Moodle has no question for formulas.
"""
SOURCES = """\
### Versions and settings

*Run* means that the system's own code read the answers, at the version named, outside of its server. *Not known* stands where it was
not run.
"""
FEATURES = """\
## Features

*None found* means: none in the documentation and code that were read, at the versions above; edX stands for the MITx Grading
Library. *In part* means by an author's own code, or less. Moodle without a plug-in was not looked through.
"""
SPEED = """\
## Speed

One run of `python benchmarks/grading.py --otter PATH`: the same {notebooks} notebooks of six cells with a plot, graded by each in
turns, {rounds} rounds, on {cores} cores that did other work, too. Ratios count, not times.
"""
AFTER_SPEED = """\
`nbgrader autograde` and `otter run` run one notebook after another, without isolation. nbgrader also writes its gradebook, the others
do not. Otter's usual way, a container for each notebook, was not measured: that machine has no Docker.
"""


def rows(name: str) -> list[dict[str, str]]:
    """The rows of a file of the data."""
    with (DATA / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def corollary_on_a_unit(text: str) -> str:
    """The outcome of a number with its unit, marked as in a student's notebook."""
    code, name = MARKED
    grade = corollary.judge(corollary.load_bank()[code], {name: text})
    (part,) = (each for each in grade.parts if each.part.id == name)
    if isinstance(part.verdict, Unread):
        return "refused"
    return "right" if part.points == part.out_of else "wrong"


def corollary_on(row: dict[str, str]) -> str:
    """The outcome of a typed answer in Corollary."""
    if row.get("field") == "number with unit":
        return corollary_on_a_unit(row["text"])
    if row.get("field") == "number":
        found = read_case({"text": row["text"], "field": "quantity", "unit": "1"})
        close = found["status"] == "ok" and abs(found["value"] / float(row["asked"]) - 1) < 0.01
    else:
        names = row["letters"].split()
        found = read_case(
            {"text": row["text"], "field": "expression", "equals": row["asked"], "names": names}
        )
        close = found["verdict"] == "equal"
    return ("right" if close else "wrong") if found["status"] == "ok" else str(found["status"])


def outcomes(found: list[dict[str, str]], others: tuple[str, ...]) -> Iterator[str]:
    """The table of these answers, and how many of the right ones each takes for right. Raises ValueError for an unknown outcome."""
    systems = ("Corollary", *others)
    for row in found:
        row["Corollary"] = corollary_on(row)
        if strange := {row[system] for system in systems} - KNOWN:
            raise ValueError(f"{row['text']}: {', '.join(sorted(strange))} is no outcome")
    yield from table(
        ("typed", *(f"{system}" for system in systems)),
        (
            (
                f"`{row['text']}`" + ("" if row["should"] == "right" else " (is wrong)"),
                *(row[each] for each in systems),
            )
            for row in found
        ),
    )
    right = [row for row in found if row["should"] == "right"]
    counts = list[tuple[str, ...]]()
    for system in systems:
        established = [row[system] for row in right if row[system] not in ("not known", "no units")]
        if not established:
            continue
        of = str(len(established))
        counts.append(
            (
                system,
                of,
                str(established.count("right")),
                str(established.count("by setting")),
                str(established.count("wrong")),
            )
        )
    yield from table(("of the right answers", "established", "right", "by setting", "marked wrong"), counts)


def speed() -> Iterator[str]:
    """The table of one run of the benchmark."""
    found: dict[str, Any] = json.loads((DATA / "speed.json").read_text(encoding="utf-8"))
    times: dict[str, float] = found["ms per notebook, after the start"]
    theirs = times["nbgrader autograde"]
    versions: dict[str, str] = found["versions"]
    ours = f"Corollary {versions['corollary']}, {found['cores']} runners"
    named = {
        f"nbgrader {versions['nbgrader']}, `autograde`": times["nbgrader autograde"],
        f"Otter-Grader {versions['otter-grader']}, `run`": times["otter run"],
        f"{ours}, plots as data": times[f"{found['cores']} runners, data"],
        f"{ours}, plots as pictures": times[f"{found['cores']} runners, PNG"],
    }
    yield SPEED.format(**{name: found[name] for name in ("notebooks", "rounds", "cores")})
    yield from table(
        ("way", "ms a notebook, after the start", "notebooks in the time that nbgrader takes for one"),
        ((way, f"{took:.0f}", f"{theirs / took:.2g}") for way, took in named.items()),
    )
    yield f"Isolation of ours: {found['isolation']}. " + AFTER_SPEED


def page() -> str:
    typed, systems = rows("typed.csv"), rows("systems.csv")
    lines = [OPENING, TYPED]
    for field, title in (
        ("number", "### A number alone\n\n8.6 is right; 1234 where a thousand is typed.\n"),
        ("number with unit", "### A number with its unit\n\n8.6 kg m/s is right.\n"),
    ):
        lines += [title, *outcomes([row for row in typed if row["field"] == field], OTHERS)]
    lines += [
        FORMULAS,
        *outcomes(rows("formulas.csv"), tuple(each for each in OTHERS if each != "Moodle")),
        SOURCES,
    ]
    lines += table(
        ("system", "version", "fields", "settings", "established by", "source"),
        (
            (
                each["system"],
                each["version"],
                "; ".join(filter(None, (each[name] for name in ("number", "number with unit", "formula")))),
                each["settings"],
                each["established"],
                " ".join(
                    f"[{address.split('/')[-2 if address.endswith('/') else -1]}]({address})"
                    for address in each["source"].split()
                ),
            )
            for each in systems
        ),
    )
    peers = ("PrairieLearn", "STACK", "WeBWorK", "Numbas", "edX")
    lines.append(FEATURES)
    lines += table(
        ("feature", "Corollary", *peers),
        (
            (each["feature"], f"[{each['Corollary']}]({each['page']})", *(each[peer] for peer in peers))
            for each in rows("features.csv")
        ),
    )
    lines += speed()
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    sys.exit(written("compared.md", page(), sys.argv[1:]))
