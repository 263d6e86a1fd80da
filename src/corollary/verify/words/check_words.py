"""The words, the figure and the translations of a problem, read for what contradicts numbers, and parts that no check reads."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from corollary.derive.solution import Solution
from corollary.derive.translated import translated
from corollary.messages import catalogue, language
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.figure import is_svg
from corollary.problem.packed_pictures import pictures_of
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.translation import NOTHING, ProblemTranslation, faults, translation, translations
from corollary.units.unit import ONE, Unit, canonical, show
from corollary.verify.checked import Tally
from corollary.verify.words.asked_sign import MAGNITUDE
from corollary.verify.words.author_text import (
    INLINE,
    AuthorText,
    asks_for_numbers,
    stated_by,
    texts_of_problem,
    texts_of_solution,
    texts_of_translation,
)
from corollary.verify.words.drawn_figure import misdrawn
from corollary.verify.words.holes import exchanged, mislabelled, translated_otherwise
from corollary.verify.words.numerals_in_words import unit_after
from corollary.verify.words.typed_givens import is_angle, typed_givens

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


def named_in(code: str, text: str) -> bool:
    """Whether it is the name of a law of the library, which is translated into that language already."""
    with language(code):
        return _law_name(text) != text


def _check_texts(found: ProblemTranslation, code: str, texts: list[str], tally: Tally) -> None:
    for text in texts:
        quoted = " ".join(text.split())
        is_there = bool(found.texts.get(quoted)) or named_in(code, text)
        tally.count("translated texts", is_there)
        if not is_there and quoted in found.lines:
            tally.complain(f"{found.path.name}:{found.lines[quoted]}: {NOTHING.format(quoted)}")
        elif not is_there:
            sentence = f"the solution's text has no translation; add, below # Texts: > {quoted}"
            tally.complain(f"{found.path.name}:1: {sentence}")


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
    for spoken in translations(problem.path):
        name = LANGUAGES.get(spoken, spoken)
        sizes = "" if spoken in MAGNITUDE else " (units and signs, too)"
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


ASKS = re.compile(
    r"(?:give|answer|express|write|state|enter|measured?|report|quote|unit|angeben|gib|antwort\w*|schreib\w*|drück\w*|einheit|"
    r"oppgi|svar\w*|skriv|enhet\w*|uttrykk)\b[^.;?!\n]{0,60}$",
    re.IGNORECASE,
)
IN_UNIT = re.compile(
    rf"(?:(?<=[\s(\[])|^)(?P<word>in|i|as|unit:?|units? of|einheit:?|enhet:?)(?= |{INLINE})(?! the\b)",
    re.IGNORECASE,
)
BRACKETED = re.compile(r"[\[(](?=[A-Za-zµΩ°%])(?!(?:in|i|as) )")  # in a unit, not inches times a unit
HOW_MANY = re.compile(r"\b(?:how many|wie viele|wieviele|hvor mange)(?= )", re.IGNORECASE)
NEAREST = re.compile(
    r"\bto (?:the nearest|(?:the )?(?:next )?(?:whole|full))(?= )|\bauf (?:(?:den|die|das) nächste[nrs]?|(?:volle|ganze)[nrs]?)(?= )"
    r"|\btil (?:nærmeste|hele?)(?: hele?)?(?= )",
    re.IGNORECASE,
)
BLANK_ANSWER = re.compile(r"(?:_{2,}|…|\.\.\.|=\s*\\?\?)\s*\$?(?= ?)")
PERMITTED = re.compile(
    r"\b(?:you (?:may|can)|or|also|if you like|will do|du kannst|darfst|können sie|oder|auch|du kan|eller|også|such as)\b",
    re.IGNORECASE,
)
PERCENTAGE = re.compile(
    r"\b(?:what|which|the) percentage\b|\b(?:how many|wie viele?|hvor mange) (?:per ?cent|prozent|prosent)\b",
    re.IGNORECASE,
)
WHOLE = re.compile(r"turns?|rev(?:olutions?)?|rounds?|Umdrehung(?:en)?|omdreininger?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class AskedUnit:
    """A unit named in a text: `firmly` where the words say that the answer is in it."""

    start: int
    text: str
    unit: Unit
    firmly: bool


def asked_units(text: str) -> Iterator[AskedUnit]:
    """The units in which a plain text asks for an answer: `in kN`, `(in °C)`, `how many minutes`, `to the nearest foot`, `[cm]`."""
    for pattern in (IN_UNIT, BRACKETED, HOW_MANY, NEAREST, BLANK_ANSWER):
        for found in pattern.finditer(text):
            in_formula = text.count("$", 0, found.end()) % 2 == 1
            unit, end = unit_after(text, found.end(), in_formula)
            if unit is None or (unit.dimension == ONE and not _share(unit)):
                continue
            words = text[found.end() : end].replace(INLINE, "").strip(" $")
            sentence = re.split(r"[.;?!\n](?:\s|$)", text[: found.start()])[-1]
            rest = re.split(r"[.;?!\n)](?:\s|$)", text[end:])[0]
            if PERMITTED.search(sentence[-30:]) or PERMITTED.search(rest[:30]) or PERMITTED.search(found[0]):
                continue
            if pattern is BRACKETED and text[end : end + 1] not in (")", "]"):
                continue
            if (
                pattern is IN_UNIT
                and len(words) == 1
                and words.isalpha()
                and _a_name(text, found.start(), end)
            ):
                continue
            bracket = text[: found.start()].rstrip().endswith(("(", "[")) and text[end : end + 1] in (
                ")",
                "]",
            )
            apart = (
                text[: found.start()].rstrip().endswith(",")
                and re.match(r" ?\$?[,?]", text[end:]) is not None
            )
            firmly = pattern is not IN_UNIT or bracket or apart or ASKS.search(sentence) is not None
            if pattern is HOW_MANY and WHOLE.fullmatch(words):
                continue  # a number of turns is a plain number
            if (
                pattern is HOW_MANY
                and unit.offset
                and re.search(r"(?i)\b(?:by|um|med) $", text[: found.start()])
            ):
                continue  # by how many degrees Celsius: a difference, in kelvins as well
            yield AskedUnit(found.start(), words, unit, firmly)


def wrong_units(problem: Problem, texts: Iterable[AuthorText]) -> Iterator[str]:
    """A sentence with its place for each unit in the words that is not the unit of the part; `(c)` is the part of that name."""
    named = {f"({part.id})" for part in problem.parts}
    for each in texts:
        if each.part is not None and each.kind != "option":
            parts = [each.part] if asks_for_numbers(each.part) else []
        elif each.kind == "statement":
            parts = [part for part in problem.parts if asks_for_numbers(part)]
        else:
            continue
        for asked in asked_units(each.without_tex) if parts else ():
            if each.without_tex[asked.start :].startswith(f"({asked.text})") and f"({asked.text})" in named:
                continue
            for part in parts:
                if each.kind == "statement" and not asked.firmly:
                    continue
                if why := _misfit(asked, part, whole=each.kind == "statement"):
                    yield f"{each.where(asked.start)}: {each.what} asks for {asked.text}, {why}"
                    break
        for part in parts if each.kind != "statement" else ():
            found = PERCENTAGE.search(each.without_tex)
            if found and all(unit.text == "1" for unit in part.units):
                yield (
                    f"{each.where(found.start())}: {each.what} asks for a percentage, and a bare number of part {part.id} is a share: "
                    'give the part unit="%", or ask for the fraction'
                )


def _misfit(asked: AskedUnit, part: Part, whole: bool) -> str:
    """What is wrong with the unit for this part; "" where it fits, or is about something else."""
    if any(_same(asked.unit, unit) for unit in part.units):
        return ""
    alike = [
        unit
        for unit in part.units
        if unit.dimension == asked.unit.dimension and is_angle(unit) == is_angle(asked.unit)
    ]
    if alike:
        theirs = show(alike[0]) or "a plain number"
        return (
            f"and a bare number of part {part.id} is in {theirs}: say {theirs} in the words, or "
            f'write unit="{canonical(asked.unit)}" in the heading'
        )
    if whole or not asked.firmly or part.unit.dimension == ONE:
        return ""
    theirs = ", ".join(dict.fromkeys(show(unit) or "a plain number" for unit in part.units))
    return f"and part {part.id} is in {theirs}, which measures something else: one of both is wrong"


def _same(one: Unit, other: Unit) -> bool:
    if (
        one.dimension == other.dimension
        and one.factor == other.factor
        and (one.is_difference or other.is_difference)
    ):
        return True  # by how many degrees Celsius
    return (one.dimension, one.factor, one.pi, one.offset) == (
        other.dimension,
        other.factor,
        other.pi,
        other.offset,
    )


def _share(unit: Unit) -> bool:
    return is_angle(unit) or unit.factor != 1


def _a_name(text: str, start: int, end: int) -> bool:
    """True if one letter behind `in` is rather a point or a frame of reference: in A, in K, in S."""
    return (
        text[end - 1].isupper()
        and text[end - 1] not in "NJWV"
        and not text[:start].rstrip().endswith(("(", "["))
    )


def check_words(problem: Problem, tally: Tally) -> None:
    """Complain of words, labels and translations that the numbers contradict; needs no solution."""
    texts = [each for each in texts_of_problem(problem) if each.text.strip()]
    tally.count("texts read", len(texts))
    meanings = {given.symbol: given.meaning for given in problem.givens}
    sentences = [*_of_texts(problem, texts, meanings), *misdrawn(problem)]
    for spoken, found in _translations(problem):
        theirs = [each for each in texts_of_translation(problem, found, spoken) if each.text.strip()]
        tally.count("texts read", len(theirs))
        meant = {symbol: found.texts.get(meaning, meaning) for symbol, meaning in meanings.items()}
        complaints = list(_of_texts(problem, theirs, meant))
        sentences += complaints
        places = {each.split(": ")[0] for each in complaints}
        sentences += [
            each
            for each in translated_otherwise(problem, found, spoken)
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
    for spoken in translations(problem.path):
        try:
            found = translation(problem, spoken)
        except Malformed:
            continue  # which is complained of with the translations
        if found is not None:
            yield spoken, found
