"""`corollary export --person` and `--archive`: one student's data, or a whole term, as one file."""

from __future__ import annotations

from dataclasses import asdict
from datetime import date
from pathlib import Path

from corollary.atomic import write_whole
from corollary.cli.ending import HOLDS, answer, counted, refuse, say
from corollary.cli.export_options import ExportOptions
from corollary.cli.terminal import countdown
from corollary.records.files import Course, one_writer, open_course
from corollary.records.person import find_person


def run(given: ExportOptions) -> int:
    if given["to"] or given["sets"]:
        refuse("--person and --archive are of the whole course; leave out the set and --to")
    if given["person"] is not None and given["archive"]:
        refuse("--person and --archive are two files; give one of them")
    if given["course"] is None:
        refuse("the working folder is not in a course; name the course with --course")
    course = open_course(given["course"])
    if given["person"] is not None:
        return _person(course, given["person"], given)
    return _archive(course, given)


def _person(course: Course, name: str, given: ExportOptions) -> int:
    from corollary.course.personal_data import person_archive

    if given["keep_until"] is not None:
        refuse("--keep-until is for --archive; leave it out")
    person = find_person(course, name)
    content, found = person_archive(course, person)
    place = _place(given["output"], f"{person.id}.zip")
    write_whole(place, content, mode=0o600)
    for where, why in found.left.items():
        say(f"{where} is not in it: {why}")
    if given["as_json"]:
        places = [asdict(each) for each in found.places]
        answer({"student": person.id, "file": str(place), "places": places, "left": found.left})
    else:
        print(f"{person.id}: {counted(len(found.places), 'place')} of the course in {place}")
    return HOLDS


def _archive(course: Course, given: ExportOptions) -> int:
    from corollary.course.term_archive import write_archive

    until = given["keep_until"]
    if until is None:
        refuse("say until when the archive is to be stored: --keep-until 2031-09-30")
    if until.date() <= date.today():
        refuse(f"--keep-until {until:%Y-%m-%d} has passed already; give a later day")
    place = _place(given["output"], f"{course.name}-archive.zip")
    with one_writer(course), countdown("archive") as progress:
        count = write_archive(course, until.date(), place, lambda name: progress(name, 1))
    if given["as_json"]:
        answer({"file": str(place), "files": count, "keep_until": f"{until:%Y-%m-%d}"})
    else:
        print(f"{counted(count, 'file')} of {course.folder} in {place}, to be stored until {until:%Y-%m-%d}")
    return HOLDS


def _place(output: Path | None, usual: str) -> Path:
    place = output or Path(usual)
    return place / usual if place.is_dir() else place
