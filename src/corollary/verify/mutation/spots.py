"""A derivation in doubles at single draws: true values of all letters, and those that bent laws lead to."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

from corollary.derive.derivation import Entry
from corollary.derive.solution import ClosedForms, Solution, Unknown
from corollary.derive.statements import Finding, Optimum, Step
from corollary.formula.arithmetics import DOUBLES, Evaluation, NotAvailable, ready
from corollary.formula.ast import Relation, names
from corollary.formula.from_sympy import NoTree, tree
from corollary.formula.operators import has_operators
from corollary.grading.key import Key
from corollary.verify.mutation.numeric_roots import FAILURES, SAME, Values

UNCHANGED = 1e-12  # relative: a letter that no bend has moved


class Contradicted(Exception):
    """A bent derivation that fails: no root, several, or one against what is claimed of it."""


class BentEquations(Protocol):
    """The equations of a step with bent laws: in numbers (`NumericEquations`), or solved in formulas (`RootFormulas`)."""

    @property
    def unknowns(self) -> tuple[str, ...]: ...

    @property
    def letters(self) -> frozenset[str]: ...

    @property
    def angular(self) -> bool: ...

    def roots(self, letters: Mapping[str, float], near: Values) -> list[Values] | None: ...


@dataclass(slots=True)
class MutationSpot:
    """One draw: its givens and every letter that is found, in doubles; `key` where a key was made for it."""

    letters: dict[str, float]
    key: Key | None = None


@dataclass(slots=True)
class BentValues:
    """The letters that bent laws lead to, and those whose values are not known."""

    letters: dict[str, float]
    unknown: set[str] = field(default_factory=set[str])

    def of(self, wanted: Sequence[str]) -> Values | None:
        """The values of letters; None where one is not known."""
        if self.unknown.intersection(wanted):
            return None
        return tuple(self.letters[name] for name in wanted)


@dataclass(slots=True)
class FindInDoubles:
    """A find with the entry that states it, its rule and its conditions in doubles; `differential` where its rule is the solution
    of derivatives or integrals, which may have another form for other numbers."""

    place: int
    entry: Step | Optimum | Finding
    find: Unknown
    rule: list[Evaluation]
    needs: frozenset[str]
    where: list[tuple[str, Evaluation, Evaluation]] | None
    aside: dict[str, Evaluation]
    differential: bool

    @property
    def own(self) -> tuple[str, ...]:
        """The letters found, those that nobody asks for too."""
        also = self.entry.also if isinstance(self.entry, Step) else ()
        return (*self.find.names, *(symbol.name for symbol in also))


def founds(solution: Solution, entries: Sequence[Entry]) -> list[FindInDoubles]:
    """The finds of a derivation, in their order. Raises NotAvailable where a formula has no doubles."""
    stated = [entry for entry in entries if isinstance(entry, Finding)]
    return [
        _found(place, entry, find)
        for place, (entry, find) in enumerate(zip(stated, solution.unknowns, strict=True))
    ]


def _found(place: int, entry: Finding, find: Unknown) -> FindInDoubles:
    rule: list[Evaluation] = []
    needs = frozenset[str]()
    if isinstance(find.local, ClosedForms):
        rule = [ready(each, DOUBLES) for each in find.local.trees]
        needs = needs | names(*find.local.trees)
    else:
        needs = needs | names(*find.local.settings.values())
    if isinstance(entry, Optimum):  # its rule is in the givens, and takes no notice of letters found before
        needs |= {str(each) for each in entry.of.free_symbols}
    where = None if find.where is None else [compared(each) for each in find.where]
    aside = {name: ready(each, DOUBLES) for name, each in find.aside.items()}
    differential = any(has_operators(relation) for law in find.laws for relation in law.here)
    return FindInDoubles(place, entry, find, rule, needs, where, aside, differential)


def compared(relation: Relation) -> tuple[str, Evaluation, Evaluation]:
    """A condition ready to be held against letters."""
    return relation.sign, ready(relation.left, DOUBLES), ready(relation.right, DOUBLES)


def fulfilled(condition: tuple[str, Evaluation, Evaluation], letters: Mapping[str, float]) -> bool | None:
    """Whether a condition holds; None where it cannot be said."""
    sign, left, right = condition
    try:
        one, other = left(letters), right(letters)
    except FAILURES:
        return None
    if one == other:
        return sign in ("<=", ">=", "=")
    if abs(one - other) <= 1e-12 * max(abs(one), abs(other)):  # rounding decides
        return None if sign in ("<", ">", "!=") else True
    match sign:
        case "<" | "<=":
            return one < other
        case ">" | ">=":
            return one > other
        case "!=":
            return True
        case _:
            return False


def spot_of(key: Key, every: Sequence[FindInDoubles]) -> MutationSpot:
    """The letters of a key, and what laws needed besides."""
    letters = {name: float(value) for name, value in key.variant.exact.items()}
    for found, values in zip(every, key.values, strict=True):
        letters |= zip(found.find.names, values, strict=True)
        letters |= {
            name: value for name, each in found.aside.items() if (value := _value(each, letters)) is not None
        }
    return MutationSpot(letters, key)


def spot_at(givens: Mapping[str, float], every: Sequence[FindInDoubles]) -> MutationSpot | None:
    """The letters for givens that no variant has; None where one has no value."""
    letters = dict(givens)
    for found in every:
        if not found.rule:
            return None
        try:
            values = [each(letters) for each in found.rule]
        except FAILURES:
            return None
        if not all(map(math.isfinite, values)):
            return None
        letters |= zip(found.find.names, values, strict=True)
        letters |= {
            name: value for name, each in found.aside.items() if (value := _value(each, letters)) is not None
        }
    return MutationSpot(letters)


def _value(evaluation: Evaluation, letters: Mapping[str, float]) -> float | None:
    try:
        return evaluation(letters)
    except FAILURES:
        return None


def bent_values(
    every: Sequence[FindInDoubles], bent: Mapping[int, BentEquations], spot: MutationSpot
) -> BentValues:
    """Every letter where the laws of some steps are bent, by place. Raises Contradicted."""
    true = spot.letters
    asked = {name for found in every for name in (*found.own, *found.aside)}
    found_now = BentValues({name: value for name, value in true.items() if name not in asked})
    letters, unknown = found_now.letters, found_now.unknown
    for found in every:
        own = found.own
        equations = bent.get(found.place)
        if equations is not None:
            if unknown & (equations.letters - {*own}):
                unknown |= {*own}
            else:
                near = tuple(true.get(name, 1.0) for name in equations.unknowns)
                letters |= zip(equations.unknowns, _root(found, equations, letters, near), strict=True)
        elif unknown & found.needs:
            unknown |= {*own}
        elif all(
            _same(letters[name], true[name]) for name in found.needs if name in letters and name in true
        ):
            letters |= {name: true[name] for name in own if name in true}
        elif not found.rule or isinstance(found.entry, Optimum):
            unknown |= {*own}
        else:
            try:
                values = [each(letters) for each in found.rule]
            except FAILURES as error:
                if found.differential:
                    unknown |= {*own}
                    continue
                raise Contradicted("no real value") from error
            letters |= zip(found.find.names, values, strict=True)
            unknown |= {*own} - {*found.find.names}
            if any(fulfilled(each, letters) is False for each in found.where or ()):
                if found.find.others or found.find.rejected:
                    unknown |= {*own}  # then another root may be the one that is meant
                else:
                    raise Contradicted("a condition does not hold")
    return found_now


def _same(one: float, other: float) -> bool:
    return one == other or abs(one - other) <= UNCHANGED * max(abs(one), abs(other))


def _root(
    found: FindInDoubles, equations: BentEquations, letters: Mapping[str, float], near: Values
) -> Values:
    """The root that is meant. Raises Contradicted."""
    roots = equations.roots(letters, near)
    if roots is None:
        raise Contradicted("an unknown stays free")
    if not roots:
        raise Contradicted("no root")
    entry = found.entry
    assert isinstance(entry, Step)
    for each in rejected(entry, letters):
        wanted = [each.get(name) for name in equations.unknowns]
        left = [root for root in roots if not _is(root, wanted)]
        if len(left) == len(roots):
            raise Contradicted("the root to reject is none")
        roots = left
    if not roots:
        raise Contradicted("no root is left")
    if found.where:
        named = [dict(letters) | dict(zip(equations.unknowns, root, strict=True)) for root in roots]
        roots = [
            root
            for root, at in zip(roots, named, strict=True)
            if not any(fulfilled(each, at) is False for each in found.where)
        ]
        if not roots:
            raise Contradicted("no root fulfils the condition")
    if len(roots) > 1 and found.where is not None and not equations.angular:
        raise Contradicted("several roots")
    return min(roots, key=lambda root: math.dist(root, near))


def rejected(entry: Step, letters: Mapping[str, float]) -> Iterator[dict[str, float]]:
    """The values of the roots that an author rejects in words."""
    for each in entry.rejected:
        try:
            yield {symbol.name: ready(tree(value), DOUBLES)(letters) for symbol, value in each.root.items()}
        except (NoTree, NotAvailable, *FAILURES):
            continue


def _is(root: Values, wanted: Sequence[float | None]) -> bool:
    size = math.hypot(*root)
    return all(
        other is None or abs(value - other) <= SAME * max(abs(value), abs(other), 1e-6 * size)
        for value, other in zip(root, wanted, strict=True)
    )
