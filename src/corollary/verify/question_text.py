"""The words of a problem as a student reads them: the question of each part, and options told apart in print."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass
from html import unescape
from itertools import product
from math import prod

from corollary.answers.equality import Equal, compare
from corollary.answers.formula import formula
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type
from corollary.derive.solution import Solution
from corollary.formula.ast import Call, Expr, Name, Negative, Number, Relation, names, walk
from corollary.formula.ball import holds
from corollary.formula.errors import ParseError, Undefined
from corollary.grading.assign import options_alike
from corollary.grading.key import Key, make_key
from corollary.notebook.worksheet import Exercise, exercise
from corollary.problem.axes import axes
from corollary.problem.figure import drawn, letters_graphed
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.statement import FORMULA, HOLE, filled, holes
from corollary.problem.variant import Variant, chapter, written
from corollary.units.unit import show
from corollary.verify.checked import Tally

ENOUGH = 3  # variants with different answers: a number that is the answer in each of them is no chance
UNSHOWN = re.compile(
    r"<(style|script|path|defs)\b.*?</\1>|<!--.*?-->|data:[\w/+;-]*base64,[\w+/=]+|[\w+/=]{120,}", re.DOTALL
)
TAG = re.compile(r"</?[A-Za-z!][^<>]*>")
TEX = re.compile(r"\\(?:mathrm|text|operatorname)\b|\\[,;:! ]|[{}$^*·⋅\u2062\\]")
NUMERAL = re.compile(r"(?<![\w.,])\d+(?:\.\d+)?(?:(?:e|·10\^?|×10\^?|\*10\^?)-?\d+)?(?![\w]*\d)")
CODE = re.compile(r"`([^`\n]+)`")
ALT = re.compile(r"<[^<>]*?\b(?:alt|aria-label)=\"([^\"]*)\"[^<>]*>")
PREFIXES = (1.0, 1e3, 1e-3)
REACH = 1e-9  # relative, between a numeral and the answer rounded to its figures


@dataclass(frozen=True, slots=True)
class QuestionText:
    """One variant as students read it: the texts of a format by what they are."""

    key: Key
    texts: Mapping[str, str]


def visible_text(text: str) -> str:
    """HTML, SVG or Markdown as a reader has it: without tags, styles and pictures."""
    return unescape(TAG.sub(" ", ALT.sub(r" \1 ", UNSHOWN.sub(" ", text))))


def missing(one: QuestionText) -> Iterator[tuple[Part | Given, str]]:
    """Givens that stand nowhere in the texts, and parts whose unit does not, each with a sentence."""
    variant = one.key.variant
    problem, whole = variant.problem, _bare(" ".join(map(visible_text, one.texts.values())))
    sources = [problem.statement, problem.figure, problem.figure_alt]
    sources += [text for part in problem.parts for text in (part.text, *(each.text for each in part.options))]
    every = [(hole, "{{" + hole.text + "}}") for source in sources for hole in holes(source)]
    asked = {letter for hole, _ in every for letter in hole.letters}
    named = {given.table for given in problem.givens if given.words and given.symbol in asked} - {""}
    graphed = letters_graphed(problem)
    for given in problem.givens:
        if given.source or given.symbol in graphed:
            continue  # a constant of nature is looked up, and what a graph shows is read off it
        if given.value == given.grid.first == given.grid.last == 1:
            continue  # the unit itself, by which a logarithm's argument is divided
        if not given.words and given.table in named:
            continue  # the words of its row stand there, which name it
        naming = [filled(text, variant) for hole, text in every if given.symbol in hole.letters]
        unit = "" if given.words else _bare(show(given.unit))
        if not any(_stands(_bare(each), whole) for each in (*naming, written(variant, given.symbol))):
            yield given, f"the given {given.symbol} ({written(variant, given.symbol)}) is not in the text"
        elif not _stands(unit, whole) and not any(
            hole.unit for hole, _ in every if given.symbol in hole.letters
        ):
            yield given, f"the given {given.symbol} stands there without its unit, {show(given.unit)}"
    for part in problem.parts:
        if not _stands(_bare(show(part.unit)), whole):
            yield part, f"the unit of part {part.id}, {show(part.unit)}, is not in the text"


def leaks(every: Sequence[QuestionText]) -> Iterator[tuple[Part, str]]:
    """Answers that can be read off the texts of these variants: a number in each of them, exactly or rounded; or the formula asked for."""
    first = every[0].key
    for part in first.variant.problem.parts:
        if part.id not in first.truths:
            continue
        for name in every[0].texts:
            if not part.of and (number := _number_leaked(every, part, name)):
                yield part, f"{name} tells the answer to part {part.id}: {number}"
        if answer_type(part.answer_type).in_symbols:
            yield from _formula_leaks_of(every[0], part)


def formula_leaks(one: QuestionText) -> Iterator[tuple[Part, str]]:
    """Formulas of the texts that are the answers of parts which ask for a number: it has still to be worked out."""
    for part in one.key.variant.problem.parts:
        if part.id in one.key.truths and not answer_type(part.answer_type).in_symbols:
            yield from _formula_leaks_of(one, part)


def _formula_leaks_of(one: QuestionText, part: Part) -> Iterator[tuple[Part, str]]:
    for name, text in one.texts.items():
        if leaked := _formula_leaked(one.key, part, text):
            yield part, f"{name} tells the answer to part {part.id}: {leaked}"


def _number_leaked(every: Sequence[QuestionText], part: Part, name: str) -> str:
    """The numeral of the first variant, where every variant has one that is its answer; "" where not, or where too few differ.

    A variant whose answer is also the number of a given says nothing; nor does a numeral that stands in all variants.
    """
    numerals = [set(_numerals(one.texts[name])) for one in every]
    fixed = set[str].intersection(*numerals)
    for place in range(min(len(one.key.truths[part.id].values) for one in every)):
        leaked = [
            found
            for one, its in zip(every, numerals, strict=True)
            if (found := _leaked(one.key, part, place, its - fixed, fixed)) is not None
        ]
        if "" not in leaked and len(set(leaked)) >= ENOUGH:
            return leaked[0]
    return ""


def _leaked(key: Key, part: Part, place: int, numerals: Set[str], fixed: Set[str]) -> str | None:
    """The numeral that is the answer; "" for none; None where a given or what stands in all variants has the same number."""
    value = key.truths[part.id].values[place]
    sizes = abs(value), abs(part.unit.from_si(value))
    wanted = [size * prefix for size in sizes for prefix in PREFIXES]
    known = _stated(key) | fixed
    if found := [each for each in sorted(numerals - known) if any(_is(each, one) for one in wanted)]:
        return max(found, key=len)
    alike = (each for each in known if any(_is(each, one) for one in wanted))
    return None if any(_figures(each) > 1 or float(each) in wanted for each in alike) else ""


def _formula_leaked(key: Key, part: Part, text: str) -> str:
    """A formula of the text that is the answer's; the letter of a given alone is none."""
    trees = key.find(key.truths[part.id]).in_givens
    if trees is None:
        return ""
    question = question_in(key.variant, part)
    for written_there in _formulas(text):
        for side in re.split(r"=|≈|:", written_there)[-2:]:
            read = formula(side, question) if side.strip() else None
            if read is None or isinstance(read, ParseError | Relation) or _lone_letter(read):
                continue
            for tree in trees:
                if _lone_letter(tree):
                    continue
                try:
                    if isinstance(compare(read, tree, {}), Equal):
                        return written_there.strip()
                except Undefined:
                    continue
    return ""


def _lone_letter(tree: Expr) -> bool:
    """A letter, a number, or one of them with a sign."""
    return all(isinstance(node, Name | Number | Negative) for node in walk(tree)) and not isinstance(
        tree, Call
    )


def _formulas(text: str) -> Iterator[str]:
    for found in FORMULA.finditer(text):
        yield found[0].strip("$")
    for found in CODE.finditer(text):
        yield found[1]


def _numerals(text: str) -> Iterator[str]:
    for found in NUMERAL.finditer(_spaceless_numbers(visible_text(text))):
        yield re.sub(r"(·|×|\*)10\^?", "e", found[0])


def _is(numeral: str, value: float) -> bool:
    """Whether the value, rounded to the numeral's figures, is the numeral."""
    figures = _figures(numeral)
    if not figures or not value:
        return False
    rounded, number = float(f"{value:.{figures - 1}e}"), float(numeral)
    return abs(rounded - number) <= REACH * number


def _figures(numeral: str) -> int:
    return len(numeral.partition("e")[0].replace(".", "").lstrip("0"))


def _stated(key: Key) -> set[str]:
    """The numerals that the givens themselves are written with."""
    variant = key.variant
    sources = [
        variant.problem.statement,
        variant.problem.figure,
        variant.problem.figure_alt,
        *(p.text for p in variant.problem.parts),
    ]
    alone = {given.symbol for given in variant.problem.givens}
    texts = [written(variant, symbol) for symbol in alone]
    texts += [
        filled(found[0], variant)
        for source in sources
        for found in HOLE.finditer(source)
        if found["formula"].strip() in alone
    ]
    return {numeral for each in texts for numeral in _numerals(each)}


def _stands(text: str, whole: str) -> bool:
    """Whether the text is there, spaced in whatever way, and not as a piece of a longer number."""
    pattern = r"\s*".join(map(re.escape, re.sub(r"\s", "", text)))
    before, after = r"(?<![\d.])" if text[:1].isdigit() else "", r"(?!\d)" if text[-1:].isdigit() else ""
    return re.search(before + pattern + after, whole) is not None


def _spaceless_numbers(text: str) -> str:
    """With points in numbers, plain minus signs and figures of one kind."""
    figures = unicodedata.normalize("NFKC", text.replace("{,}", ".")).replace("−", "-")
    return re.sub(r"(?<=\d)\s(?=\d{3}\b)", "", figures)


def _bare(text: str) -> str:
    """To look for one text in another: without signs of multiplication and TeX's own."""
    return TEX.sub("", _spaceless_numbers(text)).strip()


VARIANTS = 4  # a number that is the answer in each of them is no chance


def check_question(solution: Solution, own: Key, tally: Tally) -> None:
    """Complains of answers that stand in the text, and notes givens and units that do not, and formulas of numbers asked for; `own` is the key of the chapter's numbers."""
    problem, every = solution.problem, [_question_text(own)]
    for variant in sample(problem, VARIANTS, salt="question"):
        with suppress(Undefined):  # such numbers are never dealt
            every.append(_question_text(make_key(solution, variant)))
    tally.count("statement", len(problem.givens) + len(problem.parts))
    for part, sentence in leaks(every):
        tally.complain(f"{problem.path.name}:{part.line}: {sentence}")
    for what, sentence in (*missing(every[0]), *formula_leaks(every[0])):
        tally.note(f"{problem.path.name}:{what.line}: {sentence}")


def _question_text(key: Key) -> QuestionText:
    return QuestionText(key, _texts(exercise(key.variant)))


def _texts(asked: Exercise) -> dict[str, str]:
    found = {"the statement": "\n\n".join([asked.statement, *_of_parts(asked)])}
    if not asked.figure:
        return found
    alt = asked.figure_alt
    for values in drawn(asked.variant).data:  # what a graph shows is there to be read
        alt = alt.replace(values, "")
    return found | {"the figure": f"{alt} {asked.figure}"}


def _of_parts(asked: Exercise) -> Iterator[str]:
    for prompt in asked.prompts:
        yield from (prompt.part.title, prompt.text, *(option.text for option in prompt.options))
        for name in prompt.part.answer_types:
            yield answer_type(name).heading(prompt.question)
            yield answer_type(name).blank(prompt.question)


MOST = 4000  # sets of numbers that are all tried
SAMPLED = 400  # of the grid, where there are more


def check_options(problem: Problem, tally: Tally) -> None:
    """Complains of options that print alike with the printed numbers, or whatever the numbers; notes the draws that are left out."""
    for part in problem.parts:
        if not part.options:
            continue
        where, own = f"{problem.path.name}:{part.line}: part {part.id}", chapter(problem)
        letters = sorted(
            {letter for option in part.options for hole in holes(option.text) for letter in hole.letters}
        )
        if met := _alike(own, part):
            one, other = met
            numbers = f" with {_numbers(own, letters)}, the printed numbers" if letters else ""
            tally.complain(f"{where}: options {one} and {other} print alike{numbers}; change one of them")
            continue
        tried = list(_variants(problem, letters))
        found = [(variant, pair) for variant in tried if (pair := _alike(variant, part))]
        tally.count("options apart", len(tried) - len(found))
        if found:
            first, (one, other) = found[0]
            tally.note(
                f"{where}: options {one} and {other} print alike with {_numbers(first, letters)} ({len(found)} of {len(tried)} "
                "sets of numbers): these are never dealt"
            )


def _variants(problem: Problem, letters: Sequence[str]) -> Iterator[Variant]:
    """Every set of values of these givens, the others as printed; where those are too many, a sample of the grid."""
    own = chapter(problem)
    moved = [
        axis for axis in axes(problem.givens) if not {given.symbol for given in axis}.isdisjoint(letters)
    ]
    if prod(axis[0].grid.count for axis in moved) > MOST:
        yield from sample(problem, SAMPLED, salt="options")
        return
    conditions = [each.relation for each in problem.conditions if names(each.relation) - {"pi"} <= {*letters}]
    for places in product(*(range(axis[0].grid.count) for axis in moved)):
        values = {
            given.symbol: given.grid[place]
            for axis, place in zip(moved, places, strict=True)
            for given in axis
        }
        variant = Variant(problem, {**own.values, **values}, None)
        if all(_fulfilled(each, variant) for each in conditions):
            yield variant


def _fulfilled(condition: Relation, variant: Variant) -> bool:
    try:
        return holds(condition, variant.exact) is True
    except Undefined:
        return False


def _alike(variant: Variant, part: Part) -> tuple[str, str] | None:
    """The marks of two options of the part that print alike; None where numbers that are never dealt give an option no value."""
    try:
        return next(((one, other) for _part, one, other in options_alike(variant, (part,))), None)
    except Undefined:
        return None


def _numbers(variant: Variant, letters: Sequence[str]) -> str:
    return ", ".join(f"{letter} = {written(variant, letter)}" for letter in letters)
