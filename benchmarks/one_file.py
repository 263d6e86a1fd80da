"""Would a problem be shorter in one file? Ten of the example banks, their solutions put into a fenced block of laws.

    python benchmarks/one_file.py [--write FOLDER]

The block has one line for each step (unknowns, part, reason), law, mistake and option, filled to 110 columns, as short as such a
syntax can be: nothing of Python is left but formulas. What it has no words for (scenes, several laws exchanged at once, formulas
worked out in Python) is counted as it stands. Lines that are not blank are counted, as in `authoring.py`; and, as a line is as long
as a formatter lets it be, letters and signs that are not blank, too.
"""

from __future__ import annotations

import argparse
import ast
import statistics
import textwrap
from collections.abc import Iterator
from pathlib import Path

BANKS = Path(__file__).parents[1] / "examples" / "banks"
TEN = (
    "braking_at_a_light", "caught_up", "over_a_pulley", "cyclist_uphill", "flywheel",
    "hanging_spring", "escape", "hydraulic_lift", "lamps_in_series", "grating",
)  # fmt: skip
"""Across all topics, chosen by name before any was converted."""
WIDTH = 110


def block(source: str) -> tuple[list[str], int]:
    """The solution as a block of laws, and how many of its lines are still Python's."""
    module = ast.parse(source)
    lines: list[str] = []
    python = 0
    for node in module.body:
        match node:
            case ast.FunctionDef(name="derive"):
                for call in _entries(node):
                    lines += _entry(call)
            case ast.FunctionDef() | ast.Assign():
                kept = [line for line in ast.get_source_segment(source, node).splitlines() if line.strip()]
                lines += kept
                python += len(kept)
            case _:
                pass  # the docstring and imports, which a block would not need
    return lines, python


def _entries(derive: ast.FunctionDef) -> Iterator[ast.Call]:
    for node in ast.walk(derive):
        if isinstance(node, ast.Return) and isinstance(node.value, ast.Call):
            yield from (each for each in node.value.args if isinstance(each, ast.Call))


def _entry(call: ast.Call) -> list[str]:
    name = ast.unparse(call.func)
    named = {each.arg: each.value for each in call.keywords}
    if name == "step":
        part = f" ({ast.literal_eval(named['answers'])})" if "answers" in named else ""
        where = f" where {ast.unparse(named['where'])}" if "where" in named else ""
        found = _filled(f"{ast.unparse(call.args[0])}{part}{where}: {_text(call.args[1])}")
        for law in call.args[2:]:
            found += _filled(f"  {_law(law)}")
        for mistake in getattr(named.get("mistakes"), "elts", []):
            rest = "; ".join(_law(each) for each in [*mistake.args[1:], *(k.value for k in mistake.keywords)])
            found += _filled(f"  wrong {rest}: {_text(mistake.args[0])}")
        if "check" in named:
            found += _filled(f"  check: {_text(named['check'])}")
        return found
    if name == "choice":
        found = _filled(f"choice {_text(call.args[0])}: {_text(call.args[1])}")
        wrong = named.pop("mistakes", None)
        found += [
            f"  {letter}: {ast.unparse(value)}"
            for letter, value in named.items()
            if ast.unparse(value) != "False"
        ]
        for key, value in zip(getattr(wrong, "keys", []), getattr(wrong, "values", []), strict=True):
            found += _filled(f"  wrong {_text(key)}: {_text(value)}")
        return found
    return _filled(ast.unparse(call))


def _law(node: ast.expr) -> str:
    if isinstance(node, ast.Call) and ast.unparse(node.func) in ("law", "wrong"):
        return ": ".join(_text(each) for each in node.args)
    return ast.unparse(node)


def _text(node: ast.expr) -> str:
    return str(node.value) if isinstance(node, ast.Constant) else ast.unparse(node)


def _filled(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH, subsequent_indent="    ", drop_whitespace=True)


def count(lines: list[str]) -> int:
    return sum(1 for line in lines if line.strip())


def signs(lines: list[str]) -> int:
    """Letters and signs that are not blank."""
    return sum(len("".join(line.split())) for line in lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", type=Path, help="where to write the ten in one file each")
    folder = parser.parse_args().write
    print(
        "| problem | two files | one file | of these Python | signs: two files | one file |\n|---|---|---|---|---|---|"
    )
    table: list[tuple[int, ...]] = []
    for name in TEN:
        (problem,) = BANKS.glob(f"*/src/*/problems/*/{name}.md")
        (solution,) = BANKS.glob(f"*/src/*/solutions/*/{name}.py")
        asks, derives = problem.read_text(encoding="utf-8"), solution.read_text(encoding="utf-8")
        lines, python = block(derives)
        one = [*asks.splitlines(), "```solution", *lines, "```"]
        two = [*asks.splitlines(), *derives.splitlines()]
        row = count(two), count(one), python, signs(two), signs(one)
        print(f"| {name} | {' | '.join(map(str, row))} |")
        table.append(row)
        if folder is not None:
            folder.mkdir(parents=True, exist_ok=True)
            (folder / f"{name}.md").write_text("\n".join(one) + "\n", encoding="utf-8")
    middle = (f"{statistics.median(each):g}" for each in zip(*table, strict=True))
    print(f"| median | {' | '.join(middle)} |")
    files = (path.read_text(encoding="utf-8") for path in BANKS.glob("*/src/*/solutions/*/*.py"))
    every = [text for text in files if "def derive(" in text]  # a ready-made scene is no solution
    scenes = sum("def scene(" in text for text in every)
    print(f"\n{scenes} of {len(every)} solutions of the example banks have a scene, which is a program.")


if __name__ == "__main__":
    main()
