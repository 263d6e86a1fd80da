"""A matplotlib backend for a notebook nobody looks at: figures are drawn in memory, and shown by being taken down."""

from matplotlib._pylab_helpers import Gcf
from matplotlib.backend_bases import FigureManagerBase
from matplotlib.backends.backend_agg import FigureCanvasAgg

shown = []  # the one function that takes figures down, once a notebook runs


class FigureManager(FigureManagerBase):
    @classmethod
    def pyplot_show(cls, *, block=None):
        show_all()


class FigureCanvas(FigureCanvasAgg):
    manager_class = FigureManager  # pyright: ignore[reportAssignmentType]


def show_all():
    """Takes down every open figure and closes it, as a notebook does at `plt.show()` and at the end of each cell."""
    for manager in Gcf.get_all_fig_managers():
        for take in shown:
            take(manager.canvas.figure)
    Gcf.destroy_all()
