"""Folders and pages of one student in nbgrader's exchange."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

import hashlib
from collections.abc import Collection
from contextlib import suppress
from glob import escape
from pathlib import Path

from corollary.nbgrader.gradebook import directory, has_nbgrader
from corollary.records.files import Course


def exchange_places(course: Course, student: str, pages: Collection[str]) -> list[Path]:
    """What a student handed in and was given there; `pages` are digests of feedback pages, whose names there say nothing.

    None where the course has no exchange, or none that can be reached. Raises NoNbgrader, BrokenConfig.
    """
    if not has_nbgrader() or not (course.folder / "nbgrader_config.py").exists():
        return []
    from nbgrader.exchange.default import Exchange

    coursedir = directory(course)
    name = str(coursedir.course_id)
    if not name:
        return []
    root = Path(str(Exchange(coursedir=coursedir, config=coursedir.config).root)) / name
    found: list[Path] = []
    with suppress(OSError):  # it is not there, or not open to this account
        found += sorted(root.glob(f"inbound/{escape(student)}+*"))
        found += sorted(root.glob(f"outbound/*/{escape(student)}"))
        for page in root.glob("feedback/*/*.html"):
            if hashlib.sha256(page.read_bytes()).hexdigest() in pages:
                found.append(page)
    return found
