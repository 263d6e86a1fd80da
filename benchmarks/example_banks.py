"""The example banks, all of their problems: verified, dealt to students in every set, and played by simulated students.

    pip install examples/banks/corollary-*
    python benchmarks/example_banks.py [--variants N] [--students N] [--markdown FILE]

Verifying is that of `corollary verify` over so many variants; the simulated students are those of `tests/content`: on two variants
of each problem one answers everything right, and one each makes one of the solution's mistakes.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
BANKS = ("mechanics", "matter", "fields")
SETS = sorted(ROOT.glob("examples/banks/*/src/*/problems/sets/*.md"))
COMMAND = ("-c", "from corollary.cli.main import main; main()")
PLAYED = 2  # variants of each problem
HEAD = "| problem | variants | redrawn | checks | for all numbers | simulations | right answers | mistakes |"


def run(*words: object) -> str:
    """A program with all three banks open: its standard output. Raises CalledProcessError when it ends with another code than 0."""
    environment = os.environ | {"COROLLARY_BANK": os.pathsep.join(BANKS)}
    done = subprocess.run(
        [sys.executable, *map(str, words)], stdout=subprocess.PIPE, text=True, env=environment, check=True
    )
    return done.stdout


def row(found: dict[str, Any]) -> str:
    checks, settled = found["checks"], found["obligations"]
    proven = sum(each["outcome"] == "proven" for each in settled)
    return (
        f"| {found['code']} | {found['variants']} | {found['redrawn']:.0%} | {sum(checks.values())} | {proven}/{len(settled)} "
        f"| {checks.get('simulations met', 0)} | {checks['right answers']} | {checks['mistakes apart']} |"
    )


def dealt(students: int) -> list[str]:
    """Each set dealt to a class: how many notebooks there are then."""
    lines: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        roster = Path(folder, "roster.csv")
        roster.write_text("id\n" + "".join(f"student{n}\n" for n in range(students)), encoding="utf-8")
        for path in SETS:
            course = Path(folder, path.stem)
            run(*COMMAND, "generate", path.stem, "--roster", roster, "--course", course)
            sheets = len(list(course.glob(f"release/*/{path.stem}/{path.stem}.ipynb")))
            lines.append(f"| {path.stem} | {sheets} |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--variants", type=int, default=20, help="of each problem, to verify")
    parser.add_argument("--students", type=int, default=10, help="to whom each set is dealt")
    parser.add_argument("--markdown", type=Path, help="a file for the tables")
    wanted = parser.parse_args()
    verified = json.loads(run(*COMMAND, "verify", "--variants", wanted.variants, "--json"))
    problems = verified["problems"]
    codes = [found["code"] for found in problems]
    played = json.loads(run(ROOT / "tests" / "content" / "simulated_students.py", PLAYED, *codes))
    counts = played["counts"]
    lines = [
        "# The example banks",
        "",
        f"`python benchmarks/example_banks.py --variants {wanted.variants} --students {wanted.students}`: {len(problems)} problems, "
        f"{sum(found['ok'] for found in problems)} without complaint. Simulated students gave {counts['right']} right answers and "
        f"{counts['mistaken']} with one of the solutions' mistakes; {len(played['faults'])} were judged otherwise than they should be.",
        "",
        *(f"- {fault}" for fault in played["faults"]),
        HEAD,
        "|---|" + "---:|" * 7,
        *map(row, sorted(problems, key=lambda found: found["code"])),
        "",
        "| set | notebooks |",
        "|---|---:|",
        *dealt(wanted.students),
        "",
    ]
    text = "\n".join(lines)
    print(text)
    if wanted.markdown:
        wanted.markdown.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
