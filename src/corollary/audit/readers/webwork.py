"""WeBWorK `.pg`: variables drawn and assigned one after the other, and the one answer; parsed, never executed."""

from __future__ import annotations

import re
from pathlib import Path

from corollary.audit.readers.straight_line import NotRead, StraightLine, arguments_at, formula_from
from corollary.audit.record import ExerciseRecord, StatedGiven
from corollary.audit.record_file import text_of
from corollary.formula.exact import constant

TEXT_BLOCK = re.compile(r"BEGIN_(TEXT|PGML|SOLUTION|HINT|PGML_SOLUTION|PGML_HINT)\b.*?END_\1", re.DOTALL)
COMMENT = re.compile(r"(?m)^\s*#.*$|(?<=;)\s*#.*$")
ASSIGNED = re.compile(r"^(?:my\s+)?\$(\w+)\s*=\s*(.+)$", re.DOTALL)
CONTROL = re.compile(r"\b(?:if|unless|for|foreach|while|until|do|sub)\b\s*[({]|[{]\s*$", re.MULTILINE)
CHANGED = re.compile(
    r"\$\w+\s*(?:\+\+|--|(?:[-+*/.%x|&^]|\*\*|\|\||//)=(?![=~]))|(?:\+\+|--)\s*\$|\)\s*=(?![=~])"
)
QUOTED = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'")
VARIABLE = re.compile(r"\$\{?(\w+)\}?")
WRAPPED = re.compile(r"(?:Real|Compute|Formula|NumberWithUnits|num_cmp|NumberWithUnits_cmp)\s*\(")
IN_PGML = re.compile(r"\[_+\]\*?\{(.*?)\}", re.DOTALL)
CONSTANT = re.compile(r"\$PI\b")
PRINTED = re.compile(r"""sprintf\s*\(\s*["']%[\d.]*l?[feg]["']\s*,""", re.IGNORECASE)
ANSWERED = re.compile(r"\bANS\s*\(")
UNIT_BEHIND = re.compile(r"""^["']\s*\$(\w+)\s+([^"'$]+)["']$""")


def webwork_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The one exercise of a file. Raises Malformed."""
    source = text_of(path)
    try:
        given, published = _read(source)
        return (ExerciseRecord(path.stem, path, 1, given, published=(published,)),)
    except NotRead as error:
        return (ExerciseRecord(path.stem, path, 1, unread=str(error)),)


def _read(source: str) -> tuple[tuple[StatedGiven, ...], str]:
    answers = [found[1] for block in TEXT_BLOCK.finditer(source) for found in IN_PGML.finditer(block[0])]
    answers = [CONSTANT.sub("pi", each) for each in answers]
    source = CONSTANT.sub("pi", source)
    program_text = COMMENT.sub("", TEXT_BLOCK.sub("", source))
    program_text = QUOTED.sub(lambda found: found[0].replace(";", " "), program_text)
    for found in ANSWERED.finditer(program_text):
        answers.append(", ".join(arguments_at(program_text, found.end())[0]))
    if len(answers) != 1:
        raise NotRead(f"it has {len(answers)} answers, and one is read")
    if CONTROL.search(program_text):
        raise NotRead("its program has conditions, loops or routines; one of assignments alone is read")
    if CHANGED.search(program_text):
        raise NotRead("a variable is changed after it was assigned")
    program = StraightLine()
    unread: dict[str, str] = {}
    for statement in program_text.split(";"):
        if (assigned := ASSIGNED.match(statement.strip())) is not None:
            program.refuse_again(assigned[1])
            try:
                _assign(program, assigned[1], assigned[2].strip())
            except NotRead as error:
                unread[assigned[1]] = str(error)  # it counts only where the key needs it
    key, unit = _key(answers[0])
    if "$" not in key and re.match(r"[-+\d.]", key):
        return (), f"{key} {unit}".strip()
    for letter in VARIABLE.findall(key):
        if letter in unread:
            raise NotRead(f"${letter}: {unread[letter]}")
    formula, drawn = program.key(VARIABLE.sub(r"\1", key))
    number = constant(formula_from(formula))
    return drawn, f"{float(number):.15g} {unit}".strip() if number is not None else formula


def _assign(program: StraightLine, letter: str, expression: str) -> None:
    call = re.match(r"(random|list_random|non_zero_random)\s*\(", expression)
    if call is None:
        key, unit = _key(expression)
        if unit:
            raise NotRead("it is a number with a unit")
        program.assign(letter, VARIABLE.sub(r"\1", key))
        return
    inside, end = arguments_at(expression, call.end())
    if expression[end:].strip():
        raise NotRead("what is drawn is changed at once")
    if call[1] == "list_random":
        program.draw_among(letter, inside)
    elif len(inside) in {2, 3}:
        program.draw(letter, inside[0], inside[1])
    else:
        raise NotRead(f"{call[1]} with {len(inside)} arguments is not read")


def _key(answer: str) -> tuple[str, str]:
    """The expression inside of what compares it, and the unit that it is followed by."""
    text = re.sub(r"->\s*(?:cmp|with|evaluator)\b.*$", "", answer.strip(), flags=re.DOTALL).strip()
    while (
        wrapped := WRAPPED.match(text) or PRINTED.match(text)
    ) is not None:  # rounding is for the page only
        inside, end = arguments_at(text, wrapped.end())
        rest = text[end:].strip()
        if rest or not inside:
            raise NotRead(f"the answer {answer.strip()!r} is not read")
        text = inside[0].strip()
    if (with_unit := UNIT_BEHIND.match(text)) is not None:
        return f"${with_unit[1]}", with_unit[2].strip()
    if text[:1] in {'"', "'", "`"}:
        return text.strip("\"'`"), ""
    if "^" in text:
        raise NotRead("^ is no power in Perl")
    return text, ""
