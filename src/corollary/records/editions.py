"""Editions of problems: what was handed out, by which it is marked, and names that look changed since."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import msgspec
import msgspec.structs

from corollary.derive.load import NotDerivable, source
from corollary.problem.bank import UnknownCode, bank_of
from corollary.problem.figure import in_letters, is_svg
from corollary.problem.given import Given
from corollary.problem.packed_pictures import packed_file
from corollary.problem.part import Option, Part
from corollary.problem.problem import Problem
from corollary.problem.statement import renamed
from corollary.units.unit import PURE, Unit, canonical, unit


def letters_now(before: Sequence[Option], today: Sequence[Option]) -> tuple[tuple[str, str], ...]:
    """Each letter of the sheet with today's letter of the same option; empty where today has none.

    Options are the same by their text. Of those that were reworded the ones that stayed at their letter are, and the last one left.
    """
    found: dict[str, str] = {}
    left = {option.letter: _words(option) for option in today}
    for option in before:
        same = [letter for letter, words in left.items() if words == _words(option)]
        if same:
            found[option.letter] = same[0]
            del left[same[0]]
    rest = [option.letter for option in before if option.letter not in found]
    for letter in rest:
        if letter in left:
            found[letter] = letter
            del left[letter]
    rest = [letter for letter in rest if letter not in found]
    if len(rest) == len(left) == 1:
        found[rest[0]] = next(iter(left))
    return tuple((option.letter, found.get(option.letter, "")) for option in before)


def _words(option: Option) -> str:
    return " ".join(option.text.split())


class AskedPart(msgspec.Struct, frozen=True):
    """One part as it was asked; `points` without the weight of the problem in the set."""

    id: str
    title: str
    types: tuple[str, ...]
    unit: str
    points: float


class Renamed(msgspec.Struct, frozen=True):
    """What today's file calls the problem, and what it calls givens and parts, by their names when it was handed out."""

    code: str = ""
    givens: dict[str, str] = {}
    parts: dict[str, str] = {}


class Edition(msgspec.Struct, frozen=True):
    """`statement` and `derivation` are the SHA-256 of the problem's file (with its pictures) and of its solution's; `units` are those of the
    givens, in their order; `weight` is the problem's in the set."""

    code: str
    statement: str
    derivation: str
    weight: float
    units: dict[str, str]
    parts: tuple[AskedPart, ...]
    renamed: Renamed = Renamed()

    @property
    def code_now(self) -> str:
        return self.renamed.code or self.code

    def given_now(self, symbol: str) -> str:
        return self.renamed.givens.get(symbol, symbol)

    def part_now(self, part: str) -> str:
        return self.renamed.parts.get(part, part)


def edition_of(problem: Problem, weight: float) -> Edition:
    """The edition that is handed out today."""
    return Edition(
        problem.code,
        fingerprint(problem),
        derivation_of(problem),
        weight,
        {given.symbol: canonical(given.unit) for given in problem.givens},
        tuple(
            AskedPart(part.id, part.title, part.answer_types, part.units_text, part.points)
            for part in problem.parts
        ),
    )


def fingerprint(problem: Problem) -> str:
    """The SHA-256 of the problem's file as it is, with its pictures."""
    return hashlib.sha256(packed_file(problem.path)).hexdigest()


def derivation_of(problem: Problem) -> str:
    """The fingerprint of the solution's file; empty where there is none."""
    try:
        return hashlib.sha256(source(bank_of(problem), problem)).hexdigest()
    except (NotDerivable, UnknownCode):
        return ""


def as_handed_out(today: Problem, edition: Edition, old: Problem | None) -> Problem:
    """The problem in the words, units and names in which it was handed out, with those of its parts that today's file has.

    `old` is the problem as its file was then (None: it can no longer be read, and today's words stand in). A part that was
    never asked is left out; a given that was added is there, and one that is gone stays for the sake of the words. Points are
    today's. The same object as `today` when nothing has changed.
    """
    asked = [part.id for part in edition.parts]
    if (
        edition.renamed == Renamed()
        and edition.statement == fingerprint(today)
        and asked == [part.id for part in today.parts]
    ):
        return today
    parts_before = {edition.part_now(part.id): part for part in edition.parts}
    givens_before = {edition.given_now(symbol): symbol for symbol in edition.units}
    givens = [_given(given, edition, givens_before.get(given.symbol), old) for given in today.givens]
    have = {given.symbol for given in givens}
    renamed = {now: before for before, now in edition.renamed.givens.items() if now in have and now != before}
    if old is not None:
        old = _in_letters(old, {before: now for now, before in renamed.items()})
    parts = [_part(part, parts_before[part.id], old) for part in today.parts if part.id in parts_before]
    gone = [
        given
        for given in (old.givens if old is not None else ())
        if given.symbol not in have and given.symbol not in renamed.values()
    ]
    words = old or today
    return replace(
        words,
        code=edition.code,
        givens=(*givens, *gone),
        conditions=today.conditions,
        parts=tuple(parts),
        name=today.name,
        topic=today.topic,
        path=today.path,
        written=today.as_written,
        renamed=tuple(renamed.items()),
    )


def parts_gone(edition: Edition, have: Collection[str], old: Problem | None) -> Problem:
    """The problem as it was handed out, without the parts that it still has; where its words are lost, the titles alone."""
    words = old or Problem(
        edition.code, edition.code, edition.code, "", "", "", (), (), (), "", "", Path(), 0
    )
    asked = {each.id for each in edition.parts}
    parts = [part for part in words.parts if part.id in asked and part.id not in have] or [
        Part(each.id, each.title, "", ("explain",), PURE, each.points, (), (), "", 0)
        for each in edition.parts
        if each.id not in have
    ]
    return replace(words, code=edition.code, parts=tuple(parts))


def _part(today: Part, asked: AskedPart, old: Problem | None) -> Part:
    """Today's part under the id, and in the words and the unit, it was asked in."""
    before = next((part for part in old.parts if part.id == asked.id), None) if old is not None else None
    label = asked.id if asked.id != today.id else ""
    if before is None or before.answer_types != today.answer_types:
        return replace(today, asked_as=label, unit=_same_dimension(today.unit, asked.unit))
    return replace(
        today,
        asked_as=label,
        title=before.title,
        text=before.text,
        lettered=before.lettered,
        unit=_same_dimension(today.unit, asked.unit),
        signature=before.signature,
        options=before.options,
        letters=letters_now(before.options, today.options) if before.options != today.options else (),
    )


def _in_letters(old: Problem, now: Mapping[str, str]) -> Problem:
    """The words of before with today's letters in their holes."""

    parts = tuple(
        replace(
            part,
            text=renamed(part.text, now),
            options=tuple(replace(option, text=renamed(option.text, now)) for option in part.options),
        )
        for part in old.parts
    )
    return replace(
        old,
        statement=renamed(old.statement, now),
        figure=renamed(in_letters(old.figure, now) if not is_svg(old.figure) else old.figure, now),
        figure_alt=renamed(old.figure_alt, now),
        parts=parts,
    )


def _given(today: Given, edition: Edition, before: str | None, old: Problem | None) -> Given:
    """Today's given in the unit, and with the decimals, it was handed out in."""
    if before is None:
        return today
    found = _same_dimension(today.unit, edition.units[before])
    then = next((given for given in old.givens if given.symbol == before), today) if old else today
    return replace(today, unit=found, places=then.places, words=then.words, as_written=then.as_written)


def _same_dimension(today: Unit, before: str) -> Unit:
    """The unit of before, if it measures the same: else it was a mistake, and the number is meant in today's."""
    try:
        found = unit(before)
    except ValueError:  # of a package that is gone
        return today
    return found if found.dimension == today.dimension else today


def values_now(problem: Problem, edition: Edition, handed_out: Mapping[str, Fraction]) -> dict[str, Fraction]:
    """The numbers of a problem as it was handed out, by its symbols: those handed out, the printed ones for what was added."""
    by_name_now = {edition.given_now(symbol): value for symbol, value in handed_out.items()}
    todays = {given.symbol for given in problem.as_written.givens}
    gone = {symbol: value for symbol, value in handed_out.items() if symbol not in todays}
    known = gone | by_name_now
    return {given.symbol: known.get(given.symbol, given.value) for given in problem.givens}


GONE = "-"  # in the place of a new name: it has none, somebody said so


class NotSettled(LookupError):
    """A name may have changed, and nobody has said whether: numbers could move; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Rename:
    """`what` is the problem, a given or a part; `why` is what speaks for it."""

    edition: Edition
    what: str
    before: str
    now: str
    why: str

    @property
    def sentence(self) -> str:
        of = "" if self.what == "problem" else f"{self.edition.code}: "
        return f"{of}the {self.what} {self.before} looks renamed to {self.now} ({self.why})"


def proposed(
    edition: Edition, problems: Sequence[Problem], known: Iterable[str], old: Problem | None
) -> list[Rename]:
    """What of an edition looks renamed among today's problems; `known` are the codes that other editions go by, `old` is the
    problem as its file was."""
    today = next((each for each in problems if each.code == edition.code_now), None)
    if today is not None:
        return [*_givens(edition, today, old), *_parts(edition, today)]
    if edition.renamed.code == GONE:
        return []
    elsewhere = set(known)
    alike = [each for each in problems if each.code not in elsewhere and _alike(edition, each)]
    if len(alike) != 1:
        return []
    return [Rename(edition, "problem", edition.code, alike[0].code, "the same givens and parts")]


def _alike(edition: Edition, problem: Problem) -> bool:
    """Whether it has the same givens in the same units, and the same parts."""
    units = {given.symbol: canonical(given.unit) for given in problem.givens}
    parts = [(part.id, part.title) for part in problem.parts]
    return units == edition.units and parts == [(part.id, part.title) for part in edition.parts]


def _givens(edition: Edition, today: Problem, old: Problem | None) -> list[Rename]:
    have = {given.symbol for given in today.givens}
    printed = {given.symbol: given.value for given in old.givens} if old is not None else {}
    before = {edition.given_now(symbol): symbol for symbol in edition.units}
    gone = [before[symbol] for symbol in before if symbol not in have and symbol != GONE]
    new = [given for given in today.givens if given.symbol not in before]
    found: list[Rename] = []
    for symbol in gone:
        alike = [
            given
            for given in new
            if canonical(given.unit) == edition.units[symbol]
            and printed.get(symbol, given.value) == given.value
        ]
        if len(alike) == 1:
            found.append(Rename(edition, "given", symbol, alike[0].symbol, "the same unit and printed value"))
    return _one_to_one(found)


def _parts(edition: Edition, today: Problem) -> list[Rename]:
    have = {part.id for part in today.parts}
    before = {edition.part_now(part.id) for part in edition.parts}
    gone = [part for part in edition.parts if edition.part_now(part.id) not in have | {GONE}]
    new = [part for part in today.parts if part.id not in before]
    found = [
        Rename(edition, "part", part.id, alike[0].id, "the same title and kind of answer")
        for part in gone
        if len(alike := [each for each in new if (each.title, each.answer_types) == (part.title, part.types)])
        == 1
    ]
    return _one_to_one(found)


def _one_to_one(found: list[Rename]) -> list[Rename]:
    """Without those that lead to the same new name: neither is clear."""
    names = [each.now for each in found]
    return [each for each in found if names.count(each.now) == 1]


def settled(edition: Edition, renames: Iterable[Rename], *, agreed: bool) -> Edition:
    """The edition with the names of today, or with the word that these are no renames."""
    renamed = edition.renamed
    for each in renames:
        now = each.now if agreed else GONE
        if each.what == "problem":
            renamed = msgspec.structs.replace(renamed, code=now)
        elif each.what == "given":
            renamed = msgspec.structs.replace(renamed, givens=renamed.givens | {each.before: now})
        else:
            renamed = msgspec.structs.replace(renamed, parts=renamed.parts | {each.before: now})
    return msgspec.structs.replace(edition, renamed=Renamed(renamed.code, renamed.givens, renamed.parts))
