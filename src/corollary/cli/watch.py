"""`corollary verify --watch`: one problem, verified again whenever its files are saved."""

from __future__ import annotations

import time
from pathlib import Path

from corollary.cli.ending import HOLDS, counted, say
from corollary.cli.saved import edition
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.verify.expected_answers import unexpected
from corollary.verify.programs import unstarted
from corollary.verify.verify import SLOW, Verification

PAUSE = 0.1  # s between looks at the files


def follow(place: Bank, path: Path, variants: int) -> int:
    """Until ctrl-C; the algebra of what has not changed is kept from one edition to the next."""
    say(f"watching {path.name} and its solution; ctrl-C ends it")
    asked = False
    try:
        while True:
            now = edition(place, path)
            whole = verified(place, path, variants, now)
            if whole is not None and not asked:
                asked = True
                _print(*filter(None, [unexpected(whole.problem)]))
            while edition(place, path) == now:
                time.sleep(PAUSE)
    except KeyboardInterrupt:
        return HOLDS


def verified(place: Bank, path: Path, variants: int, now: str) -> Verification | None:
    """Says what is wrong with this edition as soon as it is found; gives up (None) when the next one is saved, or it cannot be read."""
    start, printed = time.perf_counter(), 0
    try:
        problem = read_problem(path)
    except Malformed as error:
        _print(*map(str, error.complaints), f"{path.stem}: cannot be read")
        return None
    with unstarted() as runner:
        whole = Verification(place, problem, variants, runner)
        for stage in whole.stages():
            printed = _new(whole, printed)
            if edition(place, path) != now:
                _print(f"{problem.code}: saved again")
                return None
            if stage in SLOW:
                left = ", ".join(SLOW[SLOW.index(stage) :])
                _print(f"{_so_far(whole, start)} so far; still running: {left}")
        _new(whole, printed)
    _print(*(f"note: {note}" for note in whole.tally.notes))
    if whole.tally.mutation is not None:
        _print(*whole.tally.mutation.lines)
    ended = "" if whole.tally.complaints else f", {whole.walked.refused:.0%} of the draws redrawn: all hold"
    _print(f"{_so_far(whole, start)}{ended}")
    return whole


def _so_far(whole: Verification, start: float) -> str:
    tally = whole.tally
    found = counted(len(tally.complaints), "complaint") if tally.complaints else "no complaint"
    return f"{whole.problem.code}: {found}, {sum(tally.counts.values()):,} checks in {time.perf_counter() - start:.1f} s"


def _new(whole: Verification, printed: int) -> int:
    """Prints the complaints that were not printed yet."""
    _print(*whole.tally.complaints[printed:])
    return len(whole.tally.complaints)


def _print(*lines: str) -> None:
    for line in lines:
        print(line, flush=True)
