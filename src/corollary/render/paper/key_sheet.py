"""The key and marking scheme of one sheet on paper: answers, what is accepted, what is carried, and what mistakes earn."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction

from corollary.answers.options import option_named
from corollary.answers.registry import answer_type
from corollary.derive.typeset_numbers import given_numbers, quantity
from corollary.formula.ast import names
from corollary.formula.latex import latex, letter
from corollary.formula.numerals import decimal_text
from corollary.grading.key import Key
from corollary.grading.marking_scheme import CarriedAnswer, PartScheme, marking_scheme
from corollary.messages import catalogue, in_convention
from corollary.notebook.worksheet import Exercise, Prompt
from corollary.problem.problem_set import Scheme
from corollary.problem.statement import formulas_in_convention
from corollary.problem.variant import with_unit, written
from corollary.render.paper.sheet import PaperSheet, typst_opening, typst_pages
from corollary.render.paper.typst_text import typst_line, typst_text, words_of
from corollary.render.wording import earned, points_earned
from corollary.units.unit import ONE, PURE, Unit, si_unit, unit
from corollary.units.unit import latex as unit_latex

_ = catalogue(__name__)

FIGURES = 4  # as in worked solutions


def typst_key(paper: PaperSheet, keys: Mapping[str, Key], solutions: Mapping[str, str]) -> str:
    """The key in Typst's markup; `keys` and worked `solutions` by the code of the problem. Raises CannotTypeset."""
    about = paper.worksheet.problem_set
    title = _("Marking scheme: {title}", title=about.title)
    pieces = [typst_opening(paper, title, key=True), typst_text(_shares(about.scheme))]
    for exercise in paper.worksheet.exercises:
        code = exercise.problem.code
        weight = about.weight(exercise.problem)
        pieces.append(typst_exercise_key(exercise, keys[code], about.scheme, weight))
        if worked := solutions.get(code):
            title = words_of(_("Worked solution"))
            pieces += [f"#heading(level: 3)[{title}]", typst_text(worked)]
    return typst_pages(paper, "key", "\n\n".join(pieces))


def typst_exercise_key(exercise: Exercise, key: Key, scheme: Scheme, weight: float) -> str:
    """The numbers of one exercise, and how each of its parts is marked."""
    problem = exercise.problem
    total = points_earned(sum(prompt.out_of for prompt in exercise.prompts))
    givens = ", ".join(
        f"${letter(given.symbol)}$ = {in_convention(written(exercise.variant, given.symbol))}"
        for given in problem.givens
    )
    numbers = typst_line(_("Numbers: {givens}", givens=givens)) if givens else ""
    prompts = {prompt.part.id: prompt for prompt in exercise.prompts}
    title = f"#exercise([{words_of(f'{problem.code} {problem.title}')}], [{words_of(total)}])"
    pieces = [f"#asked[{title}\n\n{numbers}]"]
    for each in marking_scheme(key, scheme, weight):
        prompt = prompts[each.part.id]
        title = words_of(f"({prompt.part.heading_letter}) ") + typst_line(prompt.part.title)
        pieces.append(f"#exercise-part([{title}], [{words_of(points_earned(each.out_of))}])")
        if items := [f"[{item}]" for item in _items(each, key, prompt)]:
            pieces.append(f"#items({', '.join(items)})")
        pieces.append(typst_text(formulas_in_convention(each.answer)))
    return "\n\n".join(filter(None, pieces))


def _shares(scheme: Scheme) -> str:
    """What is the same for every part."""
    return _(
        "What follows from the student's own earlier answers earns {follows} of the points, a slip (sign, power of ten, factor of two, "
        "unit) {slip}, a known mistake {mistaken}.",
        follows=_percent(scheme.follows),
        slip=_percent(scheme.slip),
        mistaken=_percent(scheme.mistaken),
    )


def _percent(share: float) -> str:
    return f"{earned(100 * share)}\N{NO-BREAK SPACE}%"


def _items(each: PartScheme, key: Key, prompt: Prompt) -> Iterator[str]:
    """In Typst's markup, one item for each thing that a marker looks for; what a person compares with comes after."""
    if each.truth is not None:
        yield from map(_set, _quantity(each, key))
        for carried in each.carried:
            yield f"{_points(each.follows)} {_set(_carried(carried, each, key, prompt))}"
    elif each.letter:
        yield f"#strong[{_set(option_named(each.part, each.letter))}];"
    for mistake in each.mistakes:
        found = option_named(each.part, mistake.letter) if mistake.letter else _values(mistake.values, each)
        yield f"{_points(mistake.points)} {_set(found)}{words_of(': ')}{_set(mistake.sentence)}"


def _set(markdown: str) -> str:
    """A piece of an item; apart, because a sentence is the same on every sheet and the number before it on none."""
    return typst_line(formulas_in_convention(markdown))


def _points(points: float) -> str:
    return f"#strong[{words_of(f'{points_earned(points)}:')}];"


def _quantity(each: PartScheme, key: Key) -> Iterator[str]:
    """The answer with its unit, what is accepted, and the formula."""
    assert each.truth is not None
    find = key.find(each.truth)
    formulas = [
        f"${letter(name)} = {latex(tree)}$"
        for name, tree in zip(find.names, find.in_givens or (), strict=False)
    ]
    if answer_type(each.part.answer_type).in_symbols:
        remark = _("or any formula equal to it")
        yield f"{', '.join(formulas)} ({remark})"
        return
    accepted = _accepted(each)
    yield f"**{_values(each.truth.values, each)}** ({accepted})"
    if formulas:
        yield ", ".join(formulas)


def _values(values: tuple[float, ...], each: PartScheme) -> str:
    """Values in the part's unit, an angle in degrees too."""
    if each.part.rows:
        pairs = zip(values, each.part.units, strict=True)
        return in_convention("; ".join(_measure(unit.from_si(value), FIGURES, unit) for value, unit in pairs))
    asked = each.part.unit
    units = (asked, *([unit("deg")] if asked == unit("rad") else []))
    found = (", ".join(_measure(each.from_si(value), FIGURES, each) for value in values) for each in units)
    return in_convention(" = ".join(found))


def _accepted(each: PartScheme) -> str:
    """Between which values an answer is right; of a vector how far it may end from the right one."""
    found, asked = each.accepted, each.part.unit
    if each.part.rows and each.truth is not None:
        return _("each at most {percent} off", percent=_percent(each.truth.tolerance))
    if found is None:
        return _("exactly")
    if each.part.components:
        return _("at most {reach} off, as a vector", reach=_to_the_place(found.reach, found.place, asked))
    low, high = _to_the_place(found.low, found.place, PURE), _to_the_place(found.high, found.place, asked)
    return _("{low} to {high}", low=low, high=high)


def _to_the_place(value: Fraction, place: int, asked: Unit) -> str:
    """A number down to the place 10**`place`, with its unit."""
    figures = math.floor(math.log10(abs(value))) - place + 1 if value else 1
    return in_convention(_measure(value, figures, asked))


def _measure(value: Fraction | float, figures: int, asked: Unit) -> str:
    """A number with its unit, as text where it can be: most of a key is numbers, and a formula takes longer to set."""
    text = decimal_text(value, figures) if value else "0"
    mantissa, _e, power = text.partition("e")
    if power:
        symbol = unit_latex(asked)
        return rf"${mantissa}\cdot 10^{{{power}}}" + (rf"\,{symbol}$" if symbol else "$")
    return with_unit(text.replace("-", "−"), asked)


def _carried(carried: CarriedAnswer, each: PartScheme, key: Key, prompt: Prompt) -> str:
    """The formula by which a part follows from the student's own answers, with this sheet's numbers in it."""
    assert each.truth is not None
    letters = {part.id: part.heading_letter for part in prompt.problem.parts}
    used = frozenset[str]().union(*map(names, carried.trees))
    asked = {name for find in key.solution.unknowns if find.part in carried.earlier for name in find.names}
    numbers = given_numbers(key.variant)
    for find, values in zip(key.solution.unknowns, key.values, strict=True):
        for name, value, dimension in zip(find.names, values, find.dimensions, strict=True):
            if name in used - asked:
                numbers[name] = quantity(value, si_unit(dimension), in_formula=dimension != ONE)
    formulas = [
        " = ".join(dict.fromkeys((f"${letter(name)}", latex(tree), latex(tree, numbers)))) + "$"
        for name, tree in zip(key.find(each.truth).names, carried.trees, strict=True)
    ]
    parts = ", ".join(f"({letters.get(part, part)})" for part in carried.earlier)
    return _(
        "from the student's own answer to {parts}: {formulas}", parts=parts, formulas=", ".join(formulas)
    )
