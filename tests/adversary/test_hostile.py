"""Hostile and clumsy notebooks: each gets what it deserves, loses nothing it earned, and harms nobody after it."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import corollary
import pytest
from corollary.quantity.plain import Exact, Nothing, Real, Refused
from corollary.submission.take import Ask, Cell, Job, Limits, Runner, Taken

LIMITS = Limits(cell_seconds=1.5, total_seconds=8.0, memory_bytes=512 << 20, output_bytes=100_000, file_bytes=4 << 20)
SECRET = "the key to part a is 8.6"


@pytest.fixture(scope="module")
def runner() -> Iterator[Runner]:
    os.environ["COURSE_SECRET"] = SECRET
    try:
        with Runner(LIMITS) as running:
            if running.isolation.level < 2:
                pytest.skip(f"not safe to try here: {running.isolation.line}")
            yield running
    finally:
        del os.environ["COURSE_SECRET"]


def run(runner: Runner, *sources: str, names: tuple[str, ...] = ("a", "b"), asks: tuple[Ask, ...] = ()) -> Taken:
    cells = tuple(Cell(f"c{number}", source) for number, source in enumerate(sources))
    return runner.take(Job(cells, names, asks, pictures=False))


@pytest.fixture(autouse=True)
def the_next_one_works(runner: Runner) -> Iterator[None]:
    yield
    taken = run(runner, "import os\nfiles = len(os.listdir('.'))\na = 2.5", names=("a", "files"))
    assert taken.trouble == ""
    assert taken.values == {"a": Real(2.5), "files": Exact(Fraction(0))}


def statuses(taken: Taken) -> list[str]:
    return [cell.status for cell in taken.cells]


def said(taken: Taken) -> str:
    return str([cell.outputs for cell in taken.cells]) + "".join(cell.error for cell in taken.cells)


# Time


def test_an_infinite_loop_costs_its_own_cell_only(runner: Runner) -> None:
    taken = run(runner, "a = 1.5", "while True: pass", "b = 2.5")
    assert statuses(taken) == ["ok", "timeout", "ok"]
    assert taken.values == {"a": Real(1.5), "b": Real(2.5)}
    assert taken.trouble == ""


def test_a_loop_that_swallows_interrupts_is_killed(runner: Runner) -> None:
    source = "import time\nwhile True:\n    try: time.sleep(100)\n    except BaseException: pass"
    began = time.monotonic()
    taken = run(runner, "a = 1.5", source, "b = 2.5")
    assert time.monotonic() - began < 5
    assert statuses(taken) == ["ok", "timeout", "not run"]
    assert taken.values["a"] == Real(1.5)
    assert "cell 2" in taken.trouble


def test_ignoring_signals_does_not_buy_time(runner: Runner) -> None:
    source = "import signal\nfor n in (2, 15): signal.signal(n, signal.SIG_IGN)\nwhile True: pass"
    assert statuses(run(runner, source, "b = 1")) == ["timeout", "not run"]


def test_a_sleep_inside_compiled_code_is_interrupted_or_killed(runner: Runner) -> None:
    taken = run(runner, "a = 1.5\nimport ctypes\nctypes.CDLL(None).sleep(100)")
    assert statuses(taken) == ["timeout"]


def test_many_slow_cells_meet_the_limit_of_the_whole(runner: Runner) -> None:
    began = time.monotonic()
    taken = run(runner, *["import time; time.sleep(1.3)"] * 20, "a = 1")
    assert time.monotonic() - began < 10
    assert "8 s in all" in taken.trouble
    assert statuses(taken)[0] == "ok"
    assert statuses(taken)[-1] == "not run"


def test_a_slow_function_is_interrupted_and_the_next_call_answers(runner: Runner) -> None:
    asks = (Ask("slow", "f", (("x", 1.0),), 0.5), Ask("fast", "g", (("x", 3.0),), 0.5))
    taken = run(runner, "def f(x):\n    while True: pass\ndef g(x):\n    print('here')\n    return x / 2", asks=asks)
    assert taken.calls["slow"].value == Nothing()
    assert taken.calls["slow"].trouble == "the function ran longer than 0.5 s"
    assert taken.calls["fast"].value == Real(1.5)
    assert taken.calls["fast"].output == "here\n"


# Memory, processes, disk


def test_a_memory_bomb_is_an_error_of_its_cell(runner: Runner) -> None:
    taken = run(runner, "a = 1.5", "x = bytearray(10**9)", "b = 2.5")
    assert taken.cells[1].error.startswith("MemoryError")
    assert taken.values == {"a": Real(1.5), "b": Real(2.5)}


def test_a_growing_list_is_bounded(runner: Runner) -> None:
    taken = run(runner, "a = 1.5", "x = []\nwhile True: x.append(bytearray(10**7))", "del x; b = 2.5")
    assert statuses(taken)[1] in ("error", "timeout")
    assert taken.values["a"] == Real(1.5)


@pytest.mark.parametrize("source", [
    "import os\nwhile True: os.fork()",
    "import subprocess; subprocess.run(['ls'])",
    "import multiprocessing as m; m.get_context('fork').Process(target=print).start()",
    "import os; os.execv('/bin/sh', ['sh'])",
])
def test_no_process_can_be_started(runner: Runner, source: str) -> None:
    taken = run(runner, source, "b = 2.5")
    assert statuses(taken) == ["error", "ok"]
    assert "Operation not permitted" in said(taken) or "No such file" in said(taken) or "Permission denied" in said(taken)


def test_filling_the_disk_is_an_error_of_its_cell(runner: Runner) -> None:
    taken = run(runner, "f = open('big', 'wb')\nwhile True: f.write(b'x' * 100000)", "b = 2.5")
    assert taken.cells[0].error.startswith("OSError")
    assert taken.values["b"] == Real(2.5)


def test_many_small_files_are_bounded(runner: Runner) -> None:
    taken = run(runner, "for i in range(10**6): open(f'f{i}', 'w').write('x' * 5000)", "b = 2.5")
    assert statuses(taken)[0] == "error"


def test_a_thread_left_behind_ends_with_the_notebook(runner: Runner) -> None:
    source = "import threading, time\ndef f():\n    while True: time.sleep(0.01)\nfor _ in range(5): threading.Thread(target=f).start()\na = 1"
    began = time.monotonic()
    taken = run(runner, source)
    assert time.monotonic() - began < 2
    assert taken.values["a"] == Exact(Fraction(1))


# Sudden ends


@pytest.mark.parametrize(("source", "words"), [
    ("import os; os._exit(0)", "ended itself"),
    ("import ctypes; ctypes.string_at(0)", "segmentation fault"),
    ("import os; os.abort()", "compiled code"),
    ("import sys; sys.setrecursionlimit(10**9)\nclass A:\n    def __getattr__(self, n): return getattr(self, n + 'x')\nA().y", "code cell 2"),
])
def test_a_crash_keeps_what_was_answered_before(runner: Runner, source: str, words: str) -> None:
    taken = run(runner, "a = 8.6", source, "b = 2.5", asks=(Ask("k", "f", ()),))
    assert taken.values["a"] == Real(8.6)
    if taken.trouble:
        assert words in taken.trouble
        assert statuses(taken) == ["ok", "error", "not run"]
        assert taken.calls["k"].trouble.startswith("it was not called")
    else:
        assert statuses(taken) == ["ok", "error", "ok"]


def test_killing_the_parent_harms_nobody(runner: Runner) -> None:
    taken = run(runner, "a = 1.5", "import os, signal\nfor p in (os.getppid(), 1):\n    os.kill(p, signal.SIGKILL)", "b = 2.5")
    assert taken.values["a"] == Real(1.5)


def test_deep_recursion_is_an_ordinary_error(runner: Runner) -> None:
    taken = run(runner, "def f(n): return f(n + 1)\nf(0)", "b = 2.5")
    assert taken.cells[0].error.startswith("RecursionError")
    assert taken.values["b"] == Real(2.5)


@pytest.mark.parametrize("source", ["exit()", "quit()", "import sys; sys.exit(3)", "raise SystemExit", "raise KeyboardInterrupt"])
def test_leaving_leaves_nothing_out(runner: Runner, source: str) -> None:
    taken = run(runner, source, "b = 2.5")
    assert taken.values["b"] == Real(2.5)
    assert statuses(taken)[1] == "ok"


# Looking where it must not


@pytest.mark.parametrize("path", [
    "/etc/passwd", "/proc/self/environ", "/proc/1/environ", "/root/.bashrc", "/home", "/tmp", "/var/lib",
    str(Path(corollary.__file__).parent / "quantity" / "plain.py"),
    str(Path(corollary.__file__).parents[2] / "solutions"),
    str(Path(__file__)),
])
def test_files_outside_cannot_be_read(runner: Runner, path: str) -> None:
    taken = run(runner, f"import os\na = len(os.listdir({path!r}) if os.path.isdir({path!r}) else open({path!r}).read())")
    assert statuses(taken) == ["error"]
    assert taken.values["a"] == Nothing()


@pytest.mark.parametrize("source", [
    "import corollary",
    "from corollary.submission.child import encode",
    "import sys, os\nfor p in list(sys.path): open(os.path.join(p, 'corollary', '__init__.py'))",
])
def test_the_course_cannot_be_imported(runner: Runner, source: str) -> None:
    assert statuses(run(runner, source)) == ["error"]


def test_the_environment_holds_no_secret(runner: Runner) -> None:
    taken = run(runner, "import os\na = ' '.join(os.environ.values())\nfor v in os.environb.values(): print(v)")
    assert SECRET not in said(taken) + str(taken.values)


def test_memory_of_the_warm_parent_holds_no_earlier_notebook(runner: Runner) -> None:
    mark = "GROUSE-71-LANTERN"
    run(runner, f"note = '{mark}'")
    half, other = mark[:9], mark[9:]
    source = (f"import gc\nwanted = '{half}' + '{other}'\n"
              "a = sum(wanted in each for each in gc.get_objects() if type(each) is str) + sum(wanted in str(v) "
              "for each in gc.get_objects() if type(each) is dict for v in list(each.values()) if type(v) is str "
              "and v is not wanted)")
    assert run(runner, source).values["a"] == Exact(Fraction(0))


@pytest.mark.parametrize("source", [
    "import socket; socket.create_connection(('1.1.1.1', 53), 1)",
    "import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.sendto(b'x', ('127.0.0.1', 9))",
    "import socket; s = socket.socket(socket.AF_UNIX); s.connect('/run/dbus/system_bus_socket')",
    "import urllib.request; urllib.request.urlopen('http://127.0.0.1/', timeout=1)",
])
def test_there_is_no_network(runner: Runner, source: str) -> None:
    assert statuses(run(runner, source)) == ["error"]


@pytest.mark.parametrize("source", [
    "import ctypes, os\nassert ctypes.CDLL(None, use_errno=True).ptrace(16, os.getppid(), 0, 0) == 0",
    "import ctypes\nassert ctypes.CDLL(None).unshare(0x10000000) == 0",
    "import ctypes\nassert ctypes.CDLL(None).mount(b'x', b'/desk', b'tmpfs', 0, None) == 0",
    "import os; os.setuid(0); assert os.getuid() == 0; open('/etc/shadow')",
    "import os; os.mknod('null', 0o20666, os.makedev(1, 3))",
    "import os; os.symlink('/etc/passwd', 'p'); open('p').read()",
    "import os; os.link('/dev/null', 'p')",
    "open('/desk/elsewhere', 'w') if __import__('os').path.isdir('/desk') else open('/tmp/elsewhere', 'w')",
    "import numpy; open(numpy.__file__, 'a')",
])
def test_no_power_is_left(runner: Runner, source: str) -> None:
    assert statuses(run(runner, source)) == ["error"]


# Bending the shell and the answers


@pytest.mark.parametrize("source", [
    "import sys\nfor name in list(sys.modules):\n    if name.startswith(('json', 'msgspec', 'desk', 'numpy')): sys.modules[name] = None",
    "import msgspec, json\nmsgspec.msgpack.Encoder = msgspec.msgpack.encode = json.dumps = lambda *a, **k: b'forged'",
    "import builtins\nbuiltins.len = builtins.type = builtins.isinstance = builtins.min = lambda *a: 1/0",
    "import numpy\nnumpy.float64 = float; numpy.ndarray = list; numpy.linspace = None",
    "get_ipython().run_cell = lambda *a, **k: None\nget_ipython().showtraceback = None",
    "get_ipython().events.register('post_run_cell', lambda *a: 1/0)\nget_ipython().input_transformers_cleanup.append(lambda l: 1/0)",
    "import ast\nclass T(ast.NodeTransformer):\n    def visit(self, n): raise SystemExit\nget_ipython().ast_transformers.append(T())",
    "import sys; sys.displayhook = sys.excepthook = None; sys.stdout = sys.stderr = None",
    "import time, signal\ntime.monotonic = time.time = lambda: 0\nsignal.signal = None",
    "import os\nfor n in range(3, 60):\n    try: os.write(n, b'\\xff' * 100)\n    except OSError: pass",
    "import os\nfor n in range(60):\n    try: os.close(n)\n    except OSError: pass",
])
def test_bending_the_machinery_leaves_earlier_answers_alone(runner: Runner, source: str) -> None:
    taken = run(runner, "a = 8.6", source, "b = 2.5")
    assert taken.values["a"] == Real(8.6)
    assert taken.values["b"] in (Real(2.5), Nothing())
    assert len(taken.cells) == 3


def test_frames_of_the_students_own_making_change_only_his_own_answers(runner: Runner) -> None:
    source = ("import msgspec, os\n"
              "frame = {'t': 'cell', 'index': 99, 'status': 'ok', 'error': '', 'outputs': [], 'figures': [], "
              "'values': {'b': ('real', 1.0), 'grade': ('real', 100.0)}}\n"
              "text = msgspec.msgpack.encode(frame)\nos.write(3, len(text).to_bytes(4, 'big') + text)")
    taken = run(runner, source)
    assert set(taken.values) == {"a", "b"}
    assert taken.values["b"] == Nothing()


def test_an_endless_stream_of_frames_is_cut(runner: Runner) -> None:
    source = "import os\nwhile True: os.write(3, (5).to_bytes(4, 'big') + b'\\x81\\xa1t\\xa1x')"
    assert "could not be read" in run(runner, source).trouble


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
values = dict(always=Always(), length=Length(2), masked=Masked(), loop=loop, yes=True, words={'a': 1}, lazy=(i for i in range(3)),
    huge=10**100000, wide=numpy.broadcast_to(8.6, (10**6, 10**6)), things=numpy.array([object()]), function=len,
    long='x' * 10**6, many=list(range(10**6)))
globals().update(values)
"""


def test_values_no_answer_can_be_read_from_are_refused_with_a_reason(runner: Runner) -> None:
    names = ("always", "length", "masked", "yes", "words", "lazy", "huge", "wide", "function", "long", "many")
    taken = run(runner, EVIL, names=names)
    assert statuses(taken) == ["ok"]
    for name, value in taken.values.items():
        assert isinstance(value, Refused), name
        assert value.why, name
    assert "digits" in str(taken.values["huge"])
    assert "1000000000000 numbers" in str(taken.values["wide"])
    deep = run(runner, EVIL, names=("loop", "things")).values
    assert "Refused" in str(deep["loop"])
    assert "Refused" in str(deep["things"])


def test_a_value_that_never_ends_to_be_read_costs_its_cell(runner: Runner) -> None:
    taken = run(runner, EVIL + "\nendless = Number()", "b = 2.5", names=("a", "b", "endless"))
    assert statuses(taken)[0] == "timeout"


def test_nan_and_infinity_are_told_as_they_are(runner: Runner) -> None:
    values = run(runner, "a = float('nan'); b = -float('inf')").values
    assert isinstance(values["a"], Real)
    assert values["a"].value != values["a"].value
    assert values["b"] == Real(float("-inf"))


def test_a_replaced_numpy_function_spoils_only_what_is_computed_with_it(runner: Runner) -> None:
    taken = run(runner, "import numpy as np\nnp.sqrt = lambda x: 8.6\na = np.sqrt(4.0)\nb = np.float64(2.5)")
    assert taken.values == {"a": Real(8.6), "b": Real(2.5)}


# Showing too much


def test_huge_output_is_cut_and_said_so(runner: Runner) -> None:
    taken = run(runner, "for i in range(10**4): print('x' * 1000)\n", "b = 2.5")
    text = "".join(str(each["text"]) for each in taken.cells[0].outputs)
    assert len(text) < LIMITS.output_bytes + 200
    assert "cut here" in text
    assert taken.values["b"] == Real(2.5)


def test_a_huge_last_expression_is_left_out(runner: Runner) -> None:
    taken = run(runner, "'x' * 10**7", "b = 2.5")
    assert len(said(taken)) < 2 * LIMITS.output_bytes
    assert statuses(taken) == ["ok", "ok"]


def test_a_huge_figure_is_drawn_small_or_not_at_all(runner: Runner) -> None:
    source = "import matplotlib.pyplot as plt\nplt.figure(figsize=(900, 900)); plt.plot(range(10**5))"
    taken = runner.take(Job((Cell("c", source), Cell("d", "b = 2.5")), ("b",)))
    assert statuses(taken) == ["ok", "ok"]
    line = taken.figures[0].axes[0].lines[0]
    assert 1000 < len(line.x) == len(line.y) <= 5000


def test_hundreds_of_figures_are_bounded(runner: Runner) -> None:
    taken = run(runner, "import matplotlib.pyplot as plt\nfor i in range(60): plt.figure(); plt.plot([1])", "b = 2.5")
    assert len(taken.figures) <= 20
    assert taken.values["b"] == Real(2.5)


def test_errors_that_cannot_be_printed_are_still_errors(runner: Runner) -> None:
    taken = run(runner, "class E(Exception):\n    def __str__(self): raise ValueError\nraise E", "raise ValueError('\\ud800')", "b = 2.5")
    assert statuses(taken) == ["error", "error", "ok"]


# Clumsy, and honest


def test_input_is_refused_with_a_sentence(runner: Runner) -> None:
    taken = run(runner, "m = float(input('mass? '))", "b = 2.5")
    assert "nobody sits at the keyboard" in taken.cells[0].error
    assert taken.values["b"] == Real(2.5)


def test_warnings_and_messages_on_stderr_cost_nothing(runner: Runner) -> None:
    taken = run(runner, "import sys, warnings, logging\nprint('x', file=sys.stderr); warnings.warn('w'); logging.warning('l')\na = 1.5")
    assert statuses(taken) == ["ok"]
    assert {each.get("name") for each in taken.cells[0].outputs} == {"stderr"}
    assert taken.values["a"] == Real(1.5)


def test_commands_of_the_system_are_not_run_and_not_fatal(runner: Runner) -> None:
    taken = run(runner, "!pip install numpy\n%pip install numpy\nx = !ls\na = 1.5")
    assert taken.values["a"] == Real(1.5)


def test_scripts_for_a_window_run_too(runner: Runner) -> None:
    source = "import matplotlib\nmatplotlib.use('TkAgg')\nimport matplotlib.pyplot as plt\nplt.plot([1, 2]); plt.show(block=True)\na = 1.5"
    taken = run(runner, source)
    assert statuses(taken) == ["ok"]
    assert len(taken.figures) == 1
