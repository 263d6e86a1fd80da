"""Parts of a problem that no check reads: pictures, drawings, rubrics, languages without a list of words."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from corollary.problem.figure import is_svg
from corollary.problem.packed_pictures import pictures_of
from corollary.problem.problem import Problem
from corollary.problem.translation import translations
from corollary.verify.words.asked_sign import MAGNITUDE
from corollary.verify.words.author_text import stated_by

LANGUAGES = {
    "de": "German",
    "nb": "Norwegian",
    "fr": "French",
    "es": "Spanish",
    "nn": "Nynorsk",
    "sv": "Swedish",
    "da": "Danish",
}


def unread(problem: Problem) -> tuple[str, ...]:
    """What nothing has read of a problem, each as `what: where`; parts by their letters."""
    found: list[str] = []
    names = [path.name for path in pictures_of(problem.path)]
    found += [f"the picture {name}" for name in names]
    if problem.figure and is_svg(problem.figure):
        found.append("the hand-drawn figure")
    if marked := [part.id for part in problem.parts if stated_by(part) == "explain"]:
        found.append(f"rubric and model answer of {_parts(marked)}")
    if code := [
        part.id for part in problem.parts if "code" in part.answer_types or "plot" in part.answer_types
    ]:
        found.append(f"what the words of {_parts(code)} say of the program")
    for language in translations(problem.path):
        name = LANGUAGES.get(language, language)
        sizes = "" if language in MAGNITUDE else " (units and signs, too)"
        found.append(f"the {name} sentences{sizes}")
    found.append("the sentences of the question, but for numbers, units, holes, and words of size")
    return tuple(found)


def _parts(ids: list[str]) -> str:
    return ", ".join(f"({each})" for each in ids)


def unread_of_all(every: Iterable[tuple[str, tuple[str, ...]]]) -> str:
    """One line for one problem, or for a bank, where what is alike is counted."""
    problems = list(every)
    if not problems:
        return ""
    if len(problems) == 1:
        return "read by nobody: " + "; ".join(problems[0][1])
    kinds, where = Counter[str](), dict[str, str]()
    for code, found in problems:
        for each in dict.fromkeys(_kind(one) for one in found):
            kinds[each] += 1
            where.setdefault(each, code)
    listed = (
        f"{kind} ({f'{count} problems' if count > 1 else where[kind]})" for kind, count in kinds.most_common()
    )
    return "read by nobody: " + "; ".join(listed)


def _kind(text: str) -> str:
    if text.startswith("the picture"):
        return "pictures"
    return text.partition(" of (")[0]
