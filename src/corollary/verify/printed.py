"""Numbers that a book prints, held against the answer for the printed givens."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal

from corollary.answers.quantity import Reading, read_quantity
from corollary.answers.tolerance import coarse, last_place
from corollary.answers.verdict import Right, Unread
from corollary.derive.solution import Solution
from corollary.derive.statements import Printed
from corollary.formula.errors import ParseError
from corollary.formula.numerals import figures_apart
from corollary.formula.plain_text import text
from corollary.formula.value import Items, Text
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.part import Part
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter
from corollary.units.unit import Unit, show
from corollary.verify.checked import Tally

ABOUT = "~"  # before an order of magnitude
HALF_AN_ORDER = 0.5  # of the decimal logarithm: 4e2 is of the order of 10^3, 3e2 of 10^2
EXACTLY = 1e-9  # relative: what is printed without figures was worked out in doubles
Agreement = Literal["agrees", "last figure", "order", "differs"]


def as_printed(
    value: float, printed: str, read: Reading, unit: Unit, figures: int | None = None
) -> Agreement:
    """How a printed text, read as `read`, agrees with a value in SI; a bare number is in `unit`.

    "order": it is of another order of magnitude, which is all that the text says. `figures` are those the number has, where
    its text leaves open whether zeros count.
    """
    ratio, pi = read.si
    measured_in = read.unit or unit
    size, zero = measured_in.si, float(measured_in.offset)
    mine, theirs = value - zero, float(ratio) * math.pi**pi - zero
    if mine == theirs:
        return "agrees"
    if printed.startswith(ABOUT):
        near = mine * theirs > 0 and abs(math.log10(mine / theirs)) <= HALF_AN_ORDER
        return "agrees" if near else "order"
    if not (read.figures or figures):  # a fraction, a square root: exact
        return "agrees" if math.isclose(mine, theirs, rel_tol=EXACTLY) else "differs"
    counts = range(max(1, read.least), max(1, read.figures) + 1) if figures is None else (figures,)
    if any(coarse((theirs,), (count,), (mine,), (size,), (0.0,)) for count in counts):  # 110 has two or three
        return "agrees"
    most = read.figures if figures is None else figures
    if most and theirs and abs(mine - theirs) <= 1.5 * last_place(theirs, most, size):
        return "last figure"
    return "differs"


FIGURES = 6  # of what the derivation gives; more where the printed number would look the same
ELSEWHERE = (
    3  # variants on which a printed formula is tried besides: at one set of numbers a wrong one may be right
)


def check_printed(bank: Bank, solution: Solution, tally: Tally) -> None:
    """Complains of what is printed otherwise than it is derived, unless it is on record as an erratum; and of an erratum that
    is none."""
    path = bank.solution(solution.problem)
    for entry in solution.entries:
        if not isinstance(entry, Printed):
            continue
        key, where = (
            make_key(solution, chapter(solution.problem)),
            f"{name_in_bank(path)}:{entry.statement.line}",
        )
        part = solution.problem.part(entry.statement.part)
        differences = list(_differences(key, part, entry))
        if not entry.erratum:
            tally.check(not differences, "printed values")
            for each in differences:
                tally.complain(f"{where}: {each}")
        elif tally.check(bool(differences), "errata"):
            for each in differences:
                tally.note(f"{where}: on record as an erratum ({entry.erratum}): {each}")
        else:
            tally.complain(
                f"{where}: {entry.where} agrees with the derivation for part {part.id}; leave erratum= out"
            )


def _differences(key: Key, part: Part, entry: Printed) -> Iterator[str]:
    """A sentence for each thing that is not as the derivation has it."""
    if part.id in key.choices:
        letter = entry.text.strip("() ").lower()
        if letter != key.choices[part.id]:
            yield (
                f"{entry.where} prints ({letter}) for part {part.id}; the derivation gives ({key.choices[part.id]})"
            )
        return
    readings = [
        read_quantity(each.strip().removeprefix(ABOUT).strip(), unit)
        for each, unit in zip(entry.text.split(";"), part.units_for(entry.text.count(";") + 1), strict=False)
    ]
    if all(isinstance(each, ParseError) for each in readings):
        yield from _formula(key, part, entry)
        return
    values = key.truths[part.id].values
    several = zip(values, entry.text.split(";"), readings, part.units_for(len(values)), strict=True)
    for value, printed, read, unit in several:
        if isinstance(read, ParseError):
            yield f"the printed value {printed!r} cannot be read: {read.why}"
        elif derived := _off(value, printed.strip(), read, unit):
            yield f"{entry.where} prints {printed.strip()} for part {part.id}; {derived}"


def readings_of(part: Part, entry: Printed) -> list[tuple[str, Reading]]:
    """The quantities that are printed for a part, with their texts; none where that is a formula or a letter."""
    found = [
        (each.strip(), read_quantity(each.strip().removeprefix(ABOUT).strip(), unit))
        for each, unit in zip(entry.text.split(";"), part.units_for(entry.text.count(";") + 1), strict=False)
    ]
    return [(each, read) for each, read in found if not isinstance(read, ParseError)]


def _off(value: float, printed: str, read: Reading, unit: Unit) -> str:
    """What the derivation gives for a printed quantity, where that is something else."""
    measured_in = read.unit or unit
    ratio, pi = read.si
    mine, theirs = measured_in.from_si(value), measured_in.from_si(float(ratio) * math.pi**pi)
    number = f"{mine:.{figures_apart((mine, theirs), FIGURES)}g}"
    derived = f"the derivation gives {number} {show(measured_in)}".rstrip()
    match as_printed(value, printed, read, unit):
        case "agrees":
            return ""
        case "order":
            return f"{derived}, which is of another order of magnitude"
        case "last figure":
            return f"{derived}: they differ by one in the last figure"
        case "differs":
            return derived


def _formula(key: Key, part: Part, entry: Printed) -> Iterator[str]:
    """The formula judged as a student's answer, with the numbers of the problem and with others."""
    texts = tuple(Text(each.strip()) for each in entry.text.split(";"))
    answer = texts[0] if len(texts) == 1 else Items(texts, (len(texts),))
    others = [
        make_key(key.solution, each) for each in sample(key.solution.problem, ELSEWHERE, salt="printed")
    ]
    for each in (key, *others):
        ((verdict, *_), _) = judge(each, {part.id: answer})[part.id]
        if isinstance(verdict, Unread):
            yield f"the printed value {entry.text!r} cannot be read: {verdict.why}"
            return
        if not isinstance(verdict, Right) or verdict.leniently:
            trees = key.find(key.truths[part.id]).in_givens or ()
            derived = f"the derivation gives {', '.join(map(text, trees)) or 'something else'}"
            yield f"{entry.where} prints {entry.text} for part {part.id}; {derived}"
            return
