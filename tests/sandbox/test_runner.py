"""Honest notebooks behave as they do in Jupyter, and their answers come back."""

from __future__ import annotations

import os
import signal
import threading
from fractions import Fraction
from pathlib import Path
from typing import Any

import nbformat
import pytest

from corollary.formula.value import Exact, Items, Nothing, Real, Text
from corollary.messages import language
from corollary.sandbox.isolation import WeakIsolation
from corollary.sandbox.job import Cell, ExecutionResult, FunctionCall, Job
from corollary.sandbox.runner import Runner


def shown(taken: Any, index: int = 0) -> str:
    return "".join(str(each.get("text", "")) for each in taken.cells[index].outputs)


def test_answers_come_back_as_plain_values(run) -> None:
    taken = run(
        "from fractions import Fraction\na = 0.43 * 20\nb = Fraction(8, 5)\nc = '8.6 Ns'",
        names=("a", "b", "c", "d"),
    )
    assert taken.values == {
        "a": Real(0.43 * 20),
        "b": Exact(Fraction(8, 5)),
        "c": Text("8.6 Ns"),
        "d": Nothing(),
    }


def test_an_answer_changed_by_a_later_cell_is_the_later_one(run) -> None:
    assert run("a = 1.5; b = 1", "a = 2.5; del b").values == {"a": Real(2.5), "b": Nothing()}


def test_numpy_scalars_and_arrays_are_numbers(run) -> None:
    taken = run(
        "import numpy as np\na = np.float64(8.6)\nb = np.array([[1.0, 2.0], [3.0, np.inf]])\nc = np.int32(7)\nd = np.array(2.5)",
        names=("a", "b", "c", "d"),
    )
    assert taken.values["a"] == Real(8.6)
    assert taken.values["b"] == Items((Real(1.0), Real(2.0), Real(3.0), Real(float("inf"))), (2, 2))
    assert taken.values["c"] == Exact(Fraction(7))
    assert taken.values["d"] == Real(2.5)


def test_sympy_numbers_are_exact_and_expressions_are_text(run) -> None:
    source = "import sympy as s\nm, v = s.symbols('m v')\na = s.Rational(8, 5); b = 2*m*v; c = s.sqrt(2)/2; d = s.Integer(3)"
    values = run(source, names=("a", "b", "c", "d")).values
    assert values["a"] == Exact(Fraction(8, 5))
    assert values["b"] == Text("2*m*v")
    assert values["c"] == Real(0.5**0.5)
    assert values["d"] == Exact(Fraction(3))


def test_outputs_are_valid_nbformat_in_their_order(run) -> None:
    source = "import sys\nprint('one'); print('two', file=sys.stderr)\nfrom IPython.display import HTML\ndisplay(HTML('x'))\n8.6"
    outputs = run(source).cells[0].outputs
    assert [each["output_type"] for each in outputs] == ["stream", "stream", "display_data", "execute_result"]
    cell = nbformat.v4.new_code_cell(source, outputs=[nbformat.from_dict(dict(each)) for each in outputs])
    nbformat.validate(nbformat.v4.new_notebook(cells=[cell]))


def test_errors_show_the_students_line_and_nothing_of_ours(run) -> None:
    taken = run("m = 1\nx = m / 0", "y = 1 +", "a = 1.5")
    assert [cell.status for cell in taken.cells] == ["error", "error", "ok"]
    assert taken.cells[0].error == "ZeroDivisionError: division by zero"
    trace = "\n".join(taken.cells[0].outputs[0]["traceback"])
    assert "Cell In[1], line 2" in trace
    assert "x = m / 0" in trace
    assert "sandbox" not in trace
    assert taken.cells[1].error.startswith("SyntaxError")


@pytest.mark.parametrize(
    "source",
    [
        "%matplotlib inline\na = 1.5",
        "%config InlineBackend.figure_format = 'retina'\na = 1.5",
        "%%time\na = 1.5",
        "import asyncio\nawait asyncio.sleep(0.001)\na = 1.5",
        "import asyncio\nasync def f(): return 1.5\na = await f()",
        "from dataclasses import dataclass\n@dataclass\nclass P: x: float\na = P(1.5).x",
        "open('data.txt', 'w').write('1.5')\na = float(open('data.txt').read())",
        "import numpy as np\nnp.savetxt('d.csv', [1.5]); a = float(np.loadtxt('d.csv'))",
        "import shutil\nopen('x', 'w').write('1.5'); shutil.copy('x', 'y'); a = float(open('y').read())",
        "from concurrent.futures import ThreadPoolExecutor\nwith ThreadPoolExecutor(3) as p: a = max(p.map(float, [0.5, 1.5]))",
        "import pickle, __main__\nclass P: pass\np = P(); p.x = 1.5; a = pickle.loads(pickle.dumps(p)).x",
        "import tempfile, csv, decimal, statistics\nwith tempfile.TemporaryFile() as f: f.write(b'x')\na = 1.5",
    ],
)
def test_what_works_in_a_notebook_works_here(run, source: str) -> None:
    taken = run(source)
    assert taken.cells[0].status == "ok", taken.cells[0]
    assert taken.values["a"] == Real(1.5)


def test_results_of_earlier_cells_and_underscores_work(run) -> None:
    assert run("3.5", "a = _\nb = Out[1] + _1").values == {"a": Real(3.5), "b": Real(7.0)}


def test_displays_can_be_updated_and_cleared(run) -> None:
    taken = run(
        "h = display('one', display_id=True)\nh.update('two')",
        "print('gone')\nfrom IPython.display import clear_output\nclear_output()",
    )
    assert taken.cells[0].outputs[0]["data"]["text/plain"] == "'two'"
    assert taken.cells[1].outputs == ()


def test_functions_are_called_on_numbers_from_outside(run) -> None:
    source = (
        "def collide(m1, m2, v1, v2=0.0):\n    print('called')\n    return [m1 * v1, (m2, v2)]\nnot_one = 3"
    )
    calls = (
        FunctionCall("p/0", "collide", (("m1", 2.0), ("m2", 3), ("v1", 1.5))),
        FunctionCall("p/1", "collide", (("m1", 2.0),)),
        FunctionCall("p/2", "not_one", ()),
        FunctionCall("p/3", "missing", ()),
        FunctionCall("p/4", "collide", (("m1", 1.0), ("m2", (1.0, 2.0)), ("v1", 2.0))),
    )
    calls = run(source, calls=calls).calls
    assert calls["p/0"].value == Items((Real(3.0), Items((Exact(Fraction(3)), Real(0.0)), (2,))), (2,))
    assert calls["p/0"].output == "called\n"
    assert "missing 2 required" in calls["p/1"].trouble
    assert calls["p/2"].trouble == "not_one is not a function"
    assert calls["p/3"].trouble == "there is no function called missing"
    assert calls["p/4"].trouble == ""


def test_what_went_wrong_is_said_in_the_students_language(run) -> None:
    calls = (FunctionCall("f", "f", ()), FunctionCall("g", "g", ()), FunctionCall("x", "x", ()))
    with language("de"):
        failed = run("def f(): return 1 / 0\nx = 3", calls=calls)
        died = run("x = 1", "import os; os._exit(0)")
    assert {key: call.trouble for key, call in failed.calls.items()} == {
        "f": "die Funktion endete mit einem Fehler (division by zero)",
        "g": "es gibt keine Funktion namens g",
        "x": "x ist keine Funktion",
    }
    assert died.trouble == (
        "Der Prozess des Notebooks hat sich in Codezelle 2 selbst beendet, wie es os._exit tut. "
        "Der Rest wurde ohne diese Zelle noch einmal ausgeführt."
    )
    assert died.cells[1].error == "der Prozess des Notebooks endete in dieser Zelle"


def test_arguments_do_not_show_in_the_notebook(run) -> None:
    source = "def f(x): return x\nimport gc"
    taken = run(source, calls=(FunctionCall("secret-key", "f", (("x", 1.25),)),))
    assert taken.calls["secret-key"].value == Real(1.25)
    peek = "def f(x):\n    import sys\n    return str([sys._getframe(n).f_locals for n in range(4)])"
    looked = run(peek, calls=(FunctionCall("another-secret", "f", (("x", 1.25),)),)).calls["another-secret"]
    assert "another-secret" not in str(looked.value)


def test_a_figure_comes_back_as_what_was_drawn(run) -> None:
    source = (
        "import numpy as np, matplotlib.pyplot as plt\nt = np.linspace(0, 1, 5)\nplt.plot(t, t**2, label='height')\n"
        "plt.scatter([1, 2], [3, 4], label='seen')\nplt.plot([0, 1], [1, 1], 'o')\nplt.axhline(0.5)\n"
        "plt.xlabel('t [s]'); plt.ylabel('$y$ [m]'); plt.title('fall'); plt.legend(); plt.xlim(0, 2); plt.yscale('symlog')"
    )
    (figure,) = run(source, pictures=True).figures
    (axes,) = figure.axes
    assert figure.cell == "c0"
    assert (axes.title, axes.xlabel, axes.ylabel, axes.xlim, axes.yscale) == (
        "fall",
        "t [s]",
        "$y$ [m]",
        (0.0, 2.0),
        "symlog",
    )
    assert axes.legend == ("height", "seen")
    assert [(line.kind, line.label) for line in axes.lines] == [
        ("line", "height"),
        ("points", ""),
        ("line", ""),
        ("points", "seen"),
    ]
    assert axes.lines[0].y == (0.0, 0.0625, 0.25, 0.5625, 1.0)
    assert axes.lines[2].x == (0.0, 2.0)
    assert axes.lines[3].x == (1.0, 2.0)
    assert figure.png is not None
    assert figure.png.startswith(b"\x89PNG")


def test_bars_and_several_axes_come_back(run) -> None:
    source = "from matplotlib.pyplot import *\n_, (p, q) = subplots(1, 2)\np.bar([1, 2], [3, 4], label='n')\nq.set_title('right')"
    (figure,) = run(source).figures
    (bars,) = figure.axes[0].lines
    assert (bars.kind, bars.label, bars.y) == ("bars", "n", (3.0, 4.0))
    assert bars.x == pytest.approx((1.0, 2.0), abs=1e-12)
    assert figure.axes[1].title == "right"
    assert figure.png is None


def test_figures_belong_to_the_cell_that_shows_them_and_are_output_too(run) -> None:
    taken = run(
        "import matplotlib.pyplot as plt",
        "plt.plot([1, 2])\nplt.show()\nplt.plot([3])",
        "fig = plt.figure()\nfig",
        pictures=True,
    )
    assert [figure.cell for figure in taken.figures[:2]] == ["c1", "c1"]
    assert sum("image/png" in each.get("data", {}) for each in taken.cells[1].outputs) == 2
    assert any(figure.cell == "c2" for figure in taken.figures)


def test_notebooks_do_not_see_one_another(run) -> None:
    run(
        "import builtins, os\nbuiltins.leak = 1\nleftover = 2\nopen('left', 'w').write('x')\nimport numpy as np\nnp.leak = 3"
    )
    taken = run(
        "import builtins, os, numpy\na = str([x in globals() for x in ('leftover',)]) + str(os.listdir('.')) + "
        "str('leak' in dir(builtins)) + str('leak' in dir(numpy))"
    )
    assert taken.values["a"] == Text("[False][]FalseFalse")


def test_random_numbers_differ_from_notebook_to_notebook(run) -> None:
    source = "import random, numpy\na = random.random(); b = float(numpy.random.rand())"
    first, second = run(source).values, run(source).values
    assert first["a"] != second["a"]
    assert first["b"] != second["b"]


def test_two_runners_work_side_by_side(runner) -> None:
    answers: dict[str, object] = {}

    def work(name: str, running: Runner) -> None:
        for _ in range(5):
            answers[name] = running.execute(Job((Cell("c", f"a = {name!r}"),), ("a",))).values["a"]

    with Runner() as other:
        threads = [threading.Thread(target=work, args=pair) for pair in (("one", runner), ("two", other))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    assert answers == {"one": Text("one"), "two": Text("two")}


@pytest.mark.whole
@pytest.mark.parametrize("delay", [0.0, 0.1, 0.4])
def test_a_killed_zygote_costs_no_answer(delay: float) -> None:
    """Whether it dies before, in or after a cell: the job is run again, and its result is that of an undisturbed run."""
    slow = "import time\nfor _ in range(40): time.sleep(0.02)\nb = 2.5"
    with Runner() as running:
        zygote = running._zygote
        assert zygote is not None
        killer = threading.Timer(delay, os.kill, (zygote.pid, signal.SIGKILL))
        killer.start()
        result = running.execute(Job((Cell("c", "a = 1.5"), Cell("d", slow)), ("a", "b")))
        killer.join()
        assert (result.trouble, result.machine_failed) == ("", False)
        assert result.values == {"a": Real(1.5), "b": Real(2.5)}
        assert running.execute(Job((Cell("c", "a = 3.5"),), ("a",))).values["a"] == Real(3.5)
        assert not zygote.running


def test_nothing_is_left_behind(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with Runner() as running:
        assert running._zygote is not None
        zygote = running._zygote
        running.execute(Job((Cell("c", "open('x', 'w').write('y')"),), ()))
        assert list(tmp_path.iterdir())
    assert list(tmp_path.iterdir()) == []
    assert not zygote.running
    with pytest.raises(ProcessLookupError):
        os.kill(zygote.pid, 0)


def test_isolation_is_named_and_can_be_required(runner) -> None:
    assert runner.isolation.line.endswith("rlimits")
    with pytest.raises(WeakIsolation, match=r"level 4 is required, but here only level"):
        Runner(require=4).__enter__()


def test_without_namespaces_the_folder_is_still_bounded_and_removed() -> None:
    flood = "import os, time\nos.mkdir('no', 0)\nfor i in range(40): open(f'f{i}', 'wb').write(b'x' * 10**6)\ntime.sleep(9)"
    beside = "import os\na = len(os.listdir('.'))\ntry: open('../beside', 'w').close()\nexcept OSError: pass"
    with Runner(without=frozenset({"namespaces"})) as running:
        full = running.execute(Job((Cell("c", "a = 1.5"), Cell("d", flood)), ("a",)))
        assert "filled the disk" in full.trouble
        assert full.values["a"] == Real(1.5)
        assert any("watched" in each for each in running.isolation.missing)
        for _ in range(2):
            assert running.execute(Job((Cell("c", beside),), ("a",))).values["a"] == Exact(Fraction(0))


def again(run_on: Runner, *sources: str) -> ExecutionResult:
    cells = tuple(Cell(f"c{index}", source, again=True) for index, source in enumerate(sources))
    return run_on.execute(Job(cells, ("a", "b"), pictures=False))


@pytest.mark.parametrize(
    ("sources", "value"),
    [
        (("a = m*2", "m = 4"), 8),
        (("a = k + 1", "k = m*2", "m = 1"), 3),
        (("b = 1; a = m", "m = 2", "b = 7"), 2),
    ],
)
def test_a_cell_above_its_names_is_run_once_more(
    runner: Runner, sources: tuple[str, ...], value: int
) -> None:
    found = again(runner, *sources)
    assert {name: each for values in found.again.values() for name, each in values.items()}["a"] == Exact(
        Fraction(value)
    )
    assert isinstance(found.values["a"], Nothing)
    assert [cell.status for cell in found.cells] == ["ok"] * len(sources)


def test_no_cell_runs_twice_but_one_that_stopped_at_a_name(runner: Runner) -> None:
    found = again(runner, "n = 0", "n += 1; b = n", "1/0", "n += 10; a = n + later", "later = 5", "b = n")
    assert found.values["b"] == Exact(Fraction(11))  # each once; the second run of the fourth comes after all
    assert list(found.again) == [3]
