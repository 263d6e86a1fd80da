"""A derivation solved: each step's laws for its unknowns, in the letters before it and in the givens alone."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.applied import (
    applied,
    applied_proof,
    applied_route,
    strange_letter,
    supposed_value,
    untrue_given,
)
from corollary.derive.assumptions import FoundFunction, Known, Root, at, forms, simplest, vanishes
from corollary.derive.derivation import Always, Branch, Case, Entry, clauses, relations, ways
from corollary.derive.forces import solved_forces
from corollary.derive.load import Loaded, NotDerivable, load
from corollary.derive.numbered_list import listed
from corollary.derive.optimum import best
from corollary.derive.parts import dimensions_asked, misfits, unsolved
from corollary.derive.paths import with_paths
from corollary.derive.presentation import with_presentation
from corollary.derive.roots import NoRoot, Picked, exchanged, pick, roots
from corollary.derive.solution import (
    ClaimedCondition,
    ClosedForms,
    Numbering,
    OtherRoot,
    Regime,
    Rule,
    SceneOutcome,
    Solution,
    SolvedChoice,
    SolvedExample,
    SolvedForces,
    SolvedFunction,
    SolvedNeglected,
    SolvedProof,
    SolvedRoute,
    Unknown,
    Ways,
    dependent,
)
from corollary.derive.statements import (
    Choice,
    Each,
    Example,
    Exchange,
    Finding,
    Forces,
    Mistake,
    Neglected,
    Optimum,
    Proof,
    Route,
    Simulated,
    Step,
    Supposed,
)
from corollary.formula.ast import ONE, Call, Expr, Name, Relation
from corollary.formula.authored import NotTyped, as_expression
from corollary.formula.errors import Undefined
from corollary.formula.from_sympy import NoTree, tree
from corollary.formula.latex import letters_printed
from corollary.laws.law import Law, sides, substitute
from corollary.problem.bank import Bank, bank_of
from corollary.problem.part import Part
from corollary.problem.problem import Problem

NO_REGIME = "; what holds for some of its values only cannot decide: state it in givens"


def solved_choice(entry: Choice[Boolean | bool], part: Part, known: Known) -> SolvedChoice:
    """Raises ValueError where the options are not those of the part."""
    letters = {option.letter for option in part.options}
    if letters != entry.options.keys():  # pyright: ignore[reportUnnecessaryComparison]
        raise ValueError(
            f"its options are {', '.join(sorted(letters))}; give a condition for each of them, and for no other"
        )
    options: dict[str, Ways] = {}
    for letter, condition in entry.options.items():
        try:
            holds = known.in_givens_alone(condition)
            known.refuse_variables({each.name for each in holds.free_symbols}, NO_REGIME)
            constant = holds in (sympy.true, sympy.false)
            options[letter] = (((),) if holds else ()) if constant else ways(holds)
        except ValueError as error:
            raise ValueError(f"option {letter}: {error}") from None
    return Choice(entry.statement, options, entry.mistakes)


def claims(
    entries: Iterable[Entry], known: Known, failing: Callable[[str, int], NotDerivable]
) -> Iterator[ClaimedCondition]:
    """What an author claims of all numbers. Raises what `failing` makes where a claim is none, or speaks of what is unknown."""
    for entry in entries:
        if isinstance(entry, Always):
            words, line = entry.statement.because, entry.statement.line
            try:
                yield ClaimedCondition(words, _claimed(entry.condition, known), line)
            except ValueError as error:
                raise failing(f"always(…): {error}", line) from error


def _claimed(condition: Boolean | bool | str, known: Known) -> tuple[tuple[Relation, ...], ...]:
    """None of a condition that sympy takes for true as it is stated: which of its letters it has cancelled cannot be seen any more."""
    if isinstance(condition, str):
        return ((known.relation_in_givens(condition),),)
    holds = known.in_givens_alone(condition)
    if holds == sympy.true:
        return () if condition in (True, sympy.true) else known.as_written(condition)
    if holds == sympy.false:
        one = ONE
        return ((Relation("!=", one, one),),)
    return clauses(holds)


Stated = Example[sympy.Symbol, sympy.Expr, Law]


def solved_example(entry: Stated, known: Known) -> SolvedExample:
    """Counts how many unknowns the laws leave free, for an example must leave room for the student's own. Raises ValueError."""
    equations = [
        sympy.simplify(known.in_givens(left - right)) for law in entry.laws for left, right in sides(law)
    ]
    unknowns = len(entry.unknowns)
    free = unknowns - sympy.Matrix(equations).jacobian(list(entry.unknowns)).rank()
    if free != entry.free:
        raise ValueError(f"{len(equations)} laws for {unknowns} unknowns leave {free} free, not {entry.free}")
    return Example(
        entry.statement,
        tuple(symbol.name for symbol in entry.unknowns),
        tuple(map(applied, entry.laws)),
        tuple((tuple(map(known.tree_in_givens, values)), why) for values, why in entry.apart),
        entry.free,
        known.tree_in_givens(entry.scale),
        _instance(entry, known, equations),
    )


def _instance(entry: Stated, known: Known, equations: list[sympy.Expr]) -> tuple[Expr, ...] | None:
    """One good example: the first unknowns set to simple shares of the scale, the others solved for."""
    scale = known.in_givens(entry.scale)
    chosen, others = entry.unknowns[: entry.free], list(entry.unknowns[entry.free :])
    for share in (sympy.Rational(-1, 3), sympy.Rational(1, 2), sympy.Integer(2), sympy.Rational(1, 5)):
        fixed: dict[sympy.Symbol, Any] = dict.fromkeys(chosen, share * scale)
        left = [substitute(equation, fixed) for equation in equations]
        for root in sympy.solve(left, others, dict=True) if others else [{}]:
            whole = fixed | root
            if all(
                symbol in whole and not whole[symbol].free_symbols - set(known.formulas)
                for symbol in entry.unknowns
            ) and all(at(value, each).is_real for value in whole.values() for each in known.points):
                return tuple(tree(simplest(whole[symbol])) for symbol in entry.unknowns)
    return None


def conditions(entry: Step) -> tuple[Relation, ...] | None:
    """The conditions on the root that is meant; None where they are no relations."""
    if isinstance(entry.where, bool):
        return ()
    try:
        return relations(entry.where)
    except ValueError:
        return None


def others(picked: Picked, known: Known) -> Iterator[OtherRoot]:
    """The roots that are not meant, in givens."""
    for worded, unmeant in ((True, picked.worded), (False, picked.others)):
        for root in unmeant:
            values = {symbol.name: formula(known.in_givens(value)) for symbol, value in root.items()}
            whole = {name: value for name, value in values.items() if value is not None}
            yield OtherRoot(whole if len(whole) == len(values) else {}, worded)


def asides(entry: Step, known: Known) -> dict[str, Expr]:
    """What the laws needed besides, in givens."""
    found = {symbol.name: formula(known.aside[symbol]) for symbol in entry.also}
    return {name: value for name, value in found.items() if value is not None}


def formula(expression: object) -> Expr | None:
    """In our own terms; None where it is no formula of ours."""
    try:
        return tree(as_expression(expression))
    except (NoTree, NotTyped):  # NotTyped: a complex root
        return None


@dataclass(frozen=True, slots=True)
class SolvedDerivation:
    """A derivation as it is stated and as it is solved, with the solver of each case, into whose laws the answers can be put back."""

    loaded: Loaded
    solvers: tuple[Solver, ...]
    solution: Solution


def solve(bank: Bank, problem: Problem) -> Solution:
    """Everything that is true of a problem. Raises NotDerivable with file, line and what to do."""
    return solved_derivation(bank, problem).solution


def solved_derivation(bank: Bank, problem: Problem) -> SolvedDerivation:
    """The same with what it was found from. Raises NotDerivable."""
    loaded = load(bank, problem)
    with letters_printed(problem.printed_letters):  # in the sentences on what was found
        found = tuple(solvers(problem, loaded))
        return SolvedDerivation(loaded, found, with_presentation(_of_all_cases(found)))


def _of_all_cases(found: Sequence[Solver]) -> Solution:
    solved = [(solver, _with_paths(solver.solution())) for solver in found]
    if len(solved) == 1:
        solver, only = solved[0]
        return _listed(only, solver) if any(find.numbering for find in only.unknowns) else only
    for solver, each in solved:
        if list_step := next((find for find in each.unknowns if find.numbering), None):
            raise solver.failing(
                "a list with an entry for each whole number cannot stand in a problem with cases",
                list_step.statement.line,
            )
    regimes = tuple(
        Regime(found.case, way, solver.line, replace(found, conditions=way), place)
        for place, (solver, found) in enumerate(solved)
        for way in solver.ways
    )
    return replace(regimes[0].solution, regimes=regimes)


def _with_paths(solution: Solution) -> Solution:
    """The ways to parts from others; to and from a list of numbered entries, and a formula of a variable, there are none."""
    apart = dependent(solution)
    if not apart:
        return with_paths(solution)
    others = tuple(find for find in solution.unknowns if not apart & {*find.names})
    return replace(solution, paths=with_paths(replace(solution, unknowns=others)).paths)


def _listed(template: Solution, solver: Solver) -> Solution:
    try:
        return listed(template)
    except Undefined as error:
        line = next(find.statement.line for find in template.unknowns if find.numbering)
        raise solver.failing(str(error), line) from error


def solvers(problem: Problem, loaded: Loaded) -> list[Solver]:
    """One solver for each case, or the only one. Raises NotDerivable where a case holds for no draw."""
    found: list[Solver] = []
    for branch in loaded.branches:
        solver = Solver(problem, replace(loaded, derivation=branch.derivation))
        found.append(solver if branch.case is None else solver.in_case(branch, branch.case))
    return found


class Solver:
    """Walks the entries of one problem once, in the author's order."""

    def __init__(self, problem: Problem, loaded: Loaded):
        self.problem, self.loaded, self.known = problem, loaded, Known(problem)
        self.known_in_list: dict[int, Known] = {}  # by the line of the step
        self.case, self.line = "", 0
        self.ways: tuple[tuple[Relation, ...], ...] = ()
        self.decided_by: tuple[Relation, ...] = ()

    def in_case(self, branch: Branch, case: Case) -> Solver:
        """The solver that tries only numbers at which the case holds; its condition may speak of what is found before it."""
        found = Solver(self.problem, self.loaded)
        for entry in branch.derivation.entries[: branch.before]:
            if isinstance(entry, Finding):
                try:
                    self.find(entry)
                except ValueError as error:
                    raise self.at_fault(entry, error) from error
                except Exception as error:  # as in solution
                    raise self.at_fault(entry, unforeseen(error)) from error
        try:
            found.case, found.line = case.text, case.line
            holds = self.known.in_givens(sympy.sympify(case.condition))
            self.known.refuse_variables({each.name for each in holds.free_symbols}, NO_REGIME)
            found.ways = ways(holds)
            found.known = Known(self.problem, found.ways)
            found.decided_by = _stated(case.condition)
        except ValueError as error:
            raise self.failing(f"the case {case.text!r}: {error}", case.line) from error
        return found

    def solution(self) -> Solution:
        entries = self.loaded.derivation.entries
        for sentence, line in misfits(self.problem, self.loaded.derivation):
            raise self.failing(sentence, line)
        unknowns: list[Unknown] = []
        choices: dict[str, SolvedChoice] = {}
        examples: dict[str, SolvedExample] = {}
        proofs: dict[str, SolvedProof] = {}
        forces: dict[str, SolvedForces] = {}
        for entry in entries:
            part = entry.statement.part
            try:
                match entry:
                    case Step() | Optimum() | Simulated():
                        unknowns.append(self.find(entry))
                    case Choice():
                        choices[part] = solved_choice(entry, self.problem.part(part), self.known)
                    case Forces():
                        forces[part] = solved_forces(entry, self.problem.part(part), self.known)
                    case Example():
                        examples[part] = solved_example(entry, self.known)
                    case Proof():
                        proofs[part] = applied_proof(entry, self.problem.part(part).given)
                    case _:
                        continue  # code, plot, explain, printed need no solving; what is neglected comes last
            except ValueError as error:  # NoRoot and NoTree among them
                raise self.at_fault(entry, error) from error
            except NotDerivable:
                raise
            except Exception as error:  # of sympy or of ours: it costs this problem, and no other
                raise self.at_fault(entry, unforeseen(error)) from error
        for entry in entries:
            if isinstance(entry, Proof) and (
                sentence := self.unfit_proof(entry, proofs[entry.statement.part])
            ):
                raise self.failing(f"part {entry.statement.part}: {sentence}", entry.statement.line)
        # after all that is found, so that nothing can lean on what is only supposed
        left = tuple(self.neglected(entry) for entry in entries if isinstance(entry, Neglected))
        rest, case = unsolved(self.loaded.derivation), self.case
        return Solution(
            self.problem, tuple(unknowns), choices, examples, proofs, rest, left, case=case, forces=forces,
            always=tuple(claims(entries, self.known, self.failing)), meanings=self.loaded.meanings,
            decided_by=self.decided_by,
        )  # fmt: skip

    def unfit_proof(self, entry: Proof[Law], proof: SolvedProof) -> str:
        """What is wrong with the letters of a proof, or with what is given in it; "" for nothing."""
        left = {
            equation.left.name
            for law in proof.given
            for equation in law.here
            if isinstance(equation.left, Name)
        }
        return untrue_given(proof, self.known) or strange_letter(entry, self.known.names, left)

    def failing(self, sentence: str, line: int = 0) -> NotDerivable:
        """At the author's own line, or at that of derive where the fault is of the whole."""
        return NotDerivable(self.loaded.path, line or self.loaded.line, sentence)

    def at_fault(self, entry: Entry, error: ValueError) -> NotDerivable:
        """What is wrong with an entry, named by its part, or by what it finds."""
        names = ", ".join(map(str, entry.unknowns)) if isinstance(entry, Finding) else ""
        about = f"part {entry.statement.part}" if entry.statement.part else names
        line = error.line if isinstance(error, NoRoot) else 0
        return self.failing(f"{about}: {error}", line or entry.statement.line)

    def find(self, entry: Step | Optimum | Simulated) -> Unknown:
        for symbol in entry.unknowns:
            if symbol.name in self.known.dimensions:
                raise NoRoot(f"{symbol} is given or found already; give the new find another letter")
        match entry:
            case Step():
                found = self.step(entry)
            case Optimum():
                found = self.optimum(entry)
            case Simulated():
                found = self.simulated(entry)
        self.known.dimensions |= dict(zip(found.names, found.dimensions, strict=True))
        return found

    def numbered_step(self, entry: Step, each: Each) -> Unknown:
        """A list with an entry for each whole number: its formulas have the letter of the range in them."""
        if len(entry.unknowns) > 1 or entry.also:
            raise NoRoot(
                "a list with an entry for each whole number finds one letter, and needs no other unknowns"
            )
        part = self.problem.part(entry.statement.part) if entry.statement.part else None
        if part is None or part.answer_type != "list" or part.components:
            raise NoRoot("only a .list part without components has an entry for each whole number")
        outer = self.known
        self.known = self.known_in_list[entry.statement.line] = outer.numbered(each)
        try:
            found = self.step(replace(entry, each=None))
            if found.in_givens is None:
                raise NoRoot(
                    "a list with an entry for each whole number is found by formulas, not by a simulation"
                )
        finally:
            self.known = outer
        mistakes = tuple(
            replace(
                wrong,
                rule=ClosedForms(wrong.rule.trees, wrong.rule.trees[0], self.numbering(stated.rule.each)),
            )
            if stated.rule.each is not None and isinstance(wrong.rule, ClosedForms)
            else wrong
            for wrong, stated in zip(found.mistakes, entry.mistakes, strict=True)
        )
        return replace(found, numbering=self.numbering(each), mistakes=mistakes)

    def numbering(self, each: Each) -> Numbering:
        low, high = (tree(as_expression(end)) for end in (each.low, each.high))
        return Numbering(
            each.letter.name,
            low,
            high,
            (self.known.tree_in_givens(each.low), self.known.tree_in_givens(each.high)),
        )

    def step(self, entry: Step) -> Unknown:
        if entry.each is not None:
            return self.numbered_step(entry, entry.each)
        known = self.known
        found, functions = self.roots_and_functions(entry, entry.laws)
        picked = pick(found, known.points, entry.where, entry.rejected)
        local = forms(entry.unknowns, picked.root)
        routes = tuple(SolvedRoute(applied_route(route), self.route(entry, route)) for route in entry.routes)
        mistakes = tuple(self.mistakes(entry, picked.root))
        known.found(entry.unknowns, picked.root)
        known.aside |= {symbol: simplest(known.in_givens(picked.root[symbol])) for symbol in entry.also}
        return Unknown(
            statement=entry.statement,
            names=_names(entry.unknowns),
            laws=tuple(map(applied, entry.laws)),
            local=local,
            in_givens=known.formulas_of(entry.unknowns),
            routes=routes,
            mistakes=mistakes,
            rejected=picked.refused,
            dimensions=dimensions_asked(self.problem, entry.statement.part, local.trees, known),
            scale=None if entry.scale is None else tree(known.in_givens(entry.scale)),
            note=None,
            functions=self.functions(entry, functions, picked.root),
            where=conditions(entry),
            others=tuple(others(picked, known)),
            aside=asides(entry, known),
        )

    def functions(
        self, entry: Step, found: tuple[FoundFunction, ...], root: Root
    ) -> tuple[SolvedFunction, ...]:
        """The functions found in a step, with what else was found in it put in, known to all steps from here on."""
        known = self.known
        asides = {symbol: root[symbol] for symbol in entry.also}
        final = [replace(each, formula=substitute(each.formula, asides)) for each in found]
        known.functions += final
        return tuple(map(known.solved_function, final))

    def optimum(self, entry: Optimum) -> Unknown:
        known = self.known
        goal = known.in_givens(entry.of)
        value, note = best(goal, entry.over, entry.between, entry.largest, known.points)
        root = {entry.unknowns[0]: value}
        local = forms(entry.unknowns, root)
        mistakes = tuple(self.wrong(entry, mistake, True) for mistake in entry.mistakes)
        known.found(entry.unknowns, root)
        return Unknown(
            statement=entry.statement,
            names=_names(entry.unknowns),
            laws=(),
            local=local,
            in_givens=known.formulas_of(entry.unknowns),
            routes=(),
            mistakes=mistakes,
            rejected=(),
            dimensions=dimensions_asked(self.problem, entry.statement.part, local.trees, known),
            scale=None,
            note=note,
            slope=_slope(entry, goal),
        )

    def simulated(self, entry: Simulated) -> Unknown:
        from corollary.derive.ready_scenes import ready_scenes  # only here: most need none

        bank = bank_of(self.problem)
        scenes = ready_scenes(bank)
        if entry.scene not in scenes:
            raise NoRoot(f"there is no scene {entry.scene}; choose one of {', '.join(scenes)}")
        known = scenes[entry.scene].settings
        if strange := entry.settings.keys() - {setting.name for setting in known}:
            raise NoRoot(f"scene {entry.scene} has no setting {', '.join(sorted(strange))}")
        settings = {name: tree(value) for name, value in entry.settings.items()}
        mistakes = tuple(self.wrong(entry, mistake, True) for mistake in entry.mistakes)
        units = self.problem.part(entry.statement.part).units_for(len(entry.unknowns))
        self.known.measured |= set(entry.unknowns)
        return Unknown(
            statement=entry.statement,
            names=_names(entry.unknowns),
            laws=(),
            local=SceneOutcome(entry.scene, settings, entry.observe, bank=str(bank.folder)),
            in_givens=None,
            routes=(),
            mistakes=mistakes,
            rejected=(),
            dimensions=tuple(unit.dimension for unit in units),
            scale=None,
            note=None,
        )

    def route(self, entry: Step, route: Route[Law]) -> Rule:
        try:
            found = self.roots(entry, route.laws)
            return forms(entry.unknowns, pick(found, self.known.points, entry.where, ()).root)
        except ValueError as error:
            raise NoRoot(str(error), route.line) from error

    def mistakes(self, entry: Step, right: Root) -> Iterator[Mistake[Rule]]:
        """What is found by each mistake; in a system of laws a mistake belongs to the parts whose value it changes."""
        for mistake in entry.mistakes:
            root = self.wrong_root(entry, mistake, entry.where)
            if entry.statement.system:
                changed = {
                    each for each in (*entry.unknowns, *entry.also) if not vanishes(root[each] - right[each])
                }
                if changed and not changed & set(entry.unknowns):
                    continue
            yield Mistake(mistake.text, forms(entry.unknowns, root), mistake.line, mistake.name)

    def wrong(self, entry: Finding, mistake: Mistake[Exchange], where: Boolean | bool) -> Mistake[Rule]:
        root = self.wrong_root(entry, mistake, where)
        return Mistake(mistake.text, forms(entry.unknowns, root), mistake.line, mistake.name)

    def wrong_root(self, entry: Finding, mistake: Mistake[Exchange], where: Boolean | bool) -> Root:
        """What is found by a mistake; `where` chooses only among several roots, for a mistake need not respect it."""
        try:
            only_range = isinstance(entry, Step) and mistake.rule.each is not None and not mistake.rule.laws
            laws = (
                exchanged(entry.laws, mistake)
                if isinstance(entry, Step) and not only_range
                else mistake.rule.laws
            )
            laws = entry.laws if isinstance(entry, Step) and only_range else laws
            found = self.roots(entry, laws)
            where = where if mistake.rule.where is None else mistake.rule.where
            return found[0] if len(found) == 1 else pick(found, self.known.points, where, ()).root
        except ValueError as error:
            raise NoRoot(f"the mistake {mistake.text!r}: {error}", mistake.line) from error

    def roots(self, entry: Step | Optimum | Simulated, laws: tuple[Law, ...]) -> list[Root]:
        return self.roots_and_functions(entry, laws)[0]

    def roots_and_functions(
        self, entry: Step | Optimum | Simulated, laws: tuple[Law, ...]
    ) -> tuple[list[Root], tuple[FoundFunction, ...]]:
        also = entry.also if isinstance(entry, Step) else ()
        return roots(laws, [*entry.unknowns, *also], self.known)

    def neglected(self, entry: Neglected[Step, Supposed]) -> SolvedNeglected:
        try:
            values = tuple(map(supposed_value, entry.supposing))
            for value in values:
                self.known.suppose(value)
            return Neglected(entry.what, self.find(entry.bound), values, entry.asked)
        except ValueError as error:
            sentence = f"what part {entry.statement.part} neglects: {error}"
            raise self.failing(sentence, entry.statement.line) from error


def _stated(condition: Boolean | bool) -> tuple[Relation, ...]:
    """The relations of a case as its author writes them; none where they can hold in several ways."""
    with suppress(ValueError):
        return relations(sympy.sympify(condition))
    return ()


def _slope(entry: Optimum, goal: sympy.Expr) -> tuple[Expr, Expr] | None:
    """The derivative that vanishes at an extremum: of a letter by another, and what it is in givens."""
    if not isinstance(entry.of, sympy.Symbol):
        return None
    with suppress(NoTree, ValueError):
        slope = simplest(sympy.diff(goal, entry.over))
        return Call("derivative", (Name(entry.of.name), Name(entry.over.name), ONE)), tree(slope)
    return None


def unforeseen(error: Exception) -> ValueError:
    """The sentence for a failing that nobody foresaw."""
    return ValueError(f"it cannot be solved: {type(error).__name__}: {error}")


def _names(unknowns: tuple[sympy.Symbol, ...]) -> tuple[str, ...]:
    return tuple(symbol.name for symbol in unknowns)
