"""WeBWorK `.pg`: variables drawn and assigned one after the other, and its answers; parsed, never executed."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from corollary.audit.forgiven import forgiven_in_webwork
from corollary.audit.readers.straight_line import (
    MOST_STATEMENTS,
    NotRead,
    PublishedFormula,
    StraightLine,
    arguments_at,
    formula_from,
    in_figures,
    refuse_long,
)
from corollary.audit.readers.webwork_source import WebworkSource, webwork_source
from corollary.audit.record import ExerciseRecord, ForgivenError
from corollary.audit.text_file import LARGEST_PROGRAM, text_of
from corollary.formula.abbreviations import function_words
from corollary.formula.exact import constant

ASSIGNED = re.compile(r"^(?:my\s+)?\$(\w+)\s*=\s*(.+)$", re.DOTALL)
CONTROL = re.compile(r"\b(?:if|unless|for|foreach|while|until|do|sub)\b\s*[({]|[{]\s*$", re.MULTILINE)
CHANGED = re.compile(
    r"\$\w+\s*(?:\+\+|--|(?:[-+*/.%x|&^]|\*\*|\|\||//)=(?![=~]))|(?:\+\+|--)\s*\$|\)\s*=(?![=~])"
)
VARIABLE = re.compile(r"\$\{?(\w+)\}?")
WRAPPED = re.compile(
    r"(Real|Compute|Formula|NumberWithUnits|num_cmp|std_num_cmp|strict_num_cmp|NumberWithUnits_cmp)\s*\("
)
WITH_UNITS = {"NumberWithUnits", "NumberWithUnits_cmp"}
PRINTED = re.compile(r"""sprintf\s*\(\s*["']%[\d.]*l?[feg]["']\s*,""", re.IGNORECASE)
WHOLE = re.compile(r"""sprintf\s*\(\s*["']%0?\.0+f""")
DRAWN = re.compile(r"(random|list_random|non_zero_random)\s*\(")
UNIT_BEHIND = re.compile(r"""^["']\s*\$(\w+)\s+([^"'$]+)["']$""")
RUN_TOGETHER = re.compile(r"[\w.]\$|\$\{?\w+\}?(?:\s*\$|(?<=\})\w|\.\d)")
RAISED = re.compile(r"\$\{?(\w+)\}?\s*(?:\^|\*\*)")
OF_FUNCTION = "_v"  # behind a variable that is called as a function is: `gamma_v`
UPDATED = re.compile(r"^\$(\w+)\s*(\*\*|[-+*/])=\s*(.+)$", re.DOTALL)


@dataclass(slots=True)
class PerlProgram:
    """The assignments of a file, and the unit of each letter that is a number with a unit."""

    lines: StraightLine = field(default_factory=StraightLine)
    units: dict[str, str] = field(default_factory=dict[str, str])

    def state(self, statement: str) -> None:
        """An assignment; whatever else there is does not set a letter. Raises NotRead."""
        if (changed := UPDATED.match(statement)) is not None:
            letter, expression = changed[1], f"${changed[1]} {changed[2]} ({changed[3]})"
        elif (assigned := ASSIGNED.match(statement)) is not None:
            letter, expression = assigned[1], assigned[2].strip()
        else:
            return
        letter = _letter(letter)
        self.lines.attempt(letter, partial(self._assign, letter, expression))

    def _assign(self, letter: str, expression: str) -> None:
        self.units.pop(letter, None)
        key, unit = self.key(expression)
        call = DRAWN.match(key)
        if call is None:
            self.lines.assign(letter, _letters(key))
            if unit:
                self.units[letter] = unit
            return
        inside, end = arguments_at(key, call.end())
        if key[end:].strip() or unit:
            raise NotRead("what is drawn is changed at once")
        if call[1] == "list_random":
            self.lines.draw_among(letter, inside)
        elif len(inside) in {2, 3}:
            self.lines.draw(letter, inside[0], inside[1])
        else:
            raise NotRead(f"{call[1]} with {len(inside)} arguments is not read")

    def key(self, answer: str) -> tuple[str, str]:
        """The expression inside of what compares it, and the unit that it is followed by. Raises NotRead."""
        refuse_long(answer)
        text = re.sub(r"->\s*(?:cmp|with|evaluator)\b.*$", "", answer.strip(), flags=re.DOTALL).strip()
        unit = ""
        while (wrapped := WRAPPED.match(text) or PRINTED.match(text)) is not None:  # rounding is for the page
            inside, end = arguments_at(text, wrapped.end())
            if text[end:].strip() or not inside:
                raise NotRead(f"the answer {answer.strip()!r} is not read")
            if wrapped.re is WRAPPED and wrapped[1] in WITH_UNITS and len(inside) == 2:
                unit = inside[1].strip("\"' ")
                if "$" in unit or "=" in unit:
                    raise NotRead(f"the unit in {answer.strip()!r} is not read")
            if WHOLE.match(text) and not DRAWN.match(inside[0]):
                raise NotRead("a number that is worked out is rounded to a whole one")
            text = inside[0].strip()
        if (with_unit := UNIT_BEHIND.match(text)) is not None:
            text, unit = f"${with_unit[1]}", with_unit[2].strip()
        elif text[:1] in {'"', "'", "`"}:
            text = self._interpolated(text)
        elif "^" in text:
            raise NotRead("^ is no power in Perl")
        letters = [_letter(each) for each in VARIABLE.findall(text)]
        behind = {self.units[letter] for letter in letters if letter in self.units}
        if behind and (unit or not VARIABLE.fullmatch(text)):
            raise NotRead("a number with a unit is calculated with")
        return text, unit or next(iter(behind), "")

    def _interpolated(self, text: str) -> str:
        """A text into which numbers are put as digits, where that is the same as putting in the numbers. Raises NotRead."""
        if len(text) < 2 or text[-1] != text[0]:
            raise NotRead(f"{text!r} is more than one text")
        inside = text[1:-1]
        if RUN_TOGETHER.search(inside):
            raise NotRead(f"{text!r} writes digits side by side")
        for letter in RAISED.findall(inside):
            drawn = self.lines.drawn.get(_letter(letter))
            if drawn is None or drawn.low is None or drawn.low < 0:
                raise NotRead(f"{text!r} raises ${letter}, which may be written with a minus sign")
        return inside


def webwork_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The answers of a file, each a record: `fall` where it is the only one, else `fall#2`. Raises Malformed."""
    bare = ExerciseRecord(path.stem, path, 1)
    try:
        source = webwork_source(text_of(path, LARGEST_PROGRAM))
        if not source.answers:
            raise NotRead("it has 0 answers")
        program, read = _program(source)
    except NotRead as error:
        return (replace(bare, unread=str(error)),)
    return tuple(
        _record(replace(bare, id=bare.id if len(read) == 1 else f"{bare.id}#{name}"), program, each)
        for name, each in read.items()
    )


@dataclass(frozen=True, slots=True)
class WebworkAnswer:
    """An answer where it is worked out: a number as it stands, or a formula; the unit behind it; and its tolerance."""

    number: str
    key: PublishedFormula | None
    unit: str
    forgiven: ForgivenError | None


def _program(source: WebworkSource) -> tuple[PerlProgram, dict[str, WebworkAnswer | NotRead]]:
    """The program behind its last statement, and each answer as it is worked out on the way. Raises NotRead."""
    if CONTROL.search(source.text):
        raise NotRead("its program has conditions, loops or routines; one of assignments alone is read")
    if len(source.statements) > MOST_STATEMENTS:
        raise NotRead(f"its program has more than {MOST_STATEMENTS} statements")
    if any(CHANGED.search(UPDATED.sub("", each)) for each in source.statements):
        raise NotRead("a variable is changed after it was assigned")
    for name in VARIABLE.findall(source.text):
        if name.removesuffix(OF_FUNCTION) != name and name.removesuffix(OF_FUNCTION) in function_words():
            raise NotRead(f"{name} is no letter here")
    program, read = PerlProgram(), dict[str, WebworkAnswer | NotRead]()
    waiting = list(source.answers.items())[::-1]
    for place, statement in enumerate(source.statements):
        program.state(statement)
        while waiting and waiting[-1][1][0] == place:
            name, (_, answer) = waiting.pop()
            try:
                contexts = " ".join(each for each in source.statements[:place] if "flags" in each)
                read[name] = _answered(program, answer, forgiven_in_webwork(contexts, answer))
            except NotRead as error:
                read[name] = error
    return program, read


def _answered(program: PerlProgram, answer: str, forgiven: ForgivenError | None) -> WebworkAnswer:
    """Raises NotRead."""
    expression, unit = program.key(answer)
    if "$" not in expression and re.match(r"[-+\d.]", expression):
        return WebworkAnswer(expression, None, unit, forgiven)
    key = program.lines.key(_letters(expression))
    number = constant(formula_from(key.text))
    return WebworkAnswer("" if number is None else in_figures(number), key, unit, forgiven)


def _record(bare: ExerciseRecord, program: PerlProgram, read: WebworkAnswer | NotRead) -> ExerciseRecord:
    """A number is published with its unit; a formula in all letters that are drawn, also behind it."""
    if isinstance(read, NotRead):
        return replace(bare, unread=str(read))
    drawn = tuple(program.lines.drawn.values())
    bare = replace(bare, forgives=(read.forgiven,))
    if read.key is None or read.number:
        given = drawn if read.key is not None else ()
        return replace(bare, given=given, published=(f"{read.number} {read.unit}".strip(),))
    return replace(
        bare,
        given=drawn,
        published=(read.key.text,),
        worked_out=frozenset(program.lines.formulas),
        key_unit=read.unit,
    )


def _letters(expression: str) -> str:
    """Variables as letters; one that is called as a function is here ends otherwise."""
    return VARIABLE.sub(lambda found: _letter(found[1]), expression)


def _letter(name: str) -> str:
    return f"{name}{OF_FUNCTION}" if name in function_words() else name
