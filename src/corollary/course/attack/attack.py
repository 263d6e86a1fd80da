"""Hostile hand-ins played in a throw-away course in a temporary folder: what a student could do on this machine."""

from __future__ import annotations

import ctypes
import json
import os
import secrets
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Collection, Iterator
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from fractions import Fraction
from functools import partial
from itertools import chain
from pathlib import Path

from corollary.course.attack.hostile_archives import HOSTILE
from corollary.course.attack.hostile_cells import PRELUDE, hostile_cells
from corollary.course.attack.hostile_notebooks import TEXTS, hostile_files
from corollary.course.attack.shown_texts import run_by_page, run_by_spreadsheet, run_by_terminal
from corollary.course.collect import collect
from corollary.course.demo.players import right_sources
from corollary.course.generate import Generated, generate
from corollary.course.grade import grade_set
from corollary.formula.value import Exact, Real
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import Student
from corollary.records.files import Course
from corollary.records.marks import feedback_place, report_place
from corollary.sandbox.isolation import Isolation
from corollary.sandbox.job import Cell, ExecutionResult, Job, Limits
from corollary.sandbox.runner import Runner

NAME, CODE = "week", "X12.5"
NARROW = Limits(
    cell_seconds=1.0, total_seconds=3.0, memory_bytes=512 << 20, output_bytes=200_000, file_bytes=4 << 20
)
OF_GRADING = Limits(cell_seconds=3.0, total_seconds=10.0)
SLOW = 30.0  # seconds of the processor for one file, or by the clock for one notebook of three seconds
MOST_MEMORY = 1 << 30  # that this process may have grown by over one file
SUBREAPER = 36  # PR_SET_CHILD_SUBREAPER: whatever outlives its notebook becomes a child of this process
HONEST = ("victim", "innocent")


@dataclass(frozen=True, slots=True)
class Attack:
    """One hostile hand-in; `harm` says what a student could do by it, and is empty where it was withstood."""

    family: str
    name: str
    harm: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Attacked:
    """All that was played, under which isolation, and how long it took."""

    attacks: tuple[Attack, ...]
    isolation: Isolation
    seconds: float

    @property
    def succeeded(self) -> tuple[Attack, ...]:
        return tuple(each for each in self.attacks if each.harm)


def play(
    progress: Callable[[str], None] = lambda name: None,
    families: Collection[str] = (),
    without: frozenset[str] = frozenset(),
) -> Attacked:
    """Plays every attack, or those of some families. Whatever is made lies in one temporary folder, which is removed. `without`
    leaves out layers of isolation, to see that their attacks succeed. Raises CannotStart."""
    began = time.monotonic()
    found = list[Attack]()
    with tempfile.TemporaryDirectory(prefix="corollary-attack-") as folder:
        stage = ThrowawayCourse(Path(folder))
        if not families:
            for attack in chain(stage.files(), stage.graded()):
                progress(attack.name)
                found.append(attack)
        with Bystanders(stage) as bystanders, Runner(NARROW, without=without) as runner:
            bystanders.begin(runner)
            for family, name, source in hostile_cells():
                if families and family not in families:
                    continue
                progress(name)
                found.append(Attack(family, name, tuple(bystanders.harmed(runner, family, source))))
            isolation = runner.isolation
    return Attacked(tuple(found), isolation, time.monotonic() - began)


def count() -> int:
    """How many attacks there are."""
    return len(list(hostile_cells())) + len(HOSTILE) + len(hostile_files({})) + len(OF_ALL)


OF_ALL = (
    "grading of all together",
    "the report",
    "marks as CSV",
    "marks for Canvas",
    "the report in a terminal",
)


@dataclass(slots=True)
class ThrowawayCourse:
    """A course with a student for each hostile file, and two honest ones who have handed in right answers."""

    folder: Path
    made: Generated = field(init=False)
    problem_set: ProblemSet = field(init=False)
    solutions: Solutions = field(init=False)
    whose: dict[str, tuple[str, str]] = field(init=False)
    secret: str = field(default_factory=lambda: secrets.token_hex(16))

    def __post_init__(self) -> None:
        names = [*(("archives", name) for name in HOSTILE), *hostile_files({})]
        self.whose = {f"a{number:03}": name for number, name in enumerate(names)}
        bank = chapter_bank()
        file = self.folder / f"{NAME}.md"
        file.write_text(f"---\ntitle: A week\nproblems: [{CODE}]\n---\nBegin.\n", encoding="utf-8")
        self.problem_set, self.solutions = find_set(bank, str(file)), Solutions(bank)
        attackers = [Student(each, *self._called(name)) for each, name in self.whose.items()]
        roster = [*map(Student, HONEST), *attackers]
        self.made = generate(self.folder / "course", self.problem_set, roster, self.solutions, jobs=1)
        for student in HONEST:
            variants = self.made.assigned[student].variants
            sheet = worksheet(self.problem_set, Student(student), variants)
            keys = {each.problem.code: self.solutions.key(each.variant) for each in sheet.exercises}
            self._collected(student, f"{NAME}.ipynb", filled_in(sheet, right_sources(sheet, keys)).encode())
        (self.folder / f"marks-{self.secret}").write_text(self.secret)

    def _called(self, name: tuple[str, str]) -> tuple[str, str]:
        """A student may choose any name in an LMS; no line of a roster has signs that do not print."""
        text = TEXTS.get(name[1], "")
        return ("", text) if text.isprintable() else ("", "")

    @property
    def course(self) -> Course:
        return self.made.course

    @property
    def marks(self) -> Path:
        return self.folder / f"marks-{self.secret}"

    def files(self) -> Iterator[Attack]:
        """Every hostile file handed in and collected, one after another."""
        for student, (family, name) in self.whose.items():
            own = json.loads(self.made.notebooks[student].read_bytes())
            if family == "archives":
                harm = self._collected(student, "hand-in.zip", HOSTILE[name]())
            else:
                harm = self._collected(student, f"{NAME}.ipynb", hostile_files(own)[family, name]())
            if not family.startswith("pages"):  # those are looked at when they are marked
                yield Attack(family, name, tuple(harm))

    def _collected(self, student: str, name: str, content: bytes) -> list[str]:
        before, harm = self.state(), list[str]()
        inbox = self.folder / "inbox"
        file = inbox / student / name
        file.parent.mkdir(parents=True)
        file.write_bytes(content)
        processor, memory = time.process_time(), _most_memory()
        try:
            collect(self.course, self.problem_set, [inbox], now=datetime.now(UTC))
        except Exception as error:
            harm.append(f"ends the collecting of all ({type(error).__name__})")
        if time.process_time() - processor > SLOW:
            harm.append(f"holds up the collecting for {time.process_time() - processor:.0f} s")
        grown = _most_memory() - memory
        if grown > MOST_MEMORY:
            harm.append(f"takes {grown >> 20} MB of memory")
        file.unlink()
        file.parent.rmdir()
        inbox.rmdir()
        after = self.state()
        harm += [f"changes {each}" for each in changed(before, after, student)]
        return harm

    def state(self) -> dict[str, bytes]:
        """What no hand-in of another student may change: files by name, with what is in those that matter."""
        course, found = self.course.folder, dict[str, bytes]()
        for place in (
            self.folder,
            course,
            course / ".corollary",
            *sorted((course / "submitted").glob("*/*")),
        ):
            found |= (
                {str(each.relative_to(self.folder)): b"" for each in place.iterdir()}
                if place.is_dir()
                else {}
            )
        for each in (course / ".corollary" / "key", course / ".corollary" / "roster.csv", self.marks):
            if each.exists():
                found[str(each.relative_to(self.folder))] = each.read_bytes()
        for student in HONEST:
            for each in self.course.place("submitted", student, NAME).glob("*"):
                found[str(each.relative_to(self.folder))] = each.read_bytes()
        return found

    def graded(self) -> Iterator[Attack]:
        """Everything marked, and whatever pages and tables come of it looked at."""
        before, harm = self.state(), list[str]()
        try:
            done = grade_set(self.course, self.problem_set, self.solutions, partial(Runner, OF_GRADING))
            full = {
                who: record.points for who, record in done.records.items() if record.points == record.out_of
            }
            harm = [f"takes marks from {each}" for each in HONEST if each not in full]
        except Exception as error:
            harm.append(f"ends the marking of all ({type(error).__name__}: {str(error)[:80]})")
        harm += [f"changes {each}" for each in changed(before, self.state(), "")]
        yield Attack("all together", OF_ALL[0], tuple(harm))
        for student, (family, name) in self.whose.items():
            if family.startswith("pages"):
                page = feedback_place(self.course, NAME, student)
                text = page.read_text(encoding="utf-8") if page.exists() else ""
                yield Attack(family, name, tuple(run_by_page(text) if text else ["loses its feedback page"]))
        report = report_place(self.course, NAME)
        text = report.read_text(encoding="utf-8") if report.exists() else ""
        yield Attack("all together", OF_ALL[1], tuple(run_by_page(text)))
        for name, target in ((OF_ALL[2], "csv"), (OF_ALL[3], "canvas-grades")):
            self._command("export", NAME, "--to", target, "-o", str(self.folder / "out"))
            tables = "".join(each.read_text("utf-8-sig") for each in (self.folder / "out").glob("*.csv"))
            yield Attack("all together", name, tuple(run_by_spreadsheet(tables)))
        yield Attack("all together", OF_ALL[4], tuple(run_by_terminal(self._command("report", NAME))))

    def _command(self, *words: str) -> str:
        line = [sys.executable, "-m", "corollary", *words, "--course", str(self.course.folder)]
        line += ["--bank", str(self.solutions.bank.each[0].folder)]
        done = subprocess.run(line, capture_output=True, cwd=self.folder, check=False)
        return (done.stdout + done.stderr).decode("utf-8", "replace")


def changed(before: dict[str, bytes], after: dict[str, bytes], student: str) -> list[str]:
    """Files that are others, gone or new, but for a student's own and for what every hand-in adds."""
    own = f"course/submitted/{student}/{NAME}/"
    usual = (
        "course/submitted",
        "course/.corollary/",
        "course/reports",
        "course/autograded",
        "course/feedback",
    )
    new = [
        each
        for each in after.keys() - before.keys()
        if not (each.startswith(own) and Path(each).name in {f"{NAME}.ipynb", "timestamp.txt"})
        and not (each.startswith(usual) and each.count("/") <= 2)
        and Path(each).name != "gradebook.db-journal"
    ]
    return [*sorted(new), *(each for each in before if after.get(each) != before[each])]


class Bystanders:
    """What a cell must not reach: a process, three sockets, files and this process itself; and how each fares."""

    def __init__(self, stage: ThrowawayCourse) -> None:
        self.stage, self._stack = stage, ExitStack()
        self.won = secrets.token_hex(16)
        self.environment = secrets.token_hex(16)

    def __enter__(self) -> Bystanders:
        with suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(SUBREAPER, 1, 0, 0, 0)
        os.environ["COROLLARY_ATTACKED"] = self.environment
        self._stack.callback(os.environ.pop, "COROLLARY_ATTACKED", None)
        self.process = self._sleeper()
        self.sockets = [self._bound(socket.AF_INET, ("127.0.0.1", 0))]
        self.path, self.abstract = str(self.stage.folder / "s"), f"\0{self.stage.folder}"
        self.sockets += [self._bound(socket.AF_UNIX, self.path)]
        if sys.platform == "linux":
            self.sockets += [self._bound(socket.AF_UNIX, self.abstract)]
        return self

    def __exit__(self, *error: object) -> None:
        self.process.kill()
        self.process.wait()
        self._stack.close()
        with suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(SUBREAPER, 0, 0, 0, 0)

    def _sleeper(self) -> subprocess.Popen[bytes]:
        return subprocess.Popen([sys.executable, "-S", "-c", "import time; time.sleep(3600)"])

    def _bound(self, family: int, address: tuple[str, int] | str) -> socket.socket:
        found = self._stack.enter_context(socket.socket(family, socket.SOCK_DGRAM))
        found.bind(address)
        found.setblocking(False)
        return found

    def begin(self, runner: Runner) -> None:
        """Runs the honest notebook that comes before all others, and notes which processes are there."""
        runner.execute(Job((Cell("note", "note = 'earlier ' + 'secret' + ' answer'"),), ()))
        course = self.stage.course
        places = {"KEY": course.folder / ".corollary" / "key", "MARKS": self.stage.marks}
        places |= {"OTHER": course.notebook("submitted", "victim", NAME), "HOME": course.folder}
        places |= {"ROSTER": course.folder / ".corollary" / "roster.csv", "GRADEBOOK": course.gradebook}
        places |= {"OUT": self.stage.folder / "out-of-it"}
        about: dict[str, object] = {name: str(path) for name, path in places.items()}
        # The name of this file is a secret: who lists the folder knows it.
        alias = self.stage.folder / "marks"
        self.stage.marks.replace(alias)
        self.stage.marks.symlink_to(alias)
        about |= {"MARKS": str(alias), "PROCESS": self.process.pid, "WON": self.won[::-1]}
        about |= {"PORT": self.sockets[0].getsockname()[1], "SOCKET": self.path, "ABSTRACT": self.abstract}
        self.setting = "\n".join(f"{name} = {value!r}" for name, value in about.items())
        key = course.key
        secret = self.stage.secret
        self.signs = {
            self.won: "gets through",
            secret: "reads files of the instructor",
            secret.encode().hex(): "reads files of the instructor",
            key.hex(): "reads the key of the course",
            self.environment: "reads the environment",
            self.environment.encode().hex(): "reads the environment",
        }
        self.files, self.children = self._files(), self._children()

    def harmed(self, runner: Runner, family: str, source: str) -> Iterator[str]:
        """Runs a cell, and says what it did to others."""
        began = time.monotonic()
        cells = (("set", self.setting), ("names", PRELUDE), ("first", "first = 8.6"), ("attack", source))
        job = Job(tuple(Cell(*each) for each in (*cells, ("last", "last = 2.5"))), ("first", "a", "b"))
        try:
            result = runner.execute(job)
        except Exception as error:
            yield f"ends the marking of all ({type(error).__name__})"
            return
        if time.monotonic() - began > SLOW:
            yield f"holds up the marking for {time.monotonic() - began:.0f} s"
        got = f"{[(run.outputs, run.error) for run in result.cells]}{result.values}"
        yield from dict.fromkeys(harm for sign, harm in self.signs.items() if sign in got)
        if family == "bending" and result.values.get("first") != Real(8.6):
            yield "changes answers after they were given"
        yield from self._fates()
        if not _is_well(runner.execute(NEXT)):
            yield "spoils the notebook that is marked next"

    def _fates(self) -> Iterator[str]:
        if self.process.poll() is not None:
            yield "ends programs of the instructor"
            self.process = self._sleeper()
        arrived = [each for each in self.sockets if _received(each)]
        if arrived:
            yield "sends messages to other programs"
        if (files := self._files()) != self.files:
            yield "changes files of the instructor"
            self.files = files
        if left := self._children() - self.children:
            yield "leaves processes behind"
            self.children |= left

    def _files(self) -> dict[str, object]:
        folder, course = self.stage.folder, self.stage.course.folder
        names = [
            str(each) for each in (*folder.iterdir(), *course.iterdir(), *(course / ".corollary").iterdir())
        ]
        about = [
            folder / "marks",
            course / ".corollary" / "key",
            self.stage.course.notebook("submitted", "victim", NAME),
        ]
        found = dict[str, object]((name, None) for name in names)
        for each in about:
            with suppress(OSError):
                status = each.stat()
                found[str(each)] = (each.read_bytes(), status.st_mode, status.st_mtime, status.st_uid)
        return found

    def _children(self) -> set[int]:
        """Processes of which this one is the parent, or has become it."""
        found = set[int]()
        for each in Path("/proc").glob("[0-9]*/stat"):
            with suppress(OSError, ValueError, IndexError):
                words = each.read_text().rpartition(")")[2].split()
                if int(words[1]) == os.getpid() and words[0] != "Z":
                    found.add(int(each.parent.name))
        return found


NEXT = Job((Cell("next", "import os\nfiles = len(os.listdir('.'))\nright = 2.5"),), ("files", "right"))


def _is_well(result: ExecutionResult) -> bool:
    return not result.trouble and result.values == {"files": Exact(Fraction(0)), "right": Real(2.5)}


def _received(listening: socket.socket) -> bytes:
    try:
        return listening.recv(10)
    except BlockingIOError:
        return b""


def _most_memory() -> int:
    """The most memory that this process has had, in bytes."""
    import resource  # not on Windows, where nothing is marked

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)
