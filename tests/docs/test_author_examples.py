"""Every problem and solution on the authors' pages: each pair, with its programs, verifies in a fresh bank."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
from corollary.verify.verify import verify

DOCS = Path(__file__).parents[2] / "docs"
FIRST = [
    DOCS / "reference" / "problem_file.md",
    DOCS / "reference" / "solution_file.md",
]  # a pair on two pages
OF_A_PAIR = re.compile(r"^```markdown\n(---\ncode: |(?!---))|^def derive\(", re.MULTILINE)
TEXTS = [path.read_text(encoding="utf-8") for path in dict.fromkeys([*FIRST, *sorted(DOCS.rglob("*.md"))])]
PAGE = "\n".join(text for text in TEXTS if OF_A_PAIR.search(text))
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
ELSEWHERE = {"bash", "text"}  # in test_tutorial and test_figures
PROGRAM = re.compile(r"# (\w+)/(\w+\.py)\n")


@dataclass
class Pair:
    problem: str
    solution: str = ""
    beside: str = ""  # the program of the same name
    programs: dict[str, str] = field(default_factory=dict)

    @property
    def code(self) -> str:
        found = re.search(r"^code: (.+)$", self.problem, re.MULTILINE)
        assert found is not None
        return found[1]


def pairs() -> dict[str, Pair]:
    """Each problem with the solution behind it, and the programs behind that. A second solution of a problem, in Python, is a pair of
    its own."""
    found: dict[str, Pair] = {}
    last = Pair("")
    for kind, text in BLOCK.findall(PAGE):
        if kind == "markdown" and text.startswith("---"):
            last = Pair(text)
            found[last.code] = last
        elif kind == "markdown":
            assert not last.solution, text
            last.solution = text
        elif kind == "python" and (program := PROGRAM.match(text)):
            last.programs["/".join(program.groups())] = text
        elif kind == "python" and "def derive(" in text:
            found[f"{last.code} in Python"] = Pair(last.problem, beside=text)
        elif kind == "python":
            last.beside = text
        else:
            assert kind in ELSEWHERE, kind
    assert all(each.solution or each.beside for each in found.values())
    return found


PAIRS = pairs()


def test_there_is_one_for_each_kind_of_answer_that_needs_explaining():
    asked = set(re.findall(r"^## .*\{#\w+ ((?:\.\w+ )+)", PAGE, re.MULTILINE))
    kinds = {kind for each in asked for kind in each.split()}
    assert {".value", ".list", ".interval", ".word", ".table", ".forces", ".code", ".plot"} <= kinds
    assert len(PAIRS) >= 8


# X1.6 has a program whose judge runs it often.
@pytest.mark.parametrize(
    "code", [pytest.param(code, marks=pytest.mark.whole) if code == "X1.6" else code for code in PAIRS]
)
def test_the_pair_verifies(tmp_path, code):
    pair, name = PAIRS[code], "pair"
    for program in pair.programs:
        name = program.partition("/")[0]
    for folder, ending, text in (
        ("problems", "md", pair.problem),
        ("solutions", "md", pair.solution),
        ("solutions", "py", pair.beside),
    ):
        if text:
            (tmp_path / folder / "x").mkdir(parents=True, exist_ok=True)
            (tmp_path / folder / "x" / f"{name}.{ending}").write_text(text, encoding="utf-8")
    for program, text in pair.programs.items():
        path = tmp_path / "solutions" / "x" / program
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    checked = verify(Bank(tmp_path), read_problem(tmp_path / "problems" / "x" / f"{name}.md"), 5)
    assert checked.complaints == ()
    asked = re.findall(r"(?m)^## .*\{.*\}$", pair.problem)
    examples = [kind for heading in asked for kind in re.findall(r"\.(?:code|plot)\b", heading)]
    assert checked.checks.get("programs run", 0) == 2 * len(examples)
    assert pair.programs or checked.checks.get("mistakes apart", 0) > 0
    assert ("def scene" in pair.beside) == (checked.checks.get("simulations met", 0) > 0)
    assert not checked.notes
