"""The cell that defines `check`: what is asked, and the very code that reads answers when they are marked, as plain text."""

from __future__ import annotations

from corollary.answers.direction import DIRECTED
from corollary.notebook.as_read import Shape
from corollary.notebook.packing import readers
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.part import Part

NUMBERS, FORMULAS = ("sandbox/worker/encode", "notebook/as_read"), ("notebook/as_formula",)

OPENING = """\
# Run this cell first: it defines check("..."), which tells you how an answer of yours is read (number, unit, figures).
# There is nothing to change here, and no answer is hidden in it: below stands only the code that reads what you write.

def corollary():
    import os, sys
    from types import ModuleType

    if sys.version_info < (3, 11):
        return lambda *names: print("check needs Python 3.11 or newer; what you write counts all the same")

    readers = sys.modules["corollary_check"] = ModuleType("corollary_check")

    def reader(name, source):
        module = sys.modules["corollary_check." + name] = ModuleType("corollary_check." + name)
        exec(compile(source, "<corollary_check." + name + ">", "exec"), module.__dict__)
        setattr(readers, name, module)
"""

CLOSING = '''\
    def asked(shape, unit=None, components=(), words=(), letters=(), directed=False, function=""):
        to_unit = readers.unit.unit
        spelled = tuple((letter, to_unit(its_unit)) for letter, its_unit in letters)
        return readers.as_read.Asked(shape, unit and to_unit(unit), components, words, spelled, directed), function

    ASKED = {
__ASKED__
    }

    def heard(name):
        what, function = ASKED[name]
        if what.shape == "function":
            return readers.as_read.heard_function(what, globals().get(function))
        if what.shape == "figure":
            return readers.as_read.Heard(True, "the figure drawn above is what will be marked")
        sent = readers.encode.encode(globals().get(name))
        return readers.__WHERE__(what, sent)

    def check(*names):
        """Says how the answers with these names are read; all answers when no name is given."""
        for name in names or ASKED:
            if name not in ASKED:
                print(name + ": there is no answer of this name; the names are " + ", ".join(ASKED))
                continue
            said = heard(name)
            print(name + ": " + said.text)
            if os.environ.get("NBGRADER_EXECUTION") == "autograde":
                raise RuntimeError("this notebook cannot mark itself; it is marked by `corollary grade`")
            if os.environ.get("NBGRADER_EXECUTION") == "validate" and not said.ok:
                raise ValueError(name + ": " + said.text)

    return check

check = corollary()'''


def check_source(sheet: Worksheet) -> str:
    """The source of the cell for one sheet: it holds what is asked, and nothing of what is right."""
    asked = [prompt for prompt in sheet.prompts if prompt.part.kind != "explain"]
    formulas = any(
        prompt.part.kind == "expression" for prompt in asked
    )  # else half the cell would be there for few
    sources = (
        f"    reader({name!r}, r'''{source}''')\n"
        for name, source in readers(*NUMBERS, *FORMULAS if formulas else ())
    )
    closing = CLOSING.replace("__WHERE__", "as_formula.heard_either" if formulas else "as_read.heard")
    return "\n".join([OPENING, *sources, closing.replace("__ASKED__", "\n".join(map(_asked, asked)))])


def _asked(prompt: Prompt) -> str:
    part, shape = prompt.part, shape_of(prompt.part)
    settings = [repr(shape)]
    if shape in ("number", "formula") and not (part.kind == "example" and part.unit.text == "1"):
        settings.append(f"unit={part.unit.text!r}")
    if part.components:
        settings.append(f"components={part.components!r}")
    if part.kind in ("value", "vector") and (part.components or part.unit.dimension in DIRECTED):
        settings.append("directed=True")
    if part.options:
        settings.append(f"words={tuple(option.letter for option in part.options)!r}")
    if part.function:
        settings.append(f"words={arguments(part)!r}, function={part.function!r}")
    if spelled := letters(prompt):
        settings.append(f"letters={spelled!r}")
    return f"        {prompt.key!r}: asked({', '.join(settings)}),"


def shape_of(part: Part) -> Shape:
    """What kind of thing answers a part: the shape its check listens for."""
    match part.kind:
        case "value" | "vector" | "example":
            return "number"
        case "expression":
            return "formula"
        case "choice":
            return "letter"
        case "code":
            return "function"
        case "plot":
            return "figure"
        case _:
            return "lines"


def letters(prompt: Prompt) -> tuple[tuple[str, str], ...]:
    """What a formula that answers the part may be written in, each letter with its unit; none where a formula will not do."""
    if prompt.part.kind not in ("expression", "value", "vector"):
        return ()
    return tuple((given.symbol, given.unit.text) for given in prompt.problem.givens)


def arguments(part: Part) -> tuple[str, ...]:
    """The names of a code part's arguments."""
    inside = part.signature.partition("(")[2].rpartition(")")[0]
    return tuple(name.strip() for name in inside.split(",") if name.strip())
