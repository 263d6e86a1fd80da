"""The lemmas that certify a key: roots, what follows from them, and the printed numbers as an example."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from corollary.derive.solution import Solution, Unknown
from corollary.formula.arithmetics import exactly
from corollary.formula.ast import (
    ZERO,
    Call,
    Expr,
    Name,
    Product,
    Quotient,
    Relation,
    names,
    substitute,
    walk,
)
from corollary.formula.ball import certified, evaluate
from corollary.formula.errors import Undefined
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.polynomials.polynomial import RationalFunction, TooLarge
from corollary.polynomials.translate import Translation
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, first_broken
from corollary.verify.certificate.coq import NotAlgebraic, Roots, comment, coq, coq_name, number, polynomial
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.claims import only_roots
from corollary.verify.obligations.obligation import Equations


def combined(top: Any, equations: Sequence[tuple[int, Relation, RationalFunction]]) -> str:
    """Tactics that show a polynomial to be zero by the equations R0, R1, … of roots, each with its place, itself and left side less
    right side; "" where it is no combination of them.

    Each root is divided out in turn, the last one made first: the others may stand in it.
    """
    letters = top.context().names()
    factor, rest = top.context().constant(1), top
    terms = list[tuple[Any, int, Any]]()
    for place, known, gap in reversed(equations):
        letter = min(names(known.left))
        at = letters.index(letter)
        square = _coefficient(gap.top, at, 2)
        while (degree := int(rest.degrees()[at])) >= 2:
            by = _coefficient(rest, at, degree) * top.context().gen(at) ** (degree - 2)
            rest = square * rest - by * gap.top
            factor, terms = square * factor, [(square * each, i, other) for each, i, other in terms]
            terms.append((by, place, gap.top))
    if not terms or not rest.is_zero():
        return ""
    total = " + ".join(f"{polynomial(by)} * {polynomial(other)}" for by, _, other in terms)
    rewritten = ", ".join(f"?R'{place}" for place in dict.fromkeys(place for _, place, _ in terms))
    return (
        f"apply (Rmult_eq_reg_l {polynomial(factor)}); "
        f"[ replace ({polynomial(factor)} * {polynomial(top)}) with ({total}) by ring; rewrite {rewritten}; ring | nonzero ]"
    )


def zero(name: str, gap: RationalFunction, left: str, right: str) -> str:
    """That the numerator of left side less right side is zero, since the sides are equal."""
    top, bottom = polynomial(gap.top), polynomial(gap.bottom)
    return (
        f"assert ({name} : {top} = 0).\n"
        f"  {{ replace {top} with (({left} - {right}) * {bottom}) by (field; nonzero). replace ({left} - {right}) with 0 by lra. ring. }}"
    )


def _coefficient(found: Any, at: int, degree: int) -> Any:
    """Of a polynomial of python-flint the coefficient of a letter's power, as a polynomial in the other letters."""
    terms = {
        tuple(0 if place == at else power for place, power in enumerate(powers)): coefficient
        for powers, coefficient in found.to_dict().items()
        if int(powers[at]) == degree
    }
    return found.context().from_dict(terms)


HALF_ANGLE = (
    10**6
)  # the largest denominator of the tangent of half an angle, whose sine and cosine are rational then
PI = Fraction(314159265358979, 10**14)
PI_IN_COQ = re.compile(r"(?<![\w'])PI\b")  # not a letter of the problem, which has a mark before it
EMPTY = "no numbers were found that keep the conditions and have answers: the claims may be empty"
TACTIC = "first [ lra | field; lra | nra ]"


def witnesses(
    givens: Mapping[str, RationalPi], roots: Mapping[Expr, str], meant: Mapping[str, Expr]
) -> dict[str, Fraction]:
    """A rational number for each letter: the givens (angles rounded), roots, sines and cosines, and what is found. Raises NotAlgebraic."""
    found = {name: value.ratio * PI**value.pi for name, value in givens.items()}
    angles = dict[Expr, tuple[Fraction, Fraction]]()
    for tree, letter in roots.items():
        if not isinstance(tree, Call):
            raise NotAlgebraic("it has a root of another kind")
        known = {name: RationalPi(value) for name, value in found.items()}
        (inner,) = tree.arguments
        if tree.function == "sqrt":
            exact = exactly(tree, known)
            if exact is None or exact.pi:
                raise NotAlgebraic("a root is irrational at the printed numbers")
            found[letter] = exact.ratio
            continue
        if inner not in angles:
            half = Fraction(math.tan(float(evaluate(inner, known, 64).mid()) / 2)).limit_denominator(
                HALF_ANGLE
            )
            angles[inner] = 2 * half / (1 + half**2), (1 - half**2) / (1 + half**2)
        found[letter] = angles[inner][0 if tree.function == "sin" else 1]
    known = {name: RationalPi(value) for name, value in found.items()}
    for name, tree in meant.items():
        exact = exactly(tree, known)
        if exact is None or exact.pi:
            raise NotAlgebraic("what is found is irrational at the printed numbers")
        found[name] = exact.ratio
    return found


@dataclass(frozen=True, slots=True)
class Lemma:
    """A claim and its proof, as Coq reads them; `why` says instead why there is none."""

    name: str
    claim: str
    text: str = ""
    why: str = ""


def lemmas(solution: Solution) -> Iterator[tuple[Unknown, list[Lemma]]]:
    """For each step of a derivation the lemmas that certify what it finds, for all numbers of the box."""
    box = Box(solution.problem)
    steps = [find for find in solution.unknowns if find.laws]
    numbers = next((each.exact for each in _dealt(solution) if _admissible(each, solution)), None)
    for find, owed in zip(steps, only_roots(solution), strict=True):
        found = ", ".join(find.names)
        stem = "_".join(map(coq_name, find.names))
        claims = (f"{stem}_holds", f"the laws hold for {found}"), (f"{stem}_only", f"nothing else is {found}")
        try:
            if owed.equations is None:
                raise NotAlgebraic(owed.open or "its laws are no algebraic equations")
            step, put_in = StepInCoq(box, owed.equations), StepInCoq(box, owed.equations, put_in=True)
            one, two = claims
            proofs = [Lemma(*one, put_in.holds(one[0])), Lemma(*two, step.only(two[0]))]
        except (NotAlgebraic, TooLarge, Undefined, ValueError) as error:
            why = str(error) or "its polynomials are too large"
            yield find, [Lemma(*claim, why=why) for claim in claims]
            continue
        example = f"{stem}_example", f"the printed numbers fulfil what is taken for granted of {found}"
        if numbers is None:
            yield find, [*proofs, Lemma(*example, why=EMPTY)]
            continue
        try:
            yield find, [*proofs, Lemma(*example, step.example(example[0], numbers))]
        except (NotAlgebraic, Undefined) as error:
            yield find, [*proofs, Lemma(*example, why=str(error) or "it has no value there")]


def _dealt(solution: Solution) -> Iterator[Variant]:
    """The printed numbers; where they are not among those that are dealt, or not of this case, others."""
    yield chapter(solution.problem)
    yield from sample(solution.problem, 100)


def _admissible(variant: Variant, solution: Solution) -> bool:
    try:
        return first_broken(variant) is None and all(
            certified(tree, variant.exact).proven
            for find in solution.unknowns
            for tree in find.in_givens or ()
        )
    except Undefined:
        return False


class StepInCoq:
    """The equations of one step in letters of Coq, and what may be taken for granted about these. Raises NotAlgebraic.

    `put_in`: with what is found in place of the unknowns, in the laws.
    """

    def __init__(self, box: Box, equations: Equations, put_in: bool = False) -> None:
        every = [
            *equations.laws,
            *equations.where,
            *(Relation("=", Name(k), v) for k, v in equations.meant.items()),
        ]
        _, conditions = box.tied(every)
        letters = names(*every, *conditions)
        self.givens = [name for name in box.axes if name in letters]
        in_laws = names(*equations.laws)
        self.unknowns = [name for name in equations.unknowns if name in in_laws]
        self.roots = Roots(letters)
        put = self.roots.without
        laws = [substitute(each, equations.meant) for each in equations.laws] if put_in else equations.laws
        self.laws = [_of(put(each)) for each in laws]
        self.where = [_of(put(each)) for each in equations.where]
        self.meant = {name: put(tree) for name, tree in equations.meant.items() if name in self.unknowns}
        self.rejected = [
            {name: put(tree) for name, tree in each.items() if name in self.unknowns}
            for each in equations.rejected
        ]
        self.by_division = ""
        self.bounds: list[str] = []
        self.low: dict[str, Fraction] = {}
        self.high: dict[str, Fraction] = {}
        for name in self.givens:
            low, high = self.low[name], self.high[name] = box.axes[name].bounds
            self.bounds.append(f"{number(low)} <= {coq_name(name)} <= {number(high)}")
        self.conditions: list[str] = []
        for each in conditions:
            try:
                self.conditions.append(coq(put(each)))
            except NotAlgebraic:
                continue  # one condition less: the claim is the stronger
        trees: list[Expr] = [
            *self.laws,
            *self.where,
            *self.meant.values(),
            *(v for r in self.rejected for v in r.values()),
            *self.roots.known,
        ]
        self.translation = Translation([*trees, *map(Name, self.unknowns)], {})
        if "pi" in names(*trees):
            self.bounds.append("3 < PI")

    def holds(self, name: str) -> str:
        """The laws with what is found put in."""
        if set(self.unknowns) - self.meant.keys():
            raise NotAlgebraic("a letter of its laws is found nowhere")
        proof = [f"  {{ {self._identity(goal)} }}" for goal in self.laws]
        split = "  repeat match goal with |- _ /\\ _ => split end.\n" if len(self.laws) > 1 else ""
        goal = " /\\\n    ".join(map(coq, self.laws))
        return self._lemma(name, [], goal, split + "\n".join(proof), unknowns=())

    def only(self, name: str) -> str:
        """Whatever fulfils the laws and the conditions is what is found, or a root that is rejected in words."""
        if len(self.rejected) > 1:
            raise NotAlgebraic("it has several roots that are rejected in words")
        if not self.unknowns:
            raise NotAlgebraic("it was found with an earlier step")
        given = [coq(each) for each in (*self.laws, *self.where, *self._divided_by())]
        meanings = [self.meant, *self.rejected]
        if any(set(self.unknowns) - each.keys() for each in meanings):
            raise NotAlgebraic("a letter of its laws is found nowhere")
        goal = " \\/ ".join(
            "(" + " /\\ ".join(f"{coq_name(k)} = {coq(v)}" for k, v in each.items()) + ")"
            for each in meanings
        )
        return self._lemma(name, given, goal, self._uniqueness(), unknowns=self.unknowns)

    def example(self, name: str, numbers: Mapping[str, RationalPi]) -> str:
        """Numbers that fulfil all hypotheses of `only`, laws and conditions among them."""
        given = {each: numbers[each] for each in self.givens}
        found = witnesses(given, self.roots.made, self.meant)
        letters = [*self.givens, *self.roots.made.values(), *self.meant]
        every = [coq(each) for each in (*self.roots.known, *self.laws, *self.where, *self._divided_by())]
        goals = [*self.bounds, *self.conditions, *every]
        if any(PI_IN_COQ.search(each) for each in goals):
            raise NotAlgebraic("an assumption contains pi")
        body = " /\\\n    ".join(goals)
        binder = f"exists {' '.join(map(coq_name, letters))} : R,\n    " if letters else ""
        chosen = f"  exists {', '.join(number(found[each]) for each in letters)}.\n" if letters else ""
        return f"Lemma {name} : {binder}{body}.\nProof.\n{chosen}  repeat split; {TACTIC}.\nQed.\n"

    def _divided_by(self) -> list[Relation]:
        """The laws say nothing where they divide an unknown by zero; in Coq a quotient by zero is some number."""
        bottoms = dict.fromkeys(
            node.bottom for law in self.laws for node in walk(law) if isinstance(node, Quotient)
        )
        return [Relation("!=", each, ZERO) for each in bottoms if names(each) & set(self.unknowns)]

    def _lemma(self, name: str, given: Sequence[str], goal: str, proof: str, unknowns: Sequence[str]) -> str:
        letters = [
            *map(coq_name, self.givens),
            *map(coq_name, self.roots.made.values()),
            *map(coq_name, unknowns),
        ]
        known = [*self.bounds, *self.conditions, *map(coq, self.roots.known)]
        premises = "".join(f"  {each} ->\n" for each in (*known, *given))
        remarks = "".join(
            f"{comment(f'{letter} is {text(tree)}')}\n" for tree, letter in self.roots.made.items()
        )
        binder = f"forall {' '.join(letters)} : R,\n" if letters else ""
        labels = (
            " ".join(f"K'{place}" for place in range(len(known)))
            + " "
            + " ".join(f"L'{place}" for place in range(len(given)))
        )
        proof = self._roots_as_polynomials(len(self.bounds) + len(self.conditions)) + proof
        return f"{remarks}Lemma {name} : {binder}{premises}    {goal}.\nProof.\n  intros {' '.join(letters)} {labels}.\n{proof}\nQed.\n"

    def _roots_as_polynomials(self, place: int) -> str:
        """What is known of the squares of roots without quotients, of which nsatz makes nothing; `place` is the first one's."""
        lines = [f"  subst {coq_name(name)}.\n" for name in self._put_into_roots()]
        for at, known, gap in self._equations_of_roots():
            difference = zero(f"R'{at}", gap, coq(known.left), coq(known.right))
            lines.append(f"  {difference}\n")
            if not gap.bottom.is_constant():
                lines.append(f"  clear K'{place + at}.\n")
        return "".join(lines)

    def _put_into_roots(self) -> dict[str, Expr]:
        """Unknowns that stand in a root, and that a law states outright."""
        inside = names(*self.roots.known)
        found = {name: self._stated_outright(name) for name in self.unknowns if name in inside}
        return {name: self.laws[place].right for name, place in found.items() if place is not None}

    def _equations_of_roots(self) -> Iterator[tuple[int, Relation, RationalFunction]]:
        """What is known of the squares of roots, and of sines and cosines: its place, the equation, and left side less right side."""
        put_in = self._put_into_roots()
        for place, known in enumerate(self.roots.known):
            if known.sign == "=":
                each = _of(substitute(known, put_in))
                yield place, each, self._fraction(each.left) - self._fraction(each.right)

    def _from_roots(self, top: Any) -> str:
        return combined(top, list(self._equations_of_roots()))

    def _identity(self, goal: Relation, squared: bool = False) -> str:
        """That two sides are the same: as fractions, for the squares of the roots, or because both are positive and their squares the same."""
        try:
            gap = self.translation.fraction(goal.left) - self.translation.fraction(goal.right)
        except KeyError:
            raise NotAlgebraic("it has letters that stand for nothing") from None
        as_fractions = "field; nonzero"
        if gap.top.is_zero() and not self.roots.made:
            return f"first [ ring | {as_fractions} ]."
        top, bottom = polynomial(gap.top), polynomial(gap.bottom)
        by_roots = self._from_roots(gap.top)
        if not by_roots and not squared and not gap.top.is_zero():
            sides = Relation("=", Product((goal.left, goal.left)), Product((goal.right, goal.right)))
            difference = self._fraction(sides.left) - self._fraction(sides.right)
            if difference.top.is_zero() or self._from_roots(difference.top):
                inner = self._identity(sides, squared=True).rstrip(".")
                return f"apply Rsqr_inj; [ nonnegative | nonnegative | unfold Rsqr; {inner} ]."
        return (
            f"first [ ring | {as_fractions} | apply Rminus_diag_uniq; assert (E' : {top} = 0) by ({by_roots or 'equations'}); "
            f"replace ({coq(goal.left)} - {coq(goal.right)}) with ({top} / {bottom}) by (field; nonzero); rewrite E'; "
            "unfold Rdiv; ring ]."
        )

    def _uniqueness(self) -> str:
        """Each law as a polynomial that is zero; then what the unknowns are follows from these polynomials."""
        lines: list[str] = []
        tops: list[Any] = []
        outright = {name: place for name in self.meant if (place := self._stated_outright(name)) is not None}
        if outright.keys() == self.meant.keys() and not self.rejected:
            lines += ["  repeat match goal with |- _ /\\ _ => split end."] if len(self.meant) > 1 else []
            for name, place in outright.items():
                goal = Relation("=", self.laws[place].right, self.meant[name])
                lines.append(f"  {{ try rewrite L'{place}. {self._identity(goal)} }}")
            return "\n".join(lines)
        for place, law in enumerate(self.laws):
            gap = self._fraction(law.left) - self._fraction(law.right)
            tops.append(gap.top)
            difference = zero(f"P'{place}", gap, coq(law.left), coq(law.right))
            lines.append(f"  {difference}")
        inverses = [
            f"assert (exists i, i * {name} = 1) as [i'{place} J'{place}] by (exists (/ {name}); apply Rinv_l; nonzero)"
            for place, name in enumerate(self._divisors(tops))
        ]
        self.by_division = ""
        if len(self.unknowns) > 1:
            lines += [f"  {each}." for each in inverses]
        elif self.roots.made:  # else an equation can be solved without a division
            self.by_division = "; ".join(inverses)
        if self.rejected:
            first = self.unknowns[0]
            meant, other = (self._off(first, each[first]) for each in (self.meant, self.rejected[0]))
            lines += [
                f"  assert (E' : {polynomial(meant.top)} * {polynomial(other.top)} = 0) by solved.",
                "  destruct (Rmult_integral _ _ E') as [F' | F']; [ left | right ];",
                "  repeat match goal with |- _ /\\ _ => split end.",
            ]
            for each in (self.meant, self.rejected[0]):
                lines += [self._equal(name, tree) for name, tree in each.items()]
            return "\n".join(lines)
        lines += ["  repeat match goal with |- _ /\\ _ => split end."] if len(self.meant) > 1 else []
        lines += [self._equal(name, tree) for name, tree in self.meant.items()]
        return "\n".join(lines)

    def _stated_outright(self, name: str) -> int | None:
        """The law that says what an unknown is, in givens alone."""
        for place, law in enumerate(self.laws):
            if law.left == Name(name) and not names(law.right) & set(self.unknowns):
                return place
        return None

    def _divisors(self, tops: Sequence[Any]) -> list[str]:
        """Givens that are never zero, and stand in the equations: one may divide by them."""
        used = {
            name
            for top in tops
            for name in self.givens
            if name in top.context().names()
            and any(int(p[top.context().names().index(name)]) for p in top.to_dict())
        }
        apart = [name for name in self.givens if name in used and not self.low[name] <= 0 <= self.high[name]]
        return [coq_name(name) for name in apart]

    def _equal(self, name: str, tree: Expr) -> str:
        """An unknown is its formula: the denominator times their difference is zero; of a square the root with the other sign is not it."""
        off = self._off(name, tree)
        top, bottom = polynomial(off.top), polynomial(off.bottom)
        sides = f"{coq_name(name)} - {coq(tree)}"
        solved = f"first [ solved | {self.by_division}; solved ]" if self.by_division else "solved"
        by_sign = ""
        if self.where:
            turned = self._fraction(Name(name)) + self._fraction(tree)
            by_sign = (
                f" | assert (T' : {top} * {polynomial(turned.top)} = 0) by {solved}; "
                "destruct (Rmult_integral _ _ T') as [U' | U']; [ exact U' | first [ lra | nra ] ]"
            )
        return (
            f"  {{ assert (Z' : {top} = 0) by (first [ {solved}{by_sign} ]). apply Rminus_diag_uniq.\n"
            f"    replace ({sides}) with ({top} / {bottom}) by (field; nonzero). rewrite Z'. unfold Rdiv. ring. }}"
        )

    def _off(self, name: str, tree: Expr) -> RationalFunction:
        return self._fraction(Name(name)) - self._fraction(tree)

    def _fraction(self, tree: Expr) -> RationalFunction:
        try:
            return self.translation.fraction(tree)
        except KeyError:
            raise NotAlgebraic("it has letters that stand for nothing") from None


def _of(tree: Expr) -> Relation:
    assert isinstance(tree, Relation)
    return tree
