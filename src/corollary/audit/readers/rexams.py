"""R/exams, `.Rmd` and `.Rnw`: what its lines of R draw and assign, and the solutions of the meta-information; never run."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from corollary.audit.forgiven import forgiven_absolutely
from corollary.audit.readers.straight_line import (
    MOST_ANSWERS,
    MOST_STATEMENTS,
    NotRead,
    StraightLine,
    arguments_at,
    known_unit,
    refuse_long,
    unrounded,
)
from corollary.audit.record import ExerciseRecord, ForgivenError
from corollary.audit.text_file import LARGEST_PROGRAM, text_of

BEGINS = re.compile(r"[\t >]*(`{3,})\s*\{r\b([^}]*)\}|[\t ]*<<([^>]*)>>=")
OPTION = re.compile(r"\beval\s*=\s*(\w+)|(?m:^)#\|\s*eval:\s*(\w+)")
META = re.compile(r"(?:%+\s*)?\\?(ex\w+)\s*(?::(.*)|\{(.*)\})$")
INLINE = re.compile(r"^(?:`r\s+(.*?)`|\\Sexpr\{(.*)\})$")
INLINE_BEGINS = re.compile(r"`r\s|\\Sexpr\{")
ASSIGNS = re.compile(r"<-|->|\w\s*=\s*\w+\s*[`}]")
NUMBER = re.compile(r"[-+\d.eE]+$")
PARTS = re.compile(r"(?:`[^`]*`|[^|`])+")
ITEMS = ("* ", "- ", "\\item")
CHOSEN = re.compile(r"[01]+$")
OPTION_WITH_CODE = re.compile(r"(`r\s+[^`]*`|\\Sexpr\{[^{}]*\})\s*(.*)$")
ASSIGNED = re.compile(r"^([A-Za-z][\w.]*)\s*(?:<-|=)\s*(.+)$|^(.+?)\s*->\s*([A-Za-z][\w.]*)$", re.DOTALL)
ROUNDS = {"round", "fmt", "signif", "format"}
RANGE = re.compile(r"^(-?[\d.]+)\s*:\s*(-?[\d.]+)$")
NO_ASSIGNMENT = re.compile(r"(?:library|options|set\.seed|require|include_supplement|par|plot|hist)\b")


@dataclass(frozen=True, slots=True)
class RFile:
    """The chunks of R with their options, the text around them, and the meta-information by its names."""

    chunks: tuple[tuple[str, str], ...]
    text: str
    meta: dict[str, str]

    @property
    def options(self) -> list[str]:
        """The list of answers in the question: `* 5 N`, or `\\item 5 N`."""
        found: list[str] = []
        listed = False
        for line in map(str.strip, self.text.splitlines()):
            if line in {"Solution", "\\begin{solution}"}:
                break
            if line in {"Answerlist", "\\begin{answerlist}"}:
                listed = True
            elif line == "\\end{answerlist}":
                listed = False
            elif listed and line.startswith(ITEMS):
                found.append(line.removeprefix("\\item").removeprefix("* ").removeprefix("- ").strip())
            elif listed and found and line:
                found[-1] += f" {line}"  # an item of several lines
        return found


def rexams_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The exercise of a file; of a cloze each answer, `fall#2`. Raises Malformed."""
    bare = ExerciseRecord(path.stem, path, 1)
    try:
        file = _file_of(text_of(path, LARGEST_PROGRAM))
        match file.meta.get("extype", "(none)"):
            case "num":
                forgives = (forgiven_absolutely(file.meta.get("extol", "")),)
                solution = partial(file.meta.get, "exsolution", "")
                return (_record(replace(bare, forgives=forgives), file, solution),)
            case "schoice" | "mchoice":
                solution = file.meta.get("exsolution", "")
                return (_record(bare, file, lambda: _right(file.options, solution)),)
            case "cloze":
                return _cloze(bare, file)
            case kind:
                raise NotRead(f"an exercise of type {kind} is not read")
    except NotRead as error:
        return (replace(bare, unread=str(error)),)


def _cloze(bare: ExerciseRecord, file: RFile) -> tuple[ExerciseRecord, ...]:
    """Raises NotRead where the answers cannot be told apart."""
    kinds = [each.strip() for each in file.meta.get("exclozetype", "").split("|")]
    solutions = [each.strip() for each in PARTS.findall(file.meta.get("exsolution", ""))]
    if len(kinds) != len(solutions) or len(kinds) > MOST_ANSWERS:
        raise NotRead(f"it has {len(kinds)} kinds of answers and {len(solutions)} solutions")
    counts = [
        len(solution) if kind in {"schoice", "mchoice"} else 1
        for kind, solution in zip(kinds, solutions, strict=True)
    ]
    tolerances = _tolerances(file.meta.get("extol", ""), len(kinds))
    options, found, at = file.options, list[ExerciseRecord](), 0
    for place, (kind, solution, count) in enumerate(zip(kinds, solutions, counts, strict=True), 1):
        own = options[at : at + count] if len(options) == sum(counts) else []
        at += count
        key = partial(_of_cloze, kind, solution, own)
        forgiven = tolerances[place - 1] if kind == "num" else None
        found.append(_record(replace(bare, id=f"{bare.id}#{place}", forgives=(forgiven,)), file, key))
    return tuple(found)


def _tolerances(text: str, count: int) -> list[ForgivenError | None]:
    """Of each answer of a cloze: one for all, or one for each."""
    stated = [forgiven_absolutely(each.strip()) for each in text.split("|")]
    return stated * count if len(stated) == 1 else stated if len(stated) == count else [None] * count


def _of_cloze(kind: str, solution: str, options: list[str]) -> str:
    """Raises NotRead."""
    if kind == "num":
        return solution
    if kind in {"schoice", "mchoice"}:
        return _right(options, solution)
    raise NotRead(f"an answer of type {kind} is not read")


def _right(options: list[str], solution: str) -> str:
    """The only option that is marked as right. Raises NotRead."""
    if not CHOSEN.match(solution) or len(options) != len(solution):
        raise NotRead(f"the solution {solution!r} does not say which of its {len(options)} options is right")
    if solution.count("1") != 1:
        raise NotRead(f"{solution.count('1')} of its options are marked as right")
    return options[solution.index("1")].replace("$", "").strip()


def _record(bare: ExerciseRecord, file: RFile, solution: Callable[[], str]) -> ExerciseRecord:
    try:
        return _read(bare, file, solution())
    except NotRead as error:
        return replace(bare, unread=str(error))


def _read(bare: ExerciseRecord, file: RFile, solution: str) -> ExerciseRecord:
    """Raises NotRead."""
    refuse_long(solution)
    behind = OPTION_WITH_CODE.match(solution)
    solution, unit = (behind[1], behind[2]) if behind is not None else (solution, "")
    inline = INLINE.match(solution)
    if inline is None:
        if not NUMBER.match(solution) and (
            file.meta.get("extype") == "num" or not re.match(r"[-+\d.]", solution)
        ):
            raise NotRead(f"the solution {solution!r} is not a number")
        return replace(bare, published=(solution,))
    if unit and not known_unit(unit):
        raise NotRead(f"{unit!r} behind the solution is not a unit")
    if _assigns(file.text):
        raise NotRead("its text assigns something")
    program = StraightLine()
    for statement in _statements(_code(file.chunks)):
        assigned = ASSIGNED.match(statement)
        if assigned is not None:
            letter = _letters(assigned[1] or assigned[4])
            expression = (assigned[2] or assigned[3]).strip()
            program.attempt(letter, partial(_assign, program, letter, expression))
        elif not NO_ASSIGNMENT.match(statement):
            raise NotRead(f"{statement.splitlines()[0]!r} is not an assignment")
    key = program.key(_letters(unrounded((inline[1] or inline[2]).strip(), ROUNDS)))
    return replace(bare, given=key.drawn, published=(key.text,), worked_out=key.worked_out, key_unit=unit)


def _file_of(source: str) -> RFile:
    """Raises NotRead where a chunk is not closed, and where a line of the meta-information stands twice."""
    chunks, text, meta = list[tuple[str, str]](), list[str](), dict[str, str]()
    code, options, ends = list[str](), "", ""
    for line in source.splitlines():
        begins = BEGINS.match(line)
        if ends and (line.strip() if ends != "@" else line[:1]) == ends:
            chunks.append((options, "\n".join(code)))
            ends = ""
        elif ends:
            code.append(line)
        elif begins is not None:
            options, ends, code = begins[2] or begins[3] or "", begins[1] or "@", []
        else:
            text.append(line)
            if (found := META.match(line.strip())) is not None:
                value = (found[2] or found[3] or "").strip()
                if meta.setdefault(found[1], value) != value:
                    raise NotRead(f"it has two lines {found[1]}")
    if ends:
        raise NotRead("a chunk of R is not closed")
    return RFile(tuple(chunks), "\n".join(text), meta)


def _assigns(text: str) -> bool:
    """Whether code within the text gives a letter a value."""
    at = 0
    while (begins := INLINE_BEGINS.search(text, at)) is not None:
        ends = text.find("`" if begins[0].startswith("`") else "}", begins.end())
        at = ends + 1 if ends >= 0 else len(text)
        if ASSIGNS.search(text[begins.end() : at]):
            return True
    return False


def _code(chunks: Sequence[tuple[str, str]]) -> str:
    """The chunks that are evaluated. Raises NotRead where that is not certain."""
    found: list[str] = []
    for options, code in chunks:
        evaluated = {(one or other).upper() for one, other in OPTION.findall(f"{options}\n{code}")}
        if evaluated - {"TRUE", "T", "FALSE", "F"}:
            raise NotRead("whether a chunk is evaluated is worked out")
        if not evaluated & {"FALSE", "F"}:
            found.append(code)
    return "\n".join(found)


def _statements(code: str) -> list[str]:
    """Lines, those of an open bracket joined, without comments."""
    found: list[str] = []
    open_brackets, begun = 0, list[str]()
    for line in code.splitlines():
        line = line.partition("#")[0].rstrip()
        begun.append(line)
        open_brackets += sum(line.count(each) for each in "([{") - sum(line.count(each) for each in ")]}")
        if open_brackets <= 0:
            found += [each.strip() for each in "\n".join(begun).split(";") if each.strip()]
            begun, open_brackets = [], 0
    if any(begun):
        raise NotRead("a bracket is not closed")
    if len(found) > MOST_STATEMENTS:
        raise NotRead(f"its program has more than {MOST_STATEMENTS} statements")
    for each in found:
        refuse_long(each)
    return found


def _assign(program: StraightLine, letter: str, expression: str) -> None:
    expression = unrounded(expression, ROUNDS)
    call = re.match(r"(sample|runif)\s*\(", expression)
    if call is None:
        program.assign(letter, _letters(expression))
        return
    if call[1] in program.unread:
        raise NotRead(f"{call[1]} is the program's own")
    inside, end = arguments_at(expression, call.end())
    count = inside[0] if call[1] == "runif" else (inside[1:] or [""])[0].removeprefix("size").strip(" =")
    if expression[end:].strip() or count != "1":
        raise NotRead("what is drawn is changed at once, or is more than one number")
    if call[1] == "runif" and len(inside) == 3:
        low, high = map(_value, inside[1:])
        program.draw(letter, low, high)
    elif (spread := RANGE.match(inside[0])) is not None:
        program.draw(letter, spread[1], spread[2])
    elif (values := _list(inside[0], "c")) is not None:
        program.draw_among(letter, values)
    elif (bounds := _list(inside[0], "seq")) is not None and len(bounds) >= 2:
        program.draw(letter, *map(_value, bounds[:2]))
    else:
        raise NotRead(f"{expression!r} is drawn in a way that is not read")


def _list(text: str, name: str) -> list[str] | None:
    """The arguments where a text is one call of a function, and nothing behind it."""
    if not text.startswith(f"{name}("):
        return None
    inside, end = arguments_at(text, len(name) + 1)
    return None if text[end:].strip() else inside


def _value(argument: str) -> str:
    """Of an argument with a name, `min = 2`, what it is."""
    return argument.rpartition("=")[2].strip()


def _letters(expression: str) -> str:
    """R's letters may have points in them."""
    return re.sub(r"(?<=[A-Za-z])\.(?=[A-Za-z])", "_", expression)
