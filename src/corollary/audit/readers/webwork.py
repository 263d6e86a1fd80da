"""WeBWorK `.pg`: variables drawn and assigned one after the other, and its answers; parsed, never executed."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from corollary.audit.forgiven import WEBWORK_OPTION, forgiven_in_webwork
from corollary.audit.readers.straight_line import (
    MOST_ANSWERS,
    MOST_STATEMENTS,
    NotRead,
    PublishedFormula,
    StraightLine,
    arguments_at,
    formula_from,
    in_figures,
    refuse_long,
)
from corollary.audit.record import ExerciseRecord, ForgivenError
from corollary.audit.text_file import LARGEST_PROGRAM, text_of
from corollary.formula.abbreviations import function_words
from corollary.formula.arithmetics import constant

BLOCK_MARK = re.compile(r"(BEGIN|END)_(\w+)")
HEREDOC = re.compile(r"<<\s*([\"']?)([A-Za-z_]\w*)\1")
DOCUMENTATION = re.compile(r"(?ms)^=[A-Za-z].*?(?:^=cut\b[^\n]*$|\Z)")
CODE_IN_TEXT = re.compile(r"\\\{|\[@")
CODE_ENDS = re.compile(r"[}@]")
ASSIGNMENT = re.compile(r"[$@%]\w+\s*(?:[-+*/.|&]|\*\*)?=(?![=~>])")
COMMENT = re.compile(r"(?m)^[^\S\n]*#.*$|(?<=;)[^\S\n]*#.*$")
QUOTED = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'")
PGML_BLANK = re.compile(r"\[_+\]\*?\{")
CONSTANT = re.compile(r"\$PI\b")
MARK = "\0"  # of a block that was taken out
END = "ENDDOCUMENT"
ANSWERED = re.compile(r"\b((?:(?:LABELED|NAMED|WEIGHTED|NAMED_WEIGHTED)_)?ANS)\s*\(")
SEVERAL = re.compile(r"@|\w_list\s*\(|\[")
TOGETHER = re.compile(r"\b(?:Radio)?MultiAnswer\s*\(")


@dataclass(frozen=True, slots=True)
class WebworkSource:
    """`statements` are those of the program, `text` is the whole of it; `answers` is what compares each answer, and behind which
    statement it is worked out, by its label if it has one and its place, from 1, if not."""

    text: str
    statements: tuple[str, ...]
    answers: dict[str, tuple[int, str]]


def webwork_source(source: str) -> WebworkSource:
    """Raises NotRead where a text assigns or answers something, and where the answers cannot be told apart."""
    if MARK in source:
        raise NotRead("it has a character that no text has")
    source = CONSTANT.sub("pi", DOCUMENTATION.sub("", source))
    source, blocks = _without_blocks(source)
    source, heredocs = _without_heredocs(source)
    texts = [*blocks, *heredocs]
    if any(map(_assigns, texts)):
        raise NotRead("its text assigns something")
    if any(map(ANSWERED.search, texts)):
        raise NotRead("its text answers something")
    source = COMMENT.sub("", source)
    source = QUOTED.sub(lambda found: found[0].replace(";", " "), source).partition(END)[0]
    if len(ANSWERED.findall(QUOTED.sub("''", source))) < len(ANSWERED.findall(source)):
        raise NotRead("a text within its program speaks of ANS")
    if any(map(PGML_BLANK.search, heredocs)):
        raise NotRead("it has answers in a text that is not a block of PGML")
    statements = tuple(each.strip() for each in source.split(";"))
    answers: dict[str, tuple[int, str]] = {}
    kinds = set[str]()
    for place, statement in enumerate(statements):
        in_block = statement.startswith(MARK)
        listed = _blanks(blocks[int(statement[1:])]) if in_block else _answers(statement)
        for label, answer in listed:
            kinds.add("PGML" if in_block else "ANS")
            name = label or str(len(answers) + 1)
            if name in answers:
                raise NotRead(f"two of its answers are called {name!r}")
            if len(answers) >= MOST_ANSWERS:
                raise NotRead(f"it has more than {MOST_ANSWERS} answers")
            answers[name] = (place, answer)
    if len(kinds) > 1:
        raise NotRead("it has answers in PGML and others in ANS")
    several = any(SEVERAL.search(answer) for _, answer in answers.values()) or TOGETHER.search(source)
    if len(answers) > 1 and several:
        raise NotRead("one of its answers compares several, and which is which is not certain")
    return WebworkSource(source, statements, answers)


def _without_blocks(source: str) -> tuple[str, list[str]]:
    """A program with a mark and a number in place of BEGIN_TEXT … END_TEXT and the like, and these."""
    marks = list(BLOCK_MARK.finditer(source))
    last_end = {each[2]: each.start() for each in marks if each[1] == "END"}
    rest, blocks = list[str](), list[str]()
    at, begun = 0, None
    for mark in marks:
        if begun is None:
            if mark[1] == "BEGIN" and last_end.get(mark[2], -1) > mark.start():
                rest.append(source[at : mark.start()])
                begun = mark
        elif mark[1] == "END" and mark[2] == begun[2]:
            rest.append(f";{MARK}{len(blocks)};")
            blocks.append(source[begun.start() : mark.end()])
            at, begun = mark.end(), None
    return "".join([*rest, source[at:]]), blocks


def _without_heredocs(source: str) -> tuple[str, list[str]]:
    """The same for texts `<<'END'`, which begin on the next line and end with a line that is the word alone."""
    ends: dict[str, list[int]] = {}
    starts, start = list[int](), 0
    for line in source.split("\n"):
        starts.append(start)
        ends.setdefault(line.rstrip(" \t"), []).append(start)
        start += len(line) + 1
    rest, texts, at = list[str](), list[str](), 0
    for found in HEREDOC.finditer(source):
        if found.start() < at:
            continue
        line = bisect_left(starts, found.end())  # the next one
        closing = ends.get(found[2], [])
        place = bisect_left(closing, starts[line]) if line < len(starts) else len(closing)
        if place < len(closing):
            rest += [source[at : found.start()], "''", source[found.end() : starts[line]]]
            at = closing[place] + len(found[2])
            texts.append(source[starts[line] : closing[place]])
    return "".join([*rest, source[at:]]), texts


def _assigns(text: str) -> bool:
    """Whether code within a text, in `\\{ … \\}` or `[@ … @]`, gives a variable a value."""
    at = 0
    while (begins := CODE_IN_TEXT.search(text, at)) is not None:
        ends = CODE_ENDS.search(text, begins.end())
        at = ends.start() if ends is not None else len(text)
        if ASSIGNMENT.search(text[begins.end() : at]) or ASSIGNMENT.match(text, at):
            return True
    return False


def _blanks(text: str) -> Iterator[tuple[str, str]]:
    """The answers in `[____]{ … }`, which have no label. Raises NotRead."""
    at = 0
    while (blank := PGML_BLANK.search(text, at)) is not None:
        inside, at = arguments_at(text, blank.end())
        yield "", ", ".join(inside)


def _answers(program: str) -> Iterator[tuple[str, str]]:
    """Each answer with its label, "" for none. Raises NotRead."""
    at = 0
    while (answered := ANSWERED.search(program, at)) is not None:
        inside, at = arguments_at(program, answered.end())
        match answered[1]:
            case "ANS":
                pairs = [("", each) for each in inside]
            case "WEIGHTED_ANS":
                pairs = [("", each) for each in inside[::2]]
            case kind:
                flat = [each for one in inside for each in (one.split("=>", 1) if "=>" in one else [one])]
                step = 3 if kind == "NAMED_WEIGHTED_ANS" else 2
                if len(flat) % step:
                    raise NotRead(f"{kind} with {len(inside)} arguments is not read")
                pairs = [
                    (label.strip(" \n\"'"), each)
                    for label, each in zip(flat[::step], flat[1::step], strict=True)
                ]
        yield from pairs


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
            raise NotRead("^ is not a power in Perl")
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
            raise NotRead(f"{name} is not a letter here")
    program, read = PerlProgram(), dict[str, WebworkAnswer | NotRead]()
    waiting, flags = list(source.answers.items())[::-1], dict[str, str]()
    for place, statement in enumerate(source.statements):
        program.state(statement)
        while waiting and waiting[-1][1][0] == place:
            name, (_, answer) = waiting.pop()
            try:
                read[name] = _answered(program, answer, forgiven_in_webwork(flags, answer))
            except NotRead as error:
                read[name] = error
        if "flags" in statement:
            flags |= dict(WEBWORK_OPTION.findall(statement))
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
