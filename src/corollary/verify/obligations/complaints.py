"""The obligations of a problem checked: what has a counter-example is complained of, with the numbers and what would exclude them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from corollary.derive.put_back import PutBack
from corollary.derive.solution import Solution
from corollary.problem.bank import Bank
from corollary.verify.checked import Tally
from corollary.verify.obligations.claims import laws_of
from corollary.verify.obligations.obligation import Settled
from corollary.verify.obligations.settle import settled


def check_obligations(bank: Bank, solution: Solution, tally: Tally, variants: int) -> None:
    """Comes after the laws were put back; `variants` are walked besides."""
    file = bank.solution(solution.problem).name
    for found in settled(solution, variants):
        each = _as_put_back(found, tally.put_back) if found.kind == "laws hold" else found
        tally.obligations.append(each)
        if (
            each.outcome == "counter-example" and each is found and each.kind != "mistakes differ"
        ):  # which is a note already
            tally.complain(f"{file}:{each.line}: {sentence(each)}")
    tally.count("obligations", len(tally.obligations))


def _as_put_back(each: Settled, put_back: Sequence[PutBack]) -> Settled:
    """How the laws of a step held when all that was found was put in; what does not is complained of already."""
    step = each.line, each.claim, each.case  # several steps, or cases, may stand on one line
    here = [one for one in put_back if (one.line, laws_of(one.names), one.case) == step]
    broken = next((one for one in here if one.how == "differ"), None)
    if broken is not None:
        return replace(each, outcome="counter-example", by="a point", numbers=broken.at)
    if each.outcome in ("proven", "sampled") and any(one.how == "undecided" for one in here):
        return replace(each, outcome="undecided", by="neither algebra nor numbers decide it")
    if each.outcome == "proven" and any(one.how == "points" for one in here):
        return replace(each, outcome="sampled", by="no algebra decides it, it holds at points")
    return each


def sentence(each: Settled) -> str:
    """What is wrong, for which numbers, and what to do."""
    numbers = ", ".join(f"{name} = {value}" for name, value in each.numbers.items())
    text = f"it does not hold that {each.claim}" + (f": {numbers}" if numbers else "")
    if each.exclude:
        share = f"{each.broken:.1%}" if each.broken else "few"
        text += f" ({share} of the draws); where: {each.exclude}, in the problem, would exclude that"
    return text
