"""A text as one would type it by hand: legible, without TeX and Markdown, and without what Python writes around numbers."""

from __future__ import annotations

import re

from corollary.formula.characters import legible
from corollary.formula.tex import without_tex

MODULE = re.compile(r"(?<![\w.])(?:np|numpy|math|sp|sympy|scipy|ureg|u)\.(?=[A-Za-z])")
NUMBER = re.compile(
    r"(?<!\w)(?:float(?:16|32|64|128)?|mpf|Float|Decimal|(?:int(?:32|64)?|Integer)(?=\(\s*[\"']?[-+]?[0-9]+[\"']?\s*\)))\(\s*[\"']?([^()\"',]*)[\"']?\s*\)"
)
FRACTION = re.compile(r"(?<!\w)(?:Fraction|Rational)\(\s*(-?[0-9]+)\s*,\s*([0-9]+)\s*\)")
ARRAY = re.compile(
    r"(?<!\w)(?:array|asarray|matrix|Matrix|ImmutableDenseMatrix|Vector|vector|tuple|list|Tuple)\s*"
    r"\((\s*[\[(].*[\])])\s*(?:,\s*dtype\s*=\s*[\w.]+)?\)"
)
ROW = re.compile(r"\[\s*([^\[\],;()]*?)\s*\]")
QUANTITY = re.compile(r"<Quantity(?:\s+([^<>()]*)|\((.*),\s*'([^']*)'\))>")
BOLD = re.compile(r"(?<![\w)\]*])\*\*(?=[^\s*])([^*]+)(?<=[^\s*])\*\*(?![\w(*])")
LOST_POWER = re.compile(
    r"(?<=[0-9])(\s?[×·⋅]\s?)10[−–-](?=[0-9]{1,2}(?:\s|$))"
)  # raised in the page it was copied from
INVERSE = re.compile(
    r"(?<![A-Za-z])(?:arc(?:us)?|inv(?:erse)?)[\s.-]+(sin|cos|tan)(?:us|inus|ine|gens|gent|angent)?(?: of(?= ))?(?![A-Za-z])",
    re.I,
)
KEY = re.compile(r"[\"']([^\W\d]\w*)[\"']\s*:")


def by_hand(text: str) -> str:
    """What the text says, in the fewest signs: `\\frac{m}{2}` is (m/2), `np.array([1, 2])` is [1, 2], `𝑚` is m."""
    text = LOST_POWER.sub(r"\g<1>10^-", text)
    typed = BOLD.sub(r"\1", without_tex(legible(text)))
    return _without_python(INVERSE.sub(lambda found: f"arc{found[1].lower()}", typed))


def _without_python(text: str) -> str:
    if "(" in text or "." in text:
        text = NUMBER.sub(r"\1", MODULE.sub("", text))
        text = ARRAY.sub(r"\1", FRACTION.sub(r"(\1/\2)", text))
    if "[[" in text:
        text = ROW.sub(r"\1", text)
    if "<Quantity" in text:
        text = QUANTITY.sub(lambda found: found[1] or f"{found[2]} {found[3]}", text)
    return KEY.sub(r"\1:", text) if "{" in text else text
