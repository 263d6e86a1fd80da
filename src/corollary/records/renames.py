"""Names that look changed since a problem was handed out: proposed, and taken only when somebody agrees."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from msgspec.structs import replace

from corollary.problem.problem import Problem
from corollary.records.edition import Edition, Renamed
from corollary.units.unit import canonical

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
            renamed = replace(renamed, code=now)
        elif each.what == "given":
            renamed = replace(renamed, givens=renamed.givens | {each.before: now})
        else:
            renamed = replace(renamed, parts=renamed.parts | {each.before: now})
    return replace(edition, renamed=Renamed(renamed.code, renamed.givens, renamed.parts))
