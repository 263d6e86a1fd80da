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
LOST_POWER = re.compile(  # raised in the page it was copied from; `5*10-3` may be a difference
    r"(?<![0-9.,])((?:[0-9][.,][0-9]+)(?:\s?[×·⋅xX*]\s?)|[0-9]+(?:\s?[×·⋅xX]\s?))10[−–-](?=[0-9]{1,2}(?:\s|[A-Za-zµ]|$))"
)
RAISED_LETTERS = str.maketrans("ⁿᵏᵗˣʸᵃᵇᶜᵈᵉᵐᵖʳˢᵘᵛʷ⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "nktxyabcdemprsuvw0123456789-+")
RAISED = re.compile(r"[⁻⁺⁰¹²³⁴-⁹]*[ⁿᵏᵗˣʸᵃᵇᶜᵈᵉᵐᵖʳˢᵘᵛʷ][⁻⁺⁰¹²³⁴-⁹ⁿᵏᵗˣʸᵃᵇᶜᵈᵉᵐᵖʳˢᵘᵛʷ]*")
RAISED_MINUS = re.compile(r"(?:^|(?<=[=≈(,;\s]))[⁻¯](?=\s?[0-9.,])")
BASED = re.compile(r"(?<![A-Za-z])(?:log|Log)_(?:\{\s*(\w{1,6})\s*\}|([0-9]{1,3}|[A-Za-z]))\s*")
INVERSE = re.compile(
    r"(?<![A-Za-z])(?:arc(?:us)?|inv(?:erse)?)[\s.-]+(sin|cos|tan)(?:us|inus|ine|gens|gent|angent)?(?: of(?= ))?(?![A-Za-z])",
    re.I,
)
KEY = re.compile(r"[\"']([^\W\d]\w*)[\"']\s*:")


def by_hand(text: str) -> str:
    """What the text says, in the fewest signs: `\\frac{m}{2}` is (m/2), `np.array([1, 2])` is [1, 2], `𝑚` is m."""
    text = RAISED_MINUS.sub("-", LOST_POWER.sub(r"\g<1>10^-", text))
    if text.endswith(("×", "✕", "⨯")):  # `2×` says two times, `2*` has lost something
        text = f"{text[:-1]} times"
    typed = BOLD.sub(r"\1", without_tex(legible(text)))
    if not typed.isascii():
        typed = RAISED.sub(lambda found: f"^({found[0].translate(RAISED_LETTERS)})", typed)
    typed = _with_bases(typed) if "_" in typed else typed
    typed = re.sub(r"(?<=\w)~(?=[^\W\d])", " ", typed) if "~" in typed else typed
    return _without_python(INVERSE.sub(lambda found: f"arc{found[1].lower()}", typed))


def _with_bases(text: str) -> str:
    """`log_a(b)` as ln(b)/ln(a), `log_10(x)` as log10(x)."""
    while found := BASED.search(text):
        base, rest = found[1] or found[2], text[found.end() :]
        argument = re.match(r"\w+", rest)
        end = _closing(rest) if rest.startswith("(") else argument.end() if argument else 0
        if end == 0:
            break
        inside = rest[1 : end - 1] if rest.startswith("(") else rest[:end]
        done = f"log10({inside})" if base == "10" else f"(ln({inside})/ln({base}))"
        text = text[: found.start()] + done + rest[end:]
    return text


def _closing(text: str) -> int:
    """The place behind the bracket that closes the first; 0 where none does."""
    depth = 0
    for place, sign in enumerate(text):
        depth += (sign == "(") - (sign == ")")
        if depth == 0:
            return place + 1
    return 0


def _without_python(text: str) -> str:
    if "(" in text or "." in text:
        text = NUMBER.sub(r"\1", MODULE.sub("", text))
        text = ARRAY.sub(r"\1", FRACTION.sub(r"(\1/\2)", text))
    if "[[" in text:
        text = ROW.sub(r"\1", text)
    if "<Quantity" in text:
        text = QUANTITY.sub(lambda found: found[1] or f"{found[2]} {found[3]}", text)
    return KEY.sub(r"\1:", text) if "{" in text else text
