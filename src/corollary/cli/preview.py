"""`corollary preview`: a local page on which an author writes a problem and sees its variants, complaints and proofs."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, cast

from corollary.cli.author_words import author_words
from corollary.cli.draft import DraftChecker, draft_of
from corollary.cli.ending import HOLDS, Refusal
from corollary.cli.local_page import OnePageServer, edition, serve
from corollary.cli.new import NAME, NO_TOPIC, create
from corollary.problem.author_files import (
    SIDES,
    AuthorFile,
    ChangedOnDisk,
    Edited,
    Side,
    locked_place,
    pair,
    problem_names,
    read_author_file,
    write_author_files,
)
from corollary.problem.bank import Bank, codes, home_of_file
from corollary.render.preview_page import preview_page


def run(code: str, bank: Path | None, no_browser: bool, port: int) -> int:
    place, path = home_of_file(bank, code)
    with tempfile.TemporaryDirectory(prefix="corollary-preview-", ignore_cleanup_errors=True) as folder:
        checker = DraftChecker(Path(folder))
        try:
            editor = Editor(place, path, checker)
            server = OnePageServer(lambda: preview_page(author_words()), editor.answered, port)
            serve(server, "write, save with ctrl-S in the page; ctrl-C here ends it", no_browser)
        finally:
            checker.end()
    return HOLDS


class StalePage(ValueError):
    """A request that this page never sends."""


class Editor:
    """What the page is answered. It names problems of the bank and one of two sides, and never a path."""

    def __init__(self, place: Bank, path: Path, checker: DraftChecker) -> None:
        self.place, self.first, self.checker = place, path, checker
        self.programs = any(each.has_programs for each in place.each)  # said when the command began
        self.requests: Mapping[str, Callable[[dict[str, Any]], dict[str, Any]]] = {
            "open": self.opened,
            "check": self.check,
            "look": self.look,
            "cancel": self.cancel,
            "save": self.save,
            "new": self.new,
        }

    def answered(self, posted: dict[str, Any]) -> str:
        """The answer to one request, as JSON. Raises ValueError with a sentence for what is refused."""
        request = self.requests.get(str(posted.get("ask")))
        if request is None:
            raise StalePage("this page belongs to another edition of Corollary; reload it")
        try:
            return json.dumps(request(posted))
        except (KeyError, TypeError, AttributeError):
            raise StalePage("this page belongs to another edition of Corollary; reload it") from None
        except Refusal as error:
            raise ValueError(str(error)) from None

    def opened(self, posted: dict[str, Any]) -> dict[str, Any]:
        """The two texts of a problem, the first one's when none is named, and the names of all."""
        names, have = problem_names(self.place), codes(self.place)
        wanted = str(posted["problem"]) or self._first(names)
        path = self._path(wanted)
        home = self.place.home_of(path)
        return {
            "problem": wanted,
            "problems": [{"name": name, "code": have.get(each, "")} for name, each in names.items()],
            "files": {side: self._record(home, each) for side, each in pair(self.place, path).items()},
            "edition": edition(self.place, path),
            "new": not locked_place(home, path.with_name("new.md")),
        }

    def check(self, posted: dict[str, Any]) -> dict[str, Any]:
        """Begin to check a draft."""
        texts: dict[Side, str] = {
            side: str(posted["texts"][side]) for side in SIDES if side in posted["texts"]
        }
        draft = draft_of(self.place, self._path(posted["problem"]), texts, self.programs)
        return {"number": self.checker.check(draft)}

    def look(self, posted: dict[str, Any]) -> dict[str, Any]:
        """What was found by now, with the variants only where the page has not those of this draft; and the edition of the files."""
        progress, path = self.checker.look(), self._path(posted["problem"])
        found = asdict(progress) | {"edition": edition(self.place, path), "shown": bool(progress.html)}
        if posted["has"] == progress.number:
            del found["html"]
        return found

    def cancel(self, _: dict[str, Any]) -> dict[str, Any]:
        self.checker.cancel()
        return {}

    def save(self, posted: dict[str, Any]) -> dict[str, Any]:
        """Write the files that are named, or say which have changed on the disk since; then none is written."""
        path, files = self._path(posted["problem"]), cast(dict[str, dict[str, Any]], posted["files"])
        if not files or not set(files) <= set(SIDES):
            raise StalePage("only the problem and its solution are written")
        edited: dict[Side, Edited] = {
            side: Edited(str(files[side]["text"]), str(files[side]["fingerprint"]))
            for side in SIDES
            if side in files
        }
        try:
            found, conflict = write_author_files(self.place, path, edited), False
        except ChangedOnDisk as error:
            found, conflict = error.files, True
        records = {side: self._of(each) for side, each in found.items()}
        return {
            "conflict": [*records] if conflict else [],
            "files": records,
            "edition": edition(self.place, path),
        }

    def new(self, posted: dict[str, Any]) -> dict[str, Any]:
        """Create a problem as `corollary new` does, in the bank and the topic of the one that is open."""
        path = self._path(posted["problem"])
        home, code, name = self.place.home_of(path), str(posted["code"]).strip(), str(posted["name"]).strip()
        topic = NO_TOPIC if path.parent == home.problems else path.parent.name
        wanted = name if "/" in name else f"{topic}/{name}"
        if NAME.match(wanted):  # else `create` says what is wrong with it
            problem = home.problems / f"{wanted}.md"
            for each in (problem, home.solution_beside(problem)):
                if why := locked_place(home, each):
                    raise ValueError(why)
        create(home, code, wanted)
        return {"problem": wanted}

    def _first(self, names: Mapping[str, Path]) -> str:
        return next(name for name, path in names.items() if path.resolve() == self.first.resolve())

    def _path(self, name: object) -> Path:
        """The problem of that name. Raises ValueError for what is none of the bank's."""
        path = problem_names(self.place).get(str(name))
        if path is None:
            raise ValueError(f"{name} is no problem of this bank; reload the page")
        return path

    def _record(self, home: Bank, path: Path) -> dict[str, str]:
        return self._of(read_author_file(home, path)) | {"name": path.relative_to(home.folder).as_posix()}

    @staticmethod
    def _of(file: AuthorFile) -> dict[str, str]:
        return {"text": file.text, "fingerprint": file.fingerprint, "locked": file.locked}
