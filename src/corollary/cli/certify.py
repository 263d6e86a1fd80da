"""`corollary certify`: a proof script of a problem's key, for a kernel that is not ours."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from corollary.atomic import write_whole
from corollary.cli.ending import FAILS, HOLDS, answer, refuse, say
from corollary.cli.terminal import console
from corollary.derive.solution import Solution
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.verify.certificate.lemmas import EMPTY, Lemma
from corollary.verify.certificate.on_record import keep
from corollary.verify.certificate.script import (
    CertifiedStep,
    NoChecker,
    certificate,
    checker,
    script,
    unproven,
)
from corollary.verify.obligations.claims import laws_of
from corollary.verify.obligations.settle import settled


def run(code: str, bank: Path | None, output: Path | None, check: bool, as_json: bool) -> int:
    place, problem = home(bank, code)
    if check:
        try:
            by = checker()
        except NoChecker as error:
            refuse(str(error))
    else:
        by = ""
    solution = Solutions(place).of(problem)
    steps = certificate(solution)
    failed = unproven(solution, steps) if check else frozenset[str]()
    text = script(solution, steps, failed)
    path = output or Path(f"{problem.prefix}.v")
    write_whole(path, text.encode())
    proven = [each.name for step in steps for each in step.lemmas if each.text and each.name not in failed]
    record: dict[str, Any] = {"code": problem.code, "script": str(path)}
    if check:
        record |= keep(place, problem, text, by, proven)
    by_algebra = _proven_by_algebra(solution) if failed else frozenset[str]()
    rows = [(step, each, _outcome(each, failed, by)) for step in steps for each in step.lemmas]
    if as_json:
        record["claims"] = [
            {"part": step.part, "claim": each.claim, "lemma": each.name, "outcome": outcome, "why": each.why}
            for step, each, outcome in rows
        ]
        answer(record)
    else:
        _show(rows, path, by)
    for step, each, outcome in rows:
        if outcome == "not proven" and each.claim in by_algebra:
            print(
                f"{problem.code}: {each.claim} (part {step.part or 'none'}): verify proves it by algebra, the kernel does not; "
                "do not rely on it until the reason is known",
                file=sys.stderr,
            )
    empty = any(each.why == EMPTY for _, each, _ in rows)
    if empty:
        print(f"{problem.code}: {EMPTY}; correct its conditions or its ranges", file=sys.stderr)
    return FAILS if failed or empty else HOLDS


def _proven_by_algebra(solution: Solution) -> frozenset[str]:
    """The claims, in the certificate's words, that `verify` proves by algebra."""
    found = {
        (each.kind, each.claim)
        for each in settled(solution, 0)
        if each.by == "algebra" and each.outcome == "proven"
    }
    words = set[str]()
    for find in (
        find for case in (solution, *(each.solution for each in solution.regimes)) for find in case.unknowns
    ):
        names = ", ".join(find.names)
        if ("laws hold", laws_of(find.names)) in found:
            words.add(f"the laws hold for {names}")
        if ("one root", f"{names} is the only admissible root of its laws") in found:
            words.add(f"nothing else is {names}")
    return frozenset(words)


def _outcome(lemma: Lemma, failed: frozenset[str], by: str) -> str:
    if not lemma.text:
        return "left out"
    return "not proven" if lemma.name in failed else "proven" if by else "written"


def _show(rows: list[tuple[CertifiedStep, Lemma, str]], path: Path, by: str) -> None:
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False)
    for heading in ("part", "claim", "outcome", "why"):
        table.add_column(heading, overflow="fold")
    for step, each, outcome in rows:
        table.add_row(*map(Text, (step.part, each.claim, outcome, each.why)))
    console().print(table)
    written = sum(outcome in ("proven", "written") for _, _, outcome in rows)
    how = f"checked by {by}" if by else f"to check it: --check, or coqc {path}"
    say(f"{path}: {written} of {len(rows)} claims; {how}")
