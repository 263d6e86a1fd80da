"""The shell the cells run in: IPython as in a notebook, without a keyboard, its outputs collected."""

import builtins
import linecache
import re
import traceback
import warnings
from typing import Any

import matplotlib
from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import DisplayPublisher
from IPython.core.error import StdinNotImplementedError
from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.text import LSString, SList
from matplotlib.figure import Figure
from matplotlib_inline.config import InlineBackend
from traitlets import Type
from traitlets.config import Config

from . import figures
from .outputs import Outputs, OutputStream

_CELL = re.compile(r'File "<ipython-input-(\d+)-[0-9a-f]+>"')
_NO_KEYBOARD = "input() has no answer here, for nobody sits at the keyboard: write the value into the cell"
_NO_COMMANDS = "Commands of the operating system are not run here.\n"


class ResultHook(DisplayHook):
    """The value of a cell's last expression."""

    outputs: Outputs

    def write_output_prompt(self):
        return None

    def write_format_data(self, format_dict, md_dict=None):
        self.outputs.display(format_dict, count=self.prompt_count)

    def finish_displayhook(self):
        self._is_active = False

    def log_output(self, format_dict):
        return None


class OutputPublisher(DisplayPublisher):
    """What `display(…)` shows."""

    outputs: Outputs

    def publish(self, data, metadata=None, *_, transient=None, update=False, **__):
        self.outputs.display(data, place=(transient or {}).get("display_id"), update=update)

    def clear_output(self, wait=False):
        self.outputs.clear()


class Shell(InteractiveShell):
    """IPython's shell without files, history, colours, keyboard and processes."""

    displayhook_class = Type(ResultHook)
    display_pub_class = Type(OutputPublisher)
    outputs: Outputs

    def init_virtualenv(self):
        return None

    def enable_gui(self, gui=None):
        return None

    def enable_matplotlib(self, gui=None):
        return "inline", "inline"

    def ask_exit(self):
        """`exit()` ends nothing: the cells below it still count."""

    def _format_exception_for_storage(self, *_, **__):
        """IPython formats each error once more for its history; that takes seconds after a deep recursion."""
        return {}

    def system(self, cmd):
        self.outputs.stream("stderr", _NO_COMMANDS)

    def getoutput(self, cmd, split=True, depth=0):
        self.outputs.stream("stderr", _NO_COMMANDS)
        return SList([]) if split else LSString("")

    def showtraceback(
        self, exc_tuple=None, filename=None, tb_offset=None, exception_only=False, running_compiled_code=False
    ):
        kind, error, trace = self._get_exc_info(exc_tuple)
        while trace is not None and "IPython" in trace.tb_frame.f_code.co_filename:
            trace = trace.tb_next
        alone = exception_only or issubclass(kind, SyntaxError)
        lines = (
            traceback.format_exception_only(kind, error)
            if alone
            else traceback.format_exception(kind, error, trace, limit=-10)
        )
        self._show_error(kind, error, lines)

    def showsyntaxerror(self, filename=None, running_compiled_code=False):
        self.showtraceback(exception_only=True)

    def show_usage_error(self, exc):
        self._show_error(type(exc), exc, [f"UsageError: {exc}"])

    def _show_error(self, kind, error, lines):
        self.outputs.error(
            kind.__name__, words(error), _CELL.sub(r"Cell In[\1]", "".join(lines)).splitlines()
        )


def words(error):
    """What an error says; asking it may itself raise."""
    try:
        return str(error)
    except Exception:
        return "(an error that cannot be written down)"


def new_shell(outputs):
    """The one shell of this process, with its streams; made while warming up, used by every child after the fork."""
    config = Config()
    config.HistoryManager.enabled = False
    config.HistoryManager.hist_file = ":memory:"
    config.InteractiveShell.colors = "nocolor"
    config.InteractiveShell.cache_size = 1000
    Shell.outputs = ResultHook.outputs = OutputPublisher.outputs = outputs
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        shell = Shell.instance(config=config)
    configurables: list = shell.configurables
    configurables.append(InlineBackend.instance(parent=shell))
    formatter: Any = shell.display_formatter
    formatter.formatters["image/png"].for_type(Figure, _show_figure)
    matplotlib.use("module://sandbox.figures")
    # One backend serves here whatever a script written for a window asks for.
    matplotlib.use = lambda backend, *, force=True: None
    builtins.input = refuse_input
    return shell


def _show_figure(figure):
    """A figure that is displayed by name; gives its PNG, if one is wanted, for the bundle IPython puts together."""
    return [add(figure, display=False) for add in figures.on_show][-1] if figures.on_show else None


def refuse_input(prompt=""):
    raise StdinNotImplementedError(_NO_KEYBOARD)


def streams(outputs):
    return OutputStream("stdout", outputs), OutputStream("stderr", outputs)


def reset(shell):
    """As if nothing had been run."""
    shell.reset(new_session=True)
    shell.execution_count = 1
    linecache.clearcache()
