"""A formula on a page: LaTeX becomes MathML a browser lays out by itself, offline, and a screen reader can say."""

from __future__ import annotations

import html
import re
from functools import lru_cache
from itertools import accumulate
from xml.etree.ElementTree import Element

from latex2mathml.converter import convert_to_element

from corollary.render.typeset import UNSEEN, typeset

LONGEST, DEEPEST = 4000, 60
DEFINES = re.compile(r"\\(newcommand|renewcommand|def|DeclareMathOperator|newenvironment)\b")
# The number and unit of a filled hole (`20.0 m/s`, joined by a no-break space): the unit stands upright in a formula.
SYMBOL = r"[A-Za-zµΩ%°][A-Za-zµΩ%°/·⁰¹²³⁴⁵⁶⁷⁸⁹⁻^0-9.()]*"
MEASURED = re.compile(rf"\u00a0({SYMBOL}(?: {SYMBOL})*)")


@lru_cache(maxsize=4096)
def formula(latex: str, *, display: bool = False) -> Element | None:
    """The MathML of a formula, made only of elements and attributes known to be harmless; None when it is no LaTeX.

    The tree is shared: read it, and leave it as it is.
    """
    depths = accumulate((letter == "{") - (letter == "}") for letter in latex)
    if len(latex) > LONGEST or DEFINES.search(latex) or max(depths, default=0) > DEEPEST:
        return None
    latex = UNSEEN.sub(" ", latex)
    text = MEASURED.sub(lambda unit: rf"\,\text{{{unit[1]}}}", latex)
    text = re.sub(r"(?<!\\)%", r"\\%", text)  # a percent sign is meant as one: no formula here holds comments
    text = re.sub(r"\\(begin|end)\{aligned\}", r"\\\1{split}", text)
    try:
        tree = typeset(convert_to_element(text, xmlns="", display="block" if display else "inline"))
    except Exception:  # malformed LaTeX ends there in a dozen unrelated exceptions (IndexError, StopIteration, KeyError, ...)
        return None
    tree.set("alttext", latex)
    return tree


@lru_cache(maxsize=4096)
def mathml(latex: str, *, display: bool = False) -> str:
    """A `<math>` element for a page, or the source as code when it is no LaTeX."""
    tree = formula(latex, display=display)
    if tree is None:
        return f'<code class="latex">{html.escape(latex)}</code>'
    return _written(tree)


def _written(element: Element) -> str:
    attributes = "".join(f' {name}="{html.escape(value)}"' for name, value in element.attrib.items())
    inside = html.escape(element.text or "", quote=False) + "".join(map(_written, element))
    return f"<{element.tag}{attributes}>{inside}</{element.tag}>"
