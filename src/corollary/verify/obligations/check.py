"""The obligations of a problem checked: what has a counter-example is complained of, with the numbers and what would exclude them."""

from __future__ import annotations

from corollary.derive.solution import Solution
from corollary.problem.bank import Bank
from corollary.verify.checked import Tally
from corollary.verify.obligations.obligation import Settled
from corollary.verify.obligations.settle import settled


def check_obligations(bank: Bank, solution: Solution, tally: Tally, variants: int) -> None:
    """Comes after the laws were put back, whose complaints it counts; `variants` are walked besides."""
    file = bank.solution(solution.problem).name
    left = tuple(tally.complaints)
    for each in settled(solution, variants):
        if each.kind == "laws hold" and any(one.startswith(f"{file}:{each.line}:") for one in left):
            tally.obligations.append(Settled(each.kind, each.claim, each.line, "counter-example", "algebra"))
            continue
        tally.obligations.append(each)
        if each.outcome == "counter-example" and each.kind != "mistakes differ":  # which is a note already
            tally.complain(f"{file}:{each.line}: {sentence(each)}")
    tally.count("obligations", len(tally.obligations))


def sentence(each: Settled) -> str:
    """What is wrong, for which numbers, and what to do."""
    numbers = ", ".join(f"{name} = {value}" for name, value in each.numbers.items())
    text = f"it does not hold that {each.claim}" + (f": {numbers}" if numbers else "")
    if each.exclude:
        share = f"{each.broken:.1%}" if each.broken else "few"
        text += f" ({share} of the draws); where: {each.exclude}, in the problem, would exclude that"
    return text
