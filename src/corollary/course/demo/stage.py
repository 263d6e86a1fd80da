"""The demonstration from beginning to end: a course made, notebooks handed in, marked, and held against what each deserves."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from datetime import timedelta
from pathlib import Path

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong, word
from corollary.atomic import write_whole
from corollary.course.demo.players import PLAYERS, Hand, Player
from corollary.course.generate import generate
from corollary.course.grade import Outcome, grade_set
from corollary.grading.points import share
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.records.files import Course, open_course, roster_table
from corollary.records.submissions import STAMP, stamp
from corollary.sandbox.runner import Runner

KEY = b"a course key for everyone to see"
MARK = ".corollary/demonstration"
DUE_LINE, DUE = re.compile(r"^due:.*$", re.MULTILINE), "2025-12-05"
VERDICTS: dict[str, Verdict] = {
    word(verdict): verdict
    for verdict in (Right(), Follows(()), Mistaken(""), Slip(""), Wrong(), Unread(""), Unmarked(""))
}
Progress = Callable[[str], None]


class NotFresh(ValueError):
    """The folder holds something that is not an earlier demonstration."""


@dataclass(frozen=True, slots=True)
class Played:
    """One student: what they did, what it deserves, and what they got."""

    player: Player
    deserved: float
    got: float
    out_of: float
    differences: tuple[str, ...]

    @property
    def fair(self) -> bool:
        return not self.differences and abs(self.deserved - self.got) < 1e-6


@dataclass(frozen=True, slots=True)
class Demonstration:
    course: Course
    played: tuple[Played, ...]
    outcome: Outcome


def perform(
    folder: Path, problem_set: ProblemSet, solutions: Solutions, progress: Progress = lambda step: None
) -> Demonstration:
    """Plays the whole way in a fresh folder; an earlier demonstration there is replaced. Raises NotFresh."""
    if folder.exists() and any(folder.iterdir()):
        if not (folder / MARK).exists():
            raise NotFresh(f"{folder} is not empty; name a fresh folder for the demonstration")
        shutil.rmtree(folder)
    write_whole(folder / ".corollary" / "key", KEY, mode=0o600)
    write_whole(folder / MARK, "made by corollary demo; may be thrown away\n")
    roster = tuple(player.student for player in PLAYERS)
    write_whole(folder / "roster.csv", roster_table(roster))
    problem_set = _of_last_year(folder, problem_set, solutions)
    made = generate(folder, problem_set, roster, solutions, progress)
    hands: dict[str, tuple[Worksheet, Hand]] = {}
    for player in PLAYERS:
        progress(f"{player.student.first_name} works")
        variants = made.assigned[player.student.id].variants
        sheet = worksheet(problem_set, player.student, variants)
        hand = player.hand(sheet, {variant.problem.code: solutions.key(variant) for variant in variants})
        hands[player.student.id] = sheet, hand
        hand_in(made.course, problem_set, sheet, hand)
    outcome = grade_set(
        open_course(folder),
        problem_set,
        solutions,
        Runner,
        progress=lambda student, left: progress(f"marking {student}"),
    )
    played = tuple(_played(problem_set, player, *hands[player.student.id], outcome) for player in PLAYERS)
    return Demonstration(made.course, played, outcome)


def _of_last_year(folder: Path, problem_set: ProblemSet, solutions: Solutions) -> ProblemSet:
    """The set in a file of the demonstration's own, due on a day that is over: solutions may be seen, whatever the day is."""
    file = folder / f"{problem_set.name}.md"
    found = next(path for bank in solutions.bank.each if (path := bank.sets / file.name).is_file())
    write_whole(file, DUE_LINE.sub(f"due: {DUE}", found.read_text(encoding="utf-8"), count=1))
    return find_set(solutions.bank, str(file))


def hand_in(course: Course, problem_set: ProblemSet, sheet: Worksheet, hand: Hand) -> None:
    """Fills the student's own notebook and puts it where hand-ins go, with its time."""
    place = course.place("submitted", sheet.student.id, problem_set.name)
    path = place / f"{problem_set.name}.ipynb"
    if hand.raw is not None:
        write_whole(path, hand.raw)
    else:
        write_whole(path, filled_in(sheet, hand.sources))
    if problem_set.due is not None:
        moment = problem_set.due + timedelta(hours=hand.late or -20)
        write_whole(place / STAMP, stamp(moment))


def _played(
    problem_set: ProblemSet, player: Player, sheet: Worksheet, hand: Hand, outcome: Outcome
) -> Played:
    record = outcome.records[player.student.id]
    deserved, differences = 0.0, list[str]()
    for prompt in sheet.prompts:
        verdict = hand.deserves.get(
            prompt.key, "unmarked" if answer_type(prompt.part.answer_type).found_in == "cell" else "right"
        )
        halves = 2 if len(prompt.part.answer_types) == 2 and verdict == "mistaken" else 1
        worth = share(VERDICTS[verdict], problem_set.scheme)
        deserved += prompt.out_of * (worth + halves - 1) / halves
        got = record.parts[prompt.key].verdict
        if got != verdict:
            differences.append(
                f"{prompt.key}: {got} instead of {verdict} ({record.parts[prompt.key].feedback})"
            )
    if hand.late:
        deserved *= problem_set.scheme.late
    return Played(player, round(deserved, 6), record.points, record.out_of, tuple(differences))
