"""Students simulated on the problems of installed banks: `python simulated_students.py VARIANTS CODE…`, the banks from COROLLARY_BANK.

One student answers everything right, others make one of the solution's mistakes each, all typed to five figures in the part's unit, or as
formulas where these are asked for. One JSON document: how many did what, and what was not judged as it should be.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Iterator

import corollary
from corollary.answers.option_names import option_named
from corollary.answers.verdict import Mistaken, Right
from corollary.formula.ast import Expr
from corollary.formula.ball import Undefined
from corollary.formula.plain_text import text
from corollary.formula.value import Items, Text, Value
from corollary.grading.assign import admitted
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.mistakes import visible_mistakes
from corollary.grading.replay import WhatIf, replay
from corollary.problem.sampling import sample
from corollary.units.unit import show


def typed(key: Key, part: str, values: tuple[float, ...]) -> Value:
    """One quantity as a student types it, or a list of them."""
    unit = key.variant.problem.part(part).unit
    texts = tuple(Text(f"{unit.from_si(value):.5g} {show(unit)}".replace(" 1", "")) for value in values)
    return texts[0] if len(texts) == 1 else Items(texts, (len(texts),))


def written(trees: tuple[Expr, ...]) -> Value:
    """The formula that a part of a variable asks for, or a list of them."""
    texts = tuple(Text(text(tree)) for tree in trees)
    return texts[0] if len(texts) == 1 else Items(texts, (len(texts),))


def mistaken(key: Key) -> Iterator[tuple[str, str, Value]]:
    """Part, sentence and answer of everybody who makes one mistake and shows it."""
    for each in visible_mistakes(key.solution):
        if key.variant.problem.asks_of_variable(each.part):
            trees = each.formulas(key.solution)
            assert trees is not None
            yield each.part, each.mistake.text, written(trees)
            continue
        what_if = WhatIf(rules={each.place: each.mistake.rule})
        try:
            values = replay(key.solution, key.variant.exact, what_if, each.at)
        except Undefined:
            continue
        yield each.part, each.mistake.text, typed(key, each.part, values[each.at])


def play(code: str, count: int, counts: Counter[str]) -> list[str]:
    """One problem over some variants: what went otherwise than it should."""
    problem = corollary.load_bank()[code]
    solution = corollary.solve(problem)
    faults: list[str] = []
    same: Counter[tuple[str, str, str]] = Counter()
    keys = [
        key
        for variant in sample(problem, 4 * count, salt="students")
        if (key := admitted(solution, variant)[0])
    ]
    for key in keys[:count]:
        where = f"{code} {dict(key.variant.values)}"
        answers = {
            part: written(key.find(truth).in_givens or ())
            if problem.asks_of_variable(part)
            else typed(key, part, truth.values)
            for part, truth in key.truths.items()
        }
        answers |= {part: Text(option_named(problem.part(part), each)) for part, each in key.choices.items()}
        judged = judge(key, answers)
        counts["right"] += len(answers)
        faults += [
            f"{where}: part {part} is right, and judged {judged[part]}"
            for part in answers
            if not isinstance(judged[part][0][0], Right)
        ]
        for part, sentence, answer in mistaken(key):
            ((verdict, *_), _) = judge(key, {part: answer})[part]
            counts["mistaken"] += 1
            if not isinstance(verdict, Mistaken):
                faults.append(f"{where}: part {part}, {answer}, is judged {verdict}; meant is {sentence!r}")
            elif verdict.mistake != sentence:
                same[part, sentence, verdict.mistake] += 1
    if not keys:
        faults.append(f"{code}: no variant may be assigned")
    faults += [
        f"{code}: part {part}: {one!r} and {other!r} always give the same value"
        for (part, one, other), times in same.items()
        if times >= min(count, len(keys)) > 1
    ]
    return faults


def main() -> None:
    count, *codes = sys.argv[1:]
    counts: Counter[str] = Counter()
    faults = [fault for code in codes for fault in play(code, int(count), counts)]
    print(json.dumps({"counts": counts, "faults": faults}))


main()
