"""The equations of a derivation, out of its lines, with the letters that the student gives a meaning to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from corollary.answers.answer import Equation, Unclear
from corollary.answers.formula import with_points
from corollary.answers.name import keyboard
from corollary.answers.proof.line_text import (
    Readable,
    equations,
    greek_letters,
    is_prose,
    lettered,
    lone,
    says_nothing,
    sides,
    without_bullets,
)
from corollary.answers.proof.rates import letter_of, with_stand_ins, worked_out
from corollary.formula.ast import Expr, Name, Relation, names
from corollary.formula.errors import ParseError, sentence
from corollary.formula.symbols import GREEK, RUN, letters, read_run
from corollary.formula.syntax import parse
from corollary.messages import catalogue

_ = catalogue(__name__)

MOST_STEPS = 120
GREEK_WORDS = frozenset(GREEK.values())


def steps_of(lines: Sequence[tuple[int, str]], known: Sequence[str]) -> tuple[Equation, ...] | Unclear:
    """The equations in order; `a = b = c` says two things of a, `= b` goes on from the line before, words alone are none."""
    found = with_stand_ins(lines, known)
    steps = _steps_of(found.lines, known, found.of)
    return _steps_of(lines, known, {}) if isinstance(steps, Unclear) and found.of else steps


def _steps_of(
    lines: Sequence[tuple[int, str]], known: Sequence[str], of: Mapping[str, Expr]
) -> tuple[Equation, ...] | Unclear:
    """The equations of lines in which letters stand for derivatives."""
    typed = _typed(lines, known)
    if isinstance(typed, Unclear):
        return typed
    names_here = [*known, *_own_letters(typed, known)]
    again = _typed(lines, names_here)  # with letters of one's own, less is taken for words
    typed = typed if isinstance(again, Unclear) else again
    steps, readable = list[Equation](), _readable(names_here)
    for number, equation in typed:
        found = _steps(number, equation, names_here, readable, steps[-1].relation.left if steps else None)
        if isinstance(found, str):
            return _unclear(number, equation, found)
        steps += found
    if len(steps) > MOST_STEPS:
        number, equation = typed[0]
        return Unclear(
            _("more than {count} equations; keep to the steps that matter", count=MOST_STEPS),
            equation.strip()[:80],
        )
    return defined(worked_out(steps, of), frozenset(known) | {"pi"}, rates_known=True)


def _typed(lines: Sequence[tuple[int, str]], known: Sequence[str]) -> list[tuple[int, str]] | Unclear:
    """The equations as typed, each with the number of its line."""
    typed, readable = list[tuple[int, str]](), _readable(known)
    for number, line in without_bullets(lines):
        if says_nothing(line):
            continue
        if not (found := equations(with_points(line), readable)):
            return _unclear(number, line, _(" must be one equation, with one = sign"))
        typed += [(number, each) for each in found if not is_prose(each, readable)]
    return typed


def _unclear(number: int, line: str, why: str) -> Unclear:
    return Unclear(_("line {number}{why}", number=number, why=why), line.strip()[:80])


def _readable(names_here: Sequence[str]) -> Readable:
    """Whether a word is a formula in these letters."""
    known, found = letters(frozenset(names_here)), dict[str, bool]()

    def readable(word: str) -> bool:
        if word not in found:
            read = read_run(word, 0, known)
            found[word] = not isinstance(read, ParseError) or read.status == "asked"
        return found[word]

    return readable


def _own_letters(typed: Sequence[tuple[int, str]], known: Sequence[str]) -> list[str]:
    """What stands alone on a side and is no letter of the problem, and what else looks like a letter: `J`, `dt`, `v_rel`."""
    found, readable = list[str](), _readable(known)
    written = {
        run for _number, equation in typed for side in sides(equation, readable) for run in RUN.findall(side)
    }
    for (
        _number,
        equation,
    ) in typed:  # `va = vA - vB`: two spellings of one letter in one derivation are two letters
        own = lone(sides(equation, readable)[0])
        if (
            own
            and own not in known
            and any(own != each and own.lower() == each.lower() for each in written & set(known))
        ):
            found.append(own)
    for _number, equation in typed:
        for side in sides(equation, readable):
            for letter in greek_letters(side):  # `gamma` is a function, γ is none
                if letter not in (*found, *known) and (letter == "gamma" or not readable(letter)):
                    found.append(letter)
            if lone(side) in GREEK_WORDS and not readable(lone(side)) and lone(side) not in found:
                found.append(lone(side))
    with_greek = _readable([*known, *found]) if found else readable
    for _number, equation in typed:
        for side in sides(equation, readable):
            for run in (lone(side), *lettered(side)):
                letter = keyboard(run)
                glued = letter != run or any(each in run for each in found if each in GREEK_WORDS)
                if letter and letter not in found and not (with_greek if glued else readable)(run):
                    found.append(letter)
            if lone(side) == "e" and "e" not in (*found, *known):
                found.append("e")
    return found


def _steps(
    number: int, equation: str, names_here: Sequence[str], readable: Readable, before: Expr | None
) -> list[Equation] | str:
    near: list[Expr] = []
    far: list[Expr] = []
    for place, side in enumerate(sides(equation, readable)):
        if not side.strip() and place == 0 and before is not None:
            near, far = [before], [before]
            continue
        tree = parse(side, names_here)
        if isinstance(tree, ParseError):
            one, other = parse(side, names_here, lean="near"), parse(side, names_here, lean="far")
            if tree.status == "refused" or isinstance(one, ParseError) or isinstance(other, ParseError):
                return f": {sentence(tree.without_place())}"
            near.append(one)
            far.append(other)
        else:
            near.append(tree)
            far.append(tree)
    return [
        Equation(
            Relation("=", near[0], right),
            number,
            "",
            None if (near[0], right) == (far[0], other) else Relation("=", far[0], other),
        )
        for right, other in zip(near[1:], far[1:], strict=True)
    ]


def defined(steps: Sequence[Equation], known: frozenset[str], *, rates_known: bool) -> tuple[Equation, ...]:
    """The steps, with what each defines; a letter is defined by the first line that says what it is in letters that are known.

    `rates_known`: how a letter changes is known where the letter is; else only a person can say it of a known letter.
    """
    found = list(steps)
    rates = {name for step in steps for name in names(step.relation) if letter_of(name)}
    understood = set(known) | {name for name in rates if rates_known and letter_of(name) in known}
    while more := next(
        (
            (place, name)
            for place, step in enumerate(found)
            if not step.defines and (name := _new(step.relation, understood))
        ),
        None,
    ):
        place, name = more
        found[place] = replace(found[place], defines=name)
        understood.add(name)
        understood |= {each for each in rates if rates_known and letter_of(each) == name}
    sides_of_steps = [side for step in steps for side in (step.relation.left, step.relation.right)]
    alone = {side.name for side in sides_of_steps if isinstance(side, Name)}
    return tuple(
        replace(
            step,
            undefined=min(
                names(step.relation) - understood, key=lambda name: (name in alone, name), default=""
            ),
        )
        for step in found
    )


def _new(relation: Relation, understood: set[str]) -> str:
    """The letter that is new and alone on one side of what is otherwise understood."""
    for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if not isinstance(one, Name) or letter_of(one.name) in understood:
            continue  # how a letter changes that has a meaning is no definition
        if one.name not in understood and names(other) <= understood:
            return one.name
    return ""
