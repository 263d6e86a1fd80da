"""One student's input thrown at random at what reads it: archives, notebooks, and values that answers may have.

python benchmarks/one_students_input.py 3000 [seed] [--markdown FILE]

Counted is what was refused, what was read, the slowest, and every exception, which would be a fault of this program.
"""

from __future__ import annotations

import argparse
import io
import json
import random
import tempfile
import time
import zipfile
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from corollary.formula.value import (
    Complex,
    Exact,
    Items,
    Measured,
    Named,
    Nothing,
    Real,
    Refused,
    Text,
    Value,
)
from corollary.grading.integrity import elsewhere, notes
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.part_grades import Marked
from corollary.grading.points import grade
from corollary.grading.solutions import Solutions
from corollary.grading.submission import MarkedSubmission, Submission
from corollary.guard import collecting, guarded
from corollary.nbgrader.graded import graded
from corollary.notebook.content import with_names
from corollary.notebook.locate import code_to_run, origin, plot_cells, written_text
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank, find, load
from corollary.problem.problem_set import ProblemSet, Scheme, read_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.sandbox.archive import members
from corollary.sandbox.notebook_file import Notebook, notebook_of

CODES = ("X12.5", "X12.6", "X12.7")
ODD = (
    "", " ", "\0", "\ud800", "\u202e", "\x1b[2J", "=1+1", "@SUM(A1)", "-2+3|cmd", "<script>", "]]>", "*)", "{}", "{0}", "%s", "\\", "$",
    "$$", "`", "|", "9" * 5_000, "1e999999999", "(" * 5_000, "-" * 5_000, "x" * 20_000, "٣", "½", "∞", "nan", "inf", "1_000", "0x1F",
    "1e-400", "m/s" * 800, "2^2^2^2^2^2", "9**9**9", "5 m +- 1", "10^(10^10)", "sin(" * 100, "sqrt(-1)", "1/0", "a=b=c", "\n" * 1_000,
)  # fmt: skip


def value(draw: random.Random, depth: int = 0) -> Value:
    """A value as it may come back from the process that ran a notebook."""
    kinds: list[Callable[[], Value]] = [
        Nothing,
        lambda: Real(
            draw.choice([0.0, -0.0, 1e308, -1e308, 5e-324, float("nan"), float("inf"), draw.gauss(0, 1e3)])
        ),
        lambda: Exact(Fraction(draw.choice([0, 1, -1, 10**400, -(10**4_000)]), draw.choice([1, 3, 10**400]))),
        lambda: Complex(draw.gauss(0, 1), draw.choice([0.0, 1.0, float("nan")])),
        lambda: Text(
            draw.choice(ODD)
            + draw.choice(["", " ", " m/s", " kg m/s"])
            + draw.choice(ODD)[: draw.choice([0, 9, 99_999])]
        ),
        lambda: Text(
            "".join(draw.choices("0123456789.,eE+-*/^()=~<> mvgskNJ_{}\\$\"'", k=draw.randrange(60)))
        ),
        lambda: Measured(
            draw.choice([1.0, float("nan"), 1e308]), draw.choice([*ODD, "m/s", "furlong"])[:19_000]
        ),
        lambda: Refused("is an object of the kind x", draw.choice(ODD)[:200]),
    ]
    if depth < 4:
        kinds += [
            lambda: Items(several := tuple(value(draw, depth + 1) for _ in range(draw.randrange(5))), draw.choice([(len(several),), (0,), (3, 1), ()])),
            lambda: Named(("x", draw.choice(ODD)[:99]), (value(draw, depth + 1), value(draw, depth + 1))),
        ]  # fmt: skip
    return draw.choice(kinds)()


def changed(draw: random.Random, content: bytes) -> bytes:
    """A few bytes overwritten, cut out, doubled or put in."""
    raw = bytearray(content)
    for _ in range(draw.choice([1, 1, 2, 4, 16])):
        at = draw.randrange(len(raw) + 1)
        match draw.randrange(4):
            case 0:
                raw[at : at + 1] = bytes([draw.randrange(256)])
            case 1:
                del raw[at : at + draw.choice([1, 4, 64, 1_000])]
            case 2:
                raw[at:at] = draw.choice(
                    [b"\xff" * 4, b"\0" * 8, b"PK\x01\x02", draw.randbytes(8), b"[", b'"', b"1e999,"]
                )
            case _:
                raw[at:at] = raw[at : at + draw.choice([8, 50, 400])]
    return bytes(raw)


def bent(draw: random.Random, node: Any, depth: int = 0) -> Any:
    """A notebook's data with some of its values exchanged for others, of any type."""
    if draw.random() < 0.004:
        return draw.choice(
            [None, True, 10**300, -1, 1e308, float("nan"), [], {}, [[[]]], draw.choice(ODD), {"": {}}, 4]
        )
    if isinstance(node, dict):
        return {
            draw.choice(ODD)[:99] if draw.random() < 0.001 else name: bent(draw, each, depth + 1)
            for name, each in node.items()
        }
    if isinstance(node, list):
        found = [bent(draw, each, depth + 1) for each in node]
        return found * 2 if draw.random() < 0.005 else found
    return node


class Tally:
    """What came of a kind of input."""

    def __init__(self, title: str) -> None:
        self.title, self.outcomes, self.slowest, self.crashes = title, Counter[str](), 0.0, Counter[str]()

    def run(self, work: Callable[[], str]) -> None:
        began = time.process_time()
        with collecting() as failures:
            found = guarded(work, 30.0)
        self.slowest = max(self.slowest, time.process_time() - began)
        for each in failures:
            where = [line.strip() for line in each.trace.splitlines() if line.startswith("  File")]
            self.crashes[f"{each.what[:90]} at {where[-1] if where else '?'}"] += 1
        self.outcomes[found if isinstance(found, str) else "failed"] += 1

    def row(self) -> str:
        came = ", ".join(f"{count} {what}" for what, count in self.outcomes.most_common())
        return f"| {self.title} | {self.outcomes.total()} | {came} | {self.slowest:.2f} | {self.crashes.total()} |"


def small_set(folder: Path) -> ProblemSet:
    file = folder / "fuzz.md"
    file.write_text(f"---\ntitle: Fuzz\nproblems: [{', '.join(CODES)}]\n---\n")
    return read_set(chapter_bank(), file)


def archives(draw: random.Random, count: int, folder: Path, sheet: bytes) -> Tally:
    """An archive of everybody's, in which one student's own is changed at random: the other member must come out whole."""
    tally = Tally("archives")
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("work/one.ipynb", sheet)
        made.writestr("data.csv", b"1,2\n" * 100)
        nested = io.BytesIO()
        with zipfile.ZipFile(nested, "w", zipfile.ZIP_LZMA) as deeper:
            deeper.writestr("one.ipynb", sheet)
        made.writestr("more.zip", nested.getvalue())
    for _ in range(count):
        path = folder / "all.zip"
        with zipfile.ZipFile(path, "w") as made:
            made.writestr("ben/own.zip", changed(draw, inner.getvalue()))
            made.writestr("cyd/one.ipynb", b"cyd's")

        def read(path: Path = path) -> str:
            found = list(members(path, lambda parts: parts[0]))
            if not any(each.content == b"cyd's" and each.parts == ("cyd", "one.ipynb") for each in found):
                raise AssertionError("another student's notebook was lost")
            return (
                "read"
                if any(isinstance(each.content, bytes) and each.parts[0] == "ben" for each in found)
                else "refused"
            )

        tally.run(read)
    return tally


def notebooks(draw: random.Random, count: int, problem_set: ProblemSet, sheet: bytes) -> Tally:
    """Notebooks changed at random, in their bytes or their values, through all that reads and shows them."""
    tally = Tally("notebooks")
    variants = tuple(chapter(problem) for problem in problem_set.problems)
    own = worksheet(problem_set, Student("ben"), variants)
    raw = json.loads(sheet)
    for number in range(count):
        content = changed(draw, sheet) if number % 2 else json.dumps(bent(draw, raw)).encode()

        def read(content: bytes = content) -> str:
            found = notebook_of(content)
            if not isinstance(found, Notebook):
                assert found.why
                return "refused"
            origin(found.node)
            if elsewhere(own, found.node):
                return "of another set"
            notes(own, found.node)
            node = with_names(found.node, own)
            code_to_run(node, notebook(own))
            plot_cells(node, own)
            for prompt in own.prompts:
                written_text(node, prompt)
            marked = Marked(own.student, (), (), (), "", "", 0.0, 1.0)
            graded(
                problem_set,
                Submission(own.student, content, variants, 0.0, ""),
                MarkedSubmission(marked, node, {}),
            )
            return "read"

        tally.run(read)
    return tally


def answers(draw: random.Random, count: int, keys: list[Key]) -> Tally:
    """Values of any type as answers to every part, judged, told in words and made into a page."""
    tally = Tally("answers")
    for _ in range(count):
        key = draw.choice(keys)
        given = {part.id: value(draw) for part in key.variant.problem.parts}

        def mark(key: Key = key, given: dict[str, Value] = given) -> str:
            judged = judge(key, given, {}, secret=b"secret", student="ben")
            points = grade(key, judged, Scheme(), 1.0, reveal=True)
            return f"{'some' if any(part.points for part in points.parts) else 'no'} points"

        tally.run(mark)
    return tally


def main() -> None:
    words = argparse.ArgumentParser(description=__doc__)
    words.add_argument("count", type=int)
    words.add_argument("seed", type=int, nargs="?", default=1)
    words.add_argument("--markdown", type=Path)
    asked = words.parse_args()
    draw, bank = random.Random(asked.seed), chapter_bank()
    solutions = Solutions(bank)
    with tempfile.TemporaryDirectory() as name:
        problem_set = small_set(Path(name))
        variants = tuple(chapter(problem) for problem in problem_set.problems)
        from corollary.notebook.notebook import filled_in

        sheet = filled_in(worksheet(problem_set, Student("ben"), variants), {}).encode()
        keys = [solutions.key(chapter(find(bank, problem.code))) for problem in load(bank)]
        tallies = [
            archives(draw, asked.count, Path(name), b"{}" * 40),
            notebooks(draw, asked.count // 4, problem_set, sheet),
            answers(draw, asked.count, keys),
        ]
    lines = [
        "| input | drawn | came to | slowest, s of the processor | failures of this program |",
        "|---|---|---|---|---|",
    ]
    lines += [tally.row() for tally in tallies]
    crashes = [f"- {count} × {what}" for tally in tallies for what, count in tally.crashes.most_common(20)]
    text = "\n".join(
        [
            f"# One student's input, at random\n\n`python benchmarks/one_students_input.py {asked.count} {asked.seed}`\n",
            *lines,
            "",
            *crashes,
        ]
    )
    print(text)
    if asked.markdown:
        asked.markdown.write_text(text.rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
