"""Claims to be proven: laws hold, regimes exclude each other, signs, roots, mistakes that differ from the truth, values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, product

from corollary.derive.solution import AppliedLaw, ClosedForms, Solution, Unknown
from corollary.formula.arithmetics import constant
from corollary.formula.ast import (
    ONE,
    TWO,
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    calls,
    children,
    names,
    opposite,
    substitute,
)
from corollary.formula.functions import FUNCTIONS
from corollary.formula.operators import has_operators
from corollary.formula.plain_text import text
from corollary.grading.assign import APART
from corollary.grading.mistakes import own_mistakes, visible_mistakes
from corollary.grading.rounding import MOST_TOLERANCE
from corollary.grading.signs import size_asked
from corollary.verify.obligations.obligation import Clause, Equations, Obligation


def existing(solution: Solution) -> Iterator[Obligation]:
    """Every answer, and all on the way to it, has a value."""
    for find in solution.unknowns:
        claim = f"{', '.join(find.names)} has a value"
        if find.in_givens is None:
            yield Obligation("value exists", claim, find.statement.line, open="it comes from a simulation")
        else:
            needs = dict.fromkeys(need for tree in find.in_givens for need in needed(tree))
            yield Obligation(
                "value exists",
                claim,
                find.statement.line,
                tuple((need,) for need in needs),
                formulas=find.in_givens,
            )


def not_zero(solution: Solution) -> Iterator[Obligation]:
    """No answer is zero where nothing says how large an error would be large."""
    for find in solution.unknowns:
        if find.part and find.in_givens is not None:
            part = next(each for each in solution.problem.parts if each.id == find.part)
            if part.answer_type == "integer" or part.of:
                continue  # a whole number, or a formula, is exact: 0 needs nothing to be compared with
            zero = Number(Fraction(part.unit.offset))
            sizes: list[Expr] = [
                Sum((tree, Negative(zero))) if zero.value else tree for tree in find.in_givens
            ]
            sizes += [find.scale] if find.scale is not None else []
            need = (
                Relation("!=", sizes[0], ZERO)
                if len(sizes) == 1
                else Relation(">", Sum(tuple(Power(each, TWO) for each in sizes)), ZERO)
            )
            claim = f"part {find.part} is not zero" + (", or has a scale" if find.scale is not None else "")
            yield Obligation("not zero", claim, find.statement.line, ((need,),), redrawn=True)


def off_steps(solution: Solution) -> Iterator[Obligation]:
    """The argument of each floor, ceil and round is where it does not jump; numbers near a step are redrawn."""
    for find in solution.unknowns:
        ends = find.numbering.ends if find.numbering and find.numbering.ends else ()
        trees = (*(find.in_givens or ()), *ends)
        for call in dict.fromkeys(each for tree in trees for each in calls(tree)):
            if step := FUNCTIONS[call.function].step:
                (argument,) = call.arguments
                turned = Product((Name("pi"), argument))
                apart = Call("sin" if step == "whole" else "cos", (turned,))
                claim = f"{text(argument)} is no step of {call.function}"
                need = Relation("!=", apart, ZERO)
                yield Obligation("no step", claim, find.statement.line, ((need,),), redrawn=True)


def needed(tree: Expr) -> Iterator[Relation]:
    """What must hold so that a formula has a value: of its parts first."""
    for part in children(tree):
        yield from needed(part)
    match tree:
        case Quotient(_, bottom) if not constant(bottom):
            yield Relation("!=", bottom, ZERO)
        case Power(base, exponent):
            power = constant(exponent)
            if power is None:
                yield Relation(">", base, ZERO)
            elif power.denominator > 1 and not _positive(base):
                yield Relation(">" if power < 0 else ">=", base, ZERO)
            elif power < 0 and not constant(base):
                yield Relation("!=", base, ZERO)
        case Call("sqrt", (of,)) if not _positive(of):
            yield Relation(">=", of, ZERO)
        case Call("ln" | "log10" | "gamma", (of,)):
            yield Relation(">", of, ZERO)
        case Call("asin" | "acos", (of,)):
            yield Relation("<=", of, ONE)
            yield Relation(">=", of, Negative(ONE))
        case Call("tan", (of,)):
            yield Relation("!=", Call("cos", (of,)), ZERO)
        case Call("atan2", (y, x)):
            yield Relation(">", Sum((Power(y, TWO), Power(x, TWO))), ZERO)
        case Product() | Name() | _:
            pass


def _positive(tree: Expr) -> bool:
    """Of a formula without letters."""
    value = constant(tree)
    return value is not None and value > 0


def laws_of(names: Sequence[str]) -> str:
    """The claim about the step that finds these."""
    return f"the laws of {', '.join(names)} hold for what is found"


def laws_hold(solution: Solution) -> Iterator[Obligation]:
    """One claim for each step. That its laws vanish is found by whoever puts them back; here, that they have a value."""
    found: dict[str, Expr] = {}
    for find in solution.unknowns:
        if find.in_givens is not None:
            found |= zip(find.names, find.in_givens, strict=True)
        found |= find.aside
        if not find.laws:
            continue
        claim, line = laws_of(find.names), find.statement.line
        here = [relation for law in find.laws for relation in law.here]
        if find.in_givens is None:
            yield Obligation("laws hold", claim, line, open="it rests on a simulation")
        elif any(map(has_operators, here)):
            yield Obligation("laws hold", claim, line, open="a differential equation, tried at points")
        else:
            sides = [substitute(side, found) for each in here for side in (each.left, each.right)]
            needs = dict.fromkeys(need for side in sides for need in needed(side))
            yield Obligation("laws hold", claim, line, tuple((need,) for need in needs))


MOST_CLAUSES = 64
TRUE, FALSE = Relation("=", ZERO, ZERO), Relation("=", ONE, ZERO)


def one_case(solution: Solution) -> Iterator[Obligation]:
    """Of the cases, and of the options of each choice."""
    if solution.template is not None:
        yield from lengths_met(solution, solution.template)
    elif solution.regimes:
        line = min(each.line for each in solution.regimes)
        yield _exactly_one([each.conditions for each in solution.regimes], "exactly one case holds", line)
    for part, choice in solution.choices.items():
        # of one option no two ways hold together
        held = [way or (TRUE,) for ways in choice.options.values() for way in ways or ((FALSE,),)]
        claim = f"exactly one option of part {part} holds"
        yield _exactly_one(held, claim, choice.statement.line)


def _exactly_one(cases: list[Clause], claim: str, line: int) -> Obligation:
    """One at least: whichever condition is taken of each case, one of those holds. No two: a condition of the two fails."""
    every = list(product(*cases))
    pairs = [tuple(map(opposite, (*one, *other))) for one, other in combinations(cases, 2)]
    if len(every) + len(pairs) > MOST_CLAUSES:
        return Obligation("one case", claim, line, open="there are too many conditions")
    return Obligation("one case", claim, line, (*every, *pairs))


def lengths_met(solution: Solution, template: Solution) -> Iterator[Obligation]:
    """Each end of the range of a list is one of those whose lists are checked: there is no number between two of these."""
    for place, find in enumerate(template.unknowns):
        if find.numbering is None or find.numbering.ends is None:
            continue
        lists = [each.solution.unknowns[place] for each in solution.regimes]
        lengths = {len(each.entries) for each in lists}
        claim = f"the lists of {find.names[0]} that are checked are all there are"
        needs: list[Clause] = []
        varying = 0
        for end in find.numbering.ends:
            if constant(end) is None:
                varying += 1
                found = sorted({number for each in lists for number in _end_numbers(each, end, find)})
                if not found or found != list(range(found[0], found[-1] + 1)):
                    varying = 2
                    break
                needs += [(Relation(">=", end, _whole(found[0])),), (Relation("<=", end, _whole(found[-1])),)]
        if varying > 1:
            yield Obligation(
                "one case", claim, find.statement.line, open=f"{len(lengths)} lengths were met", tried=True
            )
        else:
            yield Obligation("one case", claim, find.statement.line, tuple(needs))


def _end_numbers(found: Unknown, end: Expr, template: Unknown) -> Iterator[int]:
    """The number that an end of the range is, where the list has the entries that were found."""
    assert template.numbering is not None
    assert template.numbering.ends is not None
    low, high = template.numbering.ends
    other = constant(high if end is low else low)
    if other is not None:
        count = len(found.entries) - 1
        yield int(other) - count if end is low else int(other) + count


def _whole(number: int) -> Expr:
    return Number(Fraction(number)) if number >= 0 else Negative(Number(Fraction(-number)))


TRUE_AT_ONCE = "sympy takes the condition for true before it has numbers; in quotes it is proven as it stands"


def of_claimed_sign(solution: Solution) -> Iterator[Obligation]:
    """Of the answers whose part asks in English for what cannot be negative."""
    for find in solution.unknowns:
        if not find.part or find.in_givens is None or len(find.in_givens) != 1:
            continue
        words = size_asked(solution.problem.part(find.part))
        if not words:
            continue
        (tree,) = find.in_givens
        claim = f"part {find.part} is not negative, for it asks {words!r}"
        yield Obligation("claimed sign", claim, find.statement.line, ((Relation(">=", tree, ZERO),),))


def always_so(solution: Solution) -> Iterator[Obligation]:
    """What the statement says in words, and `always(…)` in the solution as a condition."""
    for each in solution.always:
        needs = each.conditions
        yield Obligation(
            "claimed", each.words, each.line, needs, open="" if needs else TRUE_AT_ONCE, tried=False
        )


Body = tuple[Expr, tuple[Expr, ...]]
"""A mass, and the components of a velocity."""


def not_created(solution: Solution) -> Iterator[Obligation]:
    """After two bodies or more have met, they have no more kinetic energy than before; every mass is positive."""
    found: dict[str, Expr] = {}
    for find in solution.unknowns:
        own = zip(find.names, find.in_givens, strict=True) if find.in_givens is not None else ()
        found |= own
        found |= find.aside
        known = found.keys() | {given.symbol for given in solution.problem.givens} | {"pi"}
        for law in find.laws:
            if law.name != "Conservation of momentum":
                continue
            before, after = (_bodies(law, side) for side in (0, 1))
            every = [tree for mass, speeds in (*before, *after) for tree in (mass, *speeds)]
            if not before or not after or any(names(tree) - known for tree in every):
                continue
            masses = dict.fromkeys(substitute(mass, found) for mass, _ in (*before, *after))
            needs = tuple(
                (Relation(">", mass, ZERO),)
                for mass in masses
                if not (isinstance(mass, Number) and mass.value > 0)
            )
            line = find.statement.line
            yield Obligation("not created", f"the masses around {find.names[0]} are positive", line, needs)
            if len(before) > 1:
                spent = Relation("<=", substitute(_energy(after), found), substitute(_energy(before), found))
                claim = f"no kinetic energy is created where {', '.join(find.names)} is found"
                yield Obligation("not created", claim, line, ((spent,),))


def _bodies(law: AppliedLaw, side: int) -> list[Body]:
    """The bodies of one side of the law; none where it is not a sum of masses times velocities."""
    components = [(relation.left, relation.right)[side] for relation in law.here]
    terms = [each.terms if isinstance(each, Sum) else (each,) for each in components]
    if any(not isinstance(term, Product) or len(term.factors) != 2 for each in terms for term in each):
        return []
    return [
        (column[0].factors[0], tuple(term.factors[1] for term in column))  # type: ignore[union-attr]
        for column in zip(*terms, strict=True)
    ]


def _energy(bodies: list[Body]) -> Expr:
    """Twice the kinetic energy."""
    terms = [Product((mass, Sum(tuple(Power(each, TWO) for each in speeds)))) for mass, speeds in bodies]
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0]


Found = Mapping[str, Expr]
NOT_FOUND = "that the algebra system has found all roots is not proven"


def only_roots(solution: Solution) -> Iterator[Obligation]:
    """For each step: its condition holds for the root that is meant, and for no other that is real."""
    found: dict[str, Expr] = {}
    for find in solution.unknowns:
        for each in find.entries or (find,):
            if each.laws:
                yield _only_root(each, found)
        if find.in_givens is not None:
            found |= zip(find.names, find.in_givens, strict=True)
        found |= find.aside


def _only_root(find: Unknown, found: Found) -> Obligation:
    claim = f"{', '.join(find.names)} is the only admissible root of its laws"
    line = find.statement.line
    if find.in_givens is None:
        return Obligation("one root", claim, line, open="it rests on a simulation", tried=False)
    if find.where is None:
        return Obligation("one root", claim, line, open="its condition is not a relation")
    here = [relation for law in find.laws for relation in law.here]
    meant = dict(zip(find.names, find.in_givens, strict=True)) | dict(find.aside)
    needs: list[Clause] = [(substitute(each, meant | dict(found)),) for each in find.where]
    rejected = [each.values for each in find.others if each.worded]
    others = [each.values for each in find.others if not each.worded and each.values]
    partial = [_not_admitted(other, meant, find.where, found) for other in others]
    equations = None
    if not any(map(has_operators, here)) and all(rejected):
        where = [substitute(each, found) for each in find.where]
        laws = tuple(substitute(each, found) for each in here)
        equations = Equations(laws, tuple(meant), meant, tuple(rejected), tuple(where), tuple(others))
    return Obligation(
        "one root", claim, line, tuple(needs), equations, tuple(partial), open="" if equations else NOT_FOUND
    )


def _not_admitted(other: Found, meant: Found, where: tuple[Relation, ...], found: Found) -> Clause:
    """That another root is the one that is meant, breaks a condition, or has no value: a relation that is never true says so."""
    broken = tuple(opposite(substitute(each, dict(other) | dict(found))) for each in where)
    no_value = (
        () if where and len(other) == 1 else tuple(Relation("!=", each, each) for each in other.values())
    )
    return (*_same(other, meant), *broken, *no_value)


def _same(other: Found, meant: Found) -> Clause:
    """That another root of one unknown is there the one that is meant: a double root."""
    (name, *more) = other
    return () if more or name not in meant else (Relation("=", other[name], meant[name]),)


def apart(solution: Solution) -> Iterator[Obligation]:
    """Every mistake is told from the truth, in the parts where it shows first; numbers for which it is not are redrawn."""
    for each in visible_mistakes(solution):
        claim = f"part {each.part}: {each.mistake.text!r} is told from the truth"
        line, find = each.mistake.line, solution.unknowns[each.at]
        largest = max(MOST_TOLERANCE, solution.problem.part(each.part).tolerance)
        share = Number(Fraction(str(largest)) + Fraction(str(APART)))  # relative: beyond, it is told apart
        wrong = each.formulas(solution)
        rule = each.mistake.rule
        if isinstance(rule, ClosedForms) and rule.numbering != find.numbering:
            why = "how long its list is depends on the numbers"
            yield Obligation("mistake apart", claim, line, redrawn=True, open=why)
        elif find.in_givens is None or wrong is None:
            why = "it rests on a simulation"
            yield Obligation("mistake apart", claim, line, redrawn=True, open=why)
        elif solution.problem.asks_of_variable(each.part):
            differ = tuple(
                Relation("!=", mine, tree) for mine, tree in zip(wrong, find.in_givens, strict=True)
            )
            yield Obligation("mistake apart", claim, line, (differ,), somewhere=True)
        elif solution.problem.part(each.part).rows:
            pairs = zip(wrong, find.in_givens, strict=True)
            need = tuple(
                far for mine, tree in pairs for far in _far((mine,), (tree,), (tree,), share) if mine != tree
            )
            yield Obligation("mistake apart", claim, line, (need,), redrawn=True)
        else:
            sizes = [find.in_givens, *([] if find.scale is None else [(find.scale,)])]
            needs = [_far(wrong, find.in_givens, size, share) for size in sizes]
            yield Obligation("mistake apart", claim, line, tuple(needs), redrawn=True)


def differing(solution: Solution) -> Iterator[Obligation]:
    """Some numbers tell any two mistakes of a step apart: checked by `settle` at single points, which is all it takes."""
    for place in range(len(solution.unknowns)):
        rules = [(each.mistake, each.formulas(solution)) for each in own_mistakes(solution, place)]
        for (one, left), (other, right) in combinations(rules, 2):
            if left is not None and right is not None and len(left) == len(right):
                claim = f"{one.text!r} and {other.text!r} are two mistakes"
                need: Clause = tuple(Relation("!=", a, b) for a, b in zip(left, right, strict=True))
                yield Obligation("mistakes differ", claim, other.line, (need,), somewhere=True)


def _far(wrong: tuple[Expr, ...], truth: tuple[Expr, ...], size: tuple[Expr, ...], share: Number) -> Clause:
    """The distance is larger than the share of the size: for numbers without squares, whose factors are seen at once."""
    gaps = [Sum((mine, Negative(theirs))) for mine, theirs in zip(wrong, truth, strict=True)]
    if len(gaps) == len(size) == 1:
        allowed = Product((share, size[0]))
        beyond = Product((Sum((gaps[0], Negative(allowed))), Sum((gaps[0], allowed))))
        return (Relation(">", beyond, ZERO),)
    far = Sum(tuple(Power(each, TWO) for each in gaps)) if len(gaps) > 1 else Power(gaps[0], TWO)
    own = [Power(Product((share, each)), TWO) for each in size]
    return (Relation(">", far, Sum(tuple(own)) if len(own) > 1 else own[0]),)
