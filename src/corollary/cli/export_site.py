"""`corollary export --to site`: the page to practise on as a folder of files that works offline."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from corollary.atomic import write_whole
from corollary.cli.ending import HOLDS, answer, refuse, say, unforeseen
from corollary.cli.export_options import ExportOptions
from corollary.cli.open_sets import course_in, not_to_be_practised, say_broken, with_sets
from corollary.cli.terminal import bar
from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.grading.assign import NoVariant
from corollary.practice.practice import Practice, practice
from corollary.problem.bank import Bank, codes, open_bank
from corollary.problem.problem_set import set_names
from corollary.render.practice_site import (
    NoPyodide,
    NoSnapshot,
    exercise_file,
    fetched,
    page_file,
    python_files,
    snapshot_file,
)
from corollary.user_cache import folder

USUAL_TURNS = 5


def run(named: Sequence[str], given: ExportOptions) -> int:
    """Sets, problems or topics, all of the bank when none is named; the last is the folder, unless that is an option."""
    opened, course = open_bank(given["bank"]), course_in(given["course"])
    try:
        words, output = _wanted(opened, named, given["output"])
        wanted = with_sets(opened, words, course)
        found = practice(opened, wanted, not_to_be_practised(opened, given["left_out"], course))
        python = given["pyodide"] or fetched(folder() or output)
        files = dict(python_files(python))
    except (LookupError, NoPyodide) as error:
        refuse(str(error))
    say_broken(found)
    exercises, refused = exercise_files(found, given["variants"] or USUAL_TURNS)
    files |= exercises
    found.problems = tuple(each for each in found.problems if each.code not in refused)
    for code, why in refused.items():
        say(f"{code} is left out, since its answers cannot be derived: {why}")
    if not found.problems:
        refuse("no problem is left to practise on")
    files["index.html"] = page_file(found)
    try:
        name, content = snapshot_file(python, found)
        files[name] = content
    except NoSnapshot as error:
        say(f"the page takes some seconds more to judge its first answer: {error}")
    for name, content in files.items():
        write_whole(output / name, content)
    size = sum(map(len, files.values()))
    if given["as_json"]:
        codes = [each.code for each in found.problems]
        answer(
            {"to": "site", "files": [str(output / name) for name in files], "problems": codes, "bytes": size}
        )
    else:
        print(f"{len(found.problems)} exercises, {size / 1e6:.1f} MB: open {output / 'index.html'}")
    return HOLDS


def exercise_files(found: Practice, turns: int) -> tuple[dict[str, bytes], dict[str, str]]:
    """The file of each exercise, by name, and what is wrong with the others, by code."""
    files, refused = dict[str, bytes](), dict[str, str]()
    with bar("exercises", len(found.problems)) as done:
        for problem in found.problems:
            try:
                files[f"exercises/{problem.code}.js"] = exercise_file(found, problem, turns)
            except (NotDerivable, NoVariant, Undefined) as error:
                refused[problem.code] = str(error)
            except Exception as error:  # it costs this problem, and no other
                refused[problem.code] = unforeseen(error)
            done(problem.code)
    return files, refused


def _wanted(bank: Bank, named: Sequence[str], output: Path | None) -> tuple[list[str], Path]:
    """What is named, and the folder."""
    wanted = list(named)
    if output is None:
        if not wanted:
            refuse("name the folder for the site: corollary export --to site DIR")
        place = wanted.pop()
        if place in {*set_names(bank), *codes(bank).values()}:
            refuse(
                f"{place} is in the bank; name the folder for the site last: corollary export {place} --to site DIR"
            )
        output = Path(place)
    if output.exists() and not output.is_dir():
        refuse(f"{output} is a file; name a folder for the site")
    return wanted, output
