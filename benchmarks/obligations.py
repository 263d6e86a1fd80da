"""The obligations of a bank by kind and outcome, from what `corollary verify --json` has written, as a Markdown table.

corollary verify --anew --json > cold.json; corollary verify --json > unchanged.json
python benchmarks/obligations.py cold.json [unchanged.json] [--markdown FILE]

Without a file the chapter's obligations alone are settled here.
"""

from __future__ import annotations

import argparse
import json
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from corollary.derive.solve import solved_derivation
from corollary.problem.bank import chapter_bank
from corollary.verify.checked import Tally
from corollary.verify.laws import check_laws, check_obligations
from corollary.verify.walk import LEAST

OUTCOMES = ("proven", "sampled", "undecided", "counter-example")
AT_RUN_TIME = "redrawn otherwise"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cold", type=Path, nargs="?")
    parser.add_argument("unchanged", type=Path, nargs="?")
    parser.add_argument("--markdown", type=Path)
    asked = parser.parse_args()
    cold = json.loads(asked.cold.read_text(encoding="utf-8")) if asked.cold else settled_here()
    again = json.loads(asked.unchanged.read_text(encoding="utf-8")) if asked.unchanged else None
    text = "\n".join(lines(cold, again)) + "\n"
    print(text)
    if asked.markdown:
        asked.markdown.write_text(text, encoding="utf-8")


def settled_here() -> dict[str, Any]:
    """What `corollary verify --json` says of obligations, and the time of the processor that they took."""
    bank, problems = chapter_bank(), list[dict[str, Any]]()
    begin = time.process_time()
    for problem in bank:
        tally, solved = Tally(), solved_derivation(bank, problem)
        check_laws(solved, tally)
        check_obligations(bank, solved.solution, tally, LEAST)
        problems.append({"code": problem.code, "obligations": [asdict(each) for each in tally.obligations]})
    return {"problems": problems, "alone": time.process_time() - begin}


def lines(cold: dict[str, Any], again: dict[str, Any] | None) -> Iterator[str]:
    every = [(problem["code"], each) for problem in cold["problems"] for each in problem["obligations"]]
    yield "# Obligations of the chapter's problems"
    yield ""
    if "alone" in cold:
        yield (
            f"`python benchmarks/obligations.py --markdown benchmarks/results/obligations.md`: {len(cold['problems'])} problems, "
            f"{len(every)} obligations; derivations, laws and obligations took {cold['alone']:.0f} s of one processor."
        )
    else:
        yield "```"
        yield "corollary verify --anew --json > cold.json; corollary verify --json > unchanged.json"
        yield "python benchmarks/obligations.py cold.json unchanged.json --markdown benchmarks/results/obligations.md"
        yield "```"
        yield ""
        yield (
            f"{len(cold['problems'])} problems, {len(every)} obligations. Everything verified anew took {cold['seconds']:.0f} s"
            + (f", unchanged {again['seconds']:.1f} s." if again else ".")
        )
    yield ""
    yield (
        "| kind | "
        + " | ".join(OUTCOMES)
        + " | algebra | subdivision | z3 | enumeration | a point | redrawn otherwise |"
    )
    yield "|---" * 11 + "|"
    for kind in (*dict.fromkeys(each["kind"] for _, each in every), "all"):
        mine = [each for _, each in every if kind in (each["kind"], "all")]
        outcomes = Counter(each["outcome"] for each in mine)
        ways = Counter(each["by"].split(" (")[0] for each in mine)
        numbers = [outcomes[name] for name in OUTCOMES]
        numbers += [
            ways[name] for name in ("algebra", "subdivision", "z3", "enumeration", "a point", AT_RUN_TIME)
        ]
        yield f"| {kind} | " + " | ".join(map(str, numbers)) + " |"
    yield ""
    proven = [each for _, each in every if each["outcome"] == "proven"]
    redrawn = [each for _, each in every if each["by"].startswith(AT_RUN_TIME)]
    apart = [each for each in proven if each["kind"] != "mistakes differ"]
    rest = [each for _, each in every if each["kind"] != "mistakes differ"]
    yield (
        f"Proven: {len(proven) / len(every):.1%}; without the pairs of mistakes, which one point tells apart, {len(apart) / len(rest):.1%}. "
        f"{len(redrawn)} claims are checked whenever numbers are dealt, and such numbers drawn again: they count as sampled."
    )
    yield ""
    yield "## Not proven"
    yield ""
    for code, each in every:
        if each["outcome"] != "proven" and not each["by"].startswith(AT_RUN_TIME):
            yield f"- {code}, {each['kind']}: {each['claim']}: {each['outcome']} ({each['by']})"


if __name__ == "__main__":
    main()
