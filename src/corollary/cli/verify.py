"""`corollary verify`: problems and solutions proven right, and sets checked; a page of what was found; a watch on one problem."""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

from corollary.cli.ending import FAILS, HOLDS, answer, counted, refuse, say
from corollary.cli.local_page import edition
from corollary.cli.terminal import bar, console
from corollary.grading.replay import forget_scenes
from corollary.problem.bank import Bank, bank_of, home, home_of_file, open_bank, readable
from corollary.problem.count import written
from corollary.problem.diagnostic import Malformed
from corollary.problem.front_matter import split
from corollary.problem.problem import Problem
from corollary.problem.problem_set import bank_of_set, find_set, set_names
from corollary.problem.reader import read_problem
from corollary.verify.checked import Checked, MutationScore
from corollary.verify.expected_answers import unexpected
from corollary.verify.obligations.obligation import REDRAWN, Settled
from corollary.verify.program_checks import unstarted
from corollary.verify.sets import CheckedSet, check_set
from corollary.verify.side_by_side import on_cluster, verify_changed, verify_each
from corollary.verify.verify import SLOW, Verification
from corollary.verify.words.check_words import unread_of_all

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
    forget_scenes()
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
    ended = (
        ""
        if whole.tally.complaints
        else f", {100 * whole.walked.refused:.0f} % of the draws redrawn: all hold"
    )
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


NAMED = 5  # problems in a sentence


def run(
    codes: list[str],
    bank: Path | None,
    variants: int,
    as_json: bool,
    extremes: bool = False,
    watch: bool = False,
    anew: bool = False,
    report: Path | None = None,
    cluster: str = "",
    verbose: bool = False,
) -> int:
    start = time.perf_counter()
    if watch:
        if len(codes) != 1 or as_json or extremes or cluster:
            refuse(
                "--watch follows one problem, for a person; name one code, and no other option but --variants"
            )

        return follow(*home_of_file(bank, codes[0]), variants)
    names = {code: place for code in codes if (place := _bank_of_set(code, bank)) is not None}
    todo, broken = _problems([code for code in codes if code not in names], bank, bool(names))
    sets = list[CheckedSet]()
    for name, place in names.items():
        try:
            problem_set = find_set(place, name)
        except Malformed as error:
            broken += map(str, error.complaints)
            continue
        sets.append(check_set(problem_set, f"{problem_set.name}.md"))
        known = {problem.path for _, problem in todo}
        members = [problem.as_written for problem in problem_set.problems]
        todo += [(bank_of(problem), problem) for problem in members if problem.path not in known]
    if extremes:
        from corollary.cli.verify_extremes import run_extremes

        return run_extremes(todo, broken, as_json=as_json)
    found: list[Checked] = []
    verify_those = on_cluster(cluster) if cluster else verify_each
    verify_all = partial(verify_changed, verify_those=verify_those, anew=anew)
    with bar("verifying", len(todo)) as progress, verify_all(todo, variants) as checked:
        for each in checked:
            progress(each.code)
            found.append(each)
    ok = not broken and all(each.ok for each in found)
    if report is not None:
        from corollary.render.proofs_page import write_report  # with its plots

        write_report(report, todo, found)
    if as_json:
        answer(
            {
                "ok": ok,
                "problems": [_record(each) for each in found],
                **({"sets": [asdict(each) for each in sets]} if names else {}),
                "malformed": broken,
                "seconds": round(time.perf_counter() - start, 2),
            }
        )
    else:
        _table(found)
        _bends(found)
        _complaints(found, broken)
        _notes({"sets": [note for each in sets for note in each.notes]}, found, verbose)
        _verdict(found, broken, time.perf_counter() - start)
    return HOLDS if ok else FAILS


def _bank_of_set(name: str, bank: Path | None) -> Bank | None:
    """The bank in which a set of this name is looked for; None for what is the name of no set, but of a problem."""
    if name.endswith(".md"):
        path = Path(name).resolve()
        if not path.is_file() or "problems" not in split(path)[0].entries:
            return None
        return bank_of_set(bank, name)
    place = open_bank(bank)
    return place if name in set_names(place) else None


def _problems(
    codes: list[str], bank: Path | None, only_these: bool
) -> tuple[list[tuple[Bank, Problem]], list[str]]:
    """The problems asked for, all without a code, each with its bank; and what is wrong with files that cannot be read."""
    if codes or only_these:
        return [home(bank, code) for code in codes], []
    place = open_bank(bank)
    problems, broken = readable(place)
    return [(place, problem) for problem in problems], list(map(str, broken))


def _record(checked: Checked) -> dict[str, Any]:
    return {
        "code": checked.code,
        "ok": checked.ok,
        "variants": checked.variants,
        "redrawn": round(checked.redrawn, 4),
        "why_redrawn": dict(checked.why),
        "checks": checked.checks,
        "obligations": [_obligation(each) for each in checked.obligations],
        "complaints": list(checked.complaints),
        "notes": list(checked.notes),
        "unread": list(checked.unread),
        **({"mutation": asdict(checked.mutation)} if checked.mutation is not None else {}),
    }


def _obligation(each: Settled) -> dict[str, Any]:
    found: dict[str, Any] = {
        "kind": each.kind,
        "claim": each.claim,
        "line": each.line,
        "outcome": each.outcome,
        "by": each.by,
    }
    if each.numbers:
        found |= {"numbers": dict(each.numbers), "share": round(each.broken, 4)}
    return found | ({"exclude": each.exclude} if each.exclude else {})


def _proven(obligations: Iterable[Settled]) -> str:
    outcomes = [each.outcome for each in obligations]
    return f"{outcomes.count('proven')}/{len(outcomes)}"


def _score(mutation: MutationScore | None) -> str:
    """Bends of the laws that are noticed, of all."""
    return f"{mutation.noticed}/{mutation.bends}" if mutation is not None and mutation.bends else "-"


def _bends(found: list[Checked]) -> None:
    """How many wrong signs and factors would be noticed; of one problem with the laws in which they would not, and what to add."""
    scores = [each.mutation for each in found if each.mutation is not None]
    if len(scores) == 1:
        print(*scores[0].lines, sep="\n")
    elif total := sum(each.bends for each in scores):
        noticed = sum(each.noticed for each in scores)
        print(f"signs and factors: {noticed:,} of {total:,} bends noticed ({100 * noticed / total:.0f} %)")


def _table(found: list[Checked]) -> None:
    from rich.table import Table

    table = Table(
        title="Verified",
        title_justify="left",
        title_style="bold",
        box=None,
        padding=(0, 2, 0, 0),
        pad_edge=False,
    )
    for heading in (
        "code",
        "variants",
        "redrawn",
        "laws",
        "mistakes",
        "proven",
        "scenes",
        "bends",
        "programs",
        "complaints",
    ):
        table.add_column(heading, justify="left" if heading == "code" else "right", no_wrap=True)
    for each in found:
        done = [
            str(each.checks.get(what, 0))
            for what in ("laws put back", "mistakes", "simulations met", "programs run")
        ]
        table.add_row(
            each.code,
            written(each.variants, each.exact_count),
            f"{100 * each.redrawn:.0f} %",
            *done[:2],
            _proven(each.obligations),
            done[2],
            _score(each.mutation),
            done[3],
            str(len(each.complaints) or "none"),
        )
    console().print(table)


def _complaints(found: list[Checked], broken: list[str]) -> None:
    """What is wrong, on standard error: files that cannot be read first, then problem by problem, one line each."""
    groups = [broken, *(each.complaints for each in found)]
    for sentences in filter(None, groups):
        print("", *sentences, sep="\n", file=sys.stderr)


def _notes(of_sets: Mapping[str, list[str]], found: list[Checked], verbose: bool) -> None:
    """Notes are no faults: of several problems they are counted only, so that they hide none."""
    groups = {**of_sets, **{each.code: list(each.notes) for each in found}}
    groups = {name: sentences for name, sentences in groups.items() if sentences}
    if not groups:
        return
    number = sum(map(len, groups.values()))
    count = counted(number, "note")
    if not verbose and len(found) > 1:
        where = ", ".join(groups) if len(groups) <= NAMED else counted(len(groups), "problem")
        print(
            f"\n{count}, no {'fault' if number == 1 else 'faults'} ({where}): --verbose shows them",
            file=sys.stderr,
        )
        return
    for name, sentences in groups.items():
        print(f"\nnotes on {name}:", *(f"  {each}" for each in sentences), sep="\n", file=sys.stderr)


def _verdict(found: list[Checked], broken: list[str], seconds: float) -> None:
    from rich.text import Text

    every = [one for each in found for one in each.obligations]
    total = sum(sum(each.checks.values()) for each in found)
    bad = [each.code for each in found if not each.ok]
    out = console()
    if line := unread_of_all([(each.code, each.unread) for each in found]):
        print(f"\n{line}", flush=True)
    out.print()
    if every:
        count = Counter(one.outcome for one in every)
        redrawn = sum(one.by.startswith(REDRAWN) for one in every)
        out.print(
            f"{counted(len(every), 'obligation')}: {count['proven']} proven for all numbers, {count['sampled']} sampled"
            + (f" ({redrawn} of these checked whenever numbers are dealt)" if redrawn else "")
            + f", {count['undecided']} undecided, {counted(count['counter-example'], 'counter-example')}"
        )
    out.print(f"{counted(len(found), 'problem')}, {total:,} checks in {seconds:.1f} s")
    if not bad and not broken:
        out.print(Text("all hold", "bold green"))
        return
    wrong = [counted(len(broken), "sentence") + " on files that cannot be read"] if broken else []
    wrong += (
        [f"{len(bad)} of {counted(len(found), 'problem')} with complaints: {', '.join(bad)}"] if bad else []
    )
    out.print(Text("; ".join(wrong), "bold red"))
