"""Figures as data: a matplotlib backend without a window, and the labels, limits, legend and lines of what is shown."""

import io
import math

import numpy
from matplotlib._pylab_helpers import Gcf
from matplotlib.backend_bases import FigureManagerBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from PIL.Image import Quantize
from PIL.PngImagePlugin import PngImageFile

from .outputs import clean

MOST_POINTS = 5_000
MOST_LINES = 60
MOST_AXES = 20
MOST_PIXELS = 2_000_000
MOST_COLOURS = 256
_DPI = 72  # Jupyter's own
on_show = []  # the function that describes a figure, once a notebook runs


class FigureManager(FigureManagerBase):
    @classmethod
    def pyplot_show(cls, *, block=None):
        show_all()


class FigureCanvas(FigureCanvasAgg):
    manager_class = FigureManager  # pyright: ignore[reportAssignmentType]


def show_all():
    """Describes every open figure and closes it, as a notebook shows them at `plt.show()` and at the end of each cell."""
    for manager in Gcf.get_all_fig_managers():
        for describe_open in on_show:
            describe_open(manager.canvas.figure)
    Gcf.destroy_all()


def describe(figure):
    """The axes of a figure as plain data; what cannot be read of it is left out, whatever the student did to it."""
    return [_attempt(_axes, each, figure) for each in list(figure.axes)[:MOST_AXES]]


def draw(figure):
    """The figure as PNG; None when it cannot be drawn."""
    return _attempt(_png, figure)


def _attempt(read, *arguments):
    try:
        return read(*arguments)
    except Exception:
        return None


def _axes(axes, figure):
    title = axes.get_title() or axes.get_title("left") or axes.get_title("right")
    if not title and len(figure.axes) == 1:
        title = figure.get_suptitle()
    legend = axes.get_legend()
    return {
        "title": _short(title),
        "xlabel": _short(_label(axes, figure, "x")),
        "ylabel": _short(_label(axes, figure, "y")),
        "xlim": [float(edge) for edge in axes.get_xlim()],
        "ylim": [float(edge) for edge in axes.get_ylim()],
        "xscale": _short(axes.get_xscale()),
        "yscale": _short(axes.get_yscale()),
        "legend": [_short(text.get_text()) for text in legend.get_texts()[:MOST_LINES]] if legend else [],
        "lines": [line for line in _lines(axes) if line][:MOST_LINES],
    }


def _label(axes, figure, way):
    """The label of an axis; of a shared one (`sharex`, `twinx`) that of the axes it is shared with; else the figure's own."""
    sharing = getattr(axes, f"get_shared_{way}_axes")().get_siblings(axes)
    labels = [getattr(each, f"get_{way}label")() for each in (axes, *sharing)]
    return next(filter(None, labels), "") or getattr(figure, f"get_sup{way}label")()


def _lines(axes):
    for line in axes.lines[:MOST_LINES]:
        if line.get_visible():
            yield _attempt(_curve, line, axes)
    for cloud in axes.collections[:MOST_LINES]:
        if type(cloud).__name__ == "PathCollection" and cloud.get_visible():
            yield _attempt(_cloud, cloud)
        elif type(cloud).__name__ == "LineCollection" and cloud.get_visible():
            for segment in cloud.get_segments()[:MOST_LINES]:
                yield _attempt(_segment, segment, cloud)
    for bars in axes.containers[:MOST_LINES]:
        if type(bars).__name__ == "BarContainer":
            yield _attempt(_bars, bars)


def _curve(line, axes):
    x, y = line.get_data(orig=False)
    x, y = _numbers(x), _numbers(y)
    # A line as of axhline counts one direction in fractions of the axes; given here in the data's own numbers.
    x_is_data, y_is_data = line.get_transform().contains_branch_seperately(axes.transData)
    x = x if x_is_data else [_along(axes.get_xlim(), each) for each in x]
    y = y if y_is_data else [_along(axes.get_ylim(), each) for each in y]
    drawn = str(line.get_linestyle()) not in ("None", "none", "", " ")
    return _as_line(x, y, line.get_label(), "line" if drawn else "points")


def _segment(places, lines):
    """One line of `hlines`, `vlines` and their like."""
    return _as_line(_numbers(places[:, 0]), _numbers(places[:, 1]), lines.get_label(), "line")


def _cloud(cloud):
    places = cloud.get_offsets()
    return _as_line(_numbers(places[:, 0]), _numbers(places[:, 1]), cloud.get_label(), "points")


def _bars(bars):
    upright = bars.orientation != "horizontal"
    x = [
        bar.get_x() + bar.get_width() / 2 if upright else bar.get_y() + bar.get_height() / 2
        for bar in bars.patches
    ]
    y = [bar.get_height() if upright else bar.get_width() for bar in bars.patches]
    return _as_line(_numbers(x), _numbers(y), bars.get_label(), "bars")


def _along(limits, fraction):
    return limits[0] + fraction * (limits[1] - limits[0])


def _numbers(values):
    every = -(-len(values) // MOST_POINTS) or 1  # of very many points, every second, third, … one
    # A masked entry is a gap in the line.
    return numpy.ma.filled(numpy.ma.asarray(values[::every], dtype=float), math.nan).tolist()


def _as_line(x, y, label, kind):
    count = min(len(x), len(y))
    x, y = [float(each) for each in x[:count]], [float(each) for each in y[:count]]
    return {"x": x, "y": y, "label": "" if str(label).startswith("_") else _short(label), "kind": kind}


def _short(text):
    return clean(str(text))[:500]


def _png(figure):
    width, height = figure.get_size_inches()
    dpi = min(_DPI, math.sqrt(MOST_PIXELS / max(width * height, 1e-9)))
    if dpi < 5:
        return None
    return _attempt(_with_palette, figure, dpi) or _encoded(figure, dpi)


def _with_palette(figure, dpi):
    """With 256 colours at most: a third of the bytes, which are stored three times, and of the time that deflating takes."""
    sink = io.BytesIO()
    with PngImageFile(io.BytesIO(_encoded(figure, dpi, compress_level=0))) as picture:
        opaque = picture.mode == "RGBA" and picture.getchannel("A").getextrema() == (255, 255)
        whole = (
            picture.convert("RGB") if opaque else picture
        )  # of clear pixels other colours would be coarser
        whole.quantize(MOST_COLOURS, Quantize.FASTOCTREE).save(sink, "PNG")
    return sink.getvalue()


def _encoded(figure, dpi, **options):
    sink = io.BytesIO()
    figure.savefig(sink, format="png", dpi=dpi, pil_kwargs=options)
    return sink.getvalue()
