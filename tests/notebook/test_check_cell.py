"""`check`, as it runs in a student's notebook, on a computer that has Python and nothing of ours."""

from __future__ import annotations

import json
import re
import subprocess
import sys

import pytest

from corollary.notebook.as_read import Asked, heard
from corollary.notebook.check_cell import check_source
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import at
from corollary.units.unit import unit

# What is typed into the answer cell, and what check says then.
SAID = [
    ("X12_5_a", "", "no answer yet"),
    ("X12_5_a", "X12_5_a = None", "no answer yet"),
    ("X12_5_a", "X12_5_a = 8.6", "read as 8.6 kg m/s"),
    ("X12_5_a", "X12_5_a = '8,60 Ns'", "read as 8.60 N s (3 figures)"),
    ("X12_5_a", "X12_5_a = '8.6'", "the unit is missing"),
    ("X12_5_a", "X12_5_a = '8.6 N/s'", "a momentum or an impulse is expected"),
    ("X12_5_a", "X12_5_a = '1,234 N s'", "1.234 or 1234"),
    ("X12_5_a", "X12_5_a = 'eight'", "cannot be read"),
    ("X12_5_a", "X12_5_a = True", "not a number"),
    ("X12_5_a", "X12_5_a = float('nan')", "is nan, which is not a number"),
    ("X12_5_a", "X12_5_a = 1j", "complex number"),
    ("X12_5_a", "X12_5_a = [3, 4]", "one number is expected"),
    ("X12_5_a", "X12_5_a = [3]", "read as 3 kg m/s"),
    ("X12_5_a", "from fractions import Fraction\nX12_5_a = Fraction(1, 3)", "read as 1/3 kg m/s"),
    ("X12_5_b", "X12_5_b = [3, '4 km/h']", "read as (3 m/s, 4 km/h)"),
    ("X12_5_b", "X12_5_b = '3 i - 4 j m/s'", "read as (3 m/s, -4 m/s)"),
    (
        "X12_5_a",
        "X12_5_a = '-8.6 N s, x to the left'",
        "read as -8.6 N s (2 figures) with your x to the left\n",
    ),
    (
        "X12_5_a",
        "X12_5_a = '8.6 N s (taking positive to the left).'",
        "read as 8.6 N s (2 figures) with positive to the left\n",
    ),
    ("X12_5_a", "X12_5_a = '8.6, x to the left'", "the unit is missing"),
    ("X12_5_a", "X12_5_a = '8.6 N s to the left'", "read as 8.6 N s (2 figures), to the left\n"),
    ("X12_5_a", "X12_5_a = '8.6 N s towards the goal'", "write the number with its sign"),
    ("X12_5_b", "X12_5_b = 'y = 4 m/s, x = 3 m/s'", "read as (3 m/s, 4 m/s)"),
    ("X12_5_a", "X12_5_a = 'm v'", "read as m*v\n"),
    ("X12_5_a", "X12_5_a = '2mv'", "read as 2*m*v\n"),
    ("X12_5_a", "X12_5_a = '-m v, x to the left'", "read as -m*v with your x to the left\n"),
    ("X12_5_a", "X12_5_a = 'm'", "cannot be read"),
    ("X12_5_b", "X12_5_b = ['v', '-v/2']", "read as [v, -v/2]\n"),
    ("X12_5_a", "X12_5_a = '8.6 N s, north to the left'", "cannot be read"),
    ("X12_5_a", "X12_5_a = ['8.6 N s, x to the left']", "cannot be read"),
    ("X12_5_b", "X12_5_b = '(-3, 4) m/s, x to the left; y down'", "with your x to the left, y down\n"),
    ("X12_5_b", "X12_5_b = '(3, 4) m/s, z to the left'", "cannot be read"),
    ("X12_5_i", "X12_5_i = '3 m/s, x to the left'", "cannot be read"),
    ("X12_5_b", "X12_5_b = [None, None]", "no answer yet"),
    ("X12_5_b", "X12_5_b = [3, None]", "y has no answer yet"),
    ("X12_5_b", "X12_5_b = [1, 2, 3]", "a list of 2 is expected, [x, y]"),
    ("X12_5_b", "X12_5_b = 3", "is one number"),
    ("X12_5_c", "X12_5_c = 'm v/dt'", "read as m*v/dt"),
    ("X12_5_c", "X12_5_c = 'm v'", "a force is expected"),
    ("X12_5_c", "X12_5_c = 'm v/dt + m'", "cannot be added"),
    ("X12_5_c", "X12_5_c = 'm v/2dt'", "not clear what stands below the slash"),
    ("X12_5_c", "X12_5_c = 'm w'", "w is not among the letters"),
    ("X12_5_c", "X12_5_c = 17", "write the formula itself"),
    ("X12_5_d", "X12_5_d = ' (B) '", "read as (b)"),
    ("X12_5_d", "X12_5_d = 'c'", "is not one of the letters a, b"),
    ("X12_5_f", "", "no function yet"),
    ("X12_5_f", "def force(t, dt, J):\n    '''Words.'''\n    ...", "force(t, dt, J) is still empty"),
    ("X12_5_f", "def force(t, dt, J):\n    ...", "force(t, dt, J) is still empty"),
    ("X12_5_f", "force = lambda t, dt, J: 1", "is there"),
    ("X12_5_f", "def force(t):\n    return 1", "takes (t), but it will be called with (t, dt, J)"),
    ("X12_5_f", "force = 3", "is of the type int"),
    ("X12_5_g", "", "the figure drawn above"),
    ("X12_5_h", "X12_5_h = ['']", "no answer yet"),
    ("X12_5_h", "X12_5_h = ['p = m v', 'J = dp']", "read as 2 lines"),
    ("X12_5_h", "X12_5_h = 3", "is not a list of texts"),
    ("X12_5_i", "X12_5_i = [0.5, '3 m/s']", "read as (0.5, 3 m/s)"),
    ("E12_3_1s_a", "E12_3_1s_a = '0.3 rad'", "read as 0.3 rad"),
    ("nobody", "", "there is no answer of this name"),
]

ALONE = """
import contextlib, io, json, sys
for name in ("corollary", "flint", "msgspec", "nbformat", "sympy", "numpy", "IPython"):
    sys.modules[name] = None
job = json.load(sys.stdin)
said = []
for key, source in job["tries"]:
    space = {}
    exec(job["setup"], space)
    exec(source, space)
    with contextlib.redirect_stdout(io.StringIO()) as out:
        space["check"](key)
    said.append(out.getvalue())
litter = sorted(name for name in space if not name.startswith("__"))
json.dump({"said": said, "litter": litter}, sys.stdout)
"""


def alone(setup: str, tries: list[tuple[str, str]]) -> dict:
    job = json.dumps({"setup": setup, "tries": tries})
    command = [sys.executable, "-I", "-c", ALONE]
    done = subprocess.run(command, input=job, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def said(ada: Worksheet) -> dict:
    return alone(check_source(ada), [(key, source) for key, source, _ in SAID])


@pytest.mark.parametrize(
    "number", range(len(SAID)), ids=[f"{key}: {source[-30:]}" for key, source, _ in SAID]
)
def test_it_says_how_an_answer_is_read(said: dict, number: int):
    key, _, expected = SAID[number]
    assert said["said"][number].startswith(key + ": ")
    assert expected in said["said"][number]


def test_it_leaves_two_names_in_the_notebook(said: dict):
    assert said["litter"] == ["check", "corollary"]


def test_without_a_name_it_goes_through_all_answers_but_the_written_ones(ada: Worksheet):
    space: dict = {}
    exec(check_source(ada), space)
    lines: list[str] = []
    space["print"] = lines.append
    space["check"]()
    assert [line.partition(":")[0] for line in lines] == [
        prompt.key for prompt in ada.prompts if prompt.part.kind != "explain"
    ]


@pytest.mark.parametrize(
    ("stage", "answer", "error"),
    [("autograde", 8.6, RuntimeError), ("validate", None, ValueError), ("validate", 8.6, None)],
)
def test_it_fails_where_nbgrader_would_take_silence_for_success(
    ada: Worksheet, monkeypatch: pytest.MonkeyPatch, stage: str, answer: object, error: type[Exception] | None
):
    monkeypatch.setenv("NBGRADER_EXECUTION", stage)
    space: dict = {"X12_5_a": answer}
    exec(check_source(ada), space)
    if error is None:
        space["check"]("X12_5_a")
    else:
        with pytest.raises(error):
            space["check"]("X12_5_a")


def test_an_old_python_is_told_so(
    ada: Worksheet, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.setattr(sys, "version_info", (3, 9, 0))
    space: dict = {}
    exec(check_source(ada), space)
    space["check"]("X12_5_a")
    assert "check needs Python 3.11" in capsys.readouterr().out


def test_it_carries_the_code_for_formulas_only_where_there_are_formulas(
    ada: Worksheet, problem_set: ProblemSet
):
    drop = problem_set.problems[1]
    small = check_source(
        Worksheet(
            problem_set, Student("bob"), worksheet(problem_set, Student("bob"), [at(drop, 3)]).exercises
        )
    )
    assert "as_formula" in check_source(ada).split("ASKED")[0]
    assert "reader('as_formula'" not in small
    assert len(small) < 0.7 * len(check_source(ada))


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        ("m*g", "looked at as a formula"), ("2 sqrt(m)g, x to the left", "looked at as a formula"), ("8.6", "the unit is missing"),
        ("m*q", "cannot be read"), ("8.6 kg m", "is expected"), ("", "cannot be read"), ("sqrt(2)*(", "cannot be read"),
    ],
)  # fmt: skip
def test_a_formula_for_a_number_is_left_to_the_marker_where_no_code_for_it_is_carried(
    answer: str, expected: str
):
    asked = Asked("number", unit("kg m/s"), letters=(("m", unit("kg")), ("g", unit("m/s^2"))), directed=True)
    assert expected in heard(asked, ("text", answer)).text


def test_it_is_readable_text_with_no_line_out_of_sight(ada: Worksheet):
    source = check_source(ada)
    assert max(map(len, source.splitlines())) < 400
    assert not re.search(r"base64|zlib|[A-Za-z0-9+/]{120}", source)
