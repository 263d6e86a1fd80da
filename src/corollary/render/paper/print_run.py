"""A print run: the sheets of a set, each with its marking scheme, and all sheets in one file for the printer."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from corollary.answers.option_names import option_named
from corollary.answers.registry import answer_type
from corollary.derive.numbers_in_formulas import given_numbers, quantity
from corollary.derive.solution import AppliedLaw, Solution
from corollary.formula.ast import Name, Number, names
from corollary.formula.latex import latex, letter, letters_printed, vector
from corollary.formula.numerals import decimal_text
from corollary.grading.key import Key
from corollary.grading.marking_scheme import CarriedAnswer, PartScheme, marking_scheme
from corollary.grading.solutions import Solutions
from corollary.messages import catalogue, in_convention, spoken
from corollary.notebook.worksheet import Exercise, Prompt
from corollary.problem.problem_set import ProblemSet, Scheme
from corollary.problem.statement import formulas_in_convention
from corollary.problem.variant import with_unit, written
from corollary.render.paper.sheet import PaperSheet, typst_opening, typst_pages, typst_sheet
from corollary.render.paper.typst import pdf, typesetter, typst_formula, typst_line, typst_text, words_of
from corollary.render.wording import earned, points_earned
from corollary.units.unit import ONE, PURE, Unit, si_unit, unit
from corollary.units.unit import latex as unit_latex

_ = catalogue(__name__)

_law_name = catalogue("corollary.laws")


def typst_formulas(solutions: Iterable[Solution]) -> str:
    """In Typst's markup, a table of names and equations in the order of the alphabet; "" where no general law is used.

    General is a law whose equation stands in letters of its own: one that is written in the letters of the problem alone is a
    step of its solution, and that two things are the same is no law.
    """
    found: dict[tuple[str, str], str] = {}
    for solution in solutions:
        own = {name for find in solution.unknowns for name in find.names}
        own |= {given.symbol for given in solution.problem.givens}
        for law in _laws(solution):
            textbook = law.textbook
            in_own = names(textbook.left) | names(textbook.right) <= own | {"pi"} and law.here == (textbook,)
            if in_own or all(isinstance(side, Name | Number) for side in (textbook.left, textbook.right)):
                continue
            vectors = {name: vector(name) for name in law.vectors}
            equation = latex(textbook, vectors)
            found[_law_name(law.name), equation] = typst_formula(equation, display=True)
    if not found:
        return ""
    cells = ", ".join(f"[{words_of(name)}], [{equation}]" for (name, _tex), equation in sorted(found.items()))
    title = words_of(_("Formulas"))
    return f"#formulas([{title}], {cells})"


def _laws(solution: Solution) -> Iterator[AppliedLaw]:
    for find in solution.unknowns:
        yield from find.laws
        for route in find.routes:
            yield from route.stated.laws
    for entry in (*solution.examples.values(), *solution.proofs.values()):
        yield from entry.laws
    for regime in solution.regimes:
        if regime.solution is not solution:
            yield from _laws(regime.solution)


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
    with letters_printed(exercise.problem.printed_letters):
        return _exercise_key(exercise, key, scheme, weight)


def _exercise_key(exercise: Exercise, key: Key, scheme: Scheme, weight: float) -> str:
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
        if mistake.formulas:
            found = ", ".join(f"${latex(tree)}$" for tree in mistake.formulas)
        else:
            found = (
                option_named(each.part, mistake.letter) if mistake.letter else _values(mistake.values, each)
            )
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
        pairs = zip(values, each.part.units_for(len(values)), strict=True)
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
    used = names(*carried.trees)
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


@dataclass(frozen=True, slots=True)
class Pages:
    """One sheet and its marking scheme in Typst's markup, not yet set."""

    sheet: str
    key: str


@dataclass(frozen=True, slots=True)
class PrintRun:
    """What is printed, and how: in large print, with a formula sheet, with worked solutions in the marking schemes."""

    problem_set: ProblemSet
    sheets: Sequence[PaperSheet]
    solutions: Solutions
    large: bool = False
    formulas: bool = False
    worked: bool = False
    _formula_sheets: dict[str, str] = field(default_factory=dict[str, str], init=False, repr=False)
    """By the language spoken."""

    def prepare(self) -> None:
        """Everything that all sheets share is found before there are processes that would each do it. Raises CannotTypeset
        without the extra `pdf`, and NotDerivable."""
        for module in ("typst", "segno"):
            typesetter(module)
        for problem in self.problem_set.problems:
            self.solutions.of(problem)
        self.formula_sheet()

    def formula_sheet(self) -> str:
        """The same for everybody: the laws of the whole set. In Typst's markup."""
        if not self.formulas:
            return ""
        if spoken() not in self._formula_sheets:
            used = [self.solutions.of(problem) for problem in self.problem_set.problems]
            self._formula_sheets[spoken()] = typst_formulas(used)
        return self._formula_sheets[spoken()]

    def pages(self, sheet: PaperSheet) -> Pages:
        """One sheet and its marking scheme. Raises CannotTypeset without the extra `pdf`."""
        exercises = sheet.worksheet.exercises
        keys = {each.problem.code: self.solutions.key(each.variant) for each in exercises}
        worked = (
            {code: self.solutions.worked_solution_of(key) for code, key in keys.items()}
            if self.worked
            else {}
        )
        return Pages(typst_sheet(sheet, self.formula_sheet()), typst_key(sheet, keys, worked))

    def printed(self, sheet: PaperSheet, pages: Pages) -> dict[str, bytes]:
        """The files of one sheet by name: the sheet and, in another folder, its marking scheme. Raises CannotTypeset."""
        name, of_key = self.name(sheet), _("Marking scheme: {title}", title=sheet.title)
        return {
            f"{name}.pdf": pdf([pages.sheet], sheet.title, large=self.large),
            f"keys/{name}-key.pdf": pdf([pages.key], of_key, large=self.large),
        }

    def name(self, sheet: PaperSheet) -> str:
        """What the files of a sheet are called; ids are names of folders, on every disk."""
        return f"{self.problem_set.name}-{sheet.mark}" if sheet.mark else self.problem_set.name

    def together(self, pages: Sequence[Pages]) -> dict[str, bytes]:
        """All sheets in one file, each beginning on the front of a leaf; none where there is one only. Raises CannotTypeset."""
        if len(pages) < 2:
            return {}
        fronts = [each.sheet.replace("#sheet(", "#sheet(front: true, ", 1) for each in pages]
        return {f"{self.problem_set.name}.pdf": pdf(fronts, self.problem_set.title, large=self.large)}
