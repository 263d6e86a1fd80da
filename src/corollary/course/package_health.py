"""Check of the packages that sets and courses declare: installed here, and imported in isolation as a notebook does."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress

from corollary.plug_ins import PlugInFault
from corollary.problem.bank import UnknownCode
from corollary.problem.diagnostic import Finding, Malformed
from corollary.problem.packages import INSTALLED_AS, is_installed, version_of
from corollary.records.files import Course, NotACourse
from corollary.records.origin import set_of
from corollary.records.settings import FILE, Settings
from corollary.sandbox.isolation import WeakIsolation
from corollary.sandbox.job import Cell, Job
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart


def package_findings(course: Course | None, settings: Settings) -> Iterator[Finding]:
    """One finding for each declared package; none where nothing is declared."""
    declared = _declared(course, settings)
    for name, places in declared.items():
        if not is_installed(name):
            install = f"pip install {INSTALLED_AS.get(name, name)}"
            sentence = (
                f"declared by {places}, and not installed: parts whose cells import it wait for a person"
            )
            yield Finding(f"package {name}", "broken", sentence, f"{install}, then corollary grade SET")
    there = [name for name in declared if is_installed(name)]
    errors = _errors(there)
    for name in there:
        if error := errors.get(name, ""):
            sentence = f"declared by {declared[name]}, and cannot be imported in isolation ({error})"
            yield Finding(f"package {name}", "broken", sentence, "install another version of it")
        else:
            yield Finding(
                f"package {name}", "good", f"{version_of(name)}, declared by {declared[name]}".lstrip(", ")
            )


def _declared(course: Course | None, settings: Settings) -> dict[str, str]:
    """The packages, each with who declares it."""
    places: dict[str, list[str]] = {name: [FILE] for name in settings.packages or ()}
    if course is None:
        return dict.fromkeys(places, FILE)
    for path in sorted(course.record("origin", "any").parent.glob("*.json")):
        with suppress(
            UnknownCode, Malformed, NotACourse, PlugInFault
        ):  # of the set itself another finding tells
            for name in set_of(course, path.stem)[1].packages or ():
                if name not in (settings.packages or ()):
                    places.setdefault(name, []).append(path.stem)
    return {name: ", ".join(those) for name, those in places.items()}


def _errors(names: list[str]) -> Mapping[str, str]:
    """What importing each gives in a notebook, where it fails; nothing where no notebook can be run, which another finding says."""
    if not names:
        return {}
    job = Job(tuple(Cell(name, f"import {name}") for name in names), (), pictures=False)
    try:
        with Runner() as runner:
            ran = runner.execute(job)
    except (CannotStart, WeakIsolation, OSError):
        return {}
    return {run.id: run.error or run.status for run in ran.cells if run.status != "ok"}
