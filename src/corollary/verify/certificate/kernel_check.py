"""A proof script checked by Coq's kernel, in a process of its own."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from corollary.derive.solution import Solution
from corollary.verify.certificate.lemmas import Lemma
from corollary.verify.certificate.script import CertifiedStep, alone, script

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
