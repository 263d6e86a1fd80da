"""Hostile notebooks that take too much or end suddenly: they lose nothing they earned and harm nobody after them."""

from __future__ import annotations

import time
from collections.abc import Callable
from fractions import Fraction

import pytest

from corollary.formula.value import Exact, Nothing, Real
from corollary.sandbox.job import ExecutionResult, FunctionCall

Run = Callable[..., ExecutionResult]


def statuses(taken: ExecutionResult) -> list[str]:
    return [cell.status for cell in taken.cells]


def said(taken: ExecutionResult) -> str:
    return str([cell.outputs for cell in taken.cells]) + "".join(cell.error for cell in taken.cells)


# Time


def test_an_infinite_loop_costs_its_own_cell_only(run: Run) -> None:
    taken = run("a = 1.5", "while True: pass", "b = 2.5")
    assert statuses(taken) == ["ok", "timeout", "ok"]
    assert taken.values == {"a": Real(1.5), "b": Real(2.5)}
    assert taken.trouble == ""


def test_a_loop_that_swallows_interrupts_is_killed(run: Run) -> None:
    source = "import time\nwhile True:\n    try: time.sleep(100)\n    except BaseException: pass"
    began = time.monotonic()
    taken = run("a = 1.5", source, "b = 2.5")
    assert time.monotonic() - began < 10
    assert statuses(taken) == ["ok", "timeout", "ok"]
    assert taken.values["a"] == Real(1.5)
    assert taken.values["b"] == Real(2.5)
    assert "cell 2" in taken.trouble


def test_ignoring_signals_does_not_buy_time(run: Run) -> None:
    source = "import signal\nfor n in (2, 15): signal.signal(n, signal.SIG_IGN)\nwhile True: pass"
    began = time.monotonic()
    assert statuses(run(source, "b = 1")) == ["timeout", "ok"]
    assert time.monotonic() - began < 10


def test_a_sleep_inside_compiled_code_is_interrupted_or_killed(run: Run) -> None:
    taken = run("a = 1.5\nimport ctypes\nctypes.CDLL(None).sleep(100)")
    assert statuses(taken) == ["timeout"]


def test_many_slow_cells_meet_the_limit_of_the_whole(run: Run) -> None:
    began = time.monotonic()
    taken = run(*["import time; time.sleep(0.8)"] * 20, "a = 1")
    assert time.monotonic() - began < 10
    assert "5 s in all" in taken.trouble
    assert statuses(taken)[0] == "ok"
    assert statuses(taken)[-1] == "not run"


def test_a_slow_function_is_interrupted_and_the_next_call_answers(run: Run) -> None:
    calls = (FunctionCall("slow", "f", (("x", 1.0),), 0.5), FunctionCall("fast", "g", (("x", 3.0),), 0.5))
    taken = run(
        "def f(x):\n    while True: pass\ndef g(x):\n    print('here')\n    return x / 2", calls=calls
    )
    assert taken.calls["slow"].value == Nothing()
    assert taken.calls["slow"].trouble == "the function ran longer than 0.5 s"
    assert taken.calls["fast"].value == Real(1.5)
    assert taken.calls["fast"].output == "here\n"


# Memory, processes, disk


def test_a_memory_bomb_is_an_error_of_its_cell(run: Run) -> None:
    taken = run("a = 1.5", "x = bytearray(10**9)", "b = 2.5")
    assert taken.cells[1].error.startswith("MemoryError")
    assert taken.values == {"a": Real(1.5), "b": Real(2.5)}


def test_a_growing_list_is_bounded(run: Run) -> None:
    taken = run("a = 1.5", "x = []\nwhile True: x.append(bytearray(10**7))", "del x; b = 2.5")
    assert statuses(taken)[1] in ("error", "timeout")
    assert taken.values["a"] == Real(1.5)


@pytest.mark.parametrize(
    "source",
    [
        "import os\nwhile True: os.fork()",
        "import subprocess; subprocess.run(['ls'])",
        "import multiprocessing as m; m.get_context('fork').Process(target=print).start()",
        "import os; os.execv('/bin/sh', ['sh'])",
    ],
)
def test_no_process_can_be_started(run: Run, source: str) -> None:
    taken = run(source, "b = 2.5")
    assert statuses(taken) == ["error", "ok"]
    assert (
        "Operation not permitted" in said(taken)
        or "No such file" in said(taken)
        or "Permission denied" in said(taken)
    )


def test_filling_the_disk_is_an_error_of_its_cell(run: Run) -> None:
    taken = run("f = open('big', 'wb')\nwhile True: f.write(b'x' * 100000)", "b = 2.5")
    assert taken.cells[0].error.startswith("OSError")
    assert taken.values["b"] == Real(2.5)


def test_many_small_files_are_bounded(run: Run) -> None:
    taken = run("for i in range(10**6): open(f'f{i}', 'w').write('x' * 5000)", "b = 2.5")
    assert statuses(taken)[0] == "error"


def test_a_thread_left_behind_ends_with_the_notebook(run: Run) -> None:
    source = "import threading as t, time\ndef f():\n    while 1:time.sleep(1)\nfor _ in 'abc': t.Thread(target=f).start()\na = 1"
    began = time.monotonic()
    taken = run(source)
    assert time.monotonic() - began < 2
    assert taken.values["a"] == Exact(Fraction(1))


# Sudden ends


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("import os; os._exit(0)", "ended itself"),
        ("import ctypes; ctypes.string_at(0)", "segmentation fault"),
        ("import os; os.abort()", "compiled code"),
        (
            "import sys; sys.setrecursionlimit(10**9)\nclass A:\n    def __getattr__(s, n): return getattr(s, n + 'x')\nA().y",
            "code cell 2",
        ),
    ],
)
def test_a_crash_costs_its_own_cell_alone(run: Run, source: str, words: str) -> None:
    taken = run("a = 8.6", source, "b = 2.5", calls=(FunctionCall("k", "f", ()),))
    assert taken.values == {"a": Real(8.6), "b": Real(2.5)}
    assert statuses(taken) == ["ok", "ended", "ok"]
    if taken.trouble:
        assert words in taken.trouble
        assert taken.trouble.endswith("The rest was run again without it.")


def test_a_function_that_ends_the_process_costs_its_own_calls_alone(run: Run) -> None:
    source = "import os\ndef f(): os._exit(0)\ndef g(): return 2.5"
    taken = run(
        "a = 8.6",
        source,
        calls=(FunctionCall("f/0", "f", ()), FunctionCall("g/0", "g", ()), FunctionCall("f/1", "f", ())),
    )
    assert taken.values["a"] == Real(8.6)
    assert taken.calls["g/0"].value == Real(2.5)
    assert taken.calls["f/0"].trouble
    assert taken.calls["f/1"].trouble


def test_a_notebook_that_dies_everywhere_is_run_again_a_few_times_only(run: Run) -> None:
    taken = run("a = 8.6", *["import os; os._exit(0)"] * 8, "b = 2.5")
    assert taken.values["a"] == Real(8.6)
    assert statuses(taken) == [
        "ok",
        "ended",
        "ended",
        "ended",
        "ended",
        "not run",
        "not run",
        "not run",
        "not run",
        "not run",
    ]
    assert taken.trouble.count("The rest was run again without it.") == 3


def test_killing_the_parent_harms_nobody(run: Run) -> None:
    taken = run(
        "a = 1.5", "import os, signal\nfor p in (os.getppid(), 1):\n    os.kill(p, signal.SIGKILL)", "b = 2.5"
    )
    assert taken.values["a"] == Real(1.5)


def test_deep_recursion_is_an_ordinary_error(run: Run) -> None:
    taken = run("def f(n): return f(n + 1)\nf(0)", "b = 2.5")
    assert taken.cells[0].error.startswith("RecursionError")
    assert taken.values["b"] == Real(2.5)


@pytest.mark.parametrize(
    "source", ["exit()", "quit()", "import sys; sys.exit(3)", "raise SystemExit", "raise KeyboardInterrupt"]
)
def test_leaving_leaves_nothing_out(run: Run, source: str) -> None:
    taken = run(source, "b = 2.5")
    assert taken.values["b"] == Real(2.5)
    assert statuses(taken)[1] == "ok"
