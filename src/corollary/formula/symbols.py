"""The letters of an exercise, and all the ways a student may write them: m_A, mA, m_a; theta, θ; dt, Δt."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

from corollary.formula.abbreviations import function_words
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.misspelt import one_apart
from corollary.messages import catalogue

_ = catalogue(__name__)

# Each letter, and what it is called on a keyboard; some have two code points (µ the sign for micro, μ the letter).
KEYBOARD_NAMES = """
    α alpha  β beta  γ gamma  δ delta  ε epsilon  ϵ epsilon  ζ zeta  η eta  θ theta
    ϑ theta  ι iota  κ kappa  λ lambda  μ mu  µ mu  ν nu  ξ xi  π pi  ρ rho
    ϱ rho  σ sigma  τ tau  υ upsilon  φ phi  ϕ phi  χ chi  ψ psi  ω omega
    Γ Gamma  Δ Delta  ∆ Delta  Θ Theta  Λ Lambda  Ξ Xi  Π Pi  Σ Sigma  Φ Phi
    Ψ Psi  Ω Omega  ħ hbar  ℏ hbar
"""
GREEK: dict[str, str] = dict(zip(KEYBOARD_NAMES.split()[::2], KEYBOARD_NAMES.split()[1::2], strict=True))
LOWERED: dict[str, str] = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ", "0123456789aexhklmnpstijruv", strict=True))
WORDS = tuple(sorted(set(GREEK.values()) - {"pi", "Pi"}, key=len, reverse=True))

LAMBDA = r"lam(?:da)?(?![a-z])"  # `lambda` is a word of Python: authors write lam, as in `lam_1`

APART = re.compile(r"([Δ∆]|Delta)( +)(?=[A-Za-z])")  # `Δ t`: the space goes before the change, no place moves
LETTER = "A-Za-z" + "".join(GREEK)
RUN = re.compile(
    rf"[{LETTER}](?:[{LETTER}0-9{''.join(LOWERED)}]|_\{{[{LETTER}0-9, ]{{1,12}}\}}|_(?=[{LETTER}0-9]))*"
)
LONGEST_RUN = 60
# Capital Greek letters that are typed, and copied, as the Latin ones they look like.
LATIN = dict(
    zip(
        [
            "Alpha",
            "Beta",
            "Epsilon",
            "Zeta",
            "Eta",
            "Iota",
            "Kappa",
            "Mu",
            "Nu",
            "Omicron",
            "Rho",
            "Tau",
            "Upsilon",
            "Chi",
        ],
        "ABEZHIKMNOPTYX",
        strict=True,
    )
)
INVERSE = frozenset({"asin", "acos", "atan", "asinh", "acosh", "atanh"})


CONJUNCTIONS = frozenset(["and", "or", "und", "oder", "og", "eller", "et", "ou"])

Word = Literal["name", "function", "e", "degree"]
Meaning = tuple[Word, str]


@dataclass(frozen=True, slots=True)
class Piece:
    """One word of a formula: a letter of the exercise, a function, a constant, or the word for degrees."""

    kind: Word
    name: str
    at: int


@dataclass(frozen=True, slots=True)
class Letters:
    """What may be typed (underscores left out), and which word it stands for; `loose` also takes mb for mB."""

    names: frozenset[str]
    exact: Mapping[str, Meaning]
    loose: Mapping[str, Meaning]


def letters(names: frozenset[str]) -> Letters:
    """The letters of an exercise. A spelling that could mean two of them stands for neither, unless it is one of the names."""
    return _letters(names, tuple(function_words()))  # with the functions, of which a plug-in may bring more


@lru_cache(maxsize=256)
def _letters(names: frozenset[str], functions: tuple[str, ...]) -> Letters:
    exact: dict[str, Meaning] = {"pi": ("name", "pi"), "PI": ("name", "pi"), "Pi": ("name", "pi")}
    known = function_words()
    for typed in functions:  # and as other systems have them: `Sin`, `SQRT`
        if len(typed) > 2 and typed.islower():
            exact |= {
                each: ("function", known[typed])
                for each in (typed.capitalize(), typed.upper())
                if each not in functions
            }
    exact |= {typed: ("function", known[typed]) for typed in functions}
    exact |= _unshared((spelling, name) for name in names for spelling in _spellings(name))
    exact |= {key: ("name", name) for name in names for key in (name, name.replace("_", ""))}
    if "e" not in names:
        exact["e"] = ("e", "e")
    return Letters(
        names, exact, _unshared((_loosened(key), word[1]) for key, word in exact.items() if word[0] == "name")
    )


def read_run(run: str, at: int, known: Letters) -> list[Piece] | ParseError:
    """The words a run of letters is made of: one whole letter if it is one, else the fewest that make it up."""
    if run in known.names:
        return [Piece("name", run, at)]
    if len(run) > LONGEST_RUN:
        return refused(_("this word is too long"), at)
    if run in ("deg", "degree", "degrees"):
        return [Piece("degree", run, at)]
    latin, places, joints = _latin(run)
    if latin in known.exact:
        kind, name = known.exact[latin]
        return _two_meanings(name, at, known) or [Piece(kind, name, at)]
    exact_cuts = _cuts(latin, joints, known, loosely=False)
    if (
        _loosened(latin) in known.loose
    ):  # `ma` may be the letter m_A, or m times a: only when both exist is there a question
        kind, name = known.loose[_loosened(latin)]
        if exact_cuts:
            return ambiguous(
                _("{run} can be read in two ways", run=run),
                at,
                name,
                "*".join(word[1] for _, word in exact_cuts[0]),
            )
        return [Piece(kind, name, at)]
    cuts = exact_cuts or _cuts(latin, joints, known, loosely=True)
    if len(cuts) > 1:
        return ambiguous(
            _("{run} can be read in several ways", run=run),
            at,
            *("*".join(word[1] for _, word in cut) for cut in cuts[:2]),
        )
    if cuts:
        pieces = [Piece(*word, at + places[start]) for start, word in cuts[0]]
        return (
            next(
                (trouble for piece in pieces if (trouble := _two_meanings(piece.name, piece.at, known))), None
            )
            or pieces
        )
    return refused(
        _("{run} is not among the letters here ({letters})", run=run, letters=", ".join(sorted(known.names))),
        at,
        _near(latin, known),
    )


def _two_meanings(name: str, at: int, known: Letters) -> ParseError | None:
    if name in INVERSE and "a" in known.names:
        return ambiguous(
            _("{name} can be an inverse function, or a times {function}", name=name, function=name[1:]),
            at,
            f"arc{name[1:]}(…)",
            f"a*{name[1:]}(…)",
        )
    return None


def _spellings(name: str) -> set[str]:
    """Other ways to write one name, underscores left out."""
    latin = name.replace("_", "")
    found = {latin}
    if len(latin) > 1 and latin[0] == "d" and latin[1].isalpha() and not latin.startswith("delta"):
        found |= {"Delta" + latin[1:], "delta" + latin[1:]}
    if latin.startswith("Delta") and len(latin) > 5:
        found |= {"d" + latin[5:], "delta" + latin[5:]}
    if latin.startswith("eps") and not latin.startswith("epsilon"):
        found.add("epsilon" + latin[3:])
    if latin.startswith("epsilon"):
        found.add("eps" + latin[7:])
    if (greek := next((each for each in LATIN if latin.startswith(each)), "")) and latin:
        found.add(LATIN[greek] + latin[len(greek) :])
    if short := re.match(LAMBDA, latin):
        found.add("lambda" + latin[short.end() :])
    return found


def _loosened(latin: str) -> str:
    """The head as written, the index in small letters."""
    head = next((word for word in WORDS if latin.startswith(word)), latin[:1])
    return head + latin[len(head) :].lower()


def _unshared(pairs: Iterable[tuple[str, str]]) -> dict[str, Meaning]:
    meanings: dict[str, set[str]] = {}
    for key, name in pairs:
        meanings.setdefault(key, set()).add(name)
    return {key: ("name", found.pop()) for key, found in meanings.items() if len(found) == 1}


def _latin(run: str) -> tuple[str, list[int], set[int]]:
    """The run in plain letters; the place of each in the run; the places where it must not be cut."""
    latin, places, joints, braced = "", list[int](), set[int](), False
    for place, letter in enumerate(run):
        if letter == "_" or letter in "{},":
            braced = letter == "{" or (braced and letter != "}")
            if letter != "}":  # behind `m_{B}` another letter may begin
                joints.add(len(latin))
        elif letter != " ":
            word = GREEK.get(letter) or LOWERED.get(letter, letter)
            first = len(latin) if braced or letter in LOWERED else len(latin) + 1
            joints |= set(range(first, len(latin) + len(word)))
            latin, places = latin + word, places + [place] * len(word)
    joints.discard(len(latin))
    return latin, places, joints


Cut = list[tuple[int, Meaning]]


def _cuts(latin: str, joints: set[int], known: Letters, *, loosely: bool) -> list[Cut]:
    """The cuts into fewest words, at most two of them, found from the end (the number of all cuts grows exponentially)."""
    best: list[tuple[int, list[Cut]]] = [(0, [[]])] * (len(latin) + 1)
    for start in range(len(latin) - 1, -1, -1):
        fewest, found = len(latin) + 1, list[Cut]()
        for end in range(start + 1, len(latin) + 1) if start not in joints else ():
            if end in joints or not best[end][1]:
                continue
            piece = latin[start:end]
            word = known.exact.get(piece) or (known.loose.get(_loosened(piece)) if loosely else None)
            if word is None or (word[0] == "e" and end < len(latin)) or best[end][0] + 1 > fewest:
                continue
            longer = [[(start, word), *rest] for rest in best[end][1]]
            found = longer if best[end][0] + 1 < fewest else found + longer
            fewest = best[end][0] + 1
        best[start] = (fewest, found[:2])
    return best[0][1]


def _near(latin: str, known: Letters) -> str:
    """A letter that differs by its case, by the order of its index, or by one sign."""
    if latin == "In":
        return _("did you mean {near}?", near="ln")
    if latin.lower() in CONJUNCTIONS:
        return _("write one formula")
    parted = re.fullmatch(r"([A-Za-z]+)([0-9]+)", latin)
    if parted and parted[1] in known.exact:
        return _(
            "write {letter}^{number} for a power, {number}*{letter} for a multiple",
            letter=parted[1],
            number=parted[2],
        )
    for key, (kind, name) in sorted(known.exact.items()):
        if kind == "name" and sorted(key.lower()) == sorted(latin.lower()):  # V for v, v0A for vA0
            return _("did you mean {near}?", near=name)
    near = sorted(key for key in known.exact if abs(len(key) - len(latin)) <= 1 and one_apart(key, latin))
    near = [key for key in near if key[0] == latin[0]] or [key for key in near if len(key) > 2]
    if near:
        return _("did you mean {near}?", near=known.exact[near[0]][1])
    return _("use only the letters of the exercise")
