"""Output on terminals and pipes that lack letters: written with the nearest ones, so that no line is lost."""

from __future__ import annotations

import codecs
import io
import sys
import unicodedata

NEAREST = "corollary.nearest"  # the name of the way that letters are replaced, as Python's "replace" is one
LIKE = {
    "≈": "~", "…": "...", "–": "-", "—": "-", "−": "-", "·": "*", "×": "x", "“": '"', "”": '"', "„": '"', "’": "'", "‘": "'",
    "≤": "<=", "≥": ">=", "≠": "!=", "→": "->", "Δ": "Delta", "π": "pi", "°": " deg", "√": "sqrt", "µ": "u", "μ": "u", "Ω": "Ohm",
    "⁻": "^-", "∞": "inf", "\N{NO-BREAK SPACE}": " ", "\N{NARROW NO-BREAK SPACE}": " ", "■": "#", "▸": ">", "ß": "ss", "ø": "o",
}  # fmt: skip


def write_whatever_comes() -> None:
    """Lets standard output and error take every text: C and cp1252 have no ≈, and a line must not end in a traceback."""
    codecs.register_error(NEAREST, nearest)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=NEAREST)


def nearest(error: UnicodeError) -> tuple[str, int]:
    """What is written for letters that cannot be: the like of them, the letter without its accent, else `?`."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letters = error.object[error.start : error.end]
    return "".join(_nearest(letter, error.encoding) for letter in letters), error.end


def _nearest(letter: str, encoding: str) -> str:
    for text in (LIKE.get(letter, ""), unicodedata.normalize("NFKD", letter)):
        bare = "".join(each for each in text if not unicodedata.combining(each))
        if bare and _has(encoding, bare):
            return bare
    return "?"


def _has(encoding: str, text: str) -> bool:
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return False
    return True
