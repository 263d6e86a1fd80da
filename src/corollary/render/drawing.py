"""The drawing of an exercise, in a page or as an address in Markdown."""

from __future__ import annotations

import base64

from markupsafe import Markup

from corollary.figure.svg import safe_svg
from corollary.notebook.worksheet import Exercise


def drawing(exercise: Exercise) -> Markup:
    """The exercise's figure as inline SVG that runs and fetches nothing, or nothing when it has none. Raises NotADrawing."""
    if not exercise.figure:
        return Markup()
    return Markup(safe_svg(exercise.figure, prefix=exercise.problem.prefix + "-", label=exercise.figure_alt))


def drawing_address(exercise: Exercise) -> str:
    """The exercise's figure as a data URI."""
    svg = str(drawing(exercise)).replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"', 1)
    return "data:image/svg+xml;base64," + base64.b64encode(svg.encode()).decode()
