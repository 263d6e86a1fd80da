"""`check`, as it runs in a student's notebook, on a computer that has Python and nothing of ours."""

from __future__ import annotations

import ast
import base64
import bz2
import contextlib
import io
import json
import subprocess
import sys
from importlib import metadata
from types import SimpleNamespace

import pytest

from corollary.messages import language
from corollary.notebook.check import Check
from corollary.notebook.notebook import check_source
from corollary.notebook.worksheet import Worksheet

# What is typed into the answer cell, and what check says then.
SAID = [
    ("X12_5_a", "", "no answer yet"),
    ("X12_5_a", "X12_5_a = None", "no answer yet"),
    ("X12_5_a", "X12_5_a = 8.6", "read as 8.6 kg m/s"),
    ("X12_5_a", "X12_5_a = '8,60 Ns'", "read as 8.60 N s (3 figures)"),
    ("X12_5_a", "X12_5_a = '8.6'", "read as 8.6, taken in kg m/s; better write 8.6 kg m/s\n"),
    ("X12_5_a", "X12_5_a = '8,6'", "read as 8.6, taken in kg m/s; better write 8.6 kg m/s\n"),
    ("X12_5_a", "X12_5_a = '0.86·10^1'", "read as 8.6, taken in kg m/s; better write 8.6 kg m/s\n"),
    ("X12_5_a", "X12_5_a = '43/5'", "read as 8.6, taken in kg m/s; better write 8.6 kg m/s\n"),
    ("X12_5_b", "X12_5_b = '(4,7; 3,1)'", "read as (4.7, 3.1), taken in m/s; better write 4.7 m/s\n"),
    (
        "X12_5_a",
        "X12_5_a = None\nIn = ['', 'X12_5_a = 1', 'X12_5_a = 8.6 N s  # mine']",
        'no answer yet: write a number with its unit in quotes: X12_5_a = "8.6 N s"\n',
    ),
    (
        "X12_5_a",
        "X12_5_a = 8.6\nIn = ['X12_5_a = 8.6 N', '%matplotlib\\nX12_5_a = 8.6']",
        "read as 8.6 kg m/s",
    ),
    ("X12_5_a", "X12_5_a = 8.6\nIn = ['X12_5_a = 8.6 N', 'm = 8\\nX12_5_a = 1.0*m']", "read as 8.6 kg m/s"),
    (
        "X12_5_a",
        "X12_5_a = 8.6\nIn = ['', 'X12_5_a = 8.6', 'X12_5_a = m*v']",
        'no answer yet: write a formula, a letter or a word in quotes: X12_5_a = "m*v"\n',
    ),
    ("X12_5_a", "m, v = 2, 3\nX12_5_a = m*v\nIn = ['', 'm, v = 2, 3', 'X12_5_a = m*v']", "read as 6 kg m/s"),
    (
        "X12_5_d",
        "In = ['', 'X12_5_d = B']",
        'no answer yet: write a formula, a letter or a word in quotes: X12_5_d = "B"\n',
    ),
    ("X12_5_a", "x12_5_a = 8.6", "no answer yet: you wrote x12_5_a instead of X12_5_a\n"),
    (
        "X12_5_a",
        "X12_5_a = None\nIn = ['X12_5_a = None  # 8.6 N s']",
        "no answer yet: text behind # is not read",
    ),
    (
        "X12_5_a",
        "In = ['8.6 N s', 'check()']",
        'no answer yet: give the value its name: X12_5_a = "8.6 N s"\n',
    ),
    (
        "X12_5_a",
        "X12_5_a = [\n1]\nIn = ['', 'X12_5_a = [\\n1]']",
        "read as 1 kg m/s",
    ),
    ("X12_5_a", "X12_5_a = '8.6 N/s'", "a momentum or an impulse is expected"),
    ("X12_5_a", "X12_5_a = '1,234 N s'", "1.234 or 1234"),
    ("X12_5_a", "X12_5_a = 'rather a lot'", "cannot be read"),
    ("X12_5_a", "X12_5_a = True", "not a number"),
    ("X12_5_a", "X12_5_a = float('nan')", "cannot be read: the result is not a number"),
    ("X12_5_a", "X12_5_a = 1j", "complex number"),
    ("X12_5_a", "X12_5_a = [3, 4]", "cannot be read: one number is asked for, not 2"),
    ("X12_5_a", "X12_5_a = [3]", "read as 3 kg m/s"),
    ("X12_5_a", "from fractions import Fraction\nX12_5_a = Fraction(1, 3)", "read as 0.333333 kg m/s"),
    ("X12_5_b", "X12_5_b = [3, '4 km/h']", "read as (3 m/s, 4 km/h)"),
    ("X12_5_b", "X12_5_b = '3 i - 4 j m/s'", "read as (3 m/s, -4 m/s)"),
    (
        "X12_5_a",
        "X12_5_a = '-8.6 N s, x to the left'",
        "read as -8.6 N s, x to the left (2 figures)\n",
    ),
    (
        "X12_5_a",
        "X12_5_a = '8.6 N s (taking positive to the left).'",
        "read as 8.6 N s, positive to the left (2 figures)\n",
    ),
    ("X12_5_a", "X12_5_a = '8.6, x to the left'", "to the left, taken in kg m/s; better write 8.6 kg m/s\n"),
    ("X12_5_a", "X12_5_a = '8.6 N s to the left'", "read as 8.6 N s to the left (2 figures)\n"),
    ("X12_5_a", "X12_5_a = '8.6 N s towards the goal'", "write the number with its sign"),
    ("X12_5_b", "X12_5_b = 'y = 4 m/s, x = 3 m/s'", "read as (3 m/s, 4 m/s)"),
    ("X12_5_a", "X12_5_a = 'm v'", "read as m*v\n"),
    ("X12_5_a", "X12_5_a = '2mv'", "read as 2*m*v\n"),
    ("X12_5_a", "X12_5_a = '-m v, x to the left'", "read as -m*v, x to the left\n"),
    ("X12_5_a", "X12_5_a = 'm'", "cannot be read: m is not in kg m/s: it is a mass"),
    ("X12_5_b", "X12_5_b = ['v', '-v/2']", "read as (v, -v/2)\n"),
    ("X12_5_a", "X12_5_a = '8.6 N s, north to the left'", "cannot be read"),
    ("X12_5_a", "X12_5_a = ['8.6 N s, x to the left']", "cannot be read"),
    ("X12_5_b", "X12_5_b = {'y': 4, 'x': '3 m/s'}", "read as (3 m/s, 4 m/s)"),
    ("X12_5_b", "X12_5_b = {'y': 4, 'z': 3}", "cannot be read: the names are x, y, not y, z"),
    ("X12_5_b", "X12_5_b = '(-3, 4) m/s, x to the left; y down'", "x to the left, y down (1 figure)\n"),
    ("X12_5_b", "X12_5_b = '(3, 4) m/s, z to the left'", "cannot be read"),
    ("X12_5_i", "X12_5_i = '3 m/s, x to the left'", "cannot be read"),
    ("X12_5_b", "X12_5_b = [None, None]", "no answer yet"),
    ("X12_5_b", "X12_5_b = [3, None]", "cannot be read: a component is missing"),
    ("X12_5_b", "X12_5_b = [1, 2, 3]", "cannot be read: 2 components are asked for, [x, y], not 3"),
    ("X12_5_b", "X12_5_b = 3", "cannot be read: 2 components are asked for: write them as a list, [x, y]"),
    ("X12_5_c", "X12_5_c = 'm v/dt'", "read as m*v/dt"),
    ("X12_5_c", "X12_5_c = 'm v'", "cannot be read: m*v is not in N: it is a momentum or an impulse"),
    ("X12_5_c", "X12_5_c = 'm v/dt + m'", "cannot be added"),
    ("X12_5_c", "X12_5_c = 'm v/2dt'", "write m*v/(2*dt) or (m*v/2)*dt"),
    ("X12_5_c", "X12_5_c = 'm w'", "w is not among the letters"),
    ("X12_5_c", "X12_5_c = 17", "cannot be read: this is a number; a formula is asked for"),
    ("X12_5_d", "X12_5_d = ' (B) '", "read as (B)"),
    ("X12_5_d", "X12_5_d = 'option b'", "read as (B)"),
    ("X12_5_d", "X12_5_d = 'c'", "cannot be read: answer with one letter of A, B"),
    ("X12_5_f", "", "no function yet"),
    ("X12_5_f", "def force(t, dt, J):\n    '''Words.'''\n    ...", "force(t, dt, J) is still empty"),
    ("X12_5_f", "def force(t, dt, J):\n    ...", "force(t, dt, J) is still empty"),
    ("X12_5_f", "force = lambda t, dt, J: 1", "is there"),
    ("X12_5_f", "def force(t):\n    return 1", "takes (t), but it will be called with (t, dt, J)"),
    ("X12_5_f", "force = 3", "is of the type int"),
    ("X12_5_g", "", "the figure drawn above"),
    ("X12_5_h", "X12_5_h = ['']", "no answer yet"),
    ("X12_5_h", "X12_5_h = ['dt = m v', 'm = v = dt']", "read as 3 equations: dt = m*v; m = v; m = dt\n"),
    (
        "X12_5_h",
        "X12_5_h = ['p = m v', 'J = dp']",
        "letters of your own: p: J in line 2 is not a letter of the problem, and no line defines it",
    ),
    ("X12_5_h", "X12_5_h = 3", "cannot be read: write a list of equations, each as text"),
    ("X12_5_i", "X12_5_i = [0.5, '3 m/s']", "read as (0.5, 3 m/s)"),
    ("E12_3_1s_a", "E12_3_1s_a = '0.3 rad'", "read as 0.3 rad"),
    ("nobody", "", "there is no answer of this name"),
]

# Each try in a process of its own, forked from one that has run the cell.
ALONE = """
import contextlib, io, json, os, sys
for name in ("corollary", "flint", "msgspec", "nbformat", "sympy", "numpy", "IPython"):
    sys.modules[name] = None
job = json.load(sys.stdin)
space = {}
exec(job["setup"], space)
found = []
for key, source in job["tries"]:
    reading, writing = os.pipe()
    if not os.fork():
        exec(source, space)
        with contextlib.redirect_stdout(io.StringIO()) as out:
            space["check"](key)
        litter = sorted(name for name in space if not name.startswith("__"))
        os.write(writing, json.dumps((out.getvalue(), litter)).encode())
        os._exit(0)
    os.close(writing)
    with open(reading, encoding="utf-8") as read:
        found.append(json.load(read))
json.dump({"said": [text for text, _ in found], "litter": found[-1][1]}, sys.stdout)
"""


def alone(setup: str, tries: list[tuple[str, str]]) -> dict:
    job = json.dumps({"setup": setup, "tries": tries})
    command = [sys.executable, "-S", "-I", "-c", ALONE]
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


def test_without_a_name_it_goes_through_all_answers_but_the_written_ones(
    ada: Worksheet, capsys: pytest.CaptureFixture[str]
):
    space: dict = {}
    exec(check_source(ada), space)
    space["check"]()
    lines = capsys.readouterr().out.splitlines()
    assert [line.partition(":")[0] for line in lines] == [
        prompt.key for prompt in ada.prompts if prompt.part.answer_type != "explain"
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


def test_it_is_a_few_lines_and_holds_no_more_than_what_reads(ada: Worksheet):
    source = check_source(ada)
    lines = source.splitlines()
    assert len(lines) < 30
    assert max(map(len, lines)) < 10_000  # an editor breaks longer ones
    assert len(source) < 150_000


def test_its_code_can_be_printed(ada: Worksheet):
    space: dict = {}
    exec(check_source(ada), space)
    assert "# corollary.answers.value.reading\n" in space["check"].source
    assert "def read_quantity(" in space["check"].source


def test_the_code_that_is_installed_is_used_where_it_is_of_the_same_version(ada: Worksheet):
    space: dict = {}
    exec(check_source(ada), space)
    assert type(space["check"]) is Check


def test_code_of_another_version_is_carried_beside_what_is_installed(
    ada: Worksheet, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    before = {name: module for name, module in sys.modules.items() if name.startswith("corollary")}
    monkeypatch.setattr(metadata, "version", lambda package: "0.0.1")
    space: dict = {"X12_5_a": "2mv"}
    exec(check_source(ada), space)
    assert type(space["check"]) is not Check
    space["check"]("X12_5_a")
    assert capsys.readouterr().out == "X12_5_a: read as 2*m*v\n"
    assert {name: module for name, module in sys.modules.items() if name.startswith("corollary")} == before


def test_it_holds_questions_and_code_that_reads_and_nothing_that_judges(ada: Worksheet):
    cell = next(each for each in ast.parse(check_source(ada)).body if isinstance(each, ast.FunctionDef))
    packed = ast.literal_eval(cell.args.defaults[0])
    carried = json.loads(bz2.decompress(base64.b85decode(packed)))
    reading = {"loader", "versions", "folders", "units", "questions", "modules"}
    assert set(carried) == reading | {"language", "catalogues"}
    for question in carried["questions"]:
        assert set(question) == {
            "part", "name", "types", "unit", "title", "components", "options", "option_texts", "signature",
            "symbols", "slope", "rows", "columns", "column_units", "positive", "reference", "extreme", "text", "variables",
        }  # fmt: skip
    rooms = {name.split(".")[1] for name in carried["modules"] if "." in name}
    assert rooms <= {"answers", "formula", "messages", "notebook", "sandbox", "units"}
    assert not {name for name in carried["modules"] if name.endswith((".judging", ".expected", ".verdict"))}


def test_check_speaks_the_language_of_the_notebook_where_nothing_of_ours_is_installed(
    ada: Worksheet, translated
):
    translated(
        "corollary.answers", {"no answer yet": "ankoraŭ neniu respondo", "it {predicate}": "tio {predicate}"}
    )
    translated("corollary.sandbox", {"is True or False, not a number": "estas vero, ne nombro"})
    translated(
        "corollary.notebook",
        {"{name}: there is no answer of this name; the names are {known}": "{name}: nekonata"},
    )
    with language("eo"):
        setup = check_source(ada)
    tries = [("X12_5_a", ""), ("X12_5_a", "X12_5_a = True"), ("X12_5_a", "X12_5_a = 8.6"), ("nobody", "")]
    nothing, truth, number, nobody = alone(setup, tries)["said"]
    assert "ankoraŭ neniu respondo" in nothing
    assert "tio estas vero, ne nombro" in truth
    assert "read as 8.6 kg m/s" in number  # what nobody has translated yet is said in English
    assert nobody == "nobody: nekonata\n"
    assert "no answer yet" in alone(check_source(ada), tries[:1])["said"][0]


class Kernel:
    """A notebook's kernel as far as `check` knows it: it runs cells by their ids, and tells of each."""

    def __init__(self, setup: str) -> None:
        self._called: dict[str, list] = {"pre_run_cell": [], "post_run_cell": []}
        events = SimpleNamespace(register=lambda name, call: self._called[name].append(call))
        self.space: dict = {"get_ipython": lambda: SimpleNamespace(events=events), "In": [""]}
        exec(setup, self.space)

    def run(self, text: str, cell: str | None) -> None:
        info = SimpleNamespace(raw_cell=text, cell_id=cell)
        before = failed = None
        for call in self._called["pre_run_cell"]:
            call(info)
        self.space["In"].append(text)
        try:
            code = compile(text, "cell", "exec")
            try:
                exec(code, self.space)
            except Exception as error:
                failed = error
        except SyntaxError as error:
            before = error
        for call in self._called["post_run_cell"]:
            call(SimpleNamespace(info=info, error_before_exec=before, error_in_exec=failed))

    def says(self, name: str) -> str:
        self.space["In"].append(f'check("{name}")')
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.space["check"](name)
        return out.getvalue()


NO_VALUE = "no answer yet: its cell gives X12_5_a no value; write X12_5_a = …"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("X12_5_a: 9.3", NO_VALUE),
        ("X12_5_a == 9.3", NO_VALUE),
        ("X12_5_a := 9.3", NO_VALUE),
        ("X12_5_a 9.3 N s", NO_VALUE),
        ("X12_5a = 9.3", NO_VALUE),
        ("# X12_5_a = 9.3", NO_VALUE),
        ("p = 9.3", NO_VALUE),
        ("", NO_VALUE),
        ("X12_5_a = None\n9.3", NO_VALUE),
        ("9.3 N s", 'no answer yet: give the value its name: X12_5_a = "9.3 N s"'),
        ("x12_5_a = 9.3", "no answer yet: you wrote x12_5_a instead of X12_5_a"),
        ("X12_5_a = 9.3 N s", 'no answer yet: write a number with its unit in quotes: X12_5_a = "9.3 N s"'),
        ("X12_5_a: float = 9.3", "read as 9.3 kg m/s"),
        ("X12_5_a, other = 5, 3", "read as 5 kg m/s"),
        ("for X12_5_a in [4, 5]: pass", "read as 5 kg m/s"),
        ("X12_5_a += 1", "read as 6 kg m/s"),
    ],
)
def test_it_speaks_of_what_stands_in_the_cell_now(ada: Worksheet, text: str, said: str):
    kernel = Kernel(check_source(ada))
    kernel.run("X12_5_a = 5", "its cell")
    assert "read as 5 kg m/s" in kernel.says("X12_5_a")
    kernel.run(text, "its cell")
    assert said in kernel.says("X12_5_a")
    kernel.run("X12_5_a = 7", "its cell")
    assert "read as 7 kg m/s" in kernel.says("X12_5_a")


@pytest.mark.parametrize("cell", ["another cell", None])
def test_a_cell_that_is_not_the_answers_own_takes_no_value_away(ada: Worksheet, cell: str | None):
    kernel = Kernel(check_source(ada))
    kernel.run("X12_5_a = 5", "its cell")
    kernel.run("X12_5_a == 9.3", cell)
    assert "read as 5 kg m/s" in kernel.says("X12_5_a")
