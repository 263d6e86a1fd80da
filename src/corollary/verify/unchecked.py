"""Which of the author's laws nothing checks beyond dimensions: no printed value, no scene, and nothing that must hold besides."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.derive.derivation import Asserted
from corollary.derive.load import NotDerivable, load
from corollary.derive.put_back import unseen
from corollary.derive.simulation import Seen, Simulation, simulations
from corollary.derive.statements import Printed
from corollary.grading.key import Key
from corollary.grading.neglect import neglected_in
from corollary.grading.replay import ancestors
from corollary.problem.bank import Bank
from corollary.verify.checked import Tally
from corollary.verify.walk import check_scene

OTHER = 1.25  # times an answer: what a scene must find for it then is something else


def note_unchecked(bank: Bank, key: Key, tally: Tally) -> None:
    """One note that names the laws in which a wrong sign would not be seen. Raises NotDerivable."""
    missing = list(_unchecked(bank, key))
    if missing:
        path = bank.solution(key.variant.problem)
        tally.note(
            f"{path.name}:{missing[0][1]}: nothing but dimensions checks the signs of "
            f"{', '.join(f'{name} (line {line})' for name, line in missing)}; "
            "confirm(…), limit(…), at(…), a scene or printed(…) would"
        )


def _unchecked(bank: Bank, key: Key) -> Iterator[tuple[str, int]]:
    solution = key.solution
    parts = {entry.statement.part for entry in solution.entries if isinstance(entry, Printed)}
    parts |= set(_in_scenes(bank, key))
    seen: set[int] = set()
    for place, find in enumerate(solution.unknowns):
        if find.part in parts:
            seen |= {place, *ancestors(solution, place)}
    claimed = any(isinstance(entry, Asserted) for entry in load(bank, solution.problem).derivation.entries)
    for place, find in enumerate(solution.unknowns):
        if place in seen or not find.laws:
            continue
        line = find.statement.line
        names = (
            unseen(bank, solution.problem, line)
            if claimed and not solution.case
            else [law.name for law in find.laws]
        )
        yield from ((name, line) for name in names)


def _in_scenes(bank: Bank, key: Key) -> Iterator[str]:
    """The parts whose answers a scene is held against: with another answer it expects something else, or shows something else."""
    answers: dict[str, Seen] = {part: truth.value for part, truth in key.truths.items()}
    neglected = neglected_in(key)
    usual = simulations(bank, key.variant, answers, neglected)
    for part, value in answers.items() if usual else ():
        other = tuple(OTHER * x for x in value) if isinstance(value, tuple) else OTHER * value
        try:
            found = simulations(bank, key.variant, answers | {part: other}, neglected)
        except NotDerivable:  # the scene cannot even be made with another answer, such as a sine of 1.1
            yield part
            continue
        if [dict(each.expect) for each in found] != [dict(each.expect) for each in usual] or any(
            map(_differs, found, usual)
        ):
            yield part


def _differs(other: Simulation, usual: Simulation) -> bool:
    """Whether what an answer changes in a scene itself, such as a force, contradicts what the scene must show."""
    if isinstance(other.scene, str) and other.settings == usual.settings:
        return False
    tally = Tally()
    check_scene(other, usual.name, tally)
    return bool(tally.complaints)
