"""One-place mutants of grading, formula and answers, and whether the tests that cover the place notice.

`python benchmarks/mutants.py --count 300 --jobs 2` draws the mutants with a fixed seed, learns once which test file covers which
line (coverage's contexts), runs for each mutant the covering test files, nearest room first, in a copy of the tree, and writes
`benchmarks/results/mutants.json` (from which a stopped run goes on) and `mutants.md`.
"""

from __future__ import annotations

import argparse
import ast
import copy
import json
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import Queue

TOP = Path(__file__).resolve().parents[1]
ROOMS = ("grading", "formula", "answers")
TESTED_BY = (*ROOMS, "units", "notebook", "verify", "derive", "cli", "api", "plugin", "journeys")
RESULTS = TOP / "benchmarks" / "results"
SEED = 12
MOST_FILES = 12  # test files tried for one mutant, nearest first

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
    """One place changed: `text` is the whole module."""

    file: str
    line: int
    what: str
    text: str

    @property
    def name(self) -> str:
        return f"{self.file}:{self.line} {self.what}"


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
                yield Mutant(path.relative_to(TOP).as_posix(), node.lineno, what, text)  # type: ignore[attr-defined]


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


def drawn(count: int) -> list[Mutant]:
    """`count` mutants, the same ones for the same sources."""
    every = [
        each
        for room in ROOMS
        for path in sorted((TOP / "src/corollary" / room).rglob("*.py"))
        for each in mutants(path)
    ]
    return random.Random(SEED).sample(every, min(count, len(every)))


def covering(folder: Path, seconds: float) -> dict[str, dict[int, list[str]]]:
    """For each file of the rooms and each line, the test files that run it. Each test file is run once, alone."""
    found: dict[str, dict[int, list[str]]] = {}
    files = [path for name in TESTED_BY for path in sorted((folder / "tests" / name).rglob("test_*.py"))]
    for path in files:
        test = path.relative_to(folder).as_posix()
        data = folder / ".coverage"
        data.unlink(missing_ok=True)
        sources = ",".join(f"src/corollary/{room}" for room in ROOMS)
        command = [
            "-m",
            "coverage",
            "run",
            f"--source={sources}",
            "-m",
            "pytest",
            "-q",
            "-x",
            "-p",
            "no:cacheprovider",
            test,
        ]
        ended = _run(folder, command, seconds)
        print(f"covering {test}: {ended}", flush=True)
        if ended != 0 or not data.exists():
            continue  # what fails, or takes too long, by itself cannot tell a mutant
        with sqlite3.connect(data) as book:
            from coverage.numbits import numbits_to_nums

            for file, bits in book.execute(
                "select path, numbits from line_bits join file on file.id = line_bits.file_id"
            ):
                lines = found.setdefault(Path(file).relative_to(folder).as_posix(), {})
                for line in numbits_to_nums(bits):
                    lines.setdefault(line, []).append(test)
    return found


def at_line(covered: dict[str, list[str]], line: int) -> list[str]:
    """The test files that run a line; of a statement over several lines not each one is counted, so those above it count, too."""
    return next((covered[str(near)] for near in range(line, line - 15, -1) if str(near) in covered), [])


def in_own_room(mutant: Mutant) -> list[str]:
    """Every test file of the room, whether it runs the line or not: what `--own-room` holds a mutant against."""
    room = TOP / "tests" / mutant.file.split("/")[2]
    return [path.relative_to(TOP).as_posix() for path in room.rglob("test_*.py")]


def nearest(mutant: Mutant, tests: list[str]) -> list[str]:
    """The tests of its own room and name first."""
    room, stem = mutant.file.split("/")[2], Path(mutant.file).stem
    return sorted(tests, key=lambda test: (f"tests/{room}/" not in test, stem not in test, test))[:MOST_FILES]


def tried(mutant: Mutant, tests: list[str], folder: Path, seconds: float) -> dict[str, object]:
    """What became of one mutant in a copy of the tree, and by which test file."""
    place = folder / mutant.file
    before = place.read_text(encoding="utf-8")
    outcome, by = ("survived", "") if tests else ("not covered", "")
    place.write_text(mutant.text, encoding="utf-8")
    try:
        for test in nearest(mutant, tests):
            ended = _run(folder, ["-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", test], seconds)
            if ended != 0:
                outcome, by = ("killed" if ended is not None else "killed by time"), test
                break
    finally:
        place.write_text(before, encoding="utf-8")
    return {"file": mutant.file, "line": mutant.line, "what": mutant.what, "outcome": outcome, "by": by}


def _run(folder: Path, command: list[str], seconds: float) -> int | None:
    """The status of Python in that copy; None when it took too long, and then everything it had started is ended."""
    environment = os.environ | {"PYTHONPATH": str(folder / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
    with subprocess.Popen(
        [sys.executable, *command], cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        start_new_session=True,
    ) as running:  # fmt: skip
        try:
            return running.wait(seconds)
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGKILL)
            running.wait()
            return None


def table(found: list[dict[str, object]]) -> str:
    """The results as Markdown: a row a room, then each survivor."""
    lines = [
        "# Mutants",
        "",
        "| room | mutants | killed | survived | not covered | killed, % |",
        "|---|---|---|---|---|---|",
    ]
    for room in (*ROOMS, "all"):
        outcomes = Counter(
            str(each["outcome"]) for each in found if room in ("all", str(each["file"]).split("/")[2])
        )
        killed, total = outcomes["killed"] + outcomes["killed by time"], sum(outcomes.values())
        share = f"{100 * killed / total:.0f}" if total else ""
        lines.append(
            f"| {room} | {total} | {killed} | {outcomes['survived']} | {outcomes['not covered']} | {share} |"
        )
    lines += ["", "## Alive", "", "| place | change | outcome |", "|---|---|---|"]
    alive = [each for each in found if not str(each["outcome"]).startswith("killed")]
    lines += [f"| {each['file']}:{each['line']} | {each['what']} | {each['outcome']} |" for each in alive]
    return "\n".join(lines) + "\n"


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--count", type=int, default=300)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--seconds", type=float, default=240, help="for one test file")
    options.add_argument(
        "--own-room",
        action="store_true",
        help="the tests of the mutant's own room, without learning what covers what",
    )
    options.add_argument("--results", type=Path, default=RESULTS)
    asked = options.parse_args()
    asked.results.mkdir(parents=True, exist_ok=True)
    kept = asked.results / "mutants.json"
    found: list[dict[str, object]] = json.loads(kept.read_text(encoding="utf-8")) if kept.exists() else []
    todo = drawn(asked.count)[len(found) :]  # the seed gives the order, so a stopped run goes on where it was
    with tempfile.TemporaryDirectory(prefix="mutants-") as scratch:
        copies: Queue[Path] = Queue()
        for number in range(asked.jobs):
            folder = Path(scratch, str(number))
            ignored = shutil.ignore_patterns(
                ".git", ".venv", "demo", "trade", "__pycache__", ".pytest_cache", ".ruff_cache"
            )
            shutil.copytree(TOP, folder, ignore=ignored)
            copies.put(folder)
        covered_file = asked.results / "covered.json"
        if asked.own_room:
            covered = {}
        elif covered_file.exists():
            covered = json.loads(covered_file.read_text(encoding="utf-8"))
        else:
            first = copies.get()
            covered = {
                file: {str(line): tests for line, tests in lines.items()}
                for file, lines in covering(first, asked.seconds).items()
            }
            copies.put(first)
            covered_file.write_text(json.dumps(covered), encoding="utf-8")

        def one(mutant: Mutant) -> dict[str, object]:
            folder = copies.get()
            try:
                at_place = at_line(covered.get(mutant.file, {}), mutant.line)
                return tried(
                    mutant, in_own_room(mutant) if asked.own_room else at_place, folder, asked.seconds
                )
            finally:
                copies.put(folder)

        with ThreadPoolExecutor(asked.jobs) as side_by_side:
            for number, result in enumerate(side_by_side.map(one, todo), len(found) + 1):
                found.append(result)
                kept.write_text(json.dumps(found, indent=1, ensure_ascii=False), encoding="utf-8")
                (asked.results / "mutants.md").write_text(table(found), encoding="utf-8")
                print(
                    f"{number}: {result['outcome']:14} {result['file']}:{result['line']} {result['what']}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
