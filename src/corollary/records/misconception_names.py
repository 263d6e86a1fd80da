"""Misconceptions by name: what the solutions of a set list, and which of them a recorded mistake or slip is."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache

import msgspec

from corollary import user_cache
from corollary.answers.verdict import Mistaken, Slip, word
from corollary.derive.load import NotDerivable, load, source
from corollary.derive.statements import Choice, Forces, Optimum, Proof, Simulated, Step
from corollary.messages import Catalogue, language, languages
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.translation import text_in_language
from corollary.version import __version__

MISTAKEN, SLIP = word(Mistaken("")), word(Slip(""))
# Slips whose sentence holds a symbol of the problem, or that a misconception of a solution may say as well.
SLIPS = {
    "{symbol} was put in without converting its unit to SI.": "unit not converted",
    "{symbol} was put in as if it were in m/s; convert km/h first.": "unit not converted",
    "Your calculator was set to radians, but the angle is given in degrees.": "radians for degrees",
    "You calculated with g = 10 m/s²; the problem gives a closer value.": "g = 10 m/s²",
    "Sine and cosine are interchanged: check from where the angle is measured.": "sine and cosine interchanged",
}
GRADING = Catalogue("corollary.grading")


class NamedMistake(msgspec.Struct, frozen=True):
    """A mistake that a solution lists: its sentence in English, its name (empty: none), and the part in which it shows first."""

    text: str
    name: str
    part: str


@dataclass(frozen=True, slots=True, order=True)
class Misconception:
    """One misconception, the same in every problem that lists it by its name. Without a name it is that of one problem, and `name`
    is its sentence; a slip of input is the same everywhere."""

    name: str
    problem: str = ""
    is_slip: bool = False

    @property
    def is_named(self) -> bool:
        return not self.problem


def mistakes_in(bank: Bank, problem: Problem) -> tuple[NamedMistake, ...]:
    """All that the solution of a problem lists; read again only when its file has changed. Raises NotDerivable and Malformed."""
    problem = problem.as_written
    content = source(bank, problem) + problem.path.read_bytes() + __version__.encode()
    origin = hashlib.sha256(content).hexdigest()
    cached = user_cache.name_of(f"{problem.name}-mistakes", bank.solution(problem))
    if (text := user_cache.read(cached, origin)) is not None:
        return msgspec.json.decode(text, type=tuple[NamedMistake, ...])
    found = tuple(dict.fromkeys(_stated(bank, problem)))
    user_cache.write(cached, origin, msgspec.json.encode(found))
    return found


def _stated(bank: Bank, problem: Problem) -> Iterator[NamedMistake]:
    loaded = load(bank, problem)
    derivations = [each.derivation for each in loaded.branches] or [loaded.derivation]
    for derivation in derivations:
        before: list[tuple[str, str]] = []  # of steps that answer no part: they show in the next that does
        for entry in derivation.entries:
            own: list[tuple[str, str]] = []
            match entry:
                case Step() | Optimum() | Simulated() | Proof():
                    own = [(each.text, each.name) for each in entry.mistakes]
                case Choice() | Forces():
                    own = [(text, "") for text in entry.mistakes.values()]
                case _:
                    continue
            part = entry.statement.part
            if not part:
                before += own
                continue
            yield from (NamedMistake(*each, part) for each in (*before, *own))
            before = []


@dataclass(slots=True)
class MisconceptionNames:
    """What is listed, by problem: read when a problem is first asked for. `unread` are those whose solution cannot be read."""

    texts: dict[tuple[str, str], Misconception] = field(default_factory=dict[tuple[str, str], Misconception])
    shows: dict[tuple[str, str], frozenset[Misconception]] = field(
        default_factory=dict[tuple[str, str], frozenset[Misconception]]
    )
    unread: dict[str, str] = field(default_factory=dict[str, str])
    _known: set[str] = field(default_factory=set[str])

    def add(self, bank: Bank, problem: Problem) -> None:
        """The mistakes of one more problem, in every language that it is translated into."""
        if problem.code in self._known:
            return
        self._known.add(problem.code)
        try:
            listed = mistakes_in(bank, problem)
        except (NotDerivable, Malformed, OSError) as error:
            self.unread[problem.code] = str(error)
            return
        for each in listed:
            found = misconception_of(problem.code, each)
            place = problem.code, each.part
            self.shows[place] = self.shows.get(place, frozenset()) | {found}
            for code in languages():
                with language(code):
                    self.texts[problem.code, _unwrapped(text_in_language(problem.as_written, each.text))] = (
                        found
                    )
            self.texts[problem.code, _unwrapped(each.text)] = found

    def named(self, problem: str, verdict: str, sentence: str) -> Misconception:
        """What a record's mistake or slip is; one that nobody lists any more is a misconception of its problem."""
        if verdict == SLIP:
            return Misconception(_slip(sentence), is_slip=True)
        return self.texts.get((problem, _unwrapped(sentence)), Misconception(sentence, problem))


def misconception_of(code: str, listed: NamedMistake) -> Misconception:
    return Misconception(listed.name) if listed.name else Misconception(listed.text, code)


@cache
def _slip(sentence: str) -> str:
    """The name of a slip, whatever symbol and language its sentence has; the sentence where it has none."""
    for code in languages():
        for pattern, name in _slips(code):
            if pattern.fullmatch(sentence):
                return name
    return sentence


_PATTERNS: dict[str, list[tuple[re.Pattern[str], str]]] = {}


def _slips(code: str) -> list[tuple[re.Pattern[str], str]]:
    if code not in _PATTERNS:
        with language(code):
            _PATTERNS[code] = [
                (re.compile(re.escape(GRADING(message)).replace(r"\{symbol\}", ".+")), name)
                for message, name in SLIPS.items()
            ]
    return _PATTERNS[code]


def _unwrapped(text: str) -> str:
    return " ".join(text.split())
