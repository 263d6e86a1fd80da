"""A draft of a problem, laid out beside its bank and checked in a process of its own: complaints, then variants, then proofs."""

from __future__ import annotations

import os
import re
import shutil
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import get_all_start_methods, get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path
from threading import Lock, Thread
from typing import Any, Literal

from corollary.cli.ending import unforeseen
from corollary.cli.variant_sheets import rendered_variants
from corollary.derive.load import NotDerivable, load
from corollary.grading.replay import forget_scenes
from corollary.messages import language, spoken
from corollary.parallel import begin
from corollary.problem.author_files import Side
from corollary.problem.bank import Bank, codes, open_bank
from corollary.problem.diagnostic import Malformed, name_in_bank
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem
from corollary.verify.expected_answers import unexpected
from corollary.verify.program_checks import unstarted
from corollary.verify.verify import SLOW, Verification

PLACE = re.compile(r"(?P<name>[^:]+):(?:(?P<line>\d+):)? (?P<sentence>.*)", re.DOTALL)
WARM = "corollary.cli.draft_warm"
SAVED_ONLY = "this page does not run programs that were put beside the solutions after it was opened"


@dataclass(frozen=True, slots=True)
class Draft:
    """The texts to check of the problem at `path` of a bank; those left out are as they are saved."""

    place: str
    path: Path
    texts: Mapping[Side, str]
    spoken: str
    programs: bool


@dataclass(frozen=True, slots=True)
class PlacedComplaint:
    """`side` is "" and `line` 0 for what has no place in the two texts."""

    side: Side | Literal[""]
    line: int
    sentence: str


@dataclass(slots=True)
class Progress:
    """What was found of a draft so far. `stage` is "" when all is done; `html` shows its variants, "" where they are not there
    yet; `ok` is None while a check may still fail."""

    number: int
    stage: str = "reading"
    complaints: list[PlacedComplaint] = field(default_factory=list[PlacedComplaint])
    notes: list[PlacedComplaint] = field(default_factory=list[PlacedComplaint])
    checks: int = 0
    ok: bool | None = None
    summary: str = ""
    html: str = ""
    began: float = field(default_factory=time.perf_counter)
    seconds: float = 0.0


def lay_out(folder: Path, draft: Draft) -> tuple[Bank, Path]:
    """The draft as a bank in an empty folder: its texts, and links to all that lies beside them. Returns its problem's file, too."""
    home = open_bank(Path(draft.place)).home_of(draft.path)
    within = draft.path.relative_to(home.problems)
    bank, solution = Bank(folder), home.solution_beside(draft.path)
    problem = bank.problems / within
    _beside(home.problems, bank.problems, within)
    _beside(home.scenes.parent, bank.scenes.parent, within)
    _write(problem, _text(draft, "problem", draft.path))
    if solution.suffix == ".md" and solution.is_file():
        _write(bank.scenes.parent / within, _text(draft, "solution", solution))
    return bank, problem


def _write(path: Path, text: str) -> None:
    """Write a new file; one that is there, perhaps a link into the bank, is never written to."""
    with path.open("x", encoding="utf-8") as file:
        file.write(text)


def _text(draft: Draft, side: Side, path: Path) -> str:
    return draft.texts[side] if side in draft.texts else path.read_text(encoding="utf-8", errors="replace")


def _beside(theirs: Path, ours: Path, within: Path) -> None:
    """Links to everything below a folder but the file `within` it, whose own folders are made anew."""
    ours.mkdir(parents=True, exist_ok=True)
    for each in theirs.iterdir() if theirs.is_dir() else ():
        if each.name != next(iter(within.parts)):
            _link(each, ours / each.name)
        elif len(within.parts) > 1:
            _beside(each, ours / each.name, Path(*within.parts[1:]))


def _link(theirs: Path, ours: Path) -> None:
    try:
        ours.symlink_to(theirs.resolve(), target_is_directory=theirs.is_dir())
    except OSError:  # Windows allows links to some users only
        if theirs.is_dir():
            shutil.copytree(theirs, ours)
        else:
            shutil.copyfile(theirs, ours)


def found_in(folder: Path, draft: Draft) -> Iterator[tuple[str, Any]]:
    """What is found of a draft, by the field of `Progress` that it belongs to, in the order in which it is found."""
    shutil.rmtree(folder / "bank", ignore_errors=True)
    forget_scenes()
    bank, path = lay_out(folder / "bank", draft)
    try:
        problem = read_problem(path)
    except Malformed as error:
        yield (
            "complaints",
            [PlacedComplaint("problem", each.line, each.sentence) for each in error.complaints],
        )
        yield "ok", False
        return
    doubles = _double_code(draft, problem)
    if doubles:
        yield "complaints", doubles
    if bank.has_programs and not draft.programs:
        yield (
            "complaints",
            [PlacedComplaint("", 0, f"{SAVED_ONLY}; end `corollary preview` and start it again")],
        )
        yield "ok", False
        return
    files = path, bank.solution(problem)
    if files[1].suffix == ".md":  # read before the words are, which takes longer
        try:
            load(bank, problem)
        except NotDerivable as error:
            yield "complaints", [*doubles, placed(str(error), *files)]
    rendered = False
    with unstarted() as runner:
        whole = Verification(bank, problem, runner=runner)
        for stage in whole.stages():
            yield from _so_far(whole, files, doubles)
            if stage == SLOW[0]:
                yield "stage", "variants shown"
                yield "html", _html(bank, path)
                rendered = True
            yield "stage", stage
        yield from _so_far(whole, files, doubles)
    tally = whole.tally
    asked = [] if tally.complaints else list(filter(None, [unexpected(problem)]))
    yield "notes", [placed(each, *files) for each in (*tally.notes, *asked)]
    if not rendered:
        yield "html", _html(bank, path)
    yield "summary", "\n".join(tally.mutation.lines) if tally.mutation is not None else ""
    yield "ok", not tally.complaints and not doubles


def _html(bank: Bank, path: Path) -> str:
    try:
        return rendered_variants(bank, path)
    except Exception:  # an author's program may raise anything: `verify` names it
        return ""


def _so_far(
    whole: Verification, files: tuple[Path, Path], doubles: list[PlacedComplaint]
) -> Iterator[tuple[str, Any]]:
    yield "complaints", [*doubles, *(placed(each, *files) for each in dict.fromkeys(whole.tally.complaints))]
    yield "checks", sum(whole.tally.counts.values())


def _double_code(draft: Draft, problem: Problem) -> list[PlacedComplaint]:
    """A complaint where another file of the bank has the draft's code."""
    place = open_bank(Path(draft.place))
    others = (path for path, code in codes(place).items() if code.lower() == problem.code.lower())
    return [
        PlacedComplaint("problem", 2, f"{other.name} has the code {problem.code} already; change one of them")
        for other in others
        if other.resolve() != draft.path.resolve()
    ][:1]


def placed(sentence: str, problem: Path, solution: Path) -> PlacedComplaint:
    """A sentence of `verify` on the problem in these files, with its place taken off its beginning."""
    found = PLACE.fullmatch(sentence)
    sides: dict[str, Side] = {name_in_bank(problem): "problem", name_in_bank(solution): "solution"}
    if found is None or (side := sides.get(found["name"])) is None:
        return PlacedComplaint("", 0, sentence)
    return PlacedComplaint(side, int(found["line"] or 0), found["sentence"])


Worker = tuple[BaseProcess, Connection]


class DraftChecker:
    """Checks the newest draft in another process. One that is still checked when the next comes is killed; another process
    waits already, with everything loaded. Nothing here waits for any of them."""

    def __init__(self, folder: Path) -> None:
        # A server has threads and must not be forked; a process without threads that has loaded all is forked at once.
        if "forkserver" in get_all_start_methods():
            self._context = get_context("forkserver")
            self._context.set_forkserver_preload([WARM])
        else:
            self._context = get_context("spawn")
        self._folder, self._lock = folder, Lock()
        self._idle: list[Worker] = []
        self._busy: Worker | None = None
        self._waiting: Draft | None = None
        self._ended = False
        self.progress = Progress(0, stage="")
        self._prepare()

    def check(self, draft: Draft) -> int:
        """Begin with this draft, and return its number."""
        with self._lock:
            self._stop()
            self.progress = Progress(self.progress.number + 1, stage="loading")
            self._waiting = draft
            self._send()
            return self.progress.number

    def look(self) -> Progress:
        """What is found by now."""
        with self._lock:
            self._send()
            if self._busy is not None:
                self._take(*self._busy)
            return self.progress

    def cancel(self) -> None:
        """Stop checking; what was found stays."""
        with self._lock:
            self._stop()

    def end(self) -> None:
        """Leave no process behind."""
        with self._lock:
            self._ended = True
            self._stop()
            for process, _ in self._idle:
                process.kill()

    def _send(self) -> None:
        if self._waiting is None or not self._idle:
            return
        _, pipe = self._busy = self._idle.pop()
        with suppress(OSError):  # a process that has ended is found when it is read from
            pipe.send(self._waiting)
        self._waiting = None
        if not self._idle:
            self._prepare()

    def _take(self, process: BaseProcess, pipe: Connection) -> None:
        progress = self.progress
        try:
            while pipe.poll():
                what, found = pipe.recv()
                if what == "end":
                    self._idle.append((process, pipe))  # it knows the algebra of this problem: it is the next
                    self._done()
                    return
                setattr(progress, what, found)
        except (EOFError, OSError):
            sentence = "the process that checks was ended: the machine may be out of memory"
            progress.complaints = [*progress.complaints, PlacedComplaint("", 0, sentence)]
            progress.ok = False
            self._done()

    def _done(self) -> None:
        self._busy = None
        self.progress.stage, self.progress.seconds = "", time.perf_counter() - self.progress.began

    def _stop(self) -> None:
        if self._busy is not None:
            process, pipe = self._busy
            process.kill()
            process.join()
            pipe.close()
        if self._busy is not None or self._waiting is not None:
            self._waiting = None
            self._done()

    def _prepare(self) -> None:
        """Start one more process, which takes a while at first."""
        Thread(target=self._start, daemon=True).start()

    def _start(self) -> None:
        ours, theirs = self._context.Pipe()
        process = self._context.Process(target=_work, args=(theirs, str(self._folder)), daemon=True)
        process.start()
        theirs.close()
        with self._lock:
            if self._ended:
                process.kill()
            else:
                self._idle.insert(0, (process, ours))


def _work(pipe: Connection, folder: str) -> None:
    """In the process: draft after draft."""
    begin()
    sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 — programs of an author may print
    os.environ["XDG_CACHE_HOME"] = str(
        Path(folder) / "cache"
    )  # drafts leave nothing among what the user keeps
    while True:
        draft: Draft = pipe.recv()
        try:
            with language(draft.spoken):
                for each in found_in(Path(folder), draft):
                    pipe.send(each)
        except Exception as error:  # of ours: the page says so, and waits for the next draft
            pipe.send(("complaints", [PlacedComplaint("", 0, unforeseen(error))]))
            pipe.send(("ok", False))
        pipe.send(("end", None))


def draft_of(place: Bank, path: Path, texts: Mapping[Side, str], programs: bool) -> Draft:
    """The draft to send to the process, in the language spoken here."""
    return Draft(place.place, path, dict(texts), spoken(), programs)
