"""An exercise as an LMS asks it: fields, what earns which share of the points, and the marks of each answer held against grading's."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from corollary.answers.answer import Letter
from corollary.answers.choice.judging import judge as judge_choice
from corollary.answers.common_errors import RATIOS, slips
from corollary.answers.expected import Expected, Quantity, Values
from corollary.answers.guessing import may_be_guessed
from corollary.answers.tolerance import ROUNDING_NOISE
from corollary.answers.verdict import Mistaken, Right, Slip, Verdict, word
from corollary.formula.ast import Expr, Number, Product
from corollary.grading.expectations import expected_of
from corollary.grading.from_json import from_json
from corollary.grading.guesses import guessed
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.points import grade, share
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.notebook.worksheet import Exercise, Prompt, exercise
from corollary.problem.part import Option, Part
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import Variant
from corollary.units.unit import ONE, Unit, show

NOT_ASKED = {
    "table": "the answer is a table, of which every entry earns its share, and is numbers in units of their own",
    "expression": "the answer is a formula; --to moodle-stack sends it to a Moodle that has STACK",
    "example": "the answer is an example of the student, which has to be inserted into the laws",
    "proof": "the answer is a derivation, line by line",
    "code": "the answer is a program, which has to be run",
    "plot": "the answer is a figure, which has to be drawn by a program",
}


@dataclass(frozen=True, slots=True)
class Credit:
    """What earns a share of a part's points: numbers near `values`, in the unit asked for.

    `reach` is how far off they may be together, `signed` which components must have the sign of theirs. `verdict` is right,
    mistaken or slip, `feedback` is Markdown, empty for what is right.
    """

    values: Values
    reach: float
    signed: tuple[bool, ...]
    share: float
    verdict: str
    feedback: str

    def ranges(self) -> tuple[tuple[float, float], ...]:
        """The lowest and the highest of each component, the others as they should be."""
        return tuple(
            (
                max(x - self.reach, 0.0) if signed and x > 0 else x - self.reach,
                min(x + self.reach, 0.0) if signed and x < 0 else x + self.reach,
            )
            for x, signed in zip(self.values, self.signed, strict=True)
        )


@dataclass(frozen=True, slots=True)
class NumbersAsked:
    """A field for each component (one, without a name, where it is one number); the first mark met counts."""

    prompt: Prompt
    components: tuple[str, ...]
    marks: tuple[Credit, ...]

    @property
    def unit(self) -> Unit:
        return self.prompt.part.unit


@dataclass(frozen=True, slots=True)
class OptionAsked:
    option: Option
    share: float
    feedback: str


@dataclass(frozen=True, slots=True)
class ChoiceAsked:
    """One of several options, in the order of the sheet."""

    prompt: Prompt
    options: tuple[OptionAsked, ...]


@dataclass(frozen=True, slots=True)
class ProseAsked:
    """Words, which a person marks by the rubric."""

    prompt: Prompt
    rubric: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class FormulaCredit:
    """What earns a share of a part's points: what equals these formulas, one for each component. `feedback` is Markdown."""

    trees: tuple[Expr, ...]
    share: float
    verdict: str
    feedback: str


@dataclass(frozen=True, slots=True)
class NotAsked:
    """A part that no LMS can mark, and why; of a formula, `formulas` are what one with computer algebra needs, in order.

    `positive`: every letter is a number above zero.
    """

    prompt: Prompt
    why: str
    formulas: tuple[FormulaCredit, ...] = ()
    positive: bool = False


PartAsked = NumbersAsked | ChoiceAsked | ProseAsked | NotAsked


@dataclass(frozen=True, slots=True)
class LmsItem:
    """One variant of a problem. `number` counts the variants of a pool from 1; `solution` is Markdown."""

    exercise: Exercise
    number: int
    parts: tuple[PartAsked, ...]
    solution: str
    key: Key
    scheme: Scheme

    @property
    def figure_name(self) -> str:
        """What the file of its figure is called; "" where it has none."""
        return f"{self.exercise.problem.name}-{self.number}.svg" if self.exercise.figure else ""


def item(solutions: Solutions, variant: Variant, number: int, weight: float, scheme: Scheme) -> LmsItem:
    """Raises NotDerivable, and Undefined where an answer does not exist."""
    asked = exercise(variant, weight)
    key = solutions.key(variant)
    parts = tuple(_part(key, prompt, scheme) for prompt in asked.prompts)
    return LmsItem(asked, number, parts, solutions.worked_solution_of(key), key, scheme)


def _part(key: Key, prompt: Prompt, scheme: Scheme) -> PartAsked:
    part = prompt.part
    expected = expected_of(key, part)
    if len(part.answer_types) > 1:
        return NotAsked(prompt, NOT_ASKED["code"])
    match part.answer_type:
        case "value" | "integer" | "vector" if expected.quantity is not None:
            marks = tuple(_distinct(_marks(key, part, expected.quantity, scheme)))
            return NumbersAsked(prompt, part.components or ("",), marks)
        case "choice" if expected.option is not None:
            return ChoiceAsked(prompt, tuple(_options(expected, prompt, scheme)))
        case "explain":
            return ProseAsked(prompt, expected.rubric)
        case "expression" if expected.quantity is not None and expected.quantity.formulas is not None:
            formulas = tuple(_formulas(expected.quantity, expected.quantity.formulas, scheme))
            above_zero = all(low > 0 for low, _high in expected.quantity.domain().values())
            return NotAsked(prompt, NOT_ASKED["expression"], formulas, above_zero)
        case other:
            return NotAsked(prompt, NOT_ASKED.get(other, f"no LMS knows answers of the type {other}"))


def _options(expected: Expected, prompt: Prompt, scheme: Scheme) -> Iterator[OptionAsked]:
    for option in prompt.options:
        verdict = judge_choice(Letter(option.letter, ""), expected)
        right = isinstance(verdict, Right)
        yield OptionAsked(option, share(verdict, scheme, "choice"), "" if right else sentence(verdict))


def _formulas(wanted: Quantity, right: tuple[Expr, ...], scheme: Scheme) -> Iterator[FormulaCredit]:
    """In the order in which `judge_formulas` tries them; of the constant ratios those that are fractions."""

    def credit(trees: tuple[Expr, ...], verdict: Verdict) -> FormulaCredit:
        feedback = "" if isinstance(verdict, Right) else sentence(verdict)
        return FormulaCredit(trees, share(verdict, scheme), word(verdict), feedback)

    yield credit(right, Right())
    for trees, text in wanted.wrong_formulas():
        yield credit(trees, Mistaken(text))
    for ratio in RATIOS if len(right) == 1 else ():
        factor = Fraction(str(ratio.factor))
        if ratio.factor < 0 and wanted.signed == (False,):
            continue
        if ratio.formula and factor.limit_denominator(1000) == factor:
            tells = ratio.of_formula()
            trees = (Product((Number(factor), *right)),)
            yield credit(trees, Slip(f"{tells[0].upper()}{tells[1:]}."))


def _marks(key: Key, part: Part, wanted: Quantity, scheme: Scheme) -> Iterator[Credit]:
    """In the order in which `judge_numbers` tries them, of an answer given alone, with figures enough."""
    unit = part.unit
    zero = float(unit.offset)
    moved = replace(unit, offset=Fraction(0))  # temperatures are compared as they are written, in °C

    def mark(values: Values, verdict: Verdict, reach: float | None = None) -> Credit:
        above = [value - zero for value in values]
        length, residue = math.hypot(*above) or wanted.scale, max(wanted.residue, default=0.0)
        return Credit(
            tuple(value / unit.si for value in above),
            (max(wanted.tolerance * length, residue) if reach is None else reach) / unit.si,
            tuple(abs(x) > small for x, small in zip(above, wanted.uncertain, strict=True)),
            share(verdict, scheme),
            word(verdict),
            "" if isinstance(verdict, Right) else sentence(verdict),
        )

    yield mark(wanted.values, Right())
    ways = list(wanted.routes())
    yield from (mark(way.values, Right()) for way in ways)
    for way in ways:
        for values, text in way.misconceptions() if way.misconceptions else ():
            nothing = not any(values)
            verdict = Mistaken(text, nothing=nothing)
            if all(map(math.isfinite, values)):
                yield mark(values, verdict, ROUNDING_NOISE * wanted.scale if nothing else None)
    for way in ways:
        above = tuple(value - zero for value in way.values)
        general = [
            (tuple(x + zero for x in values), text)
            for values, text in slips(above, moved, part.title, wanted.signed)
        ]
        for values, text in [*general, *(way.slips() if way.slips else ())]:
            if any(values) and all(map(math.isfinite, values)):
                typed = [(value - zero) / unit.si for value in values]
                guess = may_be_guessed(typed, values, way.values, unit, counted=wanted.counted)
                yield mark(values, guessed(Slip(text, nothing=guess), values, key, part, {}))


def _distinct(marks: Iterator[Credit]) -> Iterator[Credit]:
    """Without those that an earlier one covers: two ways to the same value."""
    found: list[Credit] = []
    for each in marks:
        if not any(
            math.dist(each.values, other.values) + each.reach <= other.reach * (1 + 1e-9) for other in found
        ):
            found.append(each)
            yield each


INSIDE, OUTSIDE = 0.98, 1.02  # of what is tolerated
FAR = 1.37
EDGE = 1e-3  # of what is tolerated: nobody is surprised by either mark there


@dataclass(frozen=True, slots=True)
class TriedAnswer:
    """`fields` are the texts typed into the part's fields (a letter for a choice), `unit` is what was typed behind each number
    for us, `share` what part of the points we give. `sort` says what was tried: right, rounded, misconception, ..."""

    part: Part
    sort: str
    fields: tuple[str, ...]
    share: float


def answer_table(item: LmsItem) -> list[TriedAnswer]:
    """The rows of every part that has fields, the other parts left blank."""
    return [
        TriedAnswer(asked.prompt.part, sort, fields, _share(item, asked, fields))
        for asked in item.parts
        for sort, fields in _typed(asked)
    ]


def _typed(asked: PartAsked) -> Iterator[tuple[str, tuple[str, ...]]]:
    match asked:
        case ChoiceAsked():
            for each in asked.options:
                yield ("right" if each.share == 1 else "wrong option"), (each.option.letter,)
            yield "blank", ("",)
        case NumbersAsked():
            yield from _numbers(asked)
        case _:
            return


def _numbers(asked: NumbersAsked) -> Iterator[tuple[str, tuple[str, ...]]]:
    right = asked.marks[0]

    def typed(values: Sequence[float], figures: int = 7) -> tuple[str, ...]:
        return tuple(f"{value + 0.0:#.{figures}g}".rstrip(".") for value in values)

    first, *others = right.values
    towards = math.copysign(right.reach, first or 1.0)
    yield "right", typed(right.values)
    if any(right.values) and all(_rounds_within(right, x) for x in right.values):
        yield "rounded", typed(right.values, 3)
    yield "just inside", typed((first + INSIDE * towards, *others))
    yield "just outside", typed((first + OUTSIDE * towards, *others))
    for place, each in enumerate(asked.marks[1:], 1):
        if any(_on_the_edge(earlier, each.values) for earlier in asked.marks[:place]):
            continue
        yield each.verdict, typed(each.values)
    yield "far off", typed([FAR * x + (7 if not x else 0) for x in right.values])
    if len(right.values) > 1:
        yield "one component", typed((first, *(FAR * x + right.reach * 7 for x in others)))
    if any(not float(x).is_integer() for x in right.values):
        yield "comma", tuple(text.replace(".", ",") for text in typed(right.values, 4))
    yield "blank", ("",) * len(right.values)


def _on_the_edge(mark: Credit, values: Sequence[float]) -> bool:
    """Whether doubles decide on which side they lie."""
    return abs(math.dist(mark.values, values) - mark.reach) <= EDGE * mark.reach


def _rounds_within(mark: Credit, value: float) -> bool:
    return abs(float(f"{value:.3g}") - value) <= INSIDE * mark.reach / math.sqrt(len(mark.values))


def _share(item: LmsItem, asked: PartAsked, fields: Sequence[str]) -> float:
    """As if it had been handed in as text, each number with its unit behind it."""
    part = asked.prompt.part
    if not any(fields):
        answer = None
    elif isinstance(asked, NumbersAsked):
        behind = f" {show(part.unit)}" if part.unit.dimension != ONE or not part.unit.bare else ""
        texts = [f"{text}{behind}" for text in fields]
        answer = texts if asked.components != ("",) else texts[0]
    else:
        answer = fields[0]
    grades = grade(item.key, judge(item.key, {part.id: from_json(answer)}), item.scheme)
    return grades[part.id].points / part.points
