"""Remarks on a problem that holds: data nobody needs, and mistakes that are too few, tell nothing or change no part."""

from __future__ import annotations

import math
from collections.abc import Iterator

from corollary.answers.expected import Values
from corollary.derive.introduced_letters import unexplained
from corollary.derive.solution import ClosedForms, SceneOutcome, Solution, Unknown
from corollary.derive.statements import Code, Plot
from corollary.formula.ast import Relation, names
from corollary.formula.ball import Undefined
from corollary.grading.key import Key
from corollary.grading.mistakes import ListedMistake, hidden_mistakes, numbers_tried, own_mistakes
from corollary.grading.replay import replay
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.packed_pictures import unused
from corollary.problem.problem import Problem
from corollary.verify.checked import Tally
from corollary.verify.obligations.algebra import Algebra
from corollary.verify.obligations.box import Box

SAME = 1e-9  # relative: doubles of one value by two ways


def check_hidden_mistakes(bank: Bank, solution: Solution, tally: Tally) -> None:
    """Complain of mistakes that are the truth or have no value; note those that leave every answer as it is."""
    file = name_in_bank(bank.solution(solution.problem))
    every = [each.solution for each in solution.regimes] or [solution]
    met: set[tuple[int, str]] = set()
    for one in every:
        for each, in_parts in hidden_mistakes(one):
            mistake = each.mistake
            if (mistake.line, mistake.text) in met:
                continue
            met.add((mistake.line, mistake.text))
            is_fault, why = _reason(one, each, in_parts)
            (tally.complain if is_fault else tally.note)(
                f"{file}:{mistake.line}: the mistake {mistake.text!r} {why}"
            )


def _reason(solution: Solution, own: ListedMistake, in_parts: list[ListedMistake]) -> tuple[bool, str]:
    """Whether it is a fault, and why the mistake is never met."""
    names = ", ".join(solution.unknowns[own.place].names)
    if not in_parts:
        return False, f"is never met: no part is made of {names}; ask for it, or leave the mistake out"
    outcomes = list(_outcomes(solution, own))
    tried = f"all {len(outcomes)} numbers tried" if len(outcomes) > 1 else "the printed numbers"
    if "differs" not in outcomes and "same" not in outcomes:
        return True, f"has no value for {tried}: correct its law, or leave it out"
    if "differs" not in outcomes:
        how = "for all numbers, by algebra" if _identical(solution, own) else f"for {tried}"
        return True, f"gives the same {names} as the step itself {how}: correct its law, or leave it out"
    every = len(in_parts) > 1
    asked = f"part{'s' * every} {', '.join(each.part for each in in_parts)}"
    proven = all(_identical(solution, each) for each in in_parts)
    how = "for all numbers, by algebra" if proven else f"for {tried}"
    return False, (
        f"changes {names}, and leaves {asked} as {'they are' if every else 'it is'} {how}: "
        "no student is told of it, and no numbers are redrawn for it"
    )


def _outcomes(solution: Solution, own: ListedMistake) -> Iterator[str]:
    """For each of the numbers tried: `same`, `differs`, or `undefined` where the mistake has no value."""
    for givens in numbers_tried(solution):
        try:
            truth = replay(solution, givens, until=own.place)[own.place]
        except Undefined:
            continue
        try:
            other = own.values(solution, givens)
        except Undefined:
            yield "undefined"
            continue
        alike = all(
            abs(mine - theirs) <= SAME * max(abs(mine), abs(theirs))
            for mine, theirs in zip(other, truth, strict=True)
        )
        yield "same" if alike else "differs"


def _identical(solution: Solution, each: ListedMistake) -> bool:
    """True if algebra shows that what is looked at is the same with the mistake as without."""
    wrong, truth = each.formulas(solution), solution.unknowns[each.at].in_givens
    if wrong is None or truth is None:
        return False
    need = [Relation("=", mine, theirs) for mine, theirs in zip(wrong, truth, strict=True)]
    try:
        algebra = Algebra(Box(solution.problem, solution.conditions), need)
    except ValueError:
        return False
    return all(map(algebra.holds, need))


ENOUGH = 2  # mistakes of a quantity: with one alone, everything else that is wrong is a surprise


def remark(bank: Bank, solution: Solution, key: Key, tally: Tally) -> None:
    """Notes on the givens and on the mistakes; `key` is that of the problem's own numbers."""
    file, path = solution.problem.path.name, name_in_bank(bank.solution(solution.problem))
    for picture in unused(solution.problem.path):
        tally.note(
            f"{file}:1: {picture.name} is in its folder, and no problem shows it: show it, or delete it"
        )
    for line, sentence in (*_outside(solution.problem), *_unused(solution), *_printed_unused(solution)):
        tally.note(f"{file}:{line}: {sentence}")
    for line, sentence in (*_few(key.solution), *_alike(key), *_unknown_letters(solution)):
        tally.note(f"{path}:{line}: {sentence}")


def _outside(problem: Problem) -> Iterator[tuple[int, str]]:
    for given in problem.givens:
        first, last = sorted((given.grid.first, given.grid.last))
        if not first <= given.value <= last:
            numbers = (f"{float(number):g}" for number in (given.value, first, last))
            value, low, high = numbers
            yield (
                given.line,
                f"value: {value} of {given.symbol} is outside from: {low} to: {high}; no student gets it",
            )


def _printed_unused(solution: Solution) -> Iterator[tuple[int, str]]:
    """Letters under `shown:` that stand nowhere."""
    problem, every = solution.problem, [each.solution for each in solution.regimes] or [solution]
    known = {each.symbol for each in problem.letters} | solution.meanings.keys()
    for find in (find for each in every for find in each.unknowns):
        known |= {*find.names} | {
            name for law in find.laws for one in (*law.here, law.textbook) for name in names(one)
        }
    for name, _tex in problem.printed_letters:
        if name not in known:
            yield 1, f"shown: {name} is no letter of the problem or its solution; correct it, or leave it out"


def _unused(solution: Solution) -> Iterator[tuple[int, str]]:
    """Givens that no law, no formula and no program has."""
    if any(isinstance(entry, Code | Plot) for entry in solution.entries):
        return  # judges are programs, and may use any given
    every = [each.solution for each in solution.regimes] or [solution]
    unknowns = [find for each in every for find in each.unknowns]
    laws = [law for find in unknowns for law in find.laws]
    laws += [law for proof in solution.proofs.values() for law in (*proof.laws, proof.target)]
    laws += [law for example in solution.examples.values() for law in example.laws]
    used = {name for law in laws for relation in law.here for name in names(relation)}
    used |= {name for each in solution.regimes for one in each.conditions for name in names(one)}
    for find in (*unknowns, *(each.bound for each in solution.neglected)):
        used |= _letters(find)
    for choice in solution.choices.values():
        ways = [way for each in choice.options.values() for way in each]
        used |= {name for way in ways for one in way for name in names(one)}
    for given in solution.problem.givens:
        if given.symbol not in used and not given.words:
            yield (
                given.line,
                f"the given {given.symbol} is used in no answer; leave it out, unless it is there to be left aside",
            )


def _unknown_letters(solution: Solution) -> Iterator[tuple[int, str]]:
    """Letters that a student meets in the worked solution and nobody has told them of, each once."""
    every = [each.solution for each in solution.regimes] or [solution]
    for line, letter in dict.fromkeys(found for each in every for found in unexplained(each)):
        yield (
            line,
            f"{letter} has no meaning for the reader; say what it stands for in the heading that finds it, ## {letter}: …, or above the "
            f'first heading where it is named, such as variable: `{letter}` … (in Python unknowns({letter}="…"))',
        )


def _letters(find: Unknown) -> set[str]:
    trees = [*(find.in_givens or ()), *(tree for law in find.laws for tree in law.here)]
    match find.local:
        case ClosedForms(own):
            trees += own
        case SceneOutcome(_, settings, _):
            trees += settings.values()
        case _:
            pass
    return {name for tree in trees for name in names(tree)}


def _few(solution: Solution) -> Iterator[tuple[int, str]]:
    """Parts for which fewer mistakes are foreseen than it takes to tell students apart; those on the way to a part count."""
    foreseen = 0
    for find in solution.unknowns:
        foreseen += len(find.mistakes)
        if find.part:
            if foreseen < ENOUGH:
                has = "one mistake" if foreseen else "no mistake"
                yield find.statement.line, f"part {find.part} foresees {has}; say at least two"
            foreseen = 0


def _alike(key: Key) -> Iterator[tuple[int, str]]:
    """Mistakes of one unknown that give the same value: whoever makes either is told the first."""
    for place in range(len(key.solution.unknowns)):
        met: list[tuple[str, Values]] = []
        for each in own_mistakes(key.solution, place):
            try:
                values = each.values(key.solution, key.variant.exact)
            except Undefined:
                continue
            for text, other in met:
                if len(values) == len(other) and math.dist(values, other) <= SAME * math.hypot(
                    *values, *other
                ):
                    yield (
                        each.mistake.line,
                        f"this mistake gives the same value as {text!r}; students are told that",
                    )
                    break
            else:
                met.append((each.mistake.text, values))
