"""A formula and the numbers it may have: what that leaves of its letters, and how it changes with each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from corollary.formula.arithmetics import constant
from corollary.formula.ast import (
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
    difference,
    names,
    substitute,
)
from corollary.formula.ball import RationalPi, evaluate
from corollary.formula.enclosure import (
    ALL,
    INFINITY,
    NOT_NEGATIVE,
    ONE,
    UNIT,
    Empty,
    Enclosure,
    absolute,
    add,
    arc_cosine,
    arc_sine,
    arc_tangent,
    both_signs,
    direction,
    divide,
    exponential,
    hull,
    logarithm,
    meet,
    meet_pieces,
    multiply,
    negative,
    of_ball,
    power,
    root,
    signed_root,
    sine,
    sine_back,
    subtract,
    tangent,
    tangent_back,
)
from corollary.formula.errors import Undefined

BITS = 128  # at which a part without unknowns is worked out
LARGEST_POWER = 40
HUGE = 1e300
ZERO = Enclosure(0.0, 0.0)
TWO = Enclosure(2.0, 2.0)
HALF_TURN: Expr = Quotient(Name("pi"), Number(Fraction(2)))
Box = list[Enclosure]
PERIODIC = frozenset({"sin", "cos", "tan"})


class NoContractor(ValueError):
    """The formula has a function for which there are no intervals."""


@dataclass(frozen=True, slots=True)
class Node:
    """An operation on nodes before it; `number` is the exponent or degree, or the place of a letter."""

    kind: str
    below: tuple[int, ...] = ()
    number: int = 0
    value: Enclosure = ALL


@dataclass(slots=True)
class Contractor:
    """Nodes in the order in which they are worked out; the last must have a number of `target`, `strict`: not one of its ends."""

    target: Enclosure = ALL
    strict: bool = False
    unknowns: tuple[int, ...] = ()
    nodes: list[Node] = field(default_factory=list[Node])
    found: list[Enclosure] = field(default_factory=list[Enclosure])

    def forward(self, box: Sequence[Enclosure]) -> Enclosure:
        """All values on the box. Raises Empty where there is none."""
        found = self.found = list[Enclosure]()
        for node in self.nodes:
            match node.kind:
                case "letter":
                    found.append(box[node.number])
                case "constant":
                    found.append(node.value)
                case _:
                    found.append(FORWARD[node.kind](node, [found[each] for each in node.below]))
        return found[-1]

    def contract(self, box: Box) -> None:
        """Takes from the box what cannot fulfil the constraint. Raises Empty where nothing can."""
        found = self.found
        self.forward(box)
        found = self.found
        found[-1] = meet(found[-1], self.target)
        for place in range(len(self.nodes) - 1, -1, -1):
            node = self.nodes[place]
            if node.kind == "letter":
                box[node.number] = meet(box[node.number], found[place])
            elif node.below and node.kind in BACKWARD:
                inside = [found[each] for each in node.below]
                for each, left in zip(
                    node.below, BACKWARD[node.kind](node, found[place], inside), strict=True
                ):
                    found[each] = meet(found[each], left)

    def gradient(self, box: Sequence[Enclosure]) -> dict[int, Enclosure]:
        """The derivative by each of its letters on the box. Raises Empty where the formula has no value there."""
        self.forward(box)
        found, slopes = self.found, [ZERO] * len(self.nodes)
        slopes[-1] = ONE
        gradient = dict.fromkeys(self.unknowns, ZERO)
        for place in range(len(self.nodes) - 1, -1, -1):
            node, slope = self.nodes[place], slopes[place]
            if node.kind == "letter":
                gradient[node.number] = add(gradient[node.number], slope)
            elif node.below and slope != ZERO:
                inside = [found[each] for each in node.below]
                for each, by in zip(node.below, SLOPES[node.kind](node, found[place], inside), strict=True):
                    slopes[each] = add(slopes[each], multiply(slope, by))
        return gradient


def contractor(relation: Relation, letters: Sequence[str], known: Mapping[str, RationalPi]) -> Contractor:
    """The constraint that a relation holds, its other letters being known. Raises NoContractor."""
    made = _made(_difference(relation), letters, known)
    made.target, made.strict = _target(relation.sign), relation.sign in ("<", ">")
    return made


def values_of(
    tree: Expr, letters: Sequence[str], known: Mapping[str, RationalPi], box: Sequence[Enclosure]
) -> Enclosure:
    """All values of a formula on a box. Raises NoContractor, and Empty where there is none."""
    return _made(tree, letters, known).forward(box)


def _made(tree: Expr, letters: Sequence[str], known: Mapping[str, RationalPi]) -> Contractor:
    place = {letter: number for number, letter in enumerate(letters)}
    made = Contractor(unknowns=tuple(sorted({place[name] for name in names(tree) if name in place})))
    try:
        _add(made.nodes, tree, place, known)
    except (Undefined, KeyError) as error:
        raise NoContractor(str(error)) from None
    return made


def _difference(relation: Relation) -> Expr:
    """Left side less right side; a side that is 0 is left out."""
    zero = Number(Fraction(0))
    left, right = (
        zero if isinstance(side, Number) and side.value == 0 else side
        for side in (relation.left, relation.right)
    )
    return left if right == zero else Negative(right) if left == zero else difference(relation)


def _target(sign: str) -> Enclosure:
    match sign:
        case "<" | "<=":
            return Enclosure(-INFINITY, 0.0)
        case ">" | ">=":
            return NOT_NEGATIVE
        case _:
            return ZERO


def periodic_arguments(tree: Expr, unknowns: Sequence[str]) -> list[Expr]:
    """What sines, cosines and tangents are taken of, where an unknown is in it."""
    return [
        call.arguments[0] for call in calls(tree) if call.function in PERIODIC and names(call) & set(unknowns)
    ]


def turning_letters(trees: Sequence[Expr], unknowns: Sequence[str]) -> set[str]:
    """The unknowns that are in sines and cosines alone, whole times each: with a turn more the formulas are what they were."""
    found = set(unknowns)
    for tree in trees:
        found -= _not_turning(tree)
    return found


def _not_turning(tree: Expr) -> frozenset[str]:
    if isinstance(tree, Call) and tree.function in PERIODIC:
        terms = tree.arguments[0].terms if isinstance(tree.arguments[0], Sum) else tree.arguments
        return names(*(each for each in terms if not _whole_times(each)))
    if isinstance(tree, Name):
        return frozenset({tree.name})
    return frozenset[str]().union(*map(_not_turning, children(tree)))


def _whole_times(term: Expr) -> bool:
    """`b`, `-b`, `2*b`."""
    match term:
        case Negative(inside):
            return _whole_times(inside)
        case Product((Number(value), Name())):
            return value.denominator == 1
        case _:
            return isinstance(term, Name)


def _add(nodes: list[Node], tree: Expr, place: Mapping[str, int], known: Mapping[str, RationalPi]) -> int:
    def node(kind: str, *below: int, number: int = 0, value: Enclosure = ALL) -> int:
        nodes.append(Node(kind, below, number, value))
        return len(nodes) - 1

    def put(part: Expr) -> int:
        return _add(nodes, part, place, known)

    if not names(tree) & place.keys():
        return node("constant", value=of_ball(evaluate(tree, known, BITS)))
    match tree:
        case Name(name):
            return node("letter", number=place[name])
        case Negative(term):
            return node("negative", put(term))
        case Sum((first, *terms)):
            total = put(first)
            for term in terms:
                minus = isinstance(term, Negative)
                total = node("subtract" if minus else "add", total, put(term.term if minus else term))
            return total
        case Product((first, *factors)):
            total = put(first)
            for factor in factors:
                total = node("multiply", total, put(factor))
            return total
        case Quotient(top, bottom):
            return node("divide", put(top), put(bottom))
        case Power(base, exponent):
            numbers = {name: Number(each.ratio) for name, each in known.items() if not each.pi}
            return _add_power(node, put, base, exponent, numbers)
        case Call("sqrt", (argument,)):
            return node("root", put(argument), number=2)
        case Call("cos", (argument,)):
            return node("sin", put(Sum((argument, HALF_TURN))))
        case Call("log10", (argument,)):
            return node("divide", node("ln", put(argument)), put(Call("ln", (Number(Fraction(10)),))))
        case Call(function, arguments) if function in FORWARD:
            return node(function, *map(put, arguments))
        case Call(function, _):
            raise NoContractor(function)
        case _:
            raise NoContractor(type(tree).__name__)


def _add_power(
    node: Callable[..., int],
    put: Callable[[Expr], int],
    base: Expr,
    exponent: Expr,
    numbers: Mapping[str, Expr],
) -> int:
    fixed = constant(substitute(exponent, numbers))
    up, degree = (abs(fixed.numerator), fixed.denominator) if fixed is not None else (0, 0)
    if fixed is None or max(up, degree) > LARGEST_POWER:
        return node("exp", node("multiply", put(exponent), node("ln of a base", put(base))))
    if up == 0:
        return node("constant", value=ONE)
    found = put(base)
    if degree > 1:
        found = node("root", found, number=degree)
    if up > 1:
        found = node("power", found, number=up)
    return node("divide", node("constant", value=ONE), found) if fixed < 0 else found


Forward = Callable[[Node, Sequence[Enclosure]], Enclosure]
Backward = Callable[[Node, Enclosure, Sequence[Enclosure]], tuple[Enclosure, ...]]


def _quotient(x: Enclosure, y: Enclosure) -> Enclosure:
    if y == ZERO:
        raise Empty
    return hull(divide(x, y)) if not (x.has(0) and y.has(0)) else ALL


def _logarithm_of_base(x: Enclosure) -> Enclosure:
    """As the logarithm, but 0 to a positive power is 0."""
    return logarithm(x) if x.high > 0 else Enclosure(-INFINITY, -HUGE)


FORWARD: dict[str, Forward] = {
    "negative": lambda _, x: negative(x[0]),
    "add": lambda _, x: add(x[0], x[1]),
    "subtract": lambda _, x: subtract(x[0], x[1]),
    "multiply": lambda _, x: multiply(x[0], x[1]),
    "divide": lambda _, x: _quotient(x[0], x[1]),
    "power": lambda node, x: power(x[0], node.number),
    "root": lambda node, x: root(x[0], node.number),
    "abs": lambda _, x: absolute(x[0]),
    "sin": lambda _, x: sine(x[0]),
    "tan": lambda _, x: tangent(x[0]),
    "asin": lambda _, x: arc_sine(x[0]),
    "acos": lambda _, x: arc_cosine(x[0]),
    "atan": lambda _, x: arc_tangent(x[0]),
    "ln of a base": lambda _, x: _logarithm_of_base(x[0]),
    "atan2": lambda _, x: direction(x[0], x[1]),
    "exp": lambda _, x: exponential(x[0]),
    "ln": lambda _, x: logarithm(x[0]),
}


def _power_back(node: Node, z: Enclosure, x: Sequence[Enclosure]) -> tuple[Enclosure, ...]:
    if node.number % 2:
        return (signed_root(z, node.number),)
    return (meet_pieces(x[0], both_signs(root(z, node.number))),)


# What is left of each part, when the whole has a number of z.
BACKWARD: dict[str, Backward] = {
    "negative": lambda _, z, x: (negative(z),),
    "add": lambda _, z, x: (subtract(z, x[1]), subtract(z, x[0])),
    "subtract": lambda _, z, x: (add(z, x[1]), subtract(x[0], z)),
    "multiply": lambda _, z, x: (meet_pieces(x[0], divide(z, x[1])), meet_pieces(x[1], divide(z, x[0]))),
    "divide": lambda _, z, x: (multiply(z, x[1]), meet_pieces(x[1], divide(x[0], z))),
    "power": _power_back,
    "root": lambda node, z, x: (power(meet(z, NOT_NEGATIVE), node.number),),
    "abs": lambda _, z, x: (meet_pieces(x[0], both_signs(z)),),
    "sin": lambda _, z, x: (sine_back(x[0], z),),
    "tan": lambda _, z, x: (tangent_back(x[0], z),),
    "asin": lambda _, z, x: (sine(z),),
    "acos": lambda _, z, x: (sine(add(z, HALF)),),
    "exp": lambda _, z, x: (logarithm(z),),
    "ln": lambda _, z, x: (exponential(z),),
    "ln of a base": lambda _, z, x: (exponential(z),),
    "atan": lambda _, z, x: (tangent(z),),
}
HALF = arc_sine(ONE)


def _over(x: Enclosure) -> Enclosure:
    """1/x where x may come as near to 0 as it likes."""
    return hull(divide(ONE, x)) if x != ZERO else ALL


def _sign(x: Enclosure) -> Enclosure:
    return ONE if x.low > 0 else Enclosure(-1.0, -1.0) if x.high < 0 else UNIT


def _by_exponent(node: Node, x: Enclosure) -> Enclosure:
    n = float(node.number)
    return multiply(Enclosure(n, n), ONE if node.number == 1 else power(x, node.number - 1))


def _root_slope(node: Node, z: Enclosure) -> Enclosure:
    n = float(node.number)
    return _over(multiply(Enclosure(n, n), power(z, node.number - 1)))


def _arc_slope(x: Enclosure) -> Enclosure:
    return _over(root(subtract(ONE, power(x, 2)), 2))


def _direction_slopes(x: Sequence[Enclosure]) -> tuple[Enclosure, ...]:
    if x[1].low <= 0 and x[0].has(0):  # where it jumps by a turn
        return ALL, ALL
    square = add(power(x[0], 2), power(x[1], 2))
    return _quotient(x[1], square), negative(_quotient(x[0], square))


# The derivatives of each operation by its parts.
SLOPES: dict[str, Backward] = {
    "negative": lambda _, z, x: (Enclosure(-1.0, -1.0),),
    "add": lambda _, z, x: (ONE, ONE),
    "subtract": lambda _, z, x: (ONE, Enclosure(-1.0, -1.0)),
    "multiply": lambda _, z, x: (x[1], x[0]),
    "divide": lambda _, z, x: (_over(x[1]), negative(_quotient(z, x[1]))),
    "power": lambda node, z, x: (_by_exponent(node, x[0]),),
    "root": lambda node, z, x: (_root_slope(node, z),),
    "abs": lambda _, z, x: (_sign(x[0]),),
    "sin": lambda _, z, x: (sine(add(x[0], HALF)),),
    "tan": lambda _, z, x: (add(ONE, power(z, 2)),),
    "asin": lambda _, z, x: (_arc_slope(x[0]),),
    "acos": lambda _, z, x: (negative(_arc_slope(x[0])),),
    "atan": lambda _, z, x: (_over(add(ONE, power(x[0], 2))),),
    "atan2": lambda _, z, x: _direction_slopes(x),
    "exp": lambda _, z, x: (z,),
    "ln": lambda _, z, x: (_over(x[0]),),
    "ln of a base": lambda _, z, x: (_over(x[0]),),
}
