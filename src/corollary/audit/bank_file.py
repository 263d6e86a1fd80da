"""A file of records, or of a bank whose exercises are joined with the laws that somebody states for them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from corollary.audit.record import ExerciseRecord
from corollary.audit.record_file import records_in
from corollary.problem.diagnostic import Diagnostic, Malformed

RECORDS = {".yaml", ".yml", ".json", ".csv"}
READERS: Mapping[str, Callable[[Path], tuple[ExerciseRecord, ...]]] = {}
"""By the ending of a file's name, what reads a bank of that kind."""


def records_of(path: Path, laws: Mapping[str, ExerciseRecord]) -> tuple[ExerciseRecord, ...]:
    """The records of a file; `laws` are those of exercises by their id. Raises Malformed."""
    ending = path.suffix.lower()
    if ending in RECORDS:
        return tuple(
            joined(each, laws.get(each.id)) if each.id in laws else each for each in records_in(path)
        )
    if ending not in READERS:
        known = ", ".join(sorted({*RECORDS, *READERS}))
        raise Malformed([Diagnostic(path, 1, f"is of no kind that is read here ({known})")])
    return tuple(joined(each, laws.get(each.id)) for each in READERS[ending](path))


def laws_by_id(path: Path | None) -> dict[str, ExerciseRecord]:
    """What a file of laws states for each exercise. Raises Malformed."""
    return {each.id: each for each in records_in(path, answers=False)} if path is not None else {}


def joined(exercise: ExerciseRecord, stated: ExerciseRecord | None) -> ExerciseRecord:
    """An exercise of a bank with the laws stated for it: these say what is asked, and take precedence in what both say."""
    if stated is None:
        if exercise.unread or exercise.laws or exercise.problem:
            return exercise
        return replace(
            exercise, unread=f"no laws are stated for {exercise.id}; write them in a file for --laws"
        )
    own = {each.symbol: each for each in exercise.given} | {each.symbol: each for each in stated.given}
    published = stated.published or exercise.published
    if exercise.unread and not stated.published:
        return exercise
    if len(published) != len(stated.asked):
        why = f"it publishes {len(published)} answers, and the laws are for {len(stated.asked)}"
        return replace(exercise, unread=why)
    return replace(
        stated,
        path=exercise.path,
        line=exercise.line,
        given=tuple(own.values()),
        published=published,
        source=exercise.source or stated.source,
        statement=exercise.statement or stated.statement,
    )
