"""A solution with each of its texts said otherwise: in another language, or handed to whoever lists them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from corollary.derive.numbered_list import listed
from corollary.derive.solution import AppliedLaw, Solution, SolvedNeglected, SolvedRoute, Unknown, Unsolved
from corollary.derive.statements import Code, CurveFormula, Explain, FunctionFormula, Plot, Statement

Say = Callable[[str], str]


def translated(solution: Solution, say: Say) -> Solution:
    """`say` gets every text that a student may read, but for the empty ones, and gives what stands there instead."""
    if solution.template is not None:
        return listed(translated(solution.template, say))
    return replace(
        solution,
        unknowns=tuple(_unknown(find, say) for find in solution.unknowns),
        choices={
            part: replace(
                choice,
                statement=_statement(choice.statement, say),
                mistakes={letter: say(text) for letter, text in choice.mistakes.items()},
            )
            for part, choice in solution.choices.items()
        },
        forces={
            part: replace(
                forces,
                statement=_statement(forces.statement, say),
                balances=tuple(replace(each, law=_law(each.law, say)) for each in forces.balances),
                mistakes={letter: say(text) for letter, text in forces.mistakes.items()},
            )
            for part, forces in solution.forces.items()
        },
        examples={
            part: replace(
                example,
                statement=_statement(example.statement, say),
                laws=tuple(_law(law, say) for law in example.laws),
                apart=tuple((values, say(why) if why else why) for values, why in example.apart),
            )
            for part, example in solution.examples.items()
        },
        proofs={
            part: replace(
                proof,
                statement=_statement(proof.statement, say),
                laws=tuple(_law(law, say) for law in proof.laws),
                mistakes=tuple(replace(each, text=say(each.text)) for each in proof.mistakes),
            )
            for part, proof in solution.proofs.items()
        },
        entries=tuple(_entry(entry, say) for entry in solution.entries),
        neglected=tuple(_neglected(each, say) for each in solution.neglected),
        case=say(solution.case) if solution.case else "",
        meanings={letter: say(meaning) for letter, meaning in solution.meanings.items()},
        regimes=tuple(replace(each, solution=translated(each.solution, say)) for each in solution.regimes),
    )


def _statement(statement: Statement, say: Say) -> Statement:
    because, check = statement.because, statement.check
    return replace(statement, because=say(because) if because else "", check=say(check) if check else "")


def _law(law: AppliedLaw, say: Say) -> AppliedLaw:
    return replace(law, name=say(law.name), holds=say(law.holds) if law.holds else "")


def _unknown(find: Unknown, say: Say) -> Unknown:
    return replace(
        find,
        statement=_statement(find.statement, say),
        laws=tuple(_law(law, say) for law in find.laws),
        mistakes=tuple(replace(each, text=say(each.text)) for each in find.mistakes),
        routes=tuple(
            SolvedRoute(
                replace(
                    each.stated,
                    because=say(each.stated.because),
                    laws=tuple(_law(law, say) for law in each.stated.laws),
                ),
                each.rule,
            )
            for each in find.routes
        ),
    )


def _entry(entry: Unsolved, say: Say) -> Unsolved:
    match entry:
        case Explain():
            explained = replace(entry, rubric=tuple(map(say, entry.rubric)), answer=say(entry.answer))
            return replace(explained, statement=_statement(entry.statement, say))
        case (
            Code(judge=FunctionFormula() | CurveFormula() as judge)
            | Plot(judge=FunctionFormula() | CurveFormula() as judge)
        ):
            mistakes = tuple((formula, say(text)) for formula, text in judge.mistakes)
            return replace(
                entry, statement=_statement(entry.statement, say), judge=replace(judge, mistakes=mistakes)
            )
        case _:
            return replace(entry, statement=_statement(entry.statement, say))


def _neglected(each: SolvedNeglected, say: Say) -> SolvedNeglected:
    supposing = tuple(
        replace(value, stated=replace(value.stated, why=say(value.stated.why))) for value in each.supposing
    )
    return replace(each, what=say(each.what), bound=_unknown(each.bound, say), supposing=supposing)
