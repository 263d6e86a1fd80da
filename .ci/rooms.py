"""Writes the table of rooms in docs/architecture.md: lines and files of each, and how many files the three walks enter.

`python .ci/rooms.py` writes it, `--check` says whether it is within a twentieth of the code (a test asks).
"""

from __future__ import annotations

import re
import statistics
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FrameType

from corollary.course.demo.players import right_sources
from corollary.course.generate import generate
from corollary.course.grade import grade_set
from corollary.derive.solve import solve
from corollary.formula.value import Text
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.records.files import Course
from corollary.sandbox.runner import Runner

TOP = Path(__file__).parents[1]
SOURCE = TOP / "src" / "corollary"
PAGE = TOP / "docs" / "architecture.md"
BEGIN, END = "<!-- rooms -->\n", "<!-- /rooms -->\n"
CODE = "X12.5"
NUMBER = re.compile(r"\d+")


def rooms() -> dict[str, list[int]]:
    """The lines of each file, by room; files that stand beside the rooms are `(beside)`."""
    found: dict[str, list[int]] = {}
    for path in sorted(SOURCE.rglob("*.py")):
        place = path.relative_to(SOURCE).parts
        lines = len(path.read_text(encoding="utf-8").splitlines())
        found.setdefault(place[0] if len(place) > 1 else "(beside)", []).append(lines)
    return dict(sorted(found.items(), key=lambda each: -sum(each[1])))


def entered(work: Callable[[], object]) -> int:
    """How many files of the package have a function that the work calls, in this process."""
    files = set[str]()

    def seen(frame: FrameType, event: str, argument: object) -> None:
        if event == "call" and frame.f_code.co_name != "<module>":
            files.add(frame.f_code.co_filename)

    sys.setprofile(seen)
    try:
        work()
    finally:
        sys.setprofile(None)
    return sum(each.startswith(str(SOURCE)) for each in files)


def walks() -> Iterator[tuple[str, int]]:
    """Each walk, with all that is made once at hand, as in a run over a class."""
    bank = chapter_bank()
    solutions = Solutions(bank)
    variant = chapter(bank[CODE])
    key, answer = solutions.key(variant), {"X12_5_a": Text("8.6 kg m/s")}
    judge(key, answer)
    yield "an answer, read and judged", entered(lambda: judge(key, answer))
    make_key(solve(bank, bank[CODE]), variant)
    yield "a law, from the loaded file to a key", entered(lambda: make_key(solve(bank, bank[CODE]), variant))
    with tempfile.TemporaryDirectory() as folder, Runner() as runner:
        problem_set, course = handed_in(Path(folder), bank, solutions)
        walk = entered(lambda: grade_set(course, problem_set, solutions, lambda: runner, jobs=1))
        yield "a notebook, from the folder handed in to the gradebook and the feedback page", walk


def handed_in(folder: Path, bank: Bank, solutions: Solutions) -> tuple[ProblemSet, Course]:
    """A course of one student, who has handed in right answers to one exercise."""
    (folder / "one.md").write_text(f"---\ntitle: One exercise\nproblems:\n  - {CODE}\n---\nOne exercise.\n")
    problem_set, student = find_set(bank, str(folder / "one.md")), Student("ada")
    made = generate(folder / "course", problem_set, [student], solutions)
    sheet = worksheet(problem_set, student, made.assigned[student.id].variants)
    keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
    path = made.course.notebook("submitted", student.id, problem_set.name)
    path.parent.mkdir(parents=True)
    path.write_text(filled_in(sheet, right_sources(sheet, keys)), encoding="utf-8")
    return problem_set, made.course


def page() -> str:
    """The section of the page between the two marks."""
    sizes = rooms()
    every = [lines for files in sizes.values() for lines in files]
    rows = [(name, sum(files), len(files), round(statistics.median(files))) for name, files in sizes.items()]
    rows.append(("**all**", sum(every), len(every), round(statistics.median(every))))
    return "\n".join(
        [
            "| room | lines | files | median |",
            "|---|---|---|---|",
            *(f"| {name} | {lines} | {files} | {median} |" for name, lines, files, median in rows),
            "",
            "| walk | files entered |",
            "|---|---|",
            *(f"| {name} | {files} |" for name, files in walks()),
            "",
        ]
    )


def near(told: str, found: str) -> bool:
    """Whether two texts are the same but for numbers that are within a twentieth, or two, of each other."""
    pairs = zip(map(int, NUMBER.findall(told)), map(int, NUMBER.findall(found)), strict=False)
    return NUMBER.sub("", told) == NUMBER.sub("", found) and all(
        abs(one - other) <= max(2, other / 20) for one, other in pairs
    )


def main() -> int:
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    told, _, after = rest.partition(END)
    found = page()
    if "--check" in sys.argv:
        return not near(told, found)
    PAGE.write_text(before + BEGIN + found + END + after, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
