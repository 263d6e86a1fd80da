"""Lists with an entry for each whole number in a range: the template of a step, and its entries for the numbers at hand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import islice, product

from corollary.answers.evaluation import BITS, numbers
from corollary.derive.solution import (
    AppliedLaw,
    ClosedForms,
    Numbering,
    OtherRoot,
    Regime,
    Rule,
    Solution,
    SolvedRoute,
    Unknown,
)
from corollary.derive.statements import Mistake
from corollary.formula.arithmetics import constant, exactly
from corollary.formula.ast import (
    ONE,
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
    mapped,
    names,
    negated,
    substitute,
)
from corollary.formula.ball import Ball, RationalPi, Undefined, certified, precision_of
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, first_broken

LONGEST = 12  # entries: as many numbers as a student's list may have
CORNERS = 64
TRIED = 400  # draws by which the lengths are found that lists have
NEARLY_WHOLE = 1e-6  # an end that is worked out of a student's own numbers


def listed(template: Solution) -> Solution:
    """The solution with a regime for each length that its lists have among the draws. Raises Undefined where all are empty, or too long."""
    found: dict[int, Solution] = {}
    why = Undefined("no draw keeps the conditions")
    problem = template.problem
    for variant in (chapter(problem), *sample(problem, TRIED, salt="lists"), *_corners(problem)):
        try:
            solution = listed_at(template, variant.exact)
        except Undefined as error:
            why = error
        else:
            found[id(solution)] = solution
    if not found:
        raise why
    line = min(find.statement.line for find in template.unknowns if find.numbering)
    regimes = tuple(Regime(_ranges(each), each.conditions, line, each, 0) for each in found.values())
    return replace(regimes[0].solution, regimes=regimes, template=template)


def _corners(problem: Problem) -> Iterator[Variant]:
    """The ends of all ranges that keep the conditions: there most lists are the longest, or the shortest."""
    ends = [(0, given.grid.count - 1) if given.grid.count > 1 else (0,) for given in problem.givens]
    for places in islice(product(*ends), CORNERS):
        values = {given.symbol: given.grid[at] for given, at in zip(problem.givens, places, strict=True)}
        if first_broken(variant := Variant(problem, values, None)) is None:
            yield variant


def solution_for(solution: Solution, givens: Mapping[str, RationalPi]) -> Solution:
    """What is true for these numbers: their case, and lists with the entries that there are. Raises Undefined."""
    return solution.at(givens) if solution.template is None else listed_at(solution.template, givens)


def listed_at(template: Solution, givens: Mapping[str, RationalPi]) -> Solution:
    """The solution whose lists have the entries for these numbers, made once for each range. Raises Undefined."""
    ends: list[tuple[int, int]] = []
    for find in template.unknowns:
        for numbering in _numberings(find):
            assert numbering.ends is not None
            low, high = (certified(end, givens).value for end in numbering.ends)
            if numbering is find.numbering:
                _refuse_length(numbering, low, high)
            ends.append((round(low), round(high)))
    key = "listed", *ends
    if key not in template.results:
        template.results[key] = _made(template, iter(ends))
    return template.results[key]


def own_range(rule: Rule) -> Numbering | None:
    """The range of a mistake whose list has other numbers than the step's."""
    return rule.numbering if isinstance(rule, ClosedForms) else None


def _numberings(find: Unknown) -> Iterator[Numbering]:
    """Its own range, then those of its mistakes."""
    if find.numbering is not None:
        yield find.numbering
        yield from (own for each in find.mistakes if (own := own_range(each.rule)) is not None)


def _refuse_length(numbering: Numbering, low: float, high: float) -> None:
    if high < low:
        raise Undefined(f"there is no {numbering.letter} from {low:g} to {high:g}, so the list is empty")
    if high - low >= LONGEST:
        raise Undefined(f"the list has {high - low + 1:g} entries, and {LONGEST} are the most")


def _ranges(solution: Solution) -> str:
    """The ranges of its lists, as `verify` names them."""
    return "; ".join(
        f"{', '.join(each.names[0] for each in find.entries[:1])} to {find.entries[-1].names[0]}"
        for find in solution.unknowns
        if find.entries
    )


def _made(template: Solution, ends: Iterator[tuple[int, int]]) -> Solution:
    conditions: list[Relation] = []
    unknowns: list[Unknown] = []
    in_use = {given.symbol for given in template.problem.givens}
    in_use |= {name for find in template.unknowns for name in find.names}
    for find in template.unknowns:
        if find.numbering is None:
            unknowns.append(find)
            continue
        low, high = next(ends)
        assert find.numbering.ends is not None
        for end, number in zip(find.numbering.ends, (low, high), strict=True):
            conditions += _equal(end, number)
        others = [next(ends) for each in find.mistakes if own_range(each.rule)]
        unknowns.append(_with_entries(find, range(low, high + 1), others, in_use))
    return replace(template, unknowns=tuple(unknowns), conditions=tuple(conditions), template=None)


def _with_entries(find: Unknown, numbered: range, others: list[tuple[int, int]], in_use: set[str]) -> Unknown:
    """The unknown with an entry for each number; `others` are the ranges of mistakes that have one of their own."""
    (base,), numbering = find.names, find.numbering
    assert numbering is not None
    index = numbered if numbered[0] >= 0 else range(1, len(numbered) + 1)
    entries = tuple(
        entry_of(find, _letter(base, at, in_use), number) for at, number in zip(index, numbered, strict=True)
    )
    ranges = iter(others)
    mistakes: list[Mistake[Rule]] = []
    for each in find.mistakes:
        own = own_range(each.rule)
        of = numbered
        if own is not None:
            low, high = next(ranges)
            of = range(low, min(high, low + LONGEST) + 1)
        mistakes.append(replace(each, rule=_listed_rule(each.rule, own or numbering, of)))
    return replace(
        find,
        names=tuple(name for each in entries for name in each.names),
        laws=tuple(
            replace(law, here=tuple(one for each in entries for one in each.laws[place].here))
            for place, law in enumerate(find.laws)
        ),
        local=_listed_rule(find.local, numbering, numbered),
        in_givens=tuple(tree for each in entries for tree in each.in_givens or ()) or None,
        routes=tuple(
            SolvedRoute(each.stated, _listed_rule(each.rule, numbering, numbered)) for each in find.routes
        ),
        mistakes=tuple(mistakes),
        dimensions=find.dimensions * len(entries),
        where=None if find.where is None else tuple(one for each in entries for one in each.where or ()),
        others=(),
        printed=(),
        printed_in_givens=None,
        entries=entries,
    )


def _letter(base: str, index: int, in_use: set[str]) -> str:
    name = f"{base}_{index}"
    while name in in_use:
        name += "'"
    return name


def entry_of(find: Unknown, name: str, number: int) -> Unknown:
    """What is found for one of the numbers."""
    (base,), numbering = find.names, find.numbering
    assert numbering is not None
    meaning: dict[str, Expr] = {numbering.letter: whole(number), base: Name(name)}

    def here(relation: Relation) -> Relation:
        return Relation(
            relation.sign, *(neat(substitute(side, meaning)) for side in (relation.left, relation.right))
        )

    def law(each: AppliedLaw) -> AppliedLaw:
        return replace(each, here=tuple(map(here, each.here)))

    return replace(
        find,
        names=(name,),
        laws=tuple(map(law, find.laws)),
        local=ClosedForms(_at(find.local, numbering.letter, number)),
        in_givens=tuple(neat(substitute(tree, meaning)) for tree in find.in_givens or ()) or None,
        routes=(),
        mistakes=(),
        where=None if find.where is None else tuple(map(here, find.where)),
        others=tuple(
            OtherRoot(
                {name: neat(substitute(each.values[base], meaning))} if each.values else {},
                each.worded,
            )
            for each in find.others
        ),
        printed=(),
        printed_in_givens=None,
        numbering=None,
    )


def _at(rule: Rule, letter: str, number: int) -> tuple[Expr, ...]:
    assert isinstance(rule, ClosedForms)
    return tuple(neat(substitute(tree, {letter: whole(number)})) for tree in rule.trees)


def _listed_rule(rule: Rule, numbering: Numbering, numbered: range) -> ClosedForms:
    assert isinstance(rule, ClosedForms)
    form = rule.form if rule.form is not None else rule.trees[0]
    trees = tuple(neat(substitute(form, {numbering.letter: whole(number)})) for number in numbered)
    return ClosedForms(trees, form, numbering)


def values_of_rule(rule: ClosedForms, values: Mapping[str, Ball]) -> tuple[float, ...]:
    """The values of a rule where the precision is set; of a list as many as its range has for these values. Raises Undefined."""
    if rule.form is None or rule.numbering is None:
        return numbers(rule.trees, values)
    low, high = numbers((rule.numbering.low, rule.numbering.high), values)
    if max(abs(low - round(low)), abs(high - round(high))) > NEARLY_WHOLE:
        raise Undefined("a range has whole numbers as its ends")
    if high - low >= 2 * LONGEST:
        raise Undefined("the list is too long")
    letter = rule.numbering.letter
    every = range(round(low), round(high) + 1)
    return tuple(numbers((rule.form,), {**values, letter: Ball(number)})[0] for number in every)


def rule_at(rule: ClosedForms, values: Mapping[str, Ball]) -> tuple[float, ...]:
    """The same at the usual precision."""
    with precision_of(BITS):
        return values_of_rule(rule, values)


def _equal(end: Expr, number: int) -> Iterator[Relation]:
    """That an end of a range is a number: bounds on what it is rounded from, where it is that, with a whole number added or not."""
    if constant(end) is not None:
        return
    if isinstance(end, Negative):
        yield from _equal(end.term, -number)
        return
    rounded, plus = end, Fraction(0)
    if isinstance(end, Sum) and len(end.terms) == 2 and (added := constant(end.terms[1])) is not None:
        rounded, plus = end.terms[0], added
    wanted = Fraction(number) - plus
    match rounded:
        case Call("floor", (inner,)):
            yield Relation(">=", inner, _number(wanted))
            yield Relation("<", inner, _number(wanted + 1))
        case Call("ceil", (inner,)):
            yield Relation(">", inner, _number(wanted - 1))
            yield Relation("<=", inner, _number(wanted))
        case Call("round", (inner,)):
            yield Relation(">=", inner, _number(wanted - Fraction(1, 2)))
            yield Relation("<", inner, _number(wanted + Fraction(1, 2)))
        case _:
            yield Relation("=", end, whole(number))


def whole(number: int) -> Expr:
    """A whole number as a formula."""
    return _number(Fraction(number))


def _number(value: Fraction) -> Expr:
    return Number(value) if value >= 0 else Negative(Number(-value))


def neat(tree: Expr) -> Expr:
    """The formula without factors 1, terms 0 and signs upon signs, as a person writes it with a number put in."""
    return mapped(tree, _neat)


def _neat(tree: Expr) -> Expr:
    if not names(tree) and not isinstance(tree, Number | Relation | Quotient | Negative):
        value = exactly(tree, {})
        if value is not None and not value.pi and value.ratio.denominator == 1:
            return _number(value.ratio)
    match tree:
        case Negative(Negative(inner)):
            return inner
        case Negative(inner) if inner == ZERO:
            return ZERO
        case Product(factors):
            return _product(factors)
        case Quotient(top, bottom):
            if top == ZERO:
                return ZERO
            if bottom == ONE:
                return top
            return Negative(Quotient(top.term, bottom)) if isinstance(top, Negative) else tree
        case Sum(terms):
            left = tuple(each for each in terms if each != ZERO)
            return ZERO if not left else left[0] if len(left) == 1 else Sum(left)
        case Power(base, exponent) if exponent == ONE:
            return base
        case Call("sin" | "tan" | "asin" | "atan" | "sqrt", (inner,)) if inner == ZERO:
            return ZERO
        case Call("sin" | "tan" | "asin" | "atan", (Negative(inner),)):
            return Negative(Call(tree.function, (inner,)))
        case _:
            return tree


def _product(factors: tuple[Expr, ...]) -> Expr:
    number, left = Fraction(1), list[Expr]()
    for each in factors:
        inner = each.term if isinstance(each, Negative) else each
        number = -number if isinstance(each, Negative) else number
        if isinstance(inner, Number):
            number *= inner.value
        else:
            left.append(inner)
    if not number:
        return ZERO
    size = abs(number)
    every = [*([Number(size)] if size != 1 or not left else []), *left]
    found = every[0] if len(every) == 1 else Product(tuple(every))
    return negated(found) if number < 0 else found
