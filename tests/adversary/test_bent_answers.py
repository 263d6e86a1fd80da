"""Hostile notebooks that bend the shell or their answers, and clumsy ones that mean no harm."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from corollary.formula.value import Nothing, Real, Refused
from corollary.sandbox.job import ExecutionResult

Run = Callable[..., ExecutionResult]


def statuses(taken: ExecutionResult) -> list[str]:
    return [cell.status for cell in taken.cells]


def said(taken: ExecutionResult) -> str:
    return str([cell.outputs for cell in taken.cells]) + "".join(cell.error for cell in taken.cells)


# Bending the shell and the answers


@pytest.mark.parametrize(
    "source",
    [
        "import sys\nfor n in [*sys.modules]:\n    if n.startswith(('json', 'msgspec', 'sandbox', 'numpy')): sys.modules[n] = 0",
        "import msgspec, json\nmsgspec.msgpack.Encoder = msgspec.msgpack.encode = json.dumps = lambda *a, **k: b'forged'",
        "import builtins\nbuiltins.len = builtins.type = builtins.isinstance = builtins.min = lambda *a: 1/0",
        "import numpy\nnumpy.float64 = float; numpy.ndarray = list; numpy.linspace = None",
        "get_ipython().run_cell = lambda *a, **k: None\nget_ipython().showtraceback = None",
        "s = get_ipython(); s.events.register('post_run_cell', lambda *a: 1/0)\ns.input_transformers_cleanup.append(len)",
        "import ast\nclass T(ast.NodeTransformer):\n    def visit(s, n): exit(1/0)\nget_ipython().ast_transformers.append(T())",
        "import sys; sys.displayhook = sys.excepthook = None; sys.stdout = sys.stderr = None",
        "import time, signal\ntime.monotonic = time.time = lambda: 0\nsignal.signal = None",
        "import os\nfor n in range(3, 60):\n    try: os.write(n, b'\\xff' * 100)\n    except OSError: pass",
        "import os\nfor n in range(60):\n    try: os.close(n)\n    except OSError: pass",
    ],
)
def test_bending_the_machinery_leaves_earlier_answers_alone(run: Run, source: str) -> None:
    taken = run("a = 8.6", source, "b = 2.5")
    assert taken.values["a"] == Real(8.6)
    assert taken.values["b"] in (Real(2.5), Nothing())
    assert len(taken.cells) == 3


def test_frames_of_the_students_own_making_change_only_his_own_answers(run: Run) -> None:
    source = (
        "import msgspec, os\n"
        "frame = {'t': 'cell', 'index': 99, 'status': 'ok', 'error': '', 'outputs': [], 'figures': [], "
        "'values': {'b': ('real', 1.0), 'grade': ('real', 100.0)}}\n"
        "text = msgspec.msgpack.encode(frame)\nos.write(3, len(text).to_bytes(4, 'big') + text)"
    )
    taken = run(source)
    assert set(taken.values) == {"a", "b"}
    assert taken.values["b"] == Nothing()


def test_an_endless_stream_of_frames_is_cut(run: Run) -> None:
    source = "import os\nwhile True: os.write(3, (5).to_bytes(4, 'big') + b'\\x81\\xa1t\\xa1x')"
    assert "could not be read" in run(source).trouble


EVIL = """
class Always:
    def __eq__(self, other): return True
    def __float__(self): return 8.6
    def __getattribute__(self, name): raise SystemExit
class Length(float):
    def __float__(self): return 8.6
class Meta(type):
    __name__ = property(lambda self: 1/0)
    __module__ = property(lambda self: 1/0)
class Masked(metaclass=Meta): pass
class Number:
    __module__ = 'numpy'
    def __float__(self):
        while True: pass
Number.__name__ = 'float64'
loop = []; loop.append(loop)
import numpy
values = dict(always=Always(), length=Length(2), masked=Masked(), loop=loop, yes=True, words={1: 1}, lazy=(i for i in range(3)),
    huge=10**100000, wide=numpy.broadcast_to(8.6, (10**6, 10**6)), things=numpy.array([object()]), function=len,
    long='x' * 10**6, many=list(range(10**6)))
globals().update(values)
"""


def test_values_no_answer_can_be_read_from_are_refused_with_a_reason(run: Run) -> None:
    names = ("always", "length", "masked", "yes", "words", "lazy", "huge", "wide", "function", "long", "many")
    taken = run(EVIL, names=names)
    assert statuses(taken) == ["ok"]
    for name, value in taken.values.items():
        assert isinstance(value, Refused), name
        assert value.why, name
    assert "digits" in str(taken.values["huge"])
    assert "1000000000000 numbers" in str(taken.values["wide"])
    deep = run(EVIL, names=("loop", "things")).values
    assert "Refused" in str(deep["loop"])
    assert "Refused" in str(deep["things"])


def test_a_value_that_never_ends_to_be_read_costs_its_cell(run: Run) -> None:
    taken = run(EVIL + "\nendless = Number()", "b = 2.5", names=("a", "b", "endless"))
    assert statuses(taken)[0] == "timeout"


def test_nan_and_infinity_are_told_as_they_are(run: Run) -> None:
    values = run("a = float('nan'); b = -float('inf')").values
    assert isinstance(values["a"], Real)
    assert values["a"].value != values["a"].value
    assert values["b"] == Real(float("-inf"))


def test_a_replaced_numpy_function_spoils_only_what_is_computed_with_it(run: Run) -> None:
    taken = run("import numpy as np\nnp.sqrt = lambda x: 8.6\na = np.sqrt(4.0)\nb = np.float64(2.5)")
    assert taken.values == {"a": Real(8.6), "b": Real(2.5)}


# Showing too much


def test_huge_output_is_cut_and_said_so(run: Run) -> None:
    taken = run("for i in range(10**4): print('x' * 1000)\n", "b = 2.5")
    text = "".join(str(each["text"]) for each in taken.cells[0].outputs)
    assert len(text) < 100_200
    assert "cut here" in text
    assert taken.values["b"] == Real(2.5)


def test_a_huge_last_expression_is_left_out(run: Run) -> None:
    taken = run("'x' * 10**7", "b = 2.5")
    assert len(said(taken)) < 200_000
    assert statuses(taken) == ["ok", "ok"]


def test_a_huge_figure_is_drawn_small_or_not_at_all(run: Run) -> None:
    source = "import matplotlib.pyplot as plt\nplt.figure(figsize=(900, 900)); plt.plot(range(10**5))"
    taken = run(source, "b = 2.5", pictures=True)
    assert statuses(taken) == ["ok", "ok"]
    line = taken.figures[0].axes[0].lines[0]
    assert 1000 < len(line.x) == len(line.y) <= 5000


def test_hundreds_of_figures_are_bounded(run: Run) -> None:
    taken = run("import matplotlib.pyplot as plt\nfor i in range(60): plt.figure(); plt.plot([1])", "b = 2.5")
    assert len(taken.figures) <= 20
    assert taken.values["b"] == Real(2.5)


def test_errors_that_cannot_be_printed_are_still_errors(run: Run) -> None:
    taken = run(
        "class E(Exception):\n    def __str__(self): raise ValueError\nraise E",
        "raise ValueError('\\ud800')",
        "b = 2.5",
    )
    assert statuses(taken) == ["error", "error", "ok"]


# Clumsy, and honest


def test_text_of_the_students_own_class_is_told_or_left_out(run: Run) -> None:
    source = (
        "class S(str):\n    def encode(self, *a): return 3\n    def __getitem__(self, i): return self\n"
        "class E(Exception):\n    def __str__(self): return S('x')\n"
        "E.__name__ = S('E')\nprint(S('shown'))\na = 1.5\nraise E"
    )
    taken = run(source, "b = 2.5")
    assert statuses(taken) == ["error", "ok"]
    assert taken.values == {"a": Real(1.5), "b": Real(2.5)}


def test_input_is_refused_with_a_sentence(run: Run) -> None:
    taken = run("m = float(input('mass? '))", "b = 2.5")
    assert "nobody sits at the keyboard" in taken.cells[0].error
    assert taken.values["b"] == Real(2.5)


def test_warnings_and_messages_on_stderr_cost_nothing(run: Run) -> None:
    taken = run(
        "import sys, warnings, logging\nprint('x', file=sys.stderr); warnings.warn('w'); logging.warning('l')\na = 1.5"
    )
    assert statuses(taken) == ["ok"]
    assert {each.get("name") for each in taken.cells[0].outputs} == {"stderr"}
    assert taken.values["a"] == Real(1.5)


def test_commands_of_the_system_are_not_run_and_not_fatal(run: Run) -> None:
    taken = run("!pip install numpy\n%pip install numpy\nx = !ls\na = 1.5")
    assert taken.values["a"] == Real(1.5)


def test_scripts_for_a_window_run_too(run: Run) -> None:
    source = "import matplotlib as m\nm.use('TkAgg')\nimport matplotlib.pyplot as p\np.plot([1, 2]); p.show(block=True)\na = 1.5"
    taken = run(source)
    assert statuses(taken) == ["ok"]
    assert len(taken.figures) == 1
