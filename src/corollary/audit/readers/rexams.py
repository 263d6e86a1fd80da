"""R/exams, `.Rmd` and `.Rnw`: what the first lines of R draw and assign, and the solution of the meta-information; never run."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

from corollary.audit.readers.straight_line import NotRead, StraightLine, arguments_at, unrounded
from corollary.audit.record import ExerciseRecord
from corollary.audit.text_file import text_of

CHUNK = re.compile(r"```\{r([^}\n]*)\}[^\n]*\n(.*?)```|<<([^>\n]*)>>=[^\n]*\n(.*?)\n@", re.DOTALL)
OPTION = re.compile(r"\beval\s*=\s*(\w+)|(?m:^)#\|\s*eval:\s*(\w+)")
META = re.compile(r"(?m)^\s*(?:%+\s*)?\\?(ex\w+)\s*(?::\s*(.*?)|\{(.*)\})\s*$")
INLINE = re.compile(r"^(?:`r\s+(.*?)`|\\Sexpr\{(.*)\})$")
CODE_IN_TEXT = re.compile(r"(?:`r\s[^`]*|\\Sexpr\{[^}]*)(?:<-|->|\w\s*=\s*\w+\s*[`}])")
ASSIGNED = re.compile(r"^([A-Za-z][\w.]*)\s*(?:<-|=)\s*(.+)$|^(.+?)\s*->\s*([A-Za-z][\w.]*)$", re.DOTALL)
ROUNDS = {"round", "fmt", "signif", "format"}
RANGE = re.compile(r"^(-?[\d.]+)\s*:\s*(-?[\d.]+)$")
NO_ASSIGNMENT = re.compile(r"(?:library|options|set\.seed|require|include_supplement|par|plot|hist)\b")


def rexams_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The one exercise of a file. Raises Malformed."""
    bare = ExerciseRecord(path.stem, path, 1)
    try:
        return (_read(text_of(path), bare),)
    except NotRead as error:
        return (replace(bare, unread=str(error)),)


def _read(source: str, bare: ExerciseRecord) -> ExerciseRecord:
    meta = _meta(source)
    if meta.get("extype") != "num":
        raise NotRead(f"an exercise of type {meta.get('extype', '(none)')} is not read")
    solution = meta.get("exsolution", "")
    inline = INLINE.match(solution)
    if inline is None:
        if not re.match(r"^[-+\d.eE]+$", solution):
            raise NotRead(f"the solution {solution!r} is no number")
        return replace(bare, published=(solution,))
    if CODE_IN_TEXT.search(CHUNK.sub("", source)):
        raise NotRead("its text assigns something")
    program = StraightLine()
    for statement in _statements(_code(source)):
        assigned = ASSIGNED.match(statement)
        if assigned is not None:
            letter = _letters(assigned[1] or assigned[4])
            expression = (assigned[2] or assigned[3]).strip()
            program.attempt(letter, partial(_assign, program, letter, expression))
        elif not NO_ASSIGNMENT.match(statement):
            raise NotRead(f"{statement.splitlines()[0]!r} is no assignment")
    key = program.key(_letters(unrounded((inline[1] or inline[2]).strip(), ROUNDS)))
    return replace(bare, given=key.drawn, published=(key.text,), worked_out=key.worked_out)


def _meta(source: str) -> dict[str, str]:
    """Raises NotRead where something is evaluated twice."""
    found: dict[str, str] = {}
    for each in META.finditer(source):
        value = (each[2] or each[3] or "").strip()
        if found.setdefault(each[1], value) != value:
            raise NotRead(f"it has two lines {each[1]}")
    return found


def _code(source: str) -> str:
    """The chunks that are evaluated. Raises NotRead where that is not certain."""
    found: list[str] = []
    for each in CHUNK.finditer(source):
        options, code = each[1] or each[3] or "", each[2] or each[4] or ""
        evaluated = {(one or other).upper() for one, other in OPTION.findall(f"{options}\n{code}")}
        if evaluated - {"TRUE", "T", "FALSE", "F"}:
            raise NotRead("whether a chunk is evaluated is worked out")
        if not evaluated & {"FALSE", "F"}:
            found.append(code)
    return "\n".join(found)


def _statements(code: str) -> list[str]:
    """Lines, those of an open bracket joined, without comments."""
    found: list[str] = []
    open_brackets, begun = 0, ""
    for line in code.splitlines():
        line = re.sub(r"#.*", "", line).rstrip()
        begun = f"{begun}\n{line}" if begun else line
        open_brackets += sum(line.count(each) for each in "([{") - sum(line.count(each) for each in ")]}")
        if open_brackets <= 0 and begun.strip():
            found += [each.strip() for each in begun.split(";") if each.strip()]
            begun, open_brackets = "", 0
    if begun.strip():
        raise NotRead("a bracket is not closed")
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
