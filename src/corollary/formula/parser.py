"""From signs to a formula, by how tightly each operator binds (Pratt 1973)."""

from __future__ import annotations

from fractions import Fraction

from corollary.formula.abbreviations import applied, arity, of_angle
from corollary.formula.arithmetics import constant
from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.degrees import degrees
from corollary.formula.errors import ParseError, ambiguous
from corollary.formula.functions import steps
from corollary.formula.lexer import LARGEST_EXPONENT, Token
from corollary.formula.line import Lean, Line, Stop, ask, refuse, unexpected
from corollary.formula.plain_text import text
from corollary.messages import catalogue

_ = catalogue(__name__)

DEEPEST = 40
LARGEST_POWER = 64
MOST_BITS = 4096
COMPARE, ADD, TIMES, FACTOR, UNIT, RAISE = 5, 10, 20, 21, 25, 30
EULER = Call("exp", (Number(Fraction(1)),))
STARTS = frozenset({"number", "name", "function", "e", "open"})


def formula(
    tokens: list[Token], *, student: bool, lean: Lean = "ask", numbers: bool = False
) -> Expr | ParseError:
    """The tree of a whole line. Students may leave out product signs and compare nothing; authors the other way round.

    A unit behind a factor belongs to it, as a letter named by the unit. In a calculation with `numbers` alone, whatever is
    divided by a number with a space behind it ends there: `√2/2 π` is (√2/2) π.
    """
    line = Line(tokens, student, lean, numbers)
    try:
        tree = _formula(line, 0)
        if line.next.kind != "end":
            unexpected(line)
    except Stop as stop:
        return stop.trouble
    return tree


def _formula(line: Line, least: int) -> Expr:
    line.depth += 1
    if line.depth > DEEPEST:
        refuse(_("this formula is nested more than {most} deep", most=DEEPEST), line.next.at)
    tree = _first(line, least)
    grows: type | None = None  # the sum or product this loop is building, to which terms are added
    while True:
        token = line.next
        if (
            token.kind == "compare"
            and not line.student
            and least < COMPARE
            and not isinstance(tree, Relation)
        ):
            line.take()
            tree, grows = Relation(token.text, tree, _formula(line, COMPARE)), None
        elif token.kind == "sign" and token.text in "+-" and least < ADD:
            line.take()
            if (
                line.student
                and line.next.kind == "sign"
                and line.next.text in "+-"
                and line.next.text != token.text
                and line.next.tight
            ):
                refuse(_("+- can be ± or minus"), token.at, _("write one sign"))
            term = _formula(line, ADD)
            term = Negative(term) if token.text == "-" else term
            tree, grows = (
                Sum((*tree.terms, term) if grows is Sum and isinstance(tree, Sum) else (tree, term)),
                Sum,
            )
        elif token.kind == "sign" and token.text == "*" and least < TIMES:
            line.take()
            factor = _formula(line, TIMES)
            tree, grows = _times(tree, factor, grows), Product
        elif token.kind == "sign" and token.text == "/" and least < TIMES:
            line.take()
            tree, grows = Quotient(tree, _formula(line, TIMES)), Quotient
        elif token.kind == "sign" and token.text == "^" and least < RAISE:
            line.take()
            if line.student and line.next.kind == "sign" and line.next.text == "+" and line.next.tight:
                line.take()
            tree, grows = _raised(line, tree, token), None
        elif token.kind == "degree" and least < RAISE:
            line.take()
            tree, grows = degrees(tree), None
        elif token.kind == "unit" and least < UNIT:  # `80 kg/4 m` is (80 kg)/(4 m), `3^2 m` is 9 m
            line.take()
            tree, grows = Product((tree, Name(token.text))), None
        elif _in_parallel(line) and least < TIMES:
            line.take()
            line.take()
            other = _formula(line, TIMES)
            tree, grows = Quotient(Product((tree, other)), Sum((tree, other))), None
        elif _follows(line) and least < TIMES:
            tree, grows = _implicit(line, tree, grows)
        else:
            line.depth -= 1
            return tree


def _times(tree: Expr, factor: Expr, grows: type | None) -> Expr:
    return Product(
        (*tree.factors, factor) if grows is Product and isinstance(tree, Product) else (tree, factor)
    )


def _follows(line: Line) -> bool:
    """Whether a factor follows without a product sign."""
    token = line.next
    return token.kind in STARTS or (
        token.kind == "bar" and (not line.bars or line.bars[-1] != _brackets(line))
    )


def _in_parallel(line: Line) -> bool:
    """True at the `||` of `R1 || R2`, two resistances side by side."""
    behind = line.tokens[line.at + 1] if line.next.kind == "bar" and not line.bars else None
    return line.student and behind is not None and behind.kind == "bar" and behind.tight


def _raised(line: Line, base: Expr, token: Token) -> Expr:
    """A power; of `e^2x`, `10^2x`, `r^1/2`, `e^-x/2` it is asked where the exponent ends."""
    typed = (
        line.next.at > token.at and line.next.kind != "open"
    )  # neither a raised digit nor settled by a bracket
    exponent = _formula(line, RAISE - 1)
    near = _power(base, exponent, token)
    bottom = exponent.term if isinstance(exponent, Negative) else exponent
    behind, tens = line.next, base in (Number(Fraction(10)), EULER)
    product = tens and behind.kind == "name" and behind.tight and isinstance(bottom, Number | Name)
    quotient = (
        behind.kind == "sign"
        and behind.text == "/"
        and behind.tight
        and (bottom == Number(Fraction(1)) or _of_a_root(bottom, line) or (tens and isinstance(bottom, Name)))
    )
    if not (line.student and typed and (product or quotient)) or line.lean == "near":
        return near
    if quotient:
        line.take()
    factor = _first(line, FACTOR)
    longer = Quotient(exponent, factor) if quotient else _times(exponent, factor, None)
    far = _power(base, longer, token)
    if line.lean == "far":
        return far
    if base == EULER:
        far, near = Call("exp", (longer,)), Call("exp", (exponent,))
    raise Stop(
        ambiguous(
            _("it is not clear where the exponent ends"),
            behind.at,
            text(far),
            f"({text(near)})/{text(factor)}" if quotient else text(Product((near, factor))),
        )
    )


def _of_a_root(bottom: Expr, line: Line) -> bool:
    """Whether `3/2`, `5/2` stands behind the sign of a power: `x^3/2` is meant for a root at least as often as for half a cube."""
    odd = isinstance(bottom, Number) and bottom.value in (3, 5, 7)
    return odd and line.after.kind == "number" and line.after.value == 2 and line.after.tight


def _brackets(line: Line) -> int:
    opened = line.tokens[: line.at]
    return sum(token.kind == "open" for token in opened) - sum(token.kind == "close" for token in opened)


def _implicit(line: Line, tree: Expr, grows: type | None) -> tuple[Expr, type]:
    token, before = line.next, line.tokens[line.at - 1]
    if not line.student:
        refuse(_("a product sign is missing here"), token.at, _("write * for every product"))
    if token.kind == "number":
        readings = f"{before.text}^{token.text}", f"{before.text}*{token.text}"
        raise Stop(ambiguous(_("a number behind a factor can be a power or a product"), token.at, *readings))
    half = (
        isinstance(tree, Quotient)
        and (isinstance(tree.top, Number) or line.numbers)
        and isinstance(tree.bottom, Number)
        and not token.tight
    )
    factor = _formula(line, TIMES)
    if (
        grows is Quotient and isinstance(tree, Quotient) and not half
    ):  # `1/2 m`, with its space, is one half of m
        below = Quotient(tree.top, _times(tree.bottom, factor, None))
        if line.lean == "far":
            return below, Quotient
        if line.lean == "ask":
            ask(_("it is not clear what stands below the slash"), token.at, below, Product((tree, factor)))
    return _times(tree, factor, grows), Product


def _power(base: Expr, exponent: Expr, token: Token) -> Expr:
    power, below = constant(exponent), constant(base)
    largest = LARGEST_EXPONENT if below == 10 else LARGEST_POWER
    if power is not None and abs(power) > largest:
        refuse(_("exponents go up to {largest}", largest=largest), token.at)
    if power is not None and below is not None:
        bits = max(below.numerator.bit_length(), below.denominator.bit_length())
        if bits * abs(power) > MOST_BITS:
            refuse(_("this power is too large a number"), token.at)
    return Power(base, exponent)


def _first(line: Line, least: int) -> Expr:
    token = line.next
    match token.kind:
        case "number":
            line.take()
            return Number(token.value, token.figures)
        case "name":
            line.take()
            return Name(token.text)
        case "e":
            line.take()
            return _exponential(line)
        case "function":
            line.take()
            return _call(line, token)
        case "open":
            line.take()
            inner = _formula(line, 0)
            if line.next.kind == "end":
                refuse(_("this bracket is never closed"), token.at)
            if line.next.kind != "close" or "([".index(token.text) != ")]".index(line.next.text):
                unexpected(line)
            line.take()
            return inner
        case "bar":
            line.take()
            line.bars.append(_brackets(line))
            inner = _formula(line, 0)
            if line.next.kind != "bar":
                refuse(_("this bar | is never closed"), token.at, _("write abs(…)"))
            line.bars.pop()
            line.take()
            return Call("abs", (inner,))
        case "sign" if token.text == "-":
            line.take()
            return Negative(_formula(line, max(least, ADD)))
        case "sign" if token.text == "+" and least < TIMES:
            line.take()
            if line.student and line.next.text == "-" and line.next.tight:
                refuse(_("+- can be ± or minus"), token.at, _("write one sign"))
            return _formula(line, max(least, ADD))
        case "sign":
            refuse(_("something is missing before {text}", text=token.text), token.at)
        case _:
            unexpected(line)
    raise AssertionError("to refuse leaves the reading")


def _exponential(line: Line) -> Expr:
    """Euler's number: `e^(-t)` is exp(-t)."""
    if line.next.kind == "sign" and line.next.text == "^":
        token = line.take()
        power = _raised(line, EULER, token)
        assert isinstance(power, Power)
        return Call("exp", (power.exponent,))
    return EULER


def _call(line: Line, token: Token) -> Expr:
    function, start = token.text, line.next
    power: Expr | None = None
    if start.kind == "sign" and start.text == "^":
        power = _power_of_function(line, function)
    if line.next.kind == "open":
        call = applied(function, _arguments(line, function))
    elif line.student and function not in steps():  # "round", "floor" are words, too
        call = applied(function, (_bare_argument(line, function),))
    else:
        refuse(
            _("{function} needs brackets", function=function),
            line.next.at,
            _("write {function}(…)", function=function),
        )
    if isinstance(call, Power):  # `pow(9, pow(9, 9))` is as large as 9^9^9
        call = _power(call.base, call.exponent, token)
    return call if power is None else Power(call, power)


def _power_of_function(line: Line, function: str) -> Expr:
    """`sin^2 x`; `sin^-1 x` has two readings."""
    sign = line.take()
    if line.next.kind == "sign" and line.next.text == "-":
        choices = (
            (f"arc{function}(…)", f"1/{function}(…)")
            if of_angle(function)
            else (f"1/{function}(…)", f"{function}(…)")
        )
        raise Stop(
            ambiguous(_("{function}^-1 can be read in two ways", function=function), sign.at, *choices)
        )
    if line.next.kind != "number" or line.next.figures or not 0 < line.next.value <= LARGEST_POWER:
        refuse(
            _("a whole number is expected as the power of {function}", function=function),
            line.next.at,
            _("write ({function}(…))^n", function=function),
        )
    return Number(line.take().value)


def _arguments(line: Line, function: str) -> tuple[Expr, ...]:
    opened = line.take()
    found = [_formula(line, 0)]
    wanted = arity(function)
    while line.next.kind == "comma" and (wanted != 1 or function == "ln"):
        line.take()
        found.append(_formula(line, 0))
    if line.next.kind == "end":
        refuse(_("this bracket is never closed"), opened.at)
    if line.next.kind != "close":
        unexpected(line)
    line.take()
    if wanted and len(found) != wanted and not (function == "ln" and len(found) == 2):
        refuse(
            _(
                "{function} takes {wanted} numbers, not {given}",
                function=function,
                wanted=wanted,
                given=len(found),
            ),
            opened.at,
        )
    return tuple(found)


def _bare_argument(line: Line, function: str) -> Expr:
    """`sin θ`, `sin 2θ`, `√2`: one factor, and nothing behind it that could belong to it as well."""
    token, start = line.next, line.at
    if token.kind in ("function", "bar") and arity(function) == 1:  # `sin cos x`, `ln|x|`
        return _first(line, FACTOR)
    if token.kind not in ("number", "name", "e") or arity(function) != 1:
        refuse(
            _("{function} needs brackets", function=function),
            token.at,
            _("write {function}(…)", function=function),
        )
    argument = _first(line, FACTOR)
    if line.next.kind == "degree":
        line.take()
        argument = degrees(argument)
    if token.kind == "number" and line.next.kind == "name" and line.next.tight and of_angle(function):
        argument = Product((argument, _first(line, FACTOR)))
    behind = line.next
    if behind.kind in ("number", "name", "e", "open") or (behind.kind == "sign" and behind.text in "/^"):
        if line.lean == "near" or line.numbers:
            return argument
        if line.lean == "far":
            line.at = start
            return _formula(line, ADD)
        inside = text(argument)
        more = {"/": "/…", "^": "^…"}.get(behind.text, "*…")
        choices = f"{function}({inside}{more})", f"{function}({inside}){more}"
        raise Stop(
            ambiguous(_("it is not clear where {function} ends", function=function), behind.at, *choices)
        )
    return argument
