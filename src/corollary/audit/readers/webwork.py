"""WeBWorK `.pg`: variables drawn and assigned one after the other, and the one answer; parsed, never executed."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from corollary.audit.readers.straight_line import NotRead, StraightLine, arguments_at, formula_from
from corollary.audit.record import ExerciseRecord
from corollary.audit.record_file import text_of
from corollary.formula.exact import constant

TEXT_BLOCK = re.compile(r"BEGIN_(\w+)\b.*?END_\1\b", re.DOTALL)
HEREDOC = re.compile(r"<<\s*([\"']?)([A-Za-z_]\w*)\1([^\n]*)\n(.*?\n)?\2[ \t]*(?=\n|\Z)", re.DOTALL)
DOCUMENTATION = re.compile(r"(?ms)^=[A-Za-z].*?(?:^=cut\b[^\n]*$|\Z)")
CODE_IN_TEXT = re.compile(r"(?:\\\{|\[@)[^}@]*[$@%]\w+\s*(?:[-+*/.|&]|\*\*)?=(?![=~>])")
COMMENT = re.compile(r"(?m)^\s*#.*$|(?<=;)\s*#.*$")
ASSIGNED = re.compile(r"^(?:my\s+)?\$(\w+)\s*=\s*(.+)$", re.DOTALL)
CONTROL = re.compile(r"\b(?:if|unless|for|foreach|while|until|do|sub)\b\s*[({]|[{]\s*$", re.MULTILINE)
CHANGED = re.compile(
    r"\$\w+\s*(?:\+\+|--|(?:[-+*/.%x|&^]|\*\*|\|\||//)=(?![=~]))|(?:\+\+|--)\s*\$|\)\s*=(?![=~])"
)
QUOTED = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'")
VARIABLE = re.compile(r"\$\{?(\w+)\}?")
WRAPPED = re.compile(
    r"(Real|Compute|Formula|NumberWithUnits|num_cmp|std_num_cmp|strict_num_cmp|NumberWithUnits_cmp)\s*\("
)
WITH_UNITS = {"NumberWithUnits", "NumberWithUnits_cmp"}
IN_PGML = re.compile(r"\[_+\]\*?\{(.*?)\}", re.DOTALL)
CONSTANT = re.compile(r"\$PI\b")
PRINTED = re.compile(r"""sprintf\s*\(\s*["']%[\d.]*l?[feg]["']\s*,""", re.IGNORECASE)
END = "ENDDOCUMENT"
ANSWERED = re.compile(r"\bANS\s*\(")
UNIT_BEHIND = re.compile(r"""^["']\s*\$(\w+)\s+([^"'$]+)["']$""")
RUN_TOGETHER = re.compile(r"[\w.]\$|\$\{?\w+\}?(?:\s*\$|(?<=\})\w|\.\d)")
RAISED = re.compile(r"\$\{?(\w+)\}?\s*(?:\^|\*\*)")
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
        self.lines.attempt(letter, partial(self._assign, letter, expression))

    def _assign(self, letter: str, expression: str) -> None:
        self.units.pop(letter, None)
        call = re.match(r"(random|list_random|non_zero_random)\s*\(", expression)
        if call is None:
            key, unit = self.key(expression)
            self.lines.assign(letter, VARIABLE.sub(r"\1", key))
            if unit:
                self.units[letter] = unit
            return
        inside, end = arguments_at(expression, call.end())
        if expression[end:].strip():
            raise NotRead("what is drawn is changed at once")
        if call[1] == "list_random":
            self.lines.draw_among(letter, inside)
        elif len(inside) in {2, 3}:
            self.lines.draw(letter, inside[0], inside[1])
        else:
            raise NotRead(f"{call[1]} with {len(inside)} arguments is not read")

    def key(self, answer: str) -> tuple[str, str]:
        """The expression inside of what compares it, and the unit that it is followed by. Raises NotRead."""
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
            text = inside[0].strip()
        if (with_unit := UNIT_BEHIND.match(text)) is not None:
            text, unit = f"${with_unit[1]}", with_unit[2].strip()
        elif text[:1] in {'"', "'", "`"}:
            text = self._interpolated(text)
        elif "^" in text:
            raise NotRead("^ is no power in Perl")
        behind = {self.units[letter] for letter in VARIABLE.findall(text) if letter in self.units}
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
            drawn = self.lines.drawn.get(letter)
            if drawn is None or drawn.low is None or drawn.low < 0:
                raise NotRead(f"{text!r} raises ${letter}, which may be written with a minus sign")
        return inside


def webwork_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The one exercise of a file. Raises Malformed."""
    bare = ExerciseRecord(path.stem, path, 1)
    try:
        return (_read(text_of(path), bare),)
    except NotRead as error:
        return (replace(bare, unread=str(error)),)


def _read(source: str, bare: ExerciseRecord) -> ExerciseRecord:
    source = CONSTANT.sub("pi", DOCUMENTATION.sub("", source))
    blocks = [each[0] for each in (*TEXT_BLOCK.finditer(source), *HEREDOC.finditer(source))]
    if any(map(CODE_IN_TEXT.search, blocks)):
        raise NotRead("its text assigns something")
    answers = [found[1] for block in blocks for found in IN_PGML.finditer(block)]
    program_text = COMMENT.sub("", HEREDOC.sub(r"''\3", TEXT_BLOCK.sub("", source)))
    program_text = QUOTED.sub(lambda found: found[0].replace(";", " "), program_text).partition(END)[0]
    for found in ANSWERED.finditer(program_text):
        answers.append(", ".join(arguments_at(program_text, found.end())[0]))
    if len(answers) != 1:
        raise NotRead(f"it has {len(answers)} answers, and one is read")
    if CONTROL.search(program_text):
        raise NotRead("its program has conditions, loops or routines; one of assignments alone is read")
    program, statements = PerlProgram(), [each.strip() for each in program_text.split(";")]
    if any(CHANGED.search(UPDATED.sub("", each)) for each in statements):
        raise NotRead("a variable is changed after it was assigned")
    for statement in statements:
        program.state(statement)
    expression, unit = program.key(answers[0])
    if "$" not in expression and re.match(r"[-+\d.]", expression):
        return replace(bare, published=(f"{expression} {unit}".strip(),))
    key = program.lines.key(VARIABLE.sub(r"\1", expression))
    number = constant(formula_from(key.text))
    if number is not None:
        return replace(bare, given=key.drawn, published=(f"{float(number):.15g} {unit}".strip(),))
    return replace(bare, given=key.drawn, published=(key.text,), worked_out=key.worked_out, key_unit=unit)
