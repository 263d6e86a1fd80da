"""What of the chapter's keys Coq's kernel accepts: `python benchmarks/certificates.py` writes `results/certificates.md`.

Needs coqc. `--codes` takes some problems only, and then prints the table.
"""

from __future__ import annotations

import argparse
from collections import Counter
from pathlib import Path

from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.verify.certificate.check import checker, unproven
from corollary.verify.certificate.script import certificate

RESULT = Path(__file__).with_name("results") / "certificates.md"


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--codes", nargs="*", default=[])
    given = options.parse_args()
    solutions = Solutions(chapter_bank())
    rows: list[str] = []
    total: Counter[str] = Counter()
    left_out: Counter[str] = Counter()
    for problem in chapter_bank():
        if given.codes and problem.code not in given.codes:
            continue
        solution = solutions.of(problem)
        steps = certificate(solution)
        lemmas = [each for step in steps for each in step.lemmas]
        if not lemmas:
            continue
        failed = unproven(solution, steps)
        count = Counter(
            "left out" if not each.text else "not proven" if each.name in failed else "proven"
            for each in lemmas
        )
        left_out += Counter(each.why for each in lemmas if not each.text)
        total += count
        names = ", ".join(sorted(failed))
        rows.append(
            f"| {problem.code} | {count['proven']} | {count['not proven']} | {count['left out']} | {names} |"
        )
        print(rows[-1], flush=True)
    rows.append(f"| all | {total['proven']} | {total['not proven']} | {total['left out']} | |")
    reasons = [f"- {why}: {count}" for why, count in left_out.most_common()]
    text = "\n".join(
        [
            "# Keys that Coq's kernel accepts",
            "",
            f"`python benchmarks/certificates.py`, {checker()}. Two claims for each step: its laws hold for what is found, nothing else fulfils them.",
            "",
            "| problem | proven | not proven by these tactics | left out | which are not proven |",
            "|---|---|---|---|---|",
            *rows,
            "",
            "Left out, and why:",
            "",
            *reasons,
            "",
        ]
    )
    if not given.codes:
        RESULT.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
