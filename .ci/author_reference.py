"""Writes docs/laws.md: every law, function, unit, constant and reserved letter that an author may write, from the code.

`python .ci/author_reference.py` writes it, `--check` says whether it is up to date (a test asks).
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Callable, Iterator
from itertools import groupby
from typing import Any

from reference_page import table, written

import corollary.laws
from corollary.formula.abbreviations import ROWS as ABBREVIATED
from corollary.formula.functions import FUNCTIONS
from corollary.problem.givens import RESERVED
from corollary.units.constants import CONSTANTS
from corollary.units.unit import Unit, show, si_unit
from corollary.units.unit_table import ROWS as UNIT_ROWS
from corollary.units.unit_table import UNITS

EQUATION = re.compile(r"`([^`]*=[^`]*)`")
OPENING = """\
# Laws, functions, units and letters

All that may be written in a solution, a condition, a hole or an answer, made from the code by
`python .ci/author_reference.py`. How they are used is told [for authors](author.md).
"""


def page() -> str:
    """The whole page."""
    return "\n".join([OPENING, *laws(), *functions(), *units(), *constants(), *letters()]) + "\n"


def laws() -> Iterator[str]:
    yield "## Laws\n"
    yield (
        "From `corollary.laws`. Arguments are the problem's letters, in this order or by name; what stands behind `*` by\n"
        'name only. Any other law is `law("Name", "a = b")`.\n'
    )
    own = [
        getattr(corollary.laws, name)
        for name in corollary.laws.__all__
        if name not in {"Law", "law", "wrong"}
    ]
    for topic, members in groupby(
        sorted(own, key=lambda law: (law.__module__, law.__name__)), lambda law: law.__module__
    ):
        yield f"### {topic.rpartition('.')[2].replace('_', ' ').capitalize()}\n"
        yield from table(("law", "equation", "what it says"), map(_law, members))


def _law(law: Callable[..., Any]) -> tuple[str, str, str]:
    words = inspect.getdoc(law) or ""
    equation = EQUATION.search(words.partition("\n")[2] or words)
    parameters = [
        each.replace(annotation=inspect.Parameter.empty)
        for each in inspect.signature(law).parameters.values()
    ]
    signature = str(inspect.Signature(parameters))
    return f"`{law.__name__}{signature}`", f"`{equation[1]}`" if equation else "", words.partition("\n")[0]


def functions() -> Iterator[str]:
    yield "## Functions\n"
    yield (
        "With all their spellings. A bare number inside of one that takes an angle says neither degrees nor radians, and is asked about.\n"
        "In the texts of laws there are also `d(…)/dt`, `int(F, t, 0, T)`, `dot`, `cross` and `norm`.\n"
    )
    rows = [(name, row.spellings, row.arity, row.angle) for name, row in FUNCTIONS.items()]
    for spelled, short in ABBREVIATED.items():
        first, *others = spelled.split()
        rows.append((first, others, short.arity, short.angle))
    yield from table(
        ("function", "also", "takes"),
        (
            (
                f"`{name}`",
                ", ".join(f"`{each}`" for each in also),
                "an angle" if angle else "one number" if arity == 1 else f"{arity} numbers",
            )
            for name, also, arity, angle in rows
        ),
    )


def units() -> Iterator[str]:
    yield "## Units\n"
    yield (
        "With the prefixes that are usual; the others of the SI are read as well.\n"
        "Products are written with a space, one slash goes with brackets: `J/(kg K)`.\nWhat may be typed besides (words, other languages) is in `units/unit_table.py`.\n"
    )
    rows = ((symbols.split(), prefixes) for symbols, _base, _size, prefixes, _words in UNIT_ROWS)
    yield from table(
        ("unit", "prefixes", "in SI"),
        (
            (
                ", ".join(f"`{each}`" for each in _typed(symbols)),
                prefixes,
                _in_base_units(UNITS[symbols[0]]),
            )
            for symbols, prefixes in rows
        ),
    )


def _typed(symbols: list[str]) -> dict[str, None]:
    """How a unit is written: as it is shown first, where that is no name of a file's."""
    first = show(UNITS[symbols[0]])
    delta = "Δ" if symbols[0].startswith("delta_") else ""
    return dict.fromkeys([delta + first, *symbols])


def _in_base_units(unit: Unit) -> str:
    size = str(unit.factor) if unit.pi or unit.factor.denominator == 1 else f"{float(unit.factor):.10g}"
    turned = " π" if unit.pi else ""
    zero = f", zero at {float(unit.offset):.2f} K" if unit.offset else ""
    return f"{size}{turned} {show(si_unit(unit.dimension))}".strip() + zero


def constants() -> Iterator[str]:
    yield "## Constants of nature\n"
    yield "`constants: [G, c]` in the front matter makes them letters of the problem. CODATA 2022.\n"
    yield from table(
        ("letter", "what it is", "unit"),
        ((f"`{name}`", each.name, show(each.unit)) for name, each in CONSTANTS.items()),
    )


def letters() -> Iterator[str]:
    yield "## Letters that are taken\n"
    yield (
        "No given can be called so; put an index to it (`e_1`): "
        + ", ".join(f"`{each}`" for each in sorted(RESERVED))
        + "."
    )


if __name__ == "__main__":
    sys.exit(written("laws.md", page(), sys.argv[1:]))
