"""A derivation solved: each step's laws for its unknowns, in the letters before it and in the givens alone."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy
from sympy.logic.boolalg import Boolean

from corollary.derive.applied import applied, applied_proof, applied_route, strange_letter, supposed_value
from corollary.derive.assumptions import FoundFunction, Known, Root, forms, simplest
from corollary.derive.cases import Branch, Case, ways
from corollary.derive.choices import claims, solved_choice
from corollary.derive.derivation import Entry
from corollary.derive.example import solved_example
from corollary.derive.forces import solved_forces
from corollary.derive.free_body import Forces
from corollary.derive.load import Loaded, NotDerivable, load
from corollary.derive.optimum import best
from corollary.derive.other_roots import asides, conditions, others
from corollary.derive.parts import dimensions_asked, misfits, unsolved
from corollary.derive.paths import with_paths
from corollary.derive.roots import NoRoot, exchanged, pick, roots
from corollary.derive.solution import (
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
)
from corollary.derive.statements import (
    Choice,
    Example,
    Exchange,
    Finding,
    Mistake,
    Neglected,
    Optimum,
    Proof,
    Route,
    Simulated,
    Step,
    Supposed,
)
from corollary.formula.ast import Relation
from corollary.formula.from_sympy import tree
from corollary.laws.law import Law, substitute
from corollary.problem.bank import Bank, bank_of
from corollary.problem.problem import Problem


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
    found = tuple(solvers(problem, loaded))
    return SolvedDerivation(loaded, found, _of_all_cases(found))


def _of_all_cases(found: Sequence[Solver]) -> Solution:
    solved = [(solver, with_paths(solver.solution())) for solver in found]
    if len(solved) == 1:
        return solved[0][1]
    regimes = tuple(
        Regime(found.case, way, solver.line, replace(found, conditions=way), place)
        for place, (solver, found) in enumerate(solved)
        for way in solver.ways
    )
    return replace(regimes[0].solution, regimes=regimes)


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
        self.case, self.line = "", 0
        self.ways: tuple[tuple[Relation, ...], ...] = ()

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
            found.ways = ways(self.known.in_givens(sympy.sympify(case.condition)))
            found.known = Known(self.problem, found.ways)
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
                        proofs[part] = applied_proof(entry)
                    case _:
                        continue  # code, plot, explain, printed need no solving; what is neglected comes last
            except ValueError as error:  # NoRoot and NoTree among them
                raise self.at_fault(entry, error) from error
            except NotDerivable:
                raise
            except Exception as error:  # of sympy or of ours: it costs this problem, and no other
                raise self.at_fault(entry, unforeseen(error)) from error
        for entry in entries:
            if isinstance(entry, Proof) and (sentence := strange_letter(entry, self.known.names)):
                raise self.failing(f"part {entry.statement.part}: {sentence}", entry.statement.line)
        # after all that is found, so that nothing can lean on what is only supposed
        left = tuple(self.neglected(entry) for entry in entries if isinstance(entry, Neglected))
        rest, case = unsolved(self.loaded.derivation), self.case
        return Solution(
            self.problem, tuple(unknowns), choices, examples, proofs, rest, left, case=case, forces=forces,
            always=tuple(claims(entries, self.known, self.failing)), meanings=self.loaded.meanings,
        )  # fmt: skip

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

    def step(self, entry: Step) -> Unknown:
        known = self.known
        found, functions = self.roots_and_functions(entry, entry.laws)
        picked = pick(found, known.points, entry.where, entry.rejected)
        local = forms(entry.unknowns, picked.root)
        routes = tuple(SolvedRoute(applied_route(route), self.route(entry, route)) for route in entry.routes)
        mistakes = tuple(self.wrong(entry, mistake, entry.where) for mistake in entry.mistakes)
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
        )

    def simulated(self, entry: Simulated) -> Unknown:
        from corollary.derive.ready_scenes import ready_scenes  # only here: most need none

        bank = bank_of(self.problem)
        scenes = ready_scenes(bank)
        if entry.scene not in scenes:
            raise NoRoot(f"there is no scene {entry.scene}; there are {', '.join(scenes)}")
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

    def wrong(self, entry: Finding, mistake: Mistake[Exchange], where: Boolean | bool) -> Mistake[Rule]:
        """What is found by a mistake; `where` chooses only among several roots, for a mistake need not respect it."""
        try:
            laws = exchanged(entry.laws, mistake) if isinstance(entry, Step) else mistake.rule.laws
            found = self.roots(entry, laws)
            where = where if mistake.rule.where is None else mistake.rule.where
            root = found[0] if len(found) == 1 else pick(found, self.known.points, where, ()).root
            return Mistake(mistake.text, forms(entry.unknowns, root), mistake.line)
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


def unforeseen(error: Exception) -> ValueError:
    """The sentence for a failing that nobody foresaw."""
    return ValueError(f"it cannot be solved: {type(error).__name__}: {error}")


def _names(unknowns: tuple[sympy.Symbol, ...]) -> tuple[str, ...]:
    return tuple(symbol.name for symbol in unknowns)
