r"""Answers typed in TeX, as one would type them without it: `\frac{m v}{\Delta t}` is ((m v)/(Delta t))."""

from __future__ import annotations

import re

REPLACEMENTS = {
    "cdot": "*",
    "times": "*",
    "ast": "*",
    "div": "/",
    "pm": "±",
    "approx": "≈",
    "simeq": "≈",
    "sim": "≈",
    "circ": "°",
    "degree": "°",
    "langle": "(",
    "rangle": ")",
    "lvert": "|",
    "rvert": "|",
    "vert": "|",
    "quad": " ",
    "qquad": " ",
    "left": "",
    "right": "",
    **dict.fromkeys(
        (f"{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")), ""
    ),
    "middle": "",
    **dict.fromkeys(("thinspace", "medspace", "thickspace", "enspace", "space", "nobreakspace"), " "),
    "negthinspace": "",
    "textstyle": "",
    "hslash": "hbar",
    "lbrace": "(",
    "rbrace": ")",
    "lbrack": "(",
    "rbrack": ")",
    "lparen": "(",
    "rparen": ")",
    "ge": ">=",
    "geq": ">=",
    "le": "<=",
    "leq": "<=",
    "mp": "∓",
    "displaystyle": "",
    "limits": "",
    "varphi": "phi",
    "varepsilon": "epsilon",
    "vartheta": "theta",
    "imath": "i",
    "jmath": "j",
    "per": "/",
    "newton": "N",
    "joule": "J",
    "watt": "W",
    "metre": "m",
    "meter": "m",
    "second": "s",
    "kilogram": "kg",
    "gram": "g",
    "radian": "rad",
    "squared": "^2",
    "kilo": "k",
    "milli": "m",
    "centi": "c",
    "percent": "%",
}
TEXT_COMMANDS = (
    "mathrm text textrm textit textbf mathit mathbf mathsf rm operatorname unit "
    "si num boxed underline vec overrightarrow bar boldsymbol bm pmb mathbb mathcal mathsf mathtt textsf texttt textnormal mathnormal "
    "hbox mbox emph overline widehat tilde ensuremath mathop"
)
WRAPPED = frozenset(TEXT_COMMANDS.split())
COMMAND = re.compile(r"\\([A-Za-z]+)\*?\s*|\\(.)")
SPACES = re.compile(r"\\[,;:!> ]|~|\$|\\\(|\\\)|\\\[|\\\]|\\(?:begin|end)\{[pbv]?(?:matrix|array)\}")
OVER = re.compile(r"\{([^{}]*)\\over\s([^{}]*)\}")
INDEX = re.compile(r"_\{([^{}]*)\}")
NUMERIC_POWER = re.compile(r"\s*(?:[0-9]+|°)\s*")
DEEPEST = 20


def without_tex(text: str) -> str:
    """The text as it would be typed without TeX; as it is where it holds none."""
    if "\\" not in text and "$" not in text and "^{" not in text:
        return text
    expanded = text.replace("{,}", ",").replace("\\\\", ";")
    while (over := OVER.sub(r"\\frac{\1}{\2}", expanded)) != expanded:
        expanded = over
    above, _, below = expanded.partition("\\over ")
    expanded = f"\\frac{{{above}}}{{{below}}}" if below else above
    expanded = _expanded(SPACES.sub(lambda found: _bracket(found[0]), expanded), 0)
    return re.sub(r"\^\s*°", "°", re.sub(r"\s+", " ", expanded)).strip()


def _bracket(found: str) -> str:
    return (
        ""
        if found in ("\\!", "$", "\\(", "\\)", "\\[", "\\]")
        else "("
        if "begin" in found
        else ")"
        if "end" in found
        else " "
    )


def _expanded(text: str, depth: int) -> str:
    if depth > DEEPEST:
        return text
    done = ""
    while found := COMMAND.search(text):
        done, name, rest = done + text[: found.start()], found[1], text[found.end() :]
        match name:
            case "frac" | "dfrac" | "tfrac":
                above, rest = _argument(rest)
                below, rest = _argument(rest)
                above, below = _expanded(above, depth + 1), _expanded(below, depth + 1)
                alone = below.isdecimal() or (len(below) == 1 and below.isalpha())
                done += f"(({above})/{below if alone else f'({below})'})"
            case "sqrt":
                index = re.match(r"\s*\[([^\[\]]*)\]", rest)
                inner, rest = _argument(rest[index.end() :] if index else rest)
                inner = _expanded(inner, depth + 1)
                done += f"(({inner})^(1/({_expanded(index[1], depth + 1)})))" if index else f"sqrt({inner})"
            case "textcolor" | "color" | "hspace" | "phantom":
                _shade, rest = _argument(rest)
            case "hat":
                inner, rest = _argument(rest)
                done += {"i": "î", "j": "ĵ", "x": "x̂", "y": "ŷ"}.get(
                    _expanded(inner, depth + 1).strip(), inner
                )
            case "dot":
                inner, rest = _argument(rest)
                done += f"{_expanded(inner, depth + 1)}dot"
            case "SI" | "qty":
                inner, rest = _argument(rest)
                its_unit, rest = _argument(rest)
                done += f"{_expanded(inner, depth + 1)} {_expanded(its_unit, depth + 1)}"
            case None:
                done += {"{": "(", "}": ")", "%": "%", "|": "|"}.get(found[2], " ")
            case _ if name in WRAPPED:
                inner, rest = _argument(rest)
                done += _expanded(inner, depth + 1)
            case _:
                word = REPLACEMENTS.get(name, name)
                apart = word[:1].isalpha() and done[-1:].isalnum()
                done += (
                    f"{' ' if apart else ''}{word}{' ' if word[-1:].isalpha() and rest[:1].isalnum() else ''}"
                )
        text = rest
    return _round_brackets(done + text)


def _round_brackets(text: str) -> str:
    """Curly brackets group: after ^, and around a sum, they become round ones, an index keeps them, others are left out."""
    text = INDEX.sub("_\0\\1\1", text.replace("\0", "").replace("\1", ""))
    text = re.sub(
        r"\^\s*\{([^{}]*)\}",
        lambda found: f"^{found[1]} " if NUMERIC_POWER.fullmatch(found[1]) else f"^({found[1]})",
        text,
    )
    return re.sub(r"(?<!\^)\{([^{}]*)\}", _grouped, text).replace("\0", "{").replace("\1", "}")


def _grouped(found: re.Match[str]) -> str:
    """A group as it is read: a sum beside a factor keeps its brackets."""
    before, behind = found.string[: found.start()].rstrip()[-1:], found.string[found.end() :].lstrip()[:1]
    beside = (
        before.isalnum() or before in (")", "*", "/") or behind.isalnum() or behind in ("(", "*", "/", "^")
    )
    return f"({found[1]})" if beside and re.search(r"[^\s(]\s*[-+]", found[1]) else found[1]


def _argument(text: str) -> tuple[str, str]:
    """What a command is about, and the rest: a group in curly brackets, a command, or one sign."""
    text = text.lstrip()
    if not text.startswith("{"):
        command = re.match(r"\\[A-Za-z]+", text)
        cut = command.end() if command else 1
        return text[:cut], text[cut:]
    open_ones = 0
    for place, sign in enumerate(text):
        open_ones += (sign == "{") - (sign == "}")
        if open_ones == 0:
            return text[1:place], text[place + 1 :]
    return text[1:], ""
