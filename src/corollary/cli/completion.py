"""Completion of a word in the shell: codes, sets, students, scenes and targets, as they are where the command runs."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import click

Complete = Callable[[click.Context, click.Parameter, str], list[str]]


def _completes(names: Callable[[dict[str, Any]], Iterable[str]]) -> Complete:
    """The names that begin with what is typed, capital or not; none where there is no bank or course to ask."""

    def complete(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
        try:
            found = sorted(set(names(ctx.params)))
        except (
            Exception
        ):  # while a line is typed, whatever is wrong with a bank or a course is nobody's question
            return []
        return [name for name in found if name.lower().startswith(incomplete.lower())]

    return complete


def _bank(options: dict[str, Any]) -> Any:
    from corollary.cli.left_out import completed
    from corollary.problem.bank import open_bank

    places = completed({"bank": list(options.get("bank") or ())}, course_needed=False, any_bank=True)["bank"]
    return open_bank(Path(os.pathsep.join(map(str, places))) if places else None)


def _course(options: dict[str, Any]) -> Path | None:
    from corollary.cli.left_out import course_around

    return options.get("course") or course_around()


def _codes(options: dict[str, Any]) -> Iterable[str]:
    from corollary.problem.bank import names

    return names(_bank(options))


def _sets(options: dict[str, Any]) -> Iterable[str]:
    from corollary.problem.problem_set import set_names

    course = _course(options)
    origins: list[Path] = [] if course is None else list((course / ".corollary" / "origin").glob("*.json"))
    return [*set_names(_bank(options)), *(path.stem for path in origins)]


def _students(options: dict[str, Any]) -> Iterable[str]:
    from corollary.records.files import open_course, students

    course = _course(options)
    return [] if course is None else [each.id for each in students(open_course(course))]


def _scenes(options: dict[str, Any]) -> Iterable[str]:
    from corollary.derive.ready_scenes import ready_scenes

    return ready_scenes(_bank(options))


def _targets(options: dict[str, Any]) -> Iterable[str]:
    from corollary.render.exports import names

    return names()


def _formats(options: dict[str, Any]) -> Iterable[str]:
    from corollary.render.exports import names_for_exercises

    return names_for_exercises()


def _topics(options: dict[str, Any]) -> Iterable[str]:
    from corollary.problem.bank import files

    return (path.parent.name for path in files(_bank(options)))


CODES, SETS, STUDENTS = _completes(_codes), _completes(_sets), _completes(_students)
SCENES, TARGETS, TOPICS = _completes(_scenes), _completes(_targets), _completes(_topics)
FORMATS = _completes(_formats)
CODES_AND_SETS = _completes(lambda options: [*_codes(options), *_sets(options)])
