"""One-place mutants of grading, formula and answers, and whether the tests of these rooms notice.

`python benchmarks/mutants.py --count 300` draws the mutants with a fixed seed, learns which test reaches which line and how long it
takes, and holds each mutant against the tests that reach it: those of its own room first, then those of the other two, the fastest
first, up to the first that fails (`mutant_tests.py`, `mutant_server.py`). Two processes at the lowest priority; what was learned and
tried is kept in `learned.json` and `mutants.json`, from which a stopped run goes on. `--again` tries those alive once more, at their
places in today's sources. Both write the table `mutants.md`, with the reasons of `mutants_explained.txt`.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from threading import Lock

sys.path.insert(0, str(Path(__file__).parent))
from mutant_places import SEED, TOP, Mutant, Record, drawn, found_again
from mutant_server import ROOMS
from mutant_tests import Learned, Tree

RESULTS = TOP / "benchmarks" / "results"
EXPLAINED = Path(__file__).with_name("mutants_explained.txt")


def explained() -> dict[tuple[str, ...], str]:
    """Why no test could see a mutant, by file, column, change and line."""
    lines = EXPLAINED.read_text(encoding="utf-8").splitlines()
    rows = (line.split("\t") for line in lines if line and not line.startswith("#"))
    return {tuple(place): why for *place, why in rows}


def table(found: list[Record], count: int) -> str:
    """The results as Markdown: a row a room, then each survivor."""
    reasons = explained()
    lines = [
        f"`python benchmarks/mutants.py --count {count}`, seed {SEED}: {len(found)} of {count} tried.",
        "",
        "| room | mutants | killed by tests of the room | by those of the other two | alive | of these change nothing "
        "| killed, % | of those that change something, % |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for room in (*ROOMS, "all"):
        those = [each for each in found if room in ("all", str(each["file"]).split("/")[2])]
        outcomes = Counter(str(each["outcome"]) for each in those)
        same = sum(each["outcome"] == "alive" and _named(each) in reasons for each in those)
        killed, elsewhere, alive = (outcomes[name] for name in ("killed", "killed elsewhere", "alive"))
        shares = [
            f"{100 * (killed + elsewhere) / total:.1f}" if total else ""
            for total in (len(those), len(those) - same)
        ]
        lines.append(
            f"| {room} | {len(those)} | {killed} | {elsewhere} | {alive} | {same} | {' | '.join(shares)} |"
        )
    lines += ["", "## Alive", "", "| place | line | change | why |", "|---|---|---|---|"]
    for each in found:
        if each["outcome"] == "alive":
            source = str(each["source"]).replace("|", "\\|")
            why = reasons.get(_named(each), "a hole")
            lines.append(f"| {each['file']}:{each['line']} | `{source}` | {each['what']} | {why} |")
    return "\n".join(lines) + "\n"


def _named(record: Record) -> tuple[str, ...]:
    return tuple(str(record[name]) for name in ("file", "column", "what", "source"))


def tried(tree: Tree, learned: Learned, mutant: Mutant) -> tuple[str, str]:
    """Whether a mutant is noticed, and by which test: those of its own room first."""
    tests = learned.chosen(mutant.file, mutant.line)
    text = mutant.text()
    assert text is not None, mutant
    own = f"tests/{mutant.file.split('/')[2]}/"
    for outcome, ours in (("killed", True), ("killed elsewhere", False)):
        some = [test for test in tests if test.startswith(own) == ours]
        if some and (by := tree.failing(learned, mutant.file, text, some)):
            return outcome, by
    return "alive", ""


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--count", type=int, default=300)
    options.add_argument("--processes", type=int, default=2)
    options.add_argument(
        "--again", action="store_true", help="only those alive so far, against today's tests"
    )
    options.add_argument(
        "--results", type=Path, default=RESULTS, help="the folder of mutants.json and mutants.md"
    )
    given = options.parse_args()
    os.nice(19 - os.nice(0))
    given.results.mkdir(parents=True, exist_ok=True)
    kept = given.results / "mutants.json"
    found: dict[int, Record] = {}
    if kept.is_file():
        found = {each["number"]: each for each in json.loads(kept.read_text(encoding="utf-8"))}
    learned, lock = Learned(given.results / "learned.json", TOP), Lock()

    def learn(tree: Tree) -> None:
        while True:
            with lock:
                name = next(names, None)
            if name is None:
                break
            about = tree.learned(name)
            with lock:
                learned.add(name, about)
                print(f"{name}: {sum(about['seconds'].values()):.0f} s", flush=True)
        tree.ready()

    def hold(tree: Tree) -> None:
        while True:
            with lock:
                number, mutant = next(places, (0, None))
            if mutant is None:
                return
            outcome, by = tried(tree, learned, mutant)
            about = {name: getattr(mutant, name) for name in ("file", "line", "column", "what", "source")}
            with lock:
                found[number] = {"number": number} | about | {"outcome": outcome, "by": by}
                records = [found[place] for place in sorted(found)]
                kept.write_text(json.dumps(records, indent=1, ensure_ascii=False), encoding="utf-8")
                (given.results / "mutants.md").write_text(table(records, given.count), encoding="utf-8")
                print(f"{number}: {outcome:16} {mutant.file}:{mutant.line} {mutant.what} {by}", flush=True)

    names = iter(learned.missing())
    with ExitStack() as stack, ThreadPoolExecutor(given.processes) as threads:
        trees = [stack.enter_context(Tree(TOP)) for _ in range(given.processes)]
        list(threads.map(learn, trees))
        learned.use()
        if given.again:
            alive = [each for each in found.values() if each["outcome"] == "alive"]
            todo = dict(zip((each["number"] for each in alive), found_again(alive), strict=True))
        else:  # the seed gives the order, so a stopped run goes on where it was
            todo = {number: each for number, each in enumerate(drawn(given.count)) if number not in found}
        for number in (number for number, mutant in todo.items() if mutant is None):
            print(f"{number}: the line {found[number]['source']!r} is no longer there", flush=True)
        places = iter([each for each in todo.items() if each[1] is not None])
        list(threads.map(hold, trees))


if __name__ == "__main__":
    main()
