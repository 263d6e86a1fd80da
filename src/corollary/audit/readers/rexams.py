"""R/exams, `.Rmd` and `.Rnw`: what the first lines of R draw and assign, and the solution of the meta-information; never run."""

from __future__ import annotations

import re
from pathlib import Path

from corollary.audit.readers.straight_line import NotRead, StraightLine, arguments_at
from corollary.audit.record import ExerciseRecord, StatedGiven
from corollary.audit.record_file import text_of

CHUNK = re.compile(r"```\{r[^}]*\}\n(.*?)```|<<[^>]*>>=\n(.*?)\n@", re.DOTALL)
META = re.compile(r"(?m)^\s*(?:\\)?(ex\w+)\s*(?::\s*(.*?)|\{(.*)\})\s*$")
INLINE = re.compile(r"^(?:`r\s+(.*?)`|\\Sexpr\{(.*)\})$")
ASSIGNED = re.compile(r"^([A-Za-z][\w.]*)\s*(?:<-|=)\s*(.+)$", re.DOTALL)
ROUNDED = re.compile(r"^(?:round|fmt|signif|format)\s*\(")
RANGE = re.compile(r"^(-?[\d.]+)\s*:\s*(-?[\d.]+)$")


def rexams_records(path: Path) -> tuple[ExerciseRecord, ...]:
    """The one exercise of a file. Raises Malformed."""
    source = text_of(path)
    meta = {found[1]: (found[2] or found[3] or "").strip() for found in META.finditer(source)}
    try:
        given, published = _read(source, meta)
        return (ExerciseRecord(path.stem, path, 1, given, published=(published,)),)
    except NotRead as error:
        return (ExerciseRecord(path.stem, path, 1, unread=str(error)),)


def _read(source: str, meta: dict[str, str]) -> tuple[tuple[StatedGiven, ...], str]:
    if meta.get("extype") != "num":
        raise NotRead(f"an exercise of type {meta.get('extype', '(none)')} is not read")
    solution = meta.get("exsolution", "")
    inline = INLINE.match(solution)
    if inline is None:
        if not re.match(r"^[-+\d.eE]+$", solution):
            raise NotRead(f"the solution {solution!r} is no number")
        return (), solution
    program, unread = StraightLine(), dict[str, str]()
    for statement in _statements("\n".join(one or other for one, other in CHUNK.findall(source))):
        assigned = ASSIGNED.match(statement)
        if assigned is None:
            if re.match(
                r"(?:library|options|set\.seed|require|include_supplement|par|plot|hist)\b", statement
            ):
                continue
            raise NotRead(f"{statement.splitlines()[0]!r} is no assignment")
        letter = assigned[1].replace(".", "_")
        program.refuse_again(letter)
        try:
            _assign(program, letter, assigned[2].strip())
        except NotRead as error:
            unread[letter] = str(error)  # it counts only where the key needs it
    key = _unrounded((inline[1] or inline[2]).strip())
    for letter in re.findall(r"[A-Za-z][\w.]*", key):
        if (name := letter.replace(".", "_")) in unread:
            raise NotRead(f"{letter}: {unread[name]}")
    formula, drawn = program.key(_letters(key))
    return drawn, formula


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
    return found


def _assign(program: StraightLine, letter: str, expression: str) -> None:
    expression = _unrounded(expression)
    call = re.match(r"(sample|runif)\s*\(", expression)
    if call is None:
        program.assign(letter, _letters(expression))
        return
    inside, end = arguments_at(expression, call.end())
    count = inside[0] if call[1] == "runif" else (inside[1:] or [""])[0].removeprefix("size").strip(" =")
    if expression[end:].strip() or count != "1":
        raise NotRead("what is drawn is changed at once, or is more than one number")
    if call[1] == "runif" and len(inside) == 3:
        low, high = (each.rpartition("=")[2].strip() for each in inside[1:])
        program.draw(letter, low, high)
    elif (spread := RANGE.match(inside[0])) is not None:
        program.draw(letter, spread[1], spread[2])
    elif inside[0].startswith("c("):
        program.draw_among(letter, arguments_at(inside[0], 2)[0])
    elif inside[0].startswith("seq(") and len(bounds := arguments_at(inside[0], 4)[0]) >= 2:
        program.draw(letter, *(each.rpartition("=")[2].strip() for each in bounds[:2]))
    else:
        raise NotRead(f"{expression!r} is drawn in a way that is not read")


def _unrounded(expression: str) -> str:
    """What is rounded for the page, before it is."""
    found = ROUNDED.match(expression)
    if found is None:
        return expression
    inside, end = arguments_at(expression, found.end())
    return inside[0] if inside and not expression[end:].strip() else expression


def _letters(expression: str) -> str:
    """R's letters may have points in them."""
    return re.sub(r"(?<=[A-Za-z])\.(?=[A-Za-z])", "_", expression)
