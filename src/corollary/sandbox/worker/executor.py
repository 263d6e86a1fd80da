"""One notebook from first cell to last: run, show, snapshot the answers, tell; then the calls of its functions."""

import getpass
import os
import sys

from . import backend
from . import shell as shells
from .clock import Clock
from .encode import encode
from .figures import describe, draw
from .frames import pack, say
from .outputs import clean

MOST_FIGURES = 20  # of one cell
MOST_PICTURES = 40  # of one notebook: each figure is kept until it is drawn
_MOST_CALL_OUTPUT = 10_000


class Desk:
    """Where one notebook is worked on: the shell, the clock, and what of its answers has been told already."""

    def __init__(self, shell, outputs, job):
        self.shell, self.outputs, self.job = shell, outputs, job
        self.run_cell = shell.run_cell
        self.streams = shells.streams(outputs)
        self.clock = Clock()
        self.told = {}
        self.figures = []
        self.to_draw = []  # each figure, and what was told of it when it was shown
        self.printed = 0


def work(shell, outputs, job):
    """Runs the job and says what came of it, frame by frame; every frame sent is safe from what happens later."""
    desk = _desk(shell, outputs, job)
    outputs.most_bytes = job["limits"]["output_bytes"]
    getpass.getpass = shells.refuse_input
    for index, source in enumerate(job["cells"]):
        say({"t": "began", "what": "cell", "index": index})
        say(*_run_cell(desk, index, source))
    for index, ask in enumerate(job["asks"]):
        say({"t": "began", "what": "call", "index": index})
        say(*_call(desk, index, ask))
    say({"t": "done", "pictures": len(desk.to_draw)})
    for index, (figure, told) in enumerate(desk.to_draw):
        say({"t": "began", "what": "picture", "index": index})
        say(*_draw(desk, index, figure, told))


def rehearse(shell, outputs, sources):
    """Runs cells that are nobody's, and keeps nothing of them."""
    desk = _desk(
        shell, outputs, {"names": ["a", "b", "c", "d"], "pictures": False, "limits": {"cell_seconds": 1e3}}
    )
    for index, source in enumerate(sources):
        pack(_run_cell(desk, index, source)[0])
    backend.shown.clear()


def _desk(shell, outputs, job):
    desk = Desk(shell, outputs, job)
    backend.shown.append(lambda figure, show=True: _take_figure(desk, figure, show))
    return desk


def _run_cell(desk, index, source):
    desk.outputs.start()
    desk.figures = []
    error = ""
    values = {}
    _restore_streams(desk)
    desk.clock.start(desk.job["limits"]["cell_seconds"])
    try:
        result = desk.run_cell(source, store_history=True)
        failed = result.error_before_exec or result.error_in_exec
        if failed is not None:
            error = _one_line(failed)
        backend.show_all()
        _read_printed(desk)
        values = _changed(desk)
        desk.clock.stop()
    except KeyboardInterrupt:
        error = "KeyboardInterrupt"
    except (
        BaseException
    ) as trouble:  # IPython itself was bent by the cell; the cell has failed, the notebook goes on
        error = _one_line(trouble)
    desk.clock.stop()
    status = "timeout" if desk.clock.rang else "error" if error else "ok"
    rich = {
        "t": "cell",
        "index": index,
        "status": status,
        "error": error,
        "outputs": desk.outputs.as_list(),
        "figures": desk.figures,
        "values": values,
    }
    poorer = {**rich, "outputs": []}
    poorest = {**poorer, "figures": [], "error": "the cell's error cannot be told", "values": {}}
    return rich, (poorer, {**poorer, "figures": []}, poorest)


def _changed(desk):
    """The answers this cell changed; told now, so that a later crash cannot take them away."""
    values = {}
    for name in desk.job["names"]:
        encoded = encode(desk.shell.user_ns.get(name))
        if encoded != desk.told.get(name, ("nothing",)):
            values[name] = desk.told[name] = encoded
    return values


def _take_figure(desk, figure, show):
    """Reads a figure that is shown; where pictures are wanted, gives the word that stands for its picture until it is drawn."""
    if len(desk.figures) >= MOST_FIGURES:
        return None
    axes = describe(figure)
    wanted = desk.job["pictures"] and len(desk.to_draw) < MOST_PICTURES
    place = len(desk.to_draw) if wanted else None
    desk.figures.append({"axes": axes, "picture": place})
    width, height = (int(inches * 100) for inches in figure.get_size_inches())
    shown = {"text/plain": f"<Figure size {width}x{height} with {len(figure.axes)} Axes>"}
    if wanted:
        desk.to_draw.append((figure, axes))
        shown["image/png"] = f"figure {place}"
    if show:
        desk.outputs.display(shown)
    return shown.get("image/png")


def _draw(desk, index, figure, told):
    """The picture, after all answers are out: whatever drawing comes to, they stand. A figure is drawn as it is by now."""
    picture, changed = None, False
    desk.clock.start(desk.job["limits"]["cell_seconds"])
    try:
        picture, changed = draw(figure), describe(figure) != told
        desk.clock.stop()
    except (
        BaseException
    ):  # its time was up, or the student's own class of figure has ended it: there is no picture then
        picture = None
    desk.clock.stop()
    rich = {"t": "picture", "index": index, "png": picture, "changed": changed}
    return rich, ({**rich, "png": None},)


def _call(desk, index, ask):
    name, arguments, seconds = ask
    desk.outputs.start()
    function = desk.shell.user_ns.get(name)
    if function is None:
        return _answer(desk, index, ("nothing",), f"there is no function called {name}")
    _restore_streams(desk)
    value, trouble = ("nothing",), ""
    desk.clock.start(seconds)
    try:
        if callable(function):
            value = encode(
                function(**{key: tuple(each) if type(each) is list else each for key, each in arguments})
            )
        else:
            trouble = f"{name} is not a function"
        desk.clock.stop()
    except BaseException as error:
        trouble = f"the function raised {_one_line(error)}"
    desk.clock.stop()
    if desk.clock.rang:
        value, trouble = ("nothing",), f"the function ran longer than {seconds:g} s"
    backend.Gcf.destroy_all()
    return _answer(desk, index, value, trouble)


def _answer(desk, index, value, trouble):
    text = "".join(each["text"] for each in desk.outputs.as_list() if each["output_type"] == "stream")
    rich = {
        "t": "call",
        "index": index,
        "value": value,
        "output": text[:_MOST_CALL_OUTPUT],
        "trouble": trouble,
    }
    return rich, ({**rich, "value": ("refused", "is too large to be brought back", "")},)


def _one_line(error):
    return clean(f"{type(error).__name__}: {shells.words(error)}".partition("\n")[0][:500])


def _restore_streams(desk):
    sys.stdout, sys.stderr = desk.streams


def _read_printed(desk):
    """What C code printed past Python's streams."""
    try:
        text = os.pread(1, desk.outputs.most_bytes, desk.printed)
    except OSError:
        return
    desk.printed += len(text)
    if text:
        desk.outputs.stream("stdout", text.decode("utf-8", "replace"))
