"""Problems of one page, written for a test and solved."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

from corollary.derive.solution import Solution
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home


def solved(folder: Path, givens: str, parts: str, steps: str, arguments: str) -> Solution:
    """A problem T9 of these givens (a line of front matter each), parts (`a m/s`, or `#a .vector …`, what a heading has in its
    brackets), and the body of its `derive`."""
    headings = "".join(f"\n## Part {{{_attributes(line)}}}\nWhat is it?\n" for line in parts.splitlines())
    problem = f"---\ncode: T9\ntitle: Small\ngiven:\n{indent(dedent(givens), '  ')}\n---\nSmall.\n{headings}"
    solution = (
        '"""Small."""\n\nfrom corollary.author import derivation, mistake, step, unknown, unknowns, vector\n'
        f"from corollary.laws import law\n\n\ndef derive({arguments}):\n{indent(dedent(steps), '    ')}\n"
    )
    for place, text in (("problems/all/small.md", problem), ("solutions/all/small.py", solution)):
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        (folder / place).write_text(text, encoding="utf-8")
    bank, found = home(folder, "T9")
    return Solutions(bank).of(found)


def _attributes(line: str) -> str:
    if line.startswith("#"):
        return f"{line} points=1"
    name, unit = line.split()
    return f'#{name} .value unit="{unit}" points=1'
