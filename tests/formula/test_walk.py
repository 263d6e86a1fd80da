"""A walk over a formula: every part once, parents first, in reading order, however deep it is."""

from fractions import Fraction

from corollary.formula.ast import Name, Negative, Number, Power, Product, Quotient, Sum, names, walk


def test_parents_come_first_and_parts_in_reading_order():
    a, b, c, two = Name("a"), Name("b"), Name("c"), Number(Fraction(2))
    square, product = Power(a, two), Product((b, c))
    top = Sum((square, product))
    assert list(walk(Quotient(top, c))) == [Quotient(top, c), top, square, a, two, product, b, c, c]


def test_a_formula_deeper_than_python_calls_is_walked():
    deep = Name("x")
    for _ in range(5000):
        deep = Negative(deep)
    assert names(deep) == {"x"}
