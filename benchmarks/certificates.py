"""What of the chapter's keys Coq's kernel accepts: `python benchmarks/certificates.py` writes `results/certificates.md`.

Needs coqc, and an hour of an idle machine. `--codes` certifies some problems and keeps what is known of the others
(`results/certificates.json`), so that it can be done in slices; `--stale` takes those whose script is no longer the one checked.
"""

from __future__ import annotations

import argparse
import hashlib
import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from corollary.derive.solution import Solution
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.verify.certificate.script import LEMMA, CertifiedStep, certificate, checker, script, unproven

RESULT = Path(__file__).with_name("results") / "certificates.md"
KNOWN = RESULT.with_suffix(".json")


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--codes", nargs="*", default=[])
    options.add_argument("--stale", action="store_true")
    given = options.parse_args()
    known: dict[str, Any] = json.loads(KNOWN.read_text(encoding="utf-8")) if KNOWN.is_file() else {}
    bank = chapter_bank()
    solutions = Solutions(bank)
    for problem in bank:
        if given.codes and problem.code not in given.codes:
            continue
        solution = solutions.of(problem)
        steps = certificate(solution)
        written = hashlib.sha256(script(solution, steps).encode()).hexdigest()
        if given.stale and known.get(problem.code, {}).get("script") == written:
            continue
        known[problem.code] = {"script": written, "by": checker(), **_certified(solution, steps)}
        print(_row(problem.code, known[problem.code]), flush=True)
        inside = {each.code: known[each.code] for each in bank if each.code in known}
        KNOWN.write_text(json.dumps(inside, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        if len(inside) == len(list(bank)):  # else the page of the run before is the better one
            RESULT.write_text(_page(inside), encoding="utf-8")


def _certified(solution: Solution, steps: list[CertifiedStep]) -> dict[str, Any]:
    lemmas = [each for step in steps for each in step.lemmas]
    failed = unproven(solution, steps) if any(each.text for each in lemmas) else frozenset[str]()
    return {
        "proven": [each.name for each in lemmas if each.text and each.name not in failed],
        "not proven": sorted(failed),
        "left out": {each.name: each.why for each in lemmas if not each.text},
    }


def _row(code: str, found: Mapping[str, Any]) -> str:
    counts = " | ".join(str(len(found[each])) for each in ("proven", "not proven", "left out"))
    return f"| {code} | {counts} | {', '.join(found['not proven'])} |"


def _page(known: Mapping[str, Any]) -> str:
    with_claims = {code: each for code, each in known.items() if each["proven"] or each["left out"]}
    total = {
        each: sum(len(found[each]) for found in known.values())
        for each in ("proven", "not proven", "left out")
    }
    reasons = Counter(why for found in known.values() for why in found["left out"].values())
    return "\n".join(
        [
            "# Keys that Coq's kernel accepts",
            "",
            f"`python benchmarks/certificates.py`, {', '.join(sorted({each['by'] for each in known.values()}))}. "
            "Two claims for each step: its laws hold for what is found, nothing else fulfils them. "
            f"A lemma has {LEMMA} s of a machine that may be busy with other work.",
            "",
            "| problem | proven | not proven by these tactics | left out | which are not proven |",
            "|---|---|---|---|---|",
            *(_row(code, found) for code, found in with_claims.items()),
            f"| all of these | {total['proven']} | {total['not proven']} | {total['left out']} |  |",
            "",
            "Left out, and why:",
            "",
            *(f"- {why}: {count}" for why, count in reasons.most_common()),
            "",
            *(
                [f"No step of {', '.join(set(known) - set(with_claims))} has laws to certify.", ""]
                if set(known) - set(with_claims)
                else []
            ),
        ]
    )


if __name__ == "__main__":
    main()
