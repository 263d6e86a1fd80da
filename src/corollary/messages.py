"""Message catalogues: what a student reads, in the reader's language; English stands in the code and is the fallback.

Every room, and every package of somebody else's, brings its own catalogue: `_ = catalogue(__name__)` in `corollary.answers.…`
looks in `corollary/answers/locale/<language>/LC_MESSAGES/corollary.answers.mo`. A bank's is named by a file, for its judges are
no package: `_ = catalogue(__file__)` looks in `solutions/locale/<language>/LC_MESSAGES/messages.mo`.
"""

from __future__ import annotations

import gettext
import io
import re
import unicodedata
from collections.abc import Generator, Iterable, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

# Controls, marks of direction, halves of surrogates, and separators of lines, by their category in Unicode.
HIDDEN = frozenset({"Cc", "Cf", "Cs", "Zl", "Zp"})
# Languages that part decimals by a comma, and a list of numbers by semicolons therefore.
WITH_COMMA = frozenset({"de", "nb"})
DECIMAL = re.compile(r"(?<![\w.])(\d+)\.(\d+)(?!\w*\.\d)")
_CARRIED: dict[tuple[str, str], bytes] = {}
_LANGUAGE: ContextVar[str] = ContextVar("language", default="en")
LOCALE = "locale"  # the folder of translations
OF_BANK = "messages"  # the domain of a bank's: the one that gettext and Babel take when none is named


@dataclass(frozen=True, slots=True)
class Catalogue:
    """The texts of one room, or of a bank. `domain` is the dotted name of the package, or the folder, in which `locale/` lies."""

    domain: str

    def __call__(self, message: str, /, **values: object) -> str:
        """The message in the reader's language, its `{holes}` filled with `values`. Raises KeyError for a hole without one."""
        text = _translations(self.domain, _LANGUAGE.get()).gettext(message)
        return text.format(**values) if values else text

    def plural(self, one: str, many: str, count: int, /, **values: object) -> str:
        """`one` or `many`, whichever the reader's language uses for `count`; `{count}` is filled as the other holes are."""
        return (
            _translations(self.domain, _LANGUAGE.get())
            .ngettext(one, many, count)
            .format(count=count, **values)
        )


def catalogue(module: str) -> Catalogue:
    """The catalogue of the room that a module (its `__name__`) belongs to; a package of somebody else's has one for all.

    For a file (`__file__`) it is that of the nearest folder above in which `locale/` lies.
    """
    if module.endswith(".py"):
        above = Path(module).resolve().parents
        return Catalogue(str(next((each for each in above if (each / LOCALE).is_dir()), above[0])))
    return Catalogue(".".join(module.split(".")[: 2 if module.startswith("corollary.") else 1]))


@contextmanager
def language(code: str) -> Generator[None]:
    """What is said inside the block is said in this language ("en", "de", "nb") where its catalogue has the text."""
    token = _LANGUAGE.set(code)
    try:
        yield
    finally:
        _LANGUAGE.reset(token)


@cache
def _translations(domain: str, code: str) -> gettext.NullTranslations:
    text = compiled(domain, code)
    return gettext.GNUTranslations(io.BytesIO(text)) if text else gettext.NullTranslations()


def compiled(domain: str, code: str) -> bytes:
    """The compiled catalogue of a room, or of a package of somebody else's, for one language; empty where there is none."""
    if code == "en":
        return b""
    if (domain, code) in _CARRIED:
        return _CARRIED[domain, code]
    if Path(domain).is_absolute():
        found = gettext.find(OF_BANK, Path(domain, LOCALE), [code])
    else:
        spec = find_spec(domain)
        places = list(spec.submodule_search_locations or ()) if spec is not None else []
        found = gettext.find(domain, Path(places[0], LOCALE), [code]) if places else None
    return Path(found).read_bytes() if found else b""


def in_convention(text: str, comma: str = ",") -> str:
    """A text made of numbers and units as readers of the spoken language write it: `(3.5, 4) m/s` is `(3,5; 4) m/s` in German.

    `comma` is the decimal comma (`{,}` in TeX, where a bare one is followed by a gap). Codes such as X12.5 stay as they are.
    """
    if spoken() not in WITH_COMMA:
        return text
    return DECIMAL.sub(rf"\1{comma}\2", re.sub(r"(?<=[\d\w°]), (?=[-−+]?\d)", "; ", text))


def carry(domain: str, code: str, text: bytes) -> None:
    """Takes a compiled catalogue from memory: a student's notebook has the texts with it, and no folder to find them in."""
    _CARRIED[domain, code] = text
    _translations.cache_clear()


def spoken() -> str:
    """The language in which everything is said now."""
    return _LANGUAGE.get()


def N_(message: str, /) -> str:
    """Marks a message that stands in a table; it is looked up when it is spoken."""
    return message


def speak(code: str) -> None:
    """From now on everything is said in this language, where its catalogue has the text."""
    _LANGUAGE.set(code)


def languages() -> list[str]:
    """The languages that students can be addressed in: English, and those that a room has texts in."""
    found = Path(__file__).parent.glob("*/locale/*/LC_MESSAGES/*.mo")
    return ["en", *sorted({path.parent.parent.name for path in found})]


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """` (did you mean X12.5?)`, where one of the known words, or a few, are near to it or begin with it; else nothing."""
    from difflib import get_close_matches

    by_small_letters = {each.lower(): each for each in known}
    small = word.lower()
    begun = [each for each in by_small_letters if len(small) > 2 and each.startswith(small)]
    # Two letters exchanged leave two thirds of a word of three (csv, cvs), and more of a longer one.
    alike = get_close_matches(small, by_small_letters, n=3, cutoff=0.65 if len(small) < 5 else 0.7)
    near = [by_small_letters[each] for each in dict.fromkeys((*begun, *alike))][:3]
    return f" (did you mean {' or '.join(near)}?)" if near else ""


def few(names: Sequence[str], most: int = 5) -> str:
    """The first names, and how many more there are."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def visible(text: str) -> str:
    """The text with what is no letter written out (`\\x1b`): a file name could clear the terminal or turn the line round."""
    return "".join(
        each if each in "\n\t" or unicodedata.category(each) not in HIDDEN else ascii(each)[1:-1]
        for each in text
    )
