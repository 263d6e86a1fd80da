"""The translations beside a problem: what they lack, and whether they are of the problem as it is now."""

from __future__ import annotations

from corollary.derive.solution import Solution
from corollary.derive.translated import translated
from corollary.messages import catalogue, language
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.translation import ProblemTranslation, faults, translation, translations
from corollary.verify.checked import Tally

_law_name = catalogue("corollary.laws")


def check_translations(problem: Problem, solution: Solution, tally: Tally) -> None:
    """Complains of each text that a translation does not say, by its file and line, and counts those that are there."""
    for code in translations(problem.path):
        try:
            found = translation(problem, code)
        except Malformed as error:
            for complaint in error.complaints:
                tally.complain(str(complaint))
            continue
        if found is None:
            continue
        for complaint in faults(problem, found):
            tally.complain(str(complaint))
        _check_texts(found, code, texts_of(solution), tally)


def texts_of(solution: Solution) -> list[str]:
    """Every text of a solution that a student may read, once, in the order of the derivation."""
    found: dict[str, None] = {}

    def listed(text: str) -> str:
        found[text] = None
        return text

    translated(solution, listed)
    return list(found)


def _check_texts(found: ProblemTranslation, code: str, texts: list[str], tally: Tally) -> None:
    for text in texts:
        quoted = " ".join(text.split())
        with language(code):
            is_of_a_law = _law_name(text) != text
        tally.count("translated texts", quoted in found.texts or is_of_a_law)
        if quoted not in found.texts and not is_of_a_law:
            sentence = f"the solution's text has no translation; add, below # Texts: > {quoted}"
            tally.complain(f"{found.path.name}:1: {sentence}")
