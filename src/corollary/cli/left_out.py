"""Options that were left out, as the course has them: the folder around the working one, and what its settings say."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from corollary.cli.ending import refuse

COURSE, BANK = "COROLLARY_COURSE", "COROLLARY_BANK"
MARKS = ("corollary.toml", ".corollary/key")  # by which a course's folder is known
# The options that a setting stands in for, by the setting's name; and what holds without either.
STANDS_FOR: dict[str, tuple[str, object]] = {
    "jobs": ("jobs", None),
    "executor": ("executor", ""),
    "isolation": ("require", 1),
}


def completed(options: Mapping[str, Any], *, course_needed: bool, any_bank: bool) -> dict[str, Any]:
    """The options of a command with the course's own for those left out; what was given wins.

    `course_needed`: the command works in a course only. `any_bank`: its problems may come from any bank, so that the course's
    is the usual one. Raises Malformed when the settings cannot be read.
    """
    found = dict(options)
    wanted = found.pop("language", None)
    if not {"course", "bank"} & found.keys():
        return found
    folder = found.get("course") or course_around()
    if folder is None and course_needed:
        refuse(
            "the working folder is not in a course; name the course with --course, or change into its folder"
        )
    _write_for_the_team(folder)
    settings = _settings(folder)
    if wanted:
        _speak(wanted)
    if "course" in found and (course_needed or _has_room_for_a_course(found)):
        found["course"] = folder
    for name, (option, usual) in STANDS_FOR.items():
        if option in found and found[option] in (None, ""):
            found[option] = settings.get(name, usual)
    if any_bank and "bank" in settings and not found["bank"] and not os.environ.get(BANK):
        found["bank"] = [settings["bank"]]
    return found


def _write_for_the_team(folder: Path | None) -> None:
    """In a course that a group shares, all that this process makes is for the group, and for nobody else."""
    from corollary.atomic import is_shared

    if folder is not None and os.name != "nt" and folder.is_dir() and is_shared(folder):
        os.umask(0o007)


def _settings(folder: Path | None) -> dict[str, Any]:
    """What the course's file says; nothing where there is none. Raises Malformed."""
    if folder is None or not (folder / MARKS[0]).is_file():
        return {}
    from corollary.messages import speak
    from corollary.records.settings import read_settings  # brings time zones: only where there are settings

    settings = read_settings(folder)
    if settings.language:
        speak(settings.language)
    named = {name: getattr(settings, name) for name in (*STANDS_FOR, "bank")}
    return {name: value for name, value in named.items() if value not in (None, "")}


def _speak(code: str) -> None:
    """The language named on the command line, from here on."""
    from corollary.messages import languages, speak

    if code not in (have := languages()):
        refuse(f"--language {code}: the texts are there in {', '.join(have)}; give one of these")
    speak(code)


def course_around() -> Path | None:
    """The course that the environment names, or in whose folder the command runs; None when there is none."""
    named = os.environ.get(COURSE)
    return Path(named) if named else find_course(Path.cwd())


def find_course(start: Path) -> Path | None:
    """The course folder that a folder is, or lies in: a course was made there, or is set up. None when there is none."""
    start = start.resolve()
    for folder in (start, *start.parents):
        if any((folder / mark).is_file() for mark in MARKS):
            return folder
    return None


def _has_room_for_a_course(options: Mapping[str, Any]) -> bool:
    """Whether a course that nobody named may choose the numbers: nothing else does, and a student is named where one must be.

    What is exported for everybody has no numbers of a course; of a site a course only says what is not due yet.
    """
    if options.get("person") or options.get("archive"):
        return True
    if "apart" in options:
        if not options["to"]:
            return False
        from corollary.render.exports import target  # only here: it is about to be loaded

        if (made := target(options["to"])).site or made.items is not None:
            return made.site
    chosen = tuple(map(options.get, ("roster", "variants", "variant", "forms")))
    return not any(each is not None for each in chosen) and options.get("student", "") is not None
