"""The words, the figure and the translations of a problem, read for what the numbers contradict."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.derive.solution import Solution
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.translation import ProblemTranslation, translation, translations
from corollary.verify.checked import Tally
from corollary.verify.translations import texts_of
from corollary.verify.words.asked_units import wrong_units
from corollary.verify.words.author_text import (
    AuthorText,
    texts_of_problem,
    texts_of_solution,
    texts_of_translation,
)
from corollary.verify.words.drawn_figure import misdrawn
from corollary.verify.words.holes import exchanged, mislabelled, translated_otherwise
from corollary.verify.words.typed_givens import typed_givens


def check_words(problem: Problem, tally: Tally) -> None:
    """Complain of words, labels and translations that the numbers contradict; needs no solution."""
    texts = [each for each in texts_of_problem(problem) if each.text.strip()]
    tally.count("texts read", len(texts))
    meanings = {given.symbol: given.meaning for given in problem.givens}
    sentences = [*_of_texts(problem, texts, meanings), *misdrawn(problem)]
    for language, found in _translations(problem):
        theirs = [each for each in texts_of_translation(problem, found, language) if each.text.strip()]
        tally.count("texts read", len(theirs))
        meant = {symbol: found.texts.get(meaning, meaning) for symbol, meaning in meanings.items()}
        complaints = list(_of_texts(problem, theirs, meant))
        sentences += complaints
        places = {each.split(": ")[0] for each in complaints}
        sentences += [
            each
            for each in translated_otherwise(problem, found, language)
            if each.split(": ")[0] not in places  # one fault, one complaint
        ]
    for sentence in sentences:
        tally.complain(sentence)


def check_solution_words(bank: Bank, solution: Solution, tally: Tally) -> None:
    """Complain of printed values in the sentences of a solution, which every student reads."""
    problem = solution.problem
    path = bank.solution(problem)
    for sentence in typed_givens(problem, texts_of_solution(path, texts_of(solution))):
        tally.complain(sentence)


def _of_texts(problem: Problem, texts: list[AuthorText], meanings: dict[str, str]) -> Iterator[str]:
    yield from typed_givens(problem, texts)
    yield from wrong_units(problem, texts)
    yield from mislabelled(problem, texts)
    yield from exchanged(problem, texts, meanings)


def _translations(problem: Problem) -> Iterator[tuple[str, ProblemTranslation]]:
    for language in translations(problem.path):
        try:
            found = translation(problem, language)
        except Malformed:
            continue  # which is complained of with the translations
        if found is not None:
            yield language, found
