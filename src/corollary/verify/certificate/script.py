"""A proof script for one problem: every step's lemmas in one file for the Coq proof assistant, and its check by Coq's kernel."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Collection, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from corollary.derive.solution import Solution
from corollary.verify.certificate.coq import comment
from corollary.verify.certificate.lemmas import Lemma, lemmas

OPENING = """\
Require Import Reals Lra Psatz Nsatz.
Open Scope R_scope.

Ltac positive := first [ lra | nra | apply Rmult_lt_0_compat; positive | apply Rplus_lt_0_compat; positive
  | apply Rdiv_lt_0_compat; positive ].
Ltac nonnegative := first [ lra | nra | apply Rmult_le_pos; nonnegative | apply Rplus_le_le_0_compat; nonnegative
  | apply Rle_mult_inv_pos; [ nonnegative | positive ] | left; positive ].
Ltac nonzero := repeat split; try (first [ assumption | apply Rgt_not_eq; solve [ positive ] | apply Rlt_not_eq; solve [ positive ]
  | intro; nra ]).
(* nsatz stumbles over inequalities among the hypotheses, and does not fail where it proves nothing *)
Ltac equations := repeat match goal with
  | H : _ <= _ |- _ => clear H | H : _ < _ |- _ => clear H | H : _ /\\ _ |- _ => clear H | H : _ <> _ |- _ => clear H
  end; solve [ nsatz ].
Ltac solved := first [ lra | equations | nra ].
"""


@dataclass(frozen=True, slots=True)
class CertifiedStep:
    """One step of a derivation: what it finds, for which part ("" for none), and its lemmas."""

    names: tuple[str, ...]
    part: str
    lemmas: tuple[Lemma, ...]


def certificate(solution: Solution) -> list[CertifiedStep]:
    """The lemmas of a solution, step by step, of all its cases; what several cases share stands once."""
    seen: dict[str, int] = {}
    steps: dict[tuple[int, object], CertifiedStep] = {}
    for case in [each.solution for each in solution.regimes] or [solution]:
        for find, found in lemmas(case):
            what = find.statement.line, find.in_givens
            if what not in steps:
                apart = tuple(_named_apart(each, seen) for each in found)
                steps[what] = CertifiedStep(find.names, find.part, apart)
    return list(steps.values())


def script(solution: Solution, steps: Sequence[CertifiedStep], without: Collection[str] = ()) -> str:
    """The whole file; lemmas named in `without` are left out, with a remark."""
    problem, written = solution.problem, list[str]()
    lines = [
        comment(
            f"{problem.code}: {problem.title}. Each lemma holds for all numbers between the bounds; the last lines say on which axioms."
        ),
        OPENING,
    ]
    for step in steps:
        part = f" (part {step.part})" if step.part else ""
        for each in step.lemmas:
            if each.text and each.name not in without:
                lines.append(f"{comment(each.claim + part)}\n{each.text}")
                written.append(each.name)
            else:
                why = each.why or "these tactics do not prove it"
                lines.append(comment(f"not here: {each.claim}{part}; {why}") + "\n")
    return "\n".join([*lines, *map(assumptions, written), ""])


def assumptions(name: str) -> str:
    """The command that tells on which axioms a lemma rests."""
    return f"Print Assumptions {name}."


def alone(lemma: Lemma) -> str:
    """A file with one lemma."""
    return f"{OPENING}\n{lemma.text}\n{assumptions(lemma.name)}\n"


def _named_apart(lemma: Lemma, seen: dict[str, int]) -> Lemma:
    """The same letter may be found twice, by another step."""
    seen[lemma.name] = count = seen.get(lemma.name, 0) + 1
    if count == 1:
        return lemma
    name = f"{lemma.name}_{count}"
    return Lemma(name, lemma.claim, lemma.text.replace(f"Lemma {lemma.name} :", f"Lemma {name} :"), lemma.why)


LEMMA, SCRIPT = 60, 600  # s: a search that takes longer finds nothing
SIDE_BY_SIDE = 2
AXIOMS = frozenset(
    {
        "ClassicalDedekindReals.sig_forall_dec",
        "ClassicalDedekindReals.sig_not_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)
"""On which Coq's own real numbers rest: a lemma that rests on another is not accepted."""


class NoChecker(RuntimeError):
    """There is no Coq on this machine; one sentence says how to get it."""


def checker() -> str:
    """What will check, with its version. Raises NoChecker."""
    if shutil.which("coqc") is None:
        raise NoChecker(
            "coqc, which checks the script, is not installed: apt install coq (or opam install coq); "
            "without --check the script is only written"
        )
    done = subprocess.run(["coqc", "--version"], capture_output=True, text=True, timeout=LEMMA, check=True)
    return done.stdout.splitlines()[0].strip()


def unproven(solution: Solution, steps: Sequence[CertifiedStep]) -> frozenset[str]:
    """The lemmas that Coq does not accept; the script without them it does. There must be a `checker`."""
    if accepted(script(solution, steps), LEMMA):  # as it is with most: one start of Coq for all lemmas
        return frozenset()
    written = [each for step in steps for each in step.lemmas if each.text]
    with ThreadPoolExecutor(SIDE_BY_SIDE) as threads:
        found = threads.map(_stands_alone, written)
        failed = frozenset(each.name for each, stands in zip(written, found, strict=True) if not stands)
    if not accepted(script(solution, steps, failed), SCRIPT):
        return frozenset(each.name for each in written)
    return failed


def _stands_alone(lemma: Lemma) -> bool:
    return accepted(alone(lemma), LEMMA)


def accepted(text: str, seconds: float) -> bool:
    """Whether Coq accepts the file within the time, and its lemmas rest on the axioms of the real numbers alone."""
    with tempfile.TemporaryDirectory(prefix="corollary-coq-") as folder:
        path = Path(folder) / "certificate.v"
        path.write_text(text, encoding="utf-8")
        try:
            done = subprocess.run(["coqc", path.name], cwd=folder, capture_output=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            return False
        return done.returncode == 0 and axioms(done.stdout.decode(errors="replace")) <= AXIOMS


def axioms(printed: str) -> frozenset[str]:
    """What coqc says that lemmas rest on, by `Print Assumptions`: the first word of each line that is not indented."""
    return frozenset(re.findall(r"^(?!Axioms:|Closed under the global context)(\S+)", printed, re.MULTILINE))
