"""One-place mutants of grading, formula and answers, and whether the tests of these rooms notice.

`python benchmarks/mutants.py --count 300` draws the mutants with a fixed seed, learns once which test covers which line and how
long it takes (`mutant_tests.py`), and holds each mutant against the covering tests of its own room, the fastest first, then
against those of the other two, up to the first that fails. One process, at the lowest priority; what was tried is kept in
`mutants.json`, from which a stopped run goes on. `--again` tries those alive once more, at their places in today's sources. Both
write the table `mutants.md`.
"""

from __future__ import annotations

import argparse
import ast
import copy
import json
import os
import random
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from mutant_tests import ROOMS, Tests

TOP = Path(__file__).resolve().parents[1]
RESULTS = TOP / "benchmarks" / "results"
SEED = 12

COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
COMPUTED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult, ast.FloorDiv: ast.Div,
    ast.Mod: ast.Mult, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Mutant:
    """One place changed: `text` is the whole module, `source` the line as it was and `column` the place in it."""

    file: str
    line: int
    column: int
    what: str
    source: str
    text: str


def mutants(path: Path) -> Iterator[Mutant]:
    """Every one-place mutant of a module; annotations and docstrings are left alone."""
    source = path.read_text(encoding="utf-8")
    lines = source.splitlines(keepends=True)
    tree = ast.parse(source)
    left_alone = {id(node) for node in _annotations(tree)}
    for node in ast.walk(tree):
        if id(node) in left_alone:
            continue
        for what, changed in _changes(node):
            text = _written(lines, node, changed)
            if text is not None and text != source:
                line, column = node.lineno, node.col_offset  # type: ignore[attr-defined]
                yield Mutant(
                    path.relative_to(TOP).as_posix(), line, column, what, lines[line - 1].strip(), text
                )


def _annotations(tree: ast.Module) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        for name in ("annotation", "returns"):
            if (found := getattr(node, name, None)) is not None:
                yield from ast.walk(found)
        if (
            isinstance(node, ast.Assign)
            and isinstance(node.value, ast.BinOp)
            and isinstance(node.value.op, ast.BitOr)
        ):
            yield from ast.walk(node.value)  # a union of types
        if isinstance(node, ast.JoinedStr):
            yield from ast.walk(node)


def _changes(node: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    """The node, changed in one way each."""
    match node:
        case ast.Compare(ops=[op]) if type(op) in COMPARED:
            other = COMPARED[type(op)]
            yield f"{type(op).__name__} → {other.__name__}", _with(node, ops=[other()])
        case ast.BinOp(op=op) if type(op) in COMPUTED:
            other = COMPUTED[type(op)]
            yield f"{type(op).__name__} → {other.__name__}", _with(node, op=other())
        case ast.BoolOp(op=op):
            other = ast.Or() if isinstance(op, ast.And) else ast.And()
            yield f"{type(op).__name__} → {type(other).__name__}", _with(node, op=other)
        case ast.UnaryOp(op=ast.Not() | ast.USub(), operand=operand):
            yield "sign or not dropped", operand
        case ast.Constant(value=bool() as value):
            yield f"{value} → {not value}", _with(node, value=not value)
        case ast.Constant(value=int() | float() as value):
            yield f"{value} → {value + 1}", _with(node, value=value + 1)
        case ast.If(test=test):
            yield "condition negated", _with(node, test=ast.UnaryOp(ast.Not(), test))
        case ast.IfExp(test=test):
            yield "condition negated", _with(node, test=ast.UnaryOp(ast.Not(), test))
        case ast.Return(value=value) if value is not None and not isinstance(value, ast.Constant):
            yield "returns None", _with(node, value=ast.Constant(None))
        case ast.Expr(value=ast.Call()) | ast.AugAssign():
            yield "statement removed", ast.Pass()
        case _:
            return


def _with(node: ast.AST, **fields: object) -> ast.AST:
    changed = copy.copy(node)
    for name, value in fields.items():
        setattr(changed, name, value)
    return changed


def _written(lines: list[str], node: ast.AST, changed: ast.AST) -> str | None:
    """The module with this node's text replaced; None where what comes out is no Python."""
    part = node.test if isinstance(node, ast.If) else node  # of an `if`, only its condition
    new = changed.test if isinstance(changed, ast.If) else changed
    text = ast.unparse(ast.fix_missing_locations(new))
    if isinstance(part, ast.expr):
        text = f"({text})"
    first, last = part.lineno - 1, part.end_lineno - 1  # type: ignore[attr-defined]
    begin = lines[first].encode()[: part.col_offset].decode()  # type: ignore[attr-defined]
    end = lines[last].encode()[part.end_col_offset :].decode()  # type: ignore[attr-defined]
    whole = "".join([*lines[:first], begin + text + end, *lines[last + 1 :]])
    try:
        ast.parse(whole)
    except SyntaxError:
        return None
    return whole


def every() -> list[Mutant]:
    return [
        each
        for room in ROOMS
        for path in sorted((TOP / "src/corollary" / room).rglob("*.py"))
        for each in mutants(path)
    ]


def drawn(count: int) -> list[Mutant]:
    """`count` mutants, the same ones for the same sources."""
    found = every()
    return random.Random(SEED).sample(found, min(count, len(found)))


def found_again(alive: list[dict[str, object]]) -> list[Mutant | None]:
    """The same changes in today's sources; None where the line is no longer there."""
    today = every()
    return [
        min(
            (
                each
                for each in today
                if all(record[name] == getattr(each, name) for name in ("file", "what", "source"))
            ),
            key=lambda each: (abs(each.line - record["line"]), abs(each.column - record["column"])),  # type: ignore[operator]
            default=None,
        )
        for record in alive
    ]


def table(found: list[dict[str, object]], count: int) -> str:
    """The results as Markdown: a row a room, then each survivor."""
    lines = [
        f"{len(found)} of {count} tried.",
        "",
        "| room | mutants | killed by tests of the room | by those of the other two | alive | killed, % |",
        "|---|---|---|---|---|---|",
    ]
    for room in (*ROOMS, "all"):
        outcomes = Counter(
            str(each["outcome"]) for each in found if room in ("all", str(each["file"]).split("/")[2])
        )
        total = sum(outcomes.values())
        killed, elsewhere = outcomes["killed"], outcomes["killed elsewhere"]
        share = f"{100 * (killed + elsewhere) / total:.0f}" if total else ""
        lines.append(f"| {room} | {total} | {killed} | {elsewhere} | {outcomes['alive']} | {share} |")
    lines += ["", "## Alive", "", "| place | line | change |", "|---|---|---|"]
    for each in found:
        if each["outcome"] == "alive":
            source = str(each["source"]).replace("|", "\\|")
            lines.append(f"| {each['file']}:{each['line']} | `{source}` | {each['what']} |")
    return "\n".join(lines) + "\n"


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--count", type=int, default=300)
    options.add_argument(
        "--again", action="store_true", help="only those alive so far, against today's tests"
    )
    options.add_argument(
        "--results", type=Path, default=RESULTS, help="the folder of mutants.json and mutants.md"
    )
    given = options.parse_args()
    os.nice(19 - os.nice(0))
    given.results.mkdir(parents=True, exist_ok=True)
    kept = given.results / "mutants.json"
    found: list[dict[str, object]] = json.loads(kept.read_text(encoding="utf-8")) if kept.exists() else []
    if given.again:
        places = [number for number, each in enumerate(found) if each["outcome"] == "alive"]
        todo = dict(zip(places, found_again([found[place] for place in places]), strict=True))
    else:  # the seed gives the order, so a stopped run goes on where it was
        todo = {number: each for number, each in enumerate(drawn(given.count)) if number >= len(found)}
    learned = given.results / "learned.json"
    if given.again:
        learned.unlink(missing_ok=True)  # the tests are others by now
    with Tests(TOP, learned) as tests:
        for number, mutant in todo.items():
            if mutant is None:
                print(f"{number}: the line {found[number]['source']!r} is no longer there", flush=True)
                continue
            outcome, by = tests.tried(mutant.file, mutant.line, mutant.text)
            about = {name: getattr(mutant, name) for name in ("file", "line", "column", "what", "source")}
            found[number : number + 1] = [about | {"outcome": outcome, "by": by}]
            kept.write_text(json.dumps(found, indent=1, ensure_ascii=False), encoding="utf-8")
            (given.results / "mutants.md").write_text(table(found, given.count), encoding="utf-8")
            print(f"{number}: {outcome:16} {mutant.file}:{mutant.line} {mutant.what} {by}", flush=True)


if __name__ == "__main__":
    main()
