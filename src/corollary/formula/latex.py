r"""Formulas as TeX sets them, their form kept: `m*v_A0/dt` becomes a fraction with \Delta t below the line."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterable, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from typing import assert_never

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.functions import FUNCTIONS
from corollary.formula.numerals import decimal_text
from corollary.formula.operators import OPERATORS
from corollary.formula.symbols import GREEK, LAMBDA, WORDS

COMPARE, ADD, TIMES, RAISE, ATOM = range(5)  # how tightly a formula holds together

GREEK_WORD = re.compile("|".join((*WORDS, "pi", "eps", LAMBDA)))
INDEX = re.compile(r"[0-9]+|[A-Z](?=[xyz]?(?![a-z]))|[xyz](?![a-z])|[A-Za-z][a-z]*")
IN_LATEX = {
    "eps": r"\varepsilon", "epsilon": r"\varepsilon", "phi": r"\varphi", "lam": r"\lambda", "lamda": r"\lambda",
}  # fmt: skip
SIGNS = {"=": "=", "!=": r"\neq", "<": "<", "<=": r"\leq", ">": ">", ">=": r"\geq"}
DEGREE = r"{}^{\circ}"
NO_LETTERS: Mapping[str, str] = {}
_PRINTED: ContextVar[Mapping[str, str]] = ContextVar("printed letters", default=NO_LETTERS)
AS_TYPED = re.compile(r"(?P<change>[Δ∆])?(?P<head>[^\W\d_]+)(?:_(?P<index>\w+)|(?P<number>\d+))?")


@contextmanager
def letters_printed(as_tex: Iterable[tuple[str, str]]) -> Generator[None]:
    """Inside, these letters of a problem (`printed_letters`) are set in this TeX, and all others by rule."""
    before = _PRINTED.set(dict(as_tex))
    try:
        yield
    finally:
        _PRINTED.reset(before)


def tex_of_letter(text: str) -> str:
    r"""The TeX of a letter as an author types it: `pH` is \mathrm{pH}, `Δv` is \Delta v, `pK_a` is \mathrm{pK}_{a}; what has a backslash is
    TeX already. Raises ValueError with a sentence for what is no letter."""
    if "\\" in text:
        if text.count("{") != text.count("}") or set(text) & set("$#%&~\n"):
            raise ValueError(f"{text!r} is not TeX of one letter; write it as pH, Δv, pK_a or \\mathrm{{pH}}")
        return text
    found = AS_TYPED.fullmatch(text)
    if found is None:
        raise ValueError(f"{text!r} is not a letter; write it as pH, Δv, pK_a or \\mathrm{{pH}}")
    index = found["index"] or found["number"] or ""
    head = _upright(found["head"]) + (f"_{{{_upright(index)}}}" if index else "")
    return rf"\Delta {head}" if found["change"] else head


def _upright(word: str) -> str:
    """One letter as it is, a Greek one by its name; several upright."""
    if len(word) == 1:
        name = GREEK.get(word)
        return word if name is None else IN_LATEX.get(name, f"\\{name}")
    return word if word.isdecimal() else rf"\mathrm{{{word}}}"


def latex(tree: Expr, letters: Mapping[str, str] = NO_LETTERS) -> str:
    """The formula in TeX; `letters` gives the TeX of names that should not be set by rule."""
    return _latex(tree, letters)[0]


def letter(name: str) -> str:
    r"""One letter of a formula, as its author wants it printed, else by rule: `v_A0` and `vA0` are v_{A,0}, `dt` is \Delta t, `mu` is \mu, `mdot` is \dot{m}."""
    if (own := _PRINTED.get().get(name)) is not None:
        return own
    if name.endswith("dot") and len(name) > 3:
        return rf"\dot{{{letter(name[:-3])}}}"
    change = re.fullmatch(r"(?:d(?=[A-Za-z])|Delta_?)(?!elta)(.+)", name)
    if change:
        return rf"\Delta {letter(change[1])}"
    greek = GREEK_WORD.match(name)
    head, rest = (greek[0], name[greek.end() :]) if greek else (name[:1], name[1:])
    head = IN_LATEX.get(head, "\\" + head) if greek else head
    indices = [
        rf"\mathrm{{{each}}}" if len(each) > 1 and each.isalpha() else each for each in INDEX.findall(rest)
    ]
    return head + (f"_{{{','.join(indices)}}}" if indices else "")


def vector(name: str) -> str:
    r"""The letter with an arrow over it, and none over its indices: `JAB` is {\vec{J}_{A,B}}, `dp` is \Delta \vec{p}."""
    whole = letter(name)
    if whole.startswith(r"\dot"):
        return rf"\vec{{{whole}}}"
    change = r"\Delta " if whole.startswith(r"\Delta ") else ""
    head, line, index = whole.removeprefix(change).partition("_")
    # One thing in braces: its square is a power of the whole, and not a letter with an index and a power at once.
    return rf"{change}{{\vec{{{head}}}{line}{index}}}" if line else rf"{change}\vec{{{head}}}"


def _latex(tree: Expr, letters: Mapping[str, str]) -> tuple[str, int]:
    def within(part: Expr, hold: int) -> str:
        written, own = _latex(part, letters)
        return written if own >= hold else rf"\left({written}\right)"

    match tree:
        case Number(value, figures):
            return _number(value, figures)
        case Name(name):
            return (r"\pi" if name == "pi" else letters.get(name) or letter(name)), ATOM
        case Negative(term):
            return "-" + within(term, TIMES), ADD
        case Sum(terms):
            signed = [
                (isinstance(term, Negative), term.term if isinstance(term, Negative) else term)
                for term in terms
            ]
            return _sum([(minus, within(term, TIMES)) for minus, term in signed]), ADD
        case Product(factors):
            *before, last = factors
            bracketed = [_bracketed(factor, letters) or within(factor, TIMES) for factor in before]
            return _product([*bracketed, within(last, TIMES)]), TIMES
        case Quotient(top, bottom):
            if bottom == Number(Fraction(180)) and top == Name("pi"):
                return DEGREE, TIMES
            return rf"\frac{{{_latex(top, letters)[0]}}}{{{_latex(bottom, letters)[0]}}}", TIMES
        case Power(Call(function, (argument,)), exponent) if _of_angle(function):
            return (
                f"{_named(function)}^{{{_latex(exponent, letters)[0]}}}{_argument(argument, letters)}",
                TIMES,
            )
        case Power(base, Quotient(Number(Fraction(numerator=1, denominator=1)), Number(degree))) if (
            degree > 2
        ):
            return rf"\sqrt[{degree}]{{{_latex(base, letters)[0]}}}", ATOM
        case Power(base, exponent):
            return f"{within(base, ATOM)}^{{{_latex(exponent, letters)[0]}}}", RAISE
        case Call(function, arguments) if function in OPERATORS:
            return _operator(function, arguments, letters)
        case Call(function, arguments):
            return _call(function, arguments, letters)
        case Relation(sign, left, right):
            return f"{within(left, ADD)} {SIGNS[sign]} {within(right, ADD)}", COMPARE
        case _:
            assert_never(tree)


def _number(value: Fraction, figures: int) -> tuple[str, int]:
    if value.denominator == 1 and figures == 0:
        return str(value), ADD if value < 0 else ATOM
    if figures == 0 and value.denominator < 1000:
        fraction = rf"\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
        return ("-" + fraction, ADD) if value < 0 else (fraction, TIMES)
    mantissa, _, power = decimal_text(value, figures).partition("e")
    return (
        rf"{mantissa} \cdot 10^{{{power}}}" if power else mantissa
    ), ADD if value < 0 else TIMES if power else ATOM


def _sum(terms: list[tuple[bool, str]]) -> str:
    (first_minus, first), *others = terms
    return (
        ("-" if first_minus else "")
        + first
        + "".join((" - " if minus else " + ") + term for minus, term in others)
    )


def _product(factors: list[str]) -> str:
    written = factors[0]
    for factor in factors[1:]:
        numbers = factor[0].isdigit() or (factor.startswith(r"\frac") and written[-1].isdigit())
        written += ("" if factor == DEGREE else r" \cdot " if numbers else r"\, ") + factor
    return written


def _bracketed(factor: Expr, letters: Mapping[str, str]) -> str:
    """A function with factors behind it shows where it ends; "" for other factors."""
    match factor:
        case Call(function, (Name() as argument,)) if (
            function not in OPERATORS and "#" not in FUNCTIONS[function].tex
        ):
            return f"{_named(function)}({_latex(argument, letters)[0]})"
        case Power(Call(function, (Name() as argument,)), exponent) if _of_angle(function):
            return f"{_named(function)}^{{{_latex(exponent, letters)[0]}}}({_latex(argument, letters)[0]})"
        case _:
            return ""


def _named(function: str) -> str:
    return FUNCTIONS[function].tex or "\\" + function


def _of_angle(function: str) -> bool:
    return function not in OPERATORS and FUNCTIONS[function].angle


def _operator(function: str, arguments: tuple[Expr, ...], letters: Mapping[str, str]) -> tuple[str, int]:
    """A derivative, an integral, the value of a function somewhere, a product of vectors."""

    def within(part: Expr, hold: int) -> str:
        written, own = _latex(part, letters)
        return written if own >= hold else rf"\left({written}\right)"

    match function, arguments:
        case "derivative", (of, by, order):
            power = "" if order == Number(Fraction(1)) else f"^{{{_latex(order, letters)[0]}}}"
            above, below = rf"\mathrm{{d}}{power}", rf"\mathrm{{d}}{_latex(by, letters)[0]}{power}"
            if isinstance(of, Name):
                return rf"\frac{{{above} {_latex(of, letters)[0]}}}{{{below}}}", TIMES
            return rf"\frac{{{above}}}{{{below}}}\left({_latex(of, letters)[0]}\right)", TIMES
        case "integral", (of, by, low, high):
            ends = rf"_{{{_latex(low, letters)[0]}}}^{{{_latex(high, letters)[0]}}}"
            return rf"\int{ends} {within(of, TIMES)} \,\mathrm{{d}}{_latex(by, letters)[0]}", ADD
        case "value", (of, at):
            return rf"{_latex(of, letters)[0]}\left({_latex(at, letters)[0]}\right)", ATOM
        case "infinity", _:
            return r"\infty", ATOM
        case "norm", (of,):
            return rf"\left|{_latex(of, letters)[0]}\right|", ATOM
        case _:
            one, other = (within(argument, RAISE) for argument in arguments)
            return one + (r" \cdot " if function == "dot" else r" \times ") + other, TIMES


def _argument(argument: Expr, letters: Mapping[str, str]) -> str:
    written, hold = _latex(argument, letters)
    return (
        f" {written}" if hold == ATOM and isinstance(argument, Name | Number) else rf"\left({written}\right)"
    )


def _call(function: str, arguments: tuple[Expr, ...], letters: Mapping[str, str]) -> tuple[str, int]:
    inner = ", ".join(_latex(argument, letters)[0] for argument in arguments)
    form = FUNCTIONS[function].tex
    if "#" in form:
        return form.replace("#", inner), RAISE if "^" in form else ATOM
    if len(arguments) == 1:
        return _named(function) + _argument(arguments[0], letters), TIMES
    return _named(function) + rf"\left({inner}\right)", ATOM
