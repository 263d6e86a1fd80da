"""What stands in an answer cell before the student writes: a name, an empty value, and how to fill it in."""

from __future__ import annotations

from corollary.notebook.worksheet import Prompt
from corollary.problem.part import Part
from corollary.units.unit import show

WRITTEN_ANSWER = "*Your answer here.*"


def blank(prompt: Prompt) -> str:
    """The source of the answer cell of any part that is answered in code."""
    part, name = prompt.part, prompt.name
    letters = [option.letter for option in part.options]
    match part.kind:
        case "value" | "vector" | "example" if part.components:
            row = ", ".join("None" for _ in part.components)
            return f"{name} = [{row}]   # [{', '.join(part.components)}]{_in(part)}: {_numbers(part)}"
        case "value" | "vector" | "example":
            return f"{name} = None   # {_numbers(part)}{_or_unit(part)}"
        case "expression" if part.components:
            row = ", ".join("None" for _ in part.components)
            return (
                f'{name} = [{row}]   # [{", ".join(part.components)}], each a formula as text: "2*a/(b + c)"'
            )
        case "expression":
            return f'{name} = None   # a formula as text, in quotes: "2*a/(b + c)"'
        case "choice":
            return f'{name} = None   # one letter, "{letters[0]}" to "{letters[-1]}"'
        case "proof":
            return f'{name} = [\n    "",   # one equation a line, each as text: "a + b = c"\n]'
        case "code":
            return _function(part)
        case "plot":
            return plot_blank(part)
        case _:
            return WRITTEN_ANSWER


def plot_blank(part: Part) -> str:
    """The source of a cell that is to draw."""
    return (
        "import matplotlib.pyplot as plt\n\n"
        '# Draw here. Name both axes, each with its unit: plt.xlabel("t [s]"), and label the curves when there are several.\n\n'
        "plt.show()"
    )


def _function(part: Part) -> str:
    returns = f"\n\n    Answers in {show(part.unit)}." if show(part.unit) else ""
    close = "\n    " if returns else ""
    return f'def {part.signature}:\n    """{part.title}.{returns}{close}"""\n    ...'


def _in(part: Part) -> str:
    return f" in {show(part.unit)}" if show(part.unit) else ""


def _numbers(part: Part) -> str:
    if not part.components:
        return "a number" + _in(part) + " (3.2)" if show(part.unit) else "a number (3.2)"
    return "numbers, or texts with a unit" if show(part.unit) else "numbers"


def _or_unit(part: Part) -> str:
    return f', or text with a unit ("3,2 {show(part.unit)}")' if show(part.unit) else ""
