"""Layout of formulas as a textbook sets them: order of factors, one root, few minus signs, and what a form costs to read."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from corollary.formula.arithmetics import DOUBLES, constant, ready
from corollary.formula.ast import (
    ONE,
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
    map_children,
    names,
    negated,
    walk,
)
from corollary.formula.errors import NotAvailable

# What a reader pays for. A letter or a number is 1; the rest is measured against that.
SUBTRACTION = 0.5  # a minus between two terms
MINUS = 1.0  # a minus before a product or a sum
MINUS_FIRST = 2.0  # a sum that begins with a minus
NEGATIVE_FACTOR = 0.5  # a bracket whose value is negative for the numbers of the problem: f - b where b > f
BRACKETS = 1.0  # a sum among factors
FRACTION = 0.5
DOUBLE_FRACTION = 3.0  # a fraction in a fraction or in an exponent; below a root a third of it
SQUARE = 0.5  # a whole exponent
ODD_POWER = 2.0  # any other exponent
FUNCTION = 1.0
ROOT_BELOW = 0.5  # a root below the line
MODULUS = 3.0
LATE_NUMBER = 3.0  # a number behind other factors
MINUS_INSIDE = 2.0  # a negative factor, as in m(-v)
COMMON_FACTOR = 2.0  # a sum whose terms all have a letter among their factors
REPEATED = 0.75  # each further time that a letter occurs

MOST_BRACKETS = 5  # of which every choice of signs is tried

Points = Sequence[Mapping[str, float]]


def cost(tree: Expr) -> float:
    """How much there is to read in a formula."""
    match tree:
        case Number() | Name():
            return 1.0
        case Negative(term):
            return MINUS + cost(term) + BRACKETS * isinstance(term, Sum)
        case Sum(terms):
            minus = [isinstance(term, Negative) for term in terms]
            inner = sum(cost(term) - MINUS * each for term, each in zip(terms, minus, strict=True))
            common = COMMON_FACTOR * (len(terms) > 1 and bool(_common_letters(terms)))
            return inner + SUBTRACTION * sum(minus[1:]) + MINUS_FIRST * minus[0] + common
        case Product(factors):
            brackets = BRACKETS * sum(isinstance(each, Sum) for each in factors)
            late = LATE_NUMBER * sum(isinstance(each, Number) for each in factors[1:])
            negative = MINUS_INSIDE * sum(isinstance(each, Negative) for each in factors[1:])
            return sum(map(cost, factors)) + brackets + late + negative
        case Quotient(top, bottom):
            nested = _fractions(top) + _fractions(bottom)
            below = ROOT_BELOW if any(_is_root(each) for each in _factors(bottom)) else 0
            return FRACTION + cost(top) + cost(bottom) + DOUBLE_FRACTION * nested + below
        case Power(base, exponent):
            whole = isinstance(exponent, Number) and exponent.value.denominator == 1
            raised = SQUARE if whole else ODD_POWER + cost(exponent) + DOUBLE_FRACTION * _fractions(exponent)
            return cost(base) + raised + BRACKETS * isinstance(base, Sum | Product | Quotient)
        case Call("abs", (argument,)):
            return MODULUS + cost(argument)
        case Call(function, arguments):
            nested = sum(map(_fractions, arguments))
            weight = DOUBLE_FRACTION if function == "exp" else 0
            return FUNCTION + sum(map(cost, arguments)) + weight * nested * 0.2
        case Relation(_, left, right):
            return cost(left) + cost(right)


def _fractions(tree: Expr) -> float:
    """Fractions to be seen in a formula; those below a root count a third, those of plain numbers too."""
    match tree:
        case Quotient():
            return 1.0
        case Call("sqrt", arguments):
            return sum(map(_fractions, arguments)) / 3
        case Call():
            return 0.0
        case _:
            return sum(map(_fractions, children(tree)))


def _common_letters(terms: Iterable[Expr]) -> frozenset[str]:
    """Letters that are a factor of each term, above the line."""
    found: set[str] | None = None
    for term in terms:
        letters = {
            base.name
            for base, exponent in _bases(term, Fraction(1))
            if isinstance(base, Name) and exponent > 0
        }
        found = letters if found is None else found & letters
    return frozenset(found or ()) - {"pi"}


def _factors(tree: Expr) -> tuple[Expr, ...]:
    return tree.factors if isinstance(tree, Product) else (tree,)


def _is_root(tree: Expr) -> bool:
    return isinstance(tree, Call) and tree.function == "sqrt"


class LetterOrder:
    """The order of letters in products and in sums: that of the author's laws.

    What is found takes the place of its letter: friction is μmg because laws say μN and mg. Among letters that no product
    puts in order, those with fewer before them come first (masses before velocities), then plain numbers, then what laws have first.
    """

    def __init__(
        self, laws: Iterable[Relation], formulas: Mapping[str, Expr], coefficients: Collection[str] = ()
    ):
        """`formulas` are what letters stand for, in others; `coefficients` are letters of plain numbers."""
        products: list[Sequence[Expr]] = []
        sums: list[Sequence[Expr]] = []
        above: dict[str, int] = {}
        below: dict[str, int] = {}
        for law in laws:
            for side in (law.right, law.left):
                _collect(side, products, sums, above, below)
        met = [*above, *(name for name in below if name not in above)]
        first = [name for name in (*met, *coefficients) if name in coefficients]
        met = list(dict.fromkeys([*first, *met]))
        inside = {name: names(formula) for name, formula in formulas.items()}
        self._in_products = _ranks(met, _before(products, inside), by_level=True)
        self._in_sums = _ranks(met, _before(sums, inside), by_level=False)

    def in_product(self, factor: Expr) -> list[int]:
        """Where a factor stands: the places of its letters, first ones first."""
        return _places(factor, self._in_products)

    def in_sum(self, term: Expr) -> list[int]:
        """Where a term stands: the places of its letters above the line."""
        above = term.term if isinstance(term, Negative) else term
        if isinstance(above, Quotient) and names(above.top):
            above = above.top
        return _places(above, self._in_sums)


def _places(tree: Expr, rank: Mapping[str, int]) -> list[int]:
    return sorted(rank.get(name, len(rank)) for name in names(tree) - {"pi"})


def _collect(
    tree: Expr,
    products: list[Sequence[Expr]],
    sums: list[Sequence[Expr]],
    above: dict[str, int],
    below: dict[str, int],
) -> None:
    """Products and sums of a law, and its letters as they are met above and below lines."""
    match tree:
        case Name(name):
            above.setdefault(name, len(above))
        case Product(factors):
            products.append(factors)
        case Sum(terms):
            sums.append(terms)
        case Quotient(top, bottom):
            _collect(top, products, sums, above, below)
            _collect(bottom, products, sums, below, below)
            return
        case _:
            pass
    for child in children(tree):
        _collect(child, products, sums, above, below)


def _before(listed: Iterable[Sequence[Expr]], inside: Mapping[str, frozenset[str]]) -> dict[str, set[str]]:
    """For each letter those that stand behind it; what the laws write counts before what letters stand for."""
    behind: dict[str, set[str]] = {}
    pairs = [tuple(map(names, pair)) for each in listed for pair in combinations(each, 2)]
    for widened in (False, True):
        for one, other in pairs:
            if widened:
                one, other = (
                    each.union(*(inside.get(name, frozenset[str]()) for name in each))
                    for each in (one, other)
                )
            for first in one - other:
                for second in other - one:
                    if first not in behind.get(second, ()):
                        behind.setdefault(first, set()).add(second)
    return behind


def _ranks(met: Sequence[str], behind: Mapping[str, set[str]], *, by_level: bool) -> dict[str, int]:
    """Places by how many letters stand before each in a row (`by_level`), or as they are met where none stands before them."""
    if by_level:
        levels: dict[str, int] = {}

        def level(name: str, above: frozenset[str]) -> int:
            if name not in levels:
                before = [one for one in met if name in behind.get(one, ()) and one not in above]
                found = max((1 + level(one, above | {name}) for one in before), default=0)
                if above:
                    return found
                levels[name] = found
            return levels[name]

        ordered = sorted(met, key=lambda name: level(name, frozenset()))
        return {name: rank for rank, name in enumerate(ordered)}
    left, found = list(met), list[str]()
    while left:
        free = (name for name in left if not any(name in behind.get(each, ()) for each in left))
        found.append(chosen := next(free, left[0]))
        left.remove(chosen)
    return {name: rank for rank, name in enumerate(found)}


@dataclass(frozen=True, slots=True)
class Monomial:
    """A product: a sign, a positive number, and bases with their exponents, which are fractions."""

    negative: bool
    number: Fraction
    factors: tuple[tuple[Expr, Fraction], ...]


@dataclass(frozen=True, slots=True)
class Layout:
    """Sets formulas: `order` of letters, `points` at which signs are seen (values of all letters)."""

    order: LetterOrder
    points: Points

    def set(self, tree: Expr) -> Expr:
        """An equal formula with factors in order, roots as one, and the fewest minus signs."""
        tree = map_children(tree, self.set)
        match tree:
            case Sum(terms):
                return self._sum(terms)
            case Call("abs", (argument,)) if sign := self.sign(argument):
                return self.set(negated(argument)) if sign < 0 else argument
            case Negative() | Product() | Quotient() | Power() | Call("sqrt"):
                return min(self._forms(self._monomial(tree)), key=cost)
            case _:
                return tree

    def sign(self, tree: Expr) -> int:
        """1 where the value is positive at all points, -1 where it is negative, else 0."""
        try:
            at = ready(tree, DOUBLES)
            values = [at(point) for point in self.points]
        except (NotAvailable, KeyError, ValueError, ArithmeticError, TypeError):
            return 0
        if not values or not all(map(math.isfinite, values)):
            return 0
        return 1 if min(values) > 0 else -1 if max(values) < 0 else 0

    def _sum(self, terms: tuple[Expr, ...]) -> Expr:
        flat: list[Expr] = []
        for term in terms:
            match term:
                case Sum(inner):
                    flat += inner
                case Negative(Sum(inner)):
                    flat += map(negated, inner)
                case _:
                    flat.append(term)
        numbers = [value for each in flat if (value := constant(each)) is not None and not names(each)]
        if len(numbers) > 1:
            total = sum(numbers, Fraction(0))
            flat = [each for each in flat if constant(each) is None or names(each)]
            flat += [_fraction(total)] if total or not flat else []
            if len(flat) == 1:
                return flat[0]
        ordered = sorted(flat, key=self._place_in_sum)
        if all(isinstance(term, Negative) for term in ordered):
            return Negative(Sum(tuple(map(negated, ordered))))
        return Sum(tuple(ordered))

    def _place_in_sum(self, term: Expr) -> tuple[bool, bool, list[int]]:
        """Positive terms first, roots behind others; a number before letters if it is added, behind them if it is subtracted."""
        minus = isinstance(term, Negative)
        rooted = any(_has_root(each) for each in _factors(term.term if isinstance(term, Negative) else term))
        if not names(term):
            return minus, rooted, [10**6] if minus else []
        return minus, rooted, self.order.in_sum(term)

    def _monomial(self, tree: Expr) -> Monomial:
        found: dict[Expr, Fraction] = {}
        number, negative = Fraction(1), False
        for base, exponent in _bases(tree, Fraction(1)):
            if isinstance(base, Negative) and exponent.denominator == 1:
                negative ^= exponent.numerator % 2 == 1
                base = base.term
            if isinstance(base, Sum) and exponent.denominator == 1 and (content := _content(base)) != 1:
                number *= content**exponent.numerator
                base = self._sum(
                    tuple(
                        self.set(Quotient(Product((_fraction(1 / content), each)), ONE))
                        for each in base.terms
                    )
                )
            if isinstance(base, Number) and exponent.denominator == 1 and base.value:
                number *= base.value**exponent.numerator
            elif base != ONE:
                found[base] = found.get(base, Fraction(0)) + exponent
        for one, other in combinations([base for base in found if isinstance(base, Sum)], 2):
            if found.get(one) == found.get(other) and (joined := _difference_of_squares(one, other)):
                found[joined] = found.pop(one)
                del found[other]
        factors = tuple((base, exponent) for base, exponent in found.items() if exponent)
        return Monomial(negative ^ (number < 0), abs(number), factors)

    def _forms(self, whole: Monomial) -> Iterator[Expr]:
        """The monomial with the signs of its brackets turned in every way, its number before or below the root."""
        for turned in self._turned(whole):
            for number, under in _shared(turned):
                yield self._assembled(Monomial(turned.negative, number, turned.factors), under)

    def _turned(self, whole: Monomial) -> Iterator[Monomial]:
        brackets = [
            place
            for place, (base, exponent) in enumerate(whole.factors)
            if isinstance(base, Sum)
            and exponent.denominator == 1
            and any(isinstance(term, Negative) for term in base.terms)
        ][:MOST_BRACKETS]
        for count in range(len(brackets) + 1):
            for turning in combinations(brackets, count):
                factors, negative = list(whole.factors), whole.negative
                for place in turning:
                    base, exponent = factors[place]
                    assert isinstance(base, Sum)
                    opposite = self._sum(tuple(map(negated, base.terms)))
                    if not isinstance(opposite, Sum):
                        break
                    factors[place] = opposite, exponent
                    negative ^= exponent.numerator % 2 == 1
                else:
                    yield Monomial(negative, whole.number, tuple(factors))

    def _assembled(self, whole: Monomial, under: Fraction) -> Expr:
        """The product written out; `under` is the number below its root."""
        above: list[Expr] = [_number(whole.number.numerator)] if whole.number.numerator != 1 else []
        below: list[Expr] = [_number(whole.number.denominator)] if whole.number.denominator != 1 else []
        roots: dict[int, list[tuple[Expr, Fraction]]] = {}
        for base, exponent in whole.factors:
            if isinstance(base, Number) and exponent.denominator != 1 and _one_degree(whole):
                continue  # it is in `under`
            if exponent.denominator != 1:
                roots.setdefault(exponent.denominator, []).append((base, exponent * exponent.denominator))
            elif isinstance(base, Call) and base.function == "exp":
                argument = base.arguments[0] if exponent > 0 else self.set(negated(base.arguments[0]))
                power = _raised(Call("exp", (argument,)), abs(exponent))
                above.append(power)
            else:
                (above if exponent > 0 else below).append(_raised(base, abs(exponent)))
        degree = max(roots, default=_degree(whole))
        if under != 1 and degree:
            roots.setdefault(degree, [])
        for each, inside in roots.items():
            number = under if each == degree else Fraction(1)
            inner = Monomial(False, number, tuple(inside))
            top, bottom = self._sides(inner)
            if top == ONE and bottom is not None:
                below.append(_root(bottom, each))
            else:
                above.append(_root(Quotient(top, bottom) if bottom is not None else top, each))
        return self._joined(whole.negative, above, below)

    def _sides(self, inner: Monomial) -> tuple[Expr, Expr | None]:
        """Above and below the line, of what stands below a root."""
        assembled = self._assembled(inner, Fraction(1))
        return (assembled.top, assembled.bottom) if isinstance(assembled, Quotient) else (assembled, None)

    def _joined(self, negative: bool, above: list[Expr], below: list[Expr]) -> Expr:
        top, bottom = (self._product(each) for each in (above, below))
        found = top if not below else Quotient(top, bottom)
        return Negative(found) if negative else found

    def _product(self, factors: list[Expr]) -> Expr:
        ordered = sorted(factors, key=self._place_in_product)
        return ONE if not ordered else ordered[0] if len(ordered) == 1 else Product(tuple(ordered))

    def _place_in_product(self, factor: Expr) -> tuple[int, list[int]]:
        """Numbers, π, letters and their brackets as laws have them, functions, brackets with functions, and roots last."""
        base = factor.base if isinstance(factor, Power) else factor
        letters = self.order.in_product(factor)
        if isinstance(factor, Number):
            return 0, []
        if base == Name("pi"):
            return 1, []
        if _is_root(base) or (isinstance(factor, Power) and _is_fractional(factor.exponent)):
            return 6, letters
        if isinstance(base, Call):
            short = isinstance(base.arguments[0], Name)
            return (3 if base.function == "exp" else 4 if short else 7), letters
        if isinstance(base, Sum) and any(True for _ in calls(base)):
            return 5, letters
        return 2, letters

    def total(self, tree: Expr) -> float:
        """The cost of a formula, with that of brackets that are negative at all points."""
        negative = sum(self.sign(each) < 0 for each in _brackets(tree))
        return cost(tree) + NEGATIVE_FACTOR * negative + REPEATED * _repeated(tree)


def _is_fractional(exponent: Expr) -> bool:
    value = constant(exponent)
    return value is not None and value.denominator != 1


def _repeated(tree: Expr) -> int:
    """How often letters stand there that stand there already."""
    letters = [each.name for each in walk(tree) if isinstance(each, Name)]
    return len(letters) - len(set(letters))


def _has_root(factor: Expr) -> bool:
    match factor:
        case Quotient(top, _):
            return any(map(_has_root, _factors(top)))
        case Power(_, exponent):
            return _is_fractional(exponent)
        case _:
            return _is_root(factor)


def _fraction(value: Fraction) -> Expr:
    size = abs(value)
    found = (
        _number(size.numerator)
        if size.denominator == 1
        else Quotient(_number(size.numerator), _number(size.denominator))
    )
    return Negative(found) if value < 0 else found


def _brackets(tree: Expr) -> Iterator[Sum]:
    """Sums that stand among factors."""
    match tree:
        case Product(factors):
            inside = factors
        case Quotient(top, bottom):
            inside = (top, bottom)
        case Negative(term):
            inside = (term,)
        case _:
            inside = ()
    yield from (each for each in inside if isinstance(each, Sum))
    for child in children(tree):
        yield from _brackets(child)


def _bases(tree: Expr, exponent: Fraction) -> Iterator[tuple[Expr, Fraction]]:
    """The factors of a product, quotient, power or root, down to what is none of these."""
    match tree:
        case Product(factors):
            for factor in factors:
                yield from _bases(factor, exponent)
        case Quotient(top, bottom):
            yield from _bases(top, exponent)
            yield from _bases(bottom, -exponent)
        case Negative(term) if exponent.denominator == 1:
            yield Negative(ONE), exponent
            yield from _bases(term, exponent)
        case Power(base, raised) if (value := constant(raised)) is not None:
            if value.numerator % 2 == 0 and (exponent * value).numerator % 2:
                yield tree, exponent  # the root of a square: it is positive where the base need not be
            else:
                yield from _bases(base, exponent * value)
        case Call("sqrt", (argument,)):
            yield from _bases(argument, exponent / 2)
        case _:
            yield tree, exponent


def _content(total: Sum) -> Fraction:
    """The number that all terms have in common: 1/2 of a/2 - b/2, 2 of 2a + 2b."""
    numbers = [
        math.prod(
            (
                base.value**exponent.numerator
                for base, exponent in _bases(term, Fraction(1))
                if isinstance(base, Number) and base.value and exponent.denominator == 1
            ),
            start=Fraction(1),
        )
        for term in total.terms
    ]
    top = math.gcd(*(each.numerator for each in numbers))
    return Fraction(top, math.lcm(*(each.denominator for each in numbers)))


def _difference_of_squares(one: Sum, other: Sum) -> Sum | None:
    """a² - b² for (a - b)(a + b), of letters and numbers."""
    if len(one.terms) != 2 or len(other.terms) != 2:
        return None
    for minus, plus in ((one, other), (other, one)):
        match minus.terms:
            case (Name() | Number() as first, Negative(Name() | Number() as second)) if {first, second} == {
                *plus.terms
            }:
                squares = (each if each == ONE else Power(each, _number(2)) for each in (first, second))
                first, second = squares
                return Sum((first, Negative(second)))
            case _:
                continue
    return None


def _degree(whole: Monomial) -> int:
    return max(
        (exponent.denominator for _base, exponent in whole.factors if exponent.denominator > 1), default=0
    )


def _one_degree(whole: Monomial) -> bool:
    """True if all its roots are of one degree."""
    return len({exponent.denominator for _base, exponent in whole.factors} - {1}) <= 1


def _shared(whole: Monomial) -> Iterator[tuple[Fraction, Fraction]]:
    """The number before the root and the one below it, whole roots before it; its denominator may stay below."""
    degree = _degree(whole)
    if not degree or not _one_degree(whole):
        yield whole.number, Fraction(1)
        return
    inside = Fraction(1)
    for base, exponent in whole.factors:
        if isinstance(base, Number) and exponent.denominator != 1:
            inside *= base.value ** (exponent * degree).numerator
    everything = whole.number**degree * inside
    top = _whole_root(everything.numerator, degree)
    for bottom in (_whole_root(everything.denominator, degree), 1):
        number = Fraction(top, bottom)
        yield number, everything / number**degree


def _whole_root(number: int, degree: int) -> int:
    """The largest number whose power divides this one."""
    best = 1
    for candidate in range(2, 1 + min(100, round(number ** (1 / degree)) + 1)):
        if number % candidate**degree == 0:
            best = candidate
    return best


def _raised(base: Expr, exponent: Fraction) -> Expr:
    return base if exponent == 1 else Power(base, _number(exponent.numerator))


def _root(inside: Expr, degree: int) -> Expr:
    return Call("sqrt", (inside,)) if degree == 2 else Power(inside, Quotient(ONE, _number(degree)))


def _number(value: int) -> Number:
    return Number(Fraction(value))
