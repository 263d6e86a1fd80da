"""Names on the left of an answer: one letter with its index, a word, a noun phrase; never a product or a word of change."""

from __future__ import annotations

import re

from corollary.answers.changing_words import OF_CHANGE
from corollary.answers.question import Question
from corollary.formula.abbreviations import calculator_words
from corollary.formula.numerals import VULGAR
from corollary.formula.symbols import GREEK, LOWERED
from corollary.units.unit import ONE, unit

MARKS = "̄⃗̂̇̃̅"  # bars, arrows, hats and dots above a letter
INDEX = r"(?:_\{[^{}=]{1,16}\}|_\([^()=]{1,16}\)|\[[0-9A-Za-z]{1,2}\]|[^\W²³¹⁰⁴-⁹⁻]|[₀-₉ₐ-ₜ]|['⁎]|\*(?!\s*[\w(.]))"
SYMBOL = (
    rf"(?:(?:delta|Delta|[Δ∆∑ΣδdD])\s*(?=[^\W\d_]))?[^\W\d_][{MARKS}]*{INDEX}{{0,15}}[{MARKS}]*(?:-[^\W\d_]{{3,12}})?"
    r"(?:,[^\W_]{1,3}(?![\w.]))?"
)
# `v(t)`, `F(y = 0.6 m)`: a function of its own letter, which is a name; `m(v + w)` is a product.
CALLED = r"(?:\s*\((?:[txyz0]|\s*[^\W\d_]\w*\s*=[^()=]*)\))?"
NAME = re.compile(
    rf"\s*(?:{SYMBOL}{CALLED}|\|\|?\s*{SYMBOL}\s*\|\|?|<\s*{SYMBOL}\s*>|⟨\s*{SYMBOL}\s*⟩|\[{SYMBOL}\]|\({SYMBOL}\))\s*"
)
WORD = re.compile(rf"{SYMBOL}|\([^\W\d_]\w?\)|[^\W\d_]+['’.]?s?")
GREEK_WORDS = sorted(
    {*GREEK.values(), *(word.capitalize() for word in GREEK.values())}, key=len, reverse=True
)
ONE_LETTER = rf"(?:[^\W\d_]|{'|'.join(GREEK_WORDS)})"
GLUED = re.compile(
    rf"(?P<function>{'|'.join(sorted({*calculator_words(), 'abs'}, key=len, reverse=True))})(?P<letter>{ONE_LETTER}(?:_\w+|[0-9₀-₉'])?)"
)
HEAD = re.compile(
    rf"(?:(?!(?:{'|'.join(GREEK_WORDS)})(?![^\W\d_]))(?P<change>Delta|delta|[Δ∆∑ΣδdD])(?=[^\W\d_]))?(?P<letter>{'|'.join(GREEK_WORDS)}|[^\W\d_])"
)
# What is written directly behind a letter and is no factor: a body, an axis, a time, a kind.
COMMON = re.compile(
    r"(?:[ABCDNKEPG]|[xyzifabcspkrnge1]|[0-2]|[₀-₉ₐ-ₜ]|cm|CM|st|el|rms|mx|mn|tr|rot|fr|gr|nett?|avg|av|tot|[^\W\d_]{3,})*['⁎*]*"
)
LONG_GREEK = "|".join(word for word in GREEK_WORDS if len(word) > 2)
TWO_LETTERS = re.compile(
    rf"^(?!(?:{LONG_GREEK})(?![a-z]))[A-Za-z](?:{LONG_GREEK})(?![a-z])|(?<=[A-Za-z])(?:Delta|[Δ∆])"
)
VOWEL = re.compile(r"[aeiouyåøäöü]", re.IGNORECASE)
# What a letter usually stands for, where nobody says: only to tell `m v = 8.6 kg m/s` (its formula) from `F dt = 86 N`.
CUSTOMARY: dict[str, str] = {
    "m": "kg", "M": "kg", "v": "m/s", "u": "m/s", "w": "m/s", "V": "m/s", "t": "s", "T": "s", "F": "N", "N": "N", "a": "m/s^2", "g": "m/s^2",
    "p": "kg*m/s", "P": "kg*m/s", "J": "kg*m/s", "E": "J", "K": "J", "U": "J", "W": "J", "Q": "J", "h": "m", "s": "m", "x": "m", "y": "m",
    "d": "m", "L": "m", "l": "m", "r": "m", "R": "m", "k": "N/m", "omega": "rad/s", "I": "kg*m^2",
}  # fmt: skip
CHANGING = "pPvVuEKUWLxyzst"  # of which d and a letter is a change: `dp`, `dK`


def is_name(side: str, question: Question | None = None) -> bool:
    """True for one letter or word, with Δ, an index, bars or its argument: `Δp`, `v_B'`, `|F|`, `x(t)`; not for a function.

    Letters side by side are none: `mv`, `Fv`, `cosθ`, `½F`; nor is a word that changes a value, such as `half`.
    """
    if NAME.fullmatch(side) is None or side.partition("(")[0].strip().lower() in calculator_words():
        return False
    side = re.sub(r"^\s*\((.*)\)\s*$", r"\1", side)  # `(F)`, as `\langle F\rangle` is written
    run = re.sub(r"\([^()]*\)\s*$", "", side).strip().strip("|<>⟨⟩[]() ")
    return not any(sign in VULGAR for sign in run) and _is_one(run, question)


def _is_one(run: str, question: Question | None) -> bool:
    """True if a run of signs is one letter with an index, or one word."""
    givens = {name.replace("_", "") for name in question.symbol_names} if question else set[str]()
    bare = re.sub(rf"[{MARKS}\s]", "", run)
    if keyboard(bare).replace("_", "") in givens:
        return True
    if bare.lower() in OF_CHANGE or GLUED.fullmatch(bare) or GLUED.fullmatch(bare[:1].lower() + bare[1:]):
        return False
    if bare.lower() == "mu" and question is not None and "m" in givens and question.unit.dimension != ONE:
        return False  # m times u
    if TWO_LETTERS.search(bare):
        return False
    head = HEAD.match(bare)
    if head is None:
        return False
    if head["change"] in ("d", "D") and head.end() == len(bare):
        its_unit = CUSTOMARY.get(head["letter"], "1")
        measured = question is not None and unit(its_unit).dimension == question.unit.dimension != ONE
        return head["letter"] in CHANGING and ("d" not in givens or measured)  # `dK` in J is no d times K
    index = re.split(r"_|\(|\[|-|,", bare[head.end() :])[0]
    if not index.strip("'⁎*"):
        return True
    if question is not None and re.fullmatch("[a-z](?:_.*)?'?", bare[head.end() :]):
        measured = question.dimensions.get(keyboard(head[0]))
        if measured not in (None, question.unit.dimension):
            return False  # `mp`, where m is given: m times p
    letters = [each for each in index if each.isalpha()]
    if any(ord(each) > 127 and each in GREEK for each in letters):
        return False  # `Lθ`, `FΔt`
    whole = re.sub(r"\W|[0-9_]", "", head[0] + index)
    if len(whole) > 2 and all(each in givens for each in whole):
        return False  # `mgh`
    if len(index.strip("'⁎*")) == 1 and index[0] in givens:
        return False  # `Fv`, where v is given
    if (len(whole) > 3 and VOWEL.search(whole)) or (
        COMMON.fullmatch(index) and (len(letters) < 3 or VOWEL.search(whole))
    ):
        return True
    return index[:1].isdigit() and any(name.endswith(index) for name in givens)


def is_talk(side: str, question: Question | None = None) -> bool:
    """True for words such as `change in momentum`; a function's name (`sin theta`) or letters side by side (`m v`) are none."""
    words = side.replace(",", " ").split()
    if not all(WORD.fullmatch(word) for word in words) or set(words) & calculator_words().keys():
        return False
    if any(word.lower().rstrip("'’.") in OF_CHANGE for word in words):
        return False
    if len(words) == 1:
        return is_name(words[0], question)
    return any(len(word) > 2 and word.isalpha() and word not in GREEK.values() for word in words)


def keyboard(run: str) -> str:
    """The letters of a name as they are typed: `theta` of θ, `v2` of v₂."""
    return "".join(GREEK.get(each) or LOWERED.get(each, each) for each in run)


def apart(side: str) -> str:
    """A left side with what is glued to its letter apart: `cosθ` as `cos θ`, `½F` as `1/2 F`, `F½` as `F * 1/2`."""
    side = side.strip()
    for sign in VULGAR:
        if side.startswith(sign):
            above, below = VULGAR[sign].as_integer_ratio()
            return f"{above}/{below} {side[1:].strip()}"
        if side.endswith(sign):
            above, below = VULGAR[sign].as_integer_ratio()
            return f"{side[:-1].strip()} * {above}/{below}"
    glued = GLUED.fullmatch(side) or GLUED.fullmatch(side[:1].lower() + side[1:])
    return f"{glued['function']} {glued['letter']}" if glued else side


def another_body(side: str, question: Question | None) -> bool:
    """True for a letter with the index of another body than the question's: `v_B'` where the velocity of A is asked."""
    if question is None:
        return False
    bodies = {name[-1] for name in question.symbol_names if len(name) > 1 and name[-1].isupper()}
    asked = bodies & set(re.findall(r"\b[A-Z]\b", question.title))
    found = re.fullmatch(r"[^\W\d_]_?\{?(?P<body>[A-Z])['01-9]*\}?['⁎*]*", side.strip().strip("|"))
    return len(asked) == 1 and found is not None and found["body"] in bodies - asked
