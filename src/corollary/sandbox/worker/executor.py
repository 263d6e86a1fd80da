"""One notebook from first cell to last: run each, collect its outputs, send the answers it changed; then call its functions."""

import getpass
import os
import signal
import sys
import time

from . import figures
from . import shell as shells
from .encode import encode
from .outputs import clean
from .protocol import pack, send

MOST_FIGURES = 20  # of one cell
MOST_PICTURES = 40  # of one notebook: each figure is kept until it is drawn
_MOST_CALL_OUTPUT = 10_000
_NEARLY = 0.95  # the two clocks, the grader's and this one, do not start at the same moment
_now = time.monotonic
_library_folders = set()  # looked into before any notebook ran: no notebook can write there
_set_handler = signal.signal


class Clock:
    """The time one cell has: the grader's SIGINT becomes KeyboardInterrupt, but only in a cell that has used up its time.

    A signal that arrives a moment late must not hit the next cell; so the elapsed time is looked at too.
    """

    def __init__(self):
        self.limit = 0.0
        self.began = None
        self.rang = False

    def start(self, limit):
        self.limit, self.rang = limit, False
        _set_handler(signal.SIGINT, self._ring)
        self.began = _now()

    def stop(self):
        self.began = None

    def _ring(self, number, frame):
        if self.began is not None and _now() - self.began > _NEARLY * self.limit:
            self.rang = True
            raise KeyboardInterrupt


class Session:
    """One notebook at work: the shell, the clock, and which answers have been sent already."""

    def __init__(self, shell, outputs, job):
        self.shell, self.outputs, self.job = shell, outputs, job
        self.run_cell = shell.run_cell  # the student may replace the shell's own
        self.streams = shells.streams(outputs)
        self.clock = Clock()
        self.sent = {}
        self.figures = []
        self.to_draw = []  # each figure, and its description from when it was shown
        self.printed = 0
        self.no_name = ""  # the name that the last cell or call stopped at, for nothing has made it
        figures.on_show.append(lambda figure, display=True: _add_figure(self, figure, display))


def execute(shell, outputs, job):
    """Runs the job and sends what comes of it, frame by frame; every frame sent is safe from what happens later."""
    session = Session(shell, outputs, job)
    outputs.most_bytes = job["limits"]["output_bytes"]
    getpass.getpass = shells.refuse_input
    stopped, calls = {}, []
    for index, source in enumerate(job["cells"]):
        send({"t": "began", "what": "cell", "index": index})
        send(*_run_cell(session, index, source))
        if session.no_name and job["again"][index]:
            stopped[index] = session.no_name
    for index, call in enumerate(job["calls"]):
        send({"t": "began", "what": "call", "index": index})
        frames = _call(session, index, call)
        send(*frames)
        if session.no_name or frames[0]["trouble"] == "missing":
            calls.append((index, call))
    if _run_again(session, stopped):
        for index, call in calls:
            send({"t": "began", "what": "call", "index": index})
            send(*({**frame, "again": True} for frame in _call(session, index, call)))
    send({"t": "done", "pictures": len(session.to_draw)})
    for index, (figure, description) in enumerate(session.to_draw):
        send({"t": "began", "what": "picture", "index": index})
        send(*_draw(session, index, figure, description))


def _run_again(session, stopped):
    """Each cell that stopped at a name which another has made by now, once, in their order; whether there was any."""
    space, ran = session.shell.user_ns, False
    while (index := next((each for each, name in stopped.items() if name in space), None)) is not None:
        del stopped[index]
        send({"t": "began", "what": "again", "index": index})
        send(*({**frame, "again": True} for frame in _run_cell(session, index, session.job["cells"][index])))
        ran = True
    return ran


def warm_up(shell, outputs, sources):
    """Runs cells that are nobody's, and keeps nothing of them."""
    session = Session(
        shell, outputs, {"names": ["a", "b", "c", "d"], "pictures": False, "limits": {"cell_seconds": 1e3}}
    )
    for index, source in enumerate(sources):
        pack(_run_cell(session, index, source)[0])
    figures.on_show.clear()
    _library_folders.update(sys.path_importer_cache)


def _run_cell(session, index, source):
    session.outputs.start()
    session.figures, session.no_name = [], ""
    _forget_folders()
    error = ""
    values = {}
    _restore_streams(session)
    session.clock.start(session.job["limits"]["cell_seconds"])
    try:
        result = session.run_cell(source, store_history=True)
        failed = result.error_before_exec or result.error_in_exec
        if failed is not None:
            error = _one_line(failed)
            session.no_name = _name_missed(failed)
        figures.show_all()
        _read_printed(session)
        values = _changed(session)
        session.clock.stop()
    except KeyboardInterrupt:
        error = "KeyboardInterrupt"
    except BaseException as failure:
        # The cell has broken IPython itself; the cell has failed, the notebook goes on.
        error = _one_line(failure)
    session.clock.stop()
    status = "timeout" if session.clock.rang else "error" if error else "ok"
    frame = {
        "t": "cell",
        "index": index,
        "status": status,
        "error": error,
        "outputs": session.outputs.as_list(),
        "figures": session.figures,
        "values": values,
    }
    without_outputs = {**frame, "outputs": []}
    bare = {**without_outputs, "figures": [], "error": "the cell's error cannot be shown", "values": {}}
    return frame, without_outputs, {**without_outputs, "figures": []}, bare


def _forget_folders():
    """A module that the cell before wrote can then be imported at once. (importlib.invalidate_caches goes through all folders.)"""
    for folder in sys.path_importer_cache.keys() - _library_folders:
        forget = getattr(sys.path_importer_cache[folder], "invalidate_caches", None)
        if forget is not None:
            forget()


def _changed(session):
    """The answers this cell changed; sent now, so that a later crash cannot take them away."""
    values = {}
    for name in session.job["names"]:
        encoded = encode(session.shell.user_ns.get(name))
        if encoded != session.sent.get(name, ("nothing",)):
            values[name] = session.sent[name] = encoded
    return values


def _add_figure(session, figure, display):
    """Describes a figure that is shown; where pictures are wanted, gives the placeholder of its picture until it is drawn."""
    if len(session.figures) >= MOST_FIGURES:
        return None
    axes = figures.describe(figure)
    wanted = session.job["pictures"] and len(session.to_draw) < MOST_PICTURES
    place = len(session.to_draw) if wanted else None
    session.figures.append({"axes": axes, "picture": place})
    width, height = (int(inches * 100) for inches in figure.get_size_inches())
    bundle = {"text/plain": f"<Figure size {width}x{height} with {len(figure.axes)} Axes>"}
    if wanted:
        session.to_draw.append((figure, axes))
        bundle["image/png"] = f"figure {place}"
    if display:
        session.outputs.display(bundle)
    return bundle.get("image/png")


def _draw(session, index, figure, description):
    """The picture, drawn after all answers are sent, so that no picture can cost an answer; of the figure as it is by now."""
    picture, changed = None, False
    session.clock.start(session.job["limits"]["cell_seconds"])
    try:
        picture, changed = figures.draw(figure), figures.describe(figure) != description
        session.clock.stop()
    except BaseException:
        # Its time was up, or the student's own class of figure raised: there is no picture then.
        picture = None
    session.clock.stop()
    frame = {"t": "picture", "index": index, "png": picture, "changed": changed}
    return frame, {**frame, "png": None}


def _call(session, index, call):
    name, arguments, seconds = call
    session.outputs.start()
    session.no_name = ""
    function = session.shell.user_ns.get(name)
    if function is None:
        return _result(session, index, ("nothing",), "missing")
    _restore_streams(session)
    value, trouble, raised = ("nothing",), "", ""
    session.clock.start(seconds)
    try:
        if callable(function):
            value = encode(
                function(**{key: tuple(each) if type(each) is list else each for key, each in arguments})
            )
        else:
            trouble = "no function"
        session.clock.stop()
    except BaseException as error:
        trouble, raised = "raised", _one_line(error)
        session.no_name = _name_missed(error)
    session.clock.stop()
    if session.clock.rang:
        value, trouble = ("nothing",), "late"
    figures.Gcf.destroy_all()
    return _result(session, index, value, trouble, raised)


def _result(session, index, value, trouble, raised=""):
    text = "".join(each["text"] for each in session.outputs.as_list() if each["output_type"] == "stream")
    frame = {
        "t": "call",
        "index": index,
        "value": value,
        "output": text[:_MOST_CALL_OUTPUT],
        "trouble": trouble,
        "error": raised,
    }
    return frame, {**frame, "value": ("refused", "size", "", "")}


def _name_missed(error):
    """The name of a plain NameError; empty for every other error, a class of the student's own among them."""
    name = error.name if type(error) is NameError else ""
    return name if type(name) is str else ""


def _one_line(error):
    return clean(f"{type(error).__name__}: {shells.words(error)}".partition("\n")[0][:500])


def _restore_streams(session):
    sys.stdout, sys.stderr = session.streams


def _read_printed(session):
    """What C code printed past Python's streams."""
    try:
        text = os.pread(1, session.outputs.most_bytes, session.printed)
    except OSError:
        return
    session.printed += len(text)
    if text:
        session.outputs.stream("stdout", text.decode("utf-8", "replace"))
