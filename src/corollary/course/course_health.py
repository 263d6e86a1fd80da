"""Checks of a course's files: settings, key, roster, who may read them, and whether another run is at work."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from corollary.problem.diagnostic import Finding, Malformed
from corollary.records.files import Course, NotACourse, at_work, open_course, students
from corollary.records.settings import FILE, Settings, read_settings

FOR_OTHERS, TO_ENTER = 0o044, 0o011  # bits by which others read a file, and enter a folder
WRITTEN_IN = ("", ".corollary", "submitted", "autograded", "feedback", "reports")


def of_course(folder: Path) -> tuple[Course | None, Settings, list[Finding]]:
    """The course in a folder, as far as it can be opened, its settings, and what was found. Nothing is changed."""
    course, settings = None, Settings()
    found: list[Finding] = []
    path = folder / FILE
    try:
        settings = read_settings(folder)
        found.append(Finding("settings", "good", str(path) if path.exists() else f"no {FILE}; all as usual"))
    except Malformed as error:
        found.append(Finding("settings", "broken", str(error), f"correct {path}"))
    try:
        course = open_course(folder)
    except NotACourse as error:
        there = (folder / ".corollary").is_dir()
        remedy = (
            "restore .corollary from a backup: every number and every key follow from it"
            if there
            else "name the course with --course, or generate a set"
        )
        return None, settings, [*found, Finding("course", "broken", str(error), remedy)]
    return course, settings, [*found, _roster(course), *_rights(course.folder), *_work(course)]


def _roster(course: Course) -> Finding:
    try:
        count = len(students(course))
    except NotACourse as error:
        path = course.folder / ".corollary" / "roster.csv"
        away = f"move {path} away, then " if path.is_dir() else ""
        return Finding("course", "broken", str(error), f"{away}corollary generate SET --roster FILE")
    if not count:
        remedy = "corollary generate SET --roster FILE"
        return Finding("course", "broken", f"{course.folder}, nobody on the roster", remedy)
    return Finding("course", "good", f"{course.folder}, {count} on the roster")


def _rights(folder: Path) -> Iterator[Finding]:
    """Who may read the key, and whether we may write."""
    secret = folder / ".corollary"
    if os.name != "nt":
        if secret.stat().st_mode & TO_ENTER and (secret / "key").stat().st_mode & FOR_OTHERS:
            yield Finding(
                "key",
                "broken",
                f"{secret / 'key'} can be read by others, and every answer follows from it",
                f"chmod 700 {secret} && chmod 600 {secret / 'key'}",
            )
        else:
            yield Finding("key", "good", "for you alone")
    for name in WRITTEN_IN:
        place = folder / name
        if place.is_dir() and not os.access(place, os.R_OK | os.W_OK | os.X_OK):
            yield Finding("rights", "broken", f"{place} cannot be written in by you", f"chmod u+rwx {place}")
        elif place.exists() and not place.is_dir():
            yield Finding("rights", "broken", f"{place} is no folder", "move it away")


def _work(course: Course) -> Iterator[Finding]:
    """A lock goes with the process that held it, however it ended, so there is none to be removed by hand."""
    if at_work(course):
        yield Finding("lock", "weak", "another run is at work in the course", "wait until it is done")
