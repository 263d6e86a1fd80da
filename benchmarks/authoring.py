"""How many lines the chapter's problems take, before the language of authors and with it.

`python benchmarks/authoring.py --before c4113bb~1` counts the lines of each problem's two files that are not blank, at a revision and in
the working tree: the Markdown file without its figure, the figure (hand-drawn SVG, or lines of primitives), and the solution. `--markdown FILE` writes the table.
"""

from __future__ import annotations

import argparse
import re
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from statistics import median

TOP = Path(__file__).resolve().parents[1]
FIGURE = re.compile(r"^figure:.*\n(?:[ \t]+.*\n|\n)*", re.MULTILINE)  # an SVG, or lines of primitives


@dataclass(frozen=True)
class Lines:
    statement: int
    figure: int
    solution: int

    @property
    def all(self) -> int:
        return self.statement + self.figure + self.solution


def counted(problem: str, solution: str) -> Lines:
    figure = sum(map(_lines, FIGURE.findall(problem)))
    return Lines(_lines(problem) - figure, figure, _lines(solution))


def _lines(text: str) -> int:
    return sum(bool(line.strip()) for line in text.splitlines())


def bank(names: list[str], read: Callable[[str], str]) -> dict[str, Lines]:
    """Each problem of a tree, by the name of its file; a translation is none."""
    found: dict[str, Lines] = {}
    for name in names:
        path = Path(name)
        solution = f"{name.replace('problems', 'solutions', 1).removesuffix('.md')}.py"
        if path.suffix == ".md" and "." not in path.stem and solution in names:
            found[path.stem] = counted(read(name), read(solution))
    return found


def at(revision: str) -> dict[str, Lines]:
    def git(*words: str) -> str:
        return subprocess.run(["git", *words], cwd=TOP, check=True, capture_output=True, text=True).stdout

    names = git("ls-tree", "-r", "--name-only", revision, "problems", "solutions").splitlines()
    return bank(names, lambda name: git("show", f"{revision}:{name}"))


def now() -> dict[str, Lines]:
    files = (path for room in ("problems", "solutions") for path in (TOP / room).rglob("*.*"))
    return bank(
        [str(path.relative_to(TOP)) for path in files], lambda name: (TOP / name).read_text(encoding="utf-8")
    )


def table(revision: str, before: dict[str, Lines], after: dict[str, Lines]) -> str:
    both = sorted(before.keys() & after.keys())
    names = [each.name for each in fields(Lines)]
    rows = [
        "# Lines an author writes",
        "",
        f"`python benchmarks/authoring.py --before {revision}`: lines that are not blank, of the {len(both)} problems of the chapter that stand in both.",
        "",
        "| | before: median | after: median | before: all | after: all |",
        "|---|---|---|---|---|",
    ]
    for name in [*names, "all"]:
        old, new = ([getattr(tree[each], name) for each in both] for tree in (before, after))
        rows.append(f"| {name} | {median(old):g} | {median(new):g} | {sum(old)} | {sum(new)} |")
    return "\n".join(rows) + "\n"


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--before", required=True, help="the revision to compare with")
    options.add_argument("--markdown", type=Path, help="write the table here")
    given = options.parse_args()
    text = table(given.before, at(given.before), now())
    print(text, end="")
    if given.markdown:
        given.markdown.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
