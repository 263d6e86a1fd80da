"""Balls in plain Python enclose what python-flint's enclose, as narrowly but for a few bits."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction

import flint
import pytest

from corollary.formula import plain_arb

FUNCTIONS = ["sin", "cos", "tan", "exp", "log", "sqrt", "asin", "acos", "atan", "sinh", "cosh", "tanh"]
NUMBERS = [-1e3, -2.75, -1.0, -0.5, -1e-7, 0.0, 1e-9, 0.3, 0.5, 1.0, 2.0, math.pi, 355.0, 1e6]
LOST = 40  # bits; where tanh of 1e-7 takes 1 from 1, a few more than that number is small


@contextmanager
def bits(count: int) -> Iterator[None]:
    before = plain_arb.ctx.prec, flint.ctx.prec
    plain_arb.ctx.prec = flint.ctx.prec = count
    try:
        yield
    finally:
        plain_arb.ctx.prec, flint.ctx.prec = before


def in_flint(ball: plain_arb.arb) -> flint.arb:
    """The same ball, at a precision at which nothing is rounded."""
    with bits(20_000):
        unit = flint.arb(2) ** ball.exponent
        return (flint.arb(ball.whole - ball.off) * unit).union(flint.arb(ball.whole + ball.off) * unit)


def has_value(name: str, number: float) -> bool:
    return number > 0 if name in ("log", "sqrt") else abs(number) <= 1 if name in ("asin", "acos") else not (
        name in ("exp", "sinh", "cosh") and abs(number) > 1000
    )  # fmt: skip


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("count", [64, 320, 2560])
def test_a_function_encloses_the_value_and_little_else(name, count):
    for number in NUMBERS:
        if not has_value(name, number):
            continue
        with bits(count):
            ours = getattr(plain_arb.arb(number), name)()
        with bits(2 * count + 200):
            exact = getattr(flint.arb(number), name)()
        assert in_flint(ours).contains(exact), (name, number)
        lost = LOST if name in ("tanh", "sinh", "log") else 12
        off = Fraction(ours.off) * Fraction(2) ** (ours.exponent + count - lost)
        assert off <= max(abs(float(exact)), min(1.0, abs(number))), (name, number)


@pytest.mark.parametrize("number", ["7/2", "-7/2", "3", "-3", "299999/100000", "1/1000000", "12345678901/7"])
def test_a_floor_is_the_whole_number_below(number):
    with bits(64):
        ours = (plain_arb.arb(Fraction(number).numerator) / Fraction(number).denominator).floor()
    assert ours.is_integer()
    assert int(float(ours)) == math.floor(Fraction(number))


def test_the_floor_of_a_ball_across_a_step_holds_both_whole_numbers():
    found = plain_arb.arb(2.875, 0.25).floor()
    assert found.contains(2)
    assert found.contains(3)
    assert not found.contains(1)
    assert not found.contains(4)


def test_of_a_wide_ball_the_values_of_both_ends_are_enclosed():
    draw = random.Random(4).uniform
    for _ in range(60):
        middle, width = draw(-3, 3), 10 ** draw(-8, -2)
        for name in FUNCTIONS:
            if not (has_value(name, middle - width) and has_value(name, middle + width)):
                continue
            with bits(96):
                ours = getattr(plain_arb.arb(middle, width), name)()
                if ours.is_finite():
                    for end in (middle - width, middle, middle + width):
                        assert in_flint(ours).overlaps(getattr(flint.arb(end), name)()), (name, middle, width)


@pytest.mark.parametrize("count", [53, 96, 640])
def test_arithmetic_encloses_the_value_and_rounds_to_the_same_double(count):
    draw = random.Random(count)
    for _ in range(300):
        x, y = (draw.choice((-1, 1)) * 10 ** draw.uniform(-160, 160) for _ in range(2))
        for operation in (
            lambda a, b: a + b,
            lambda a, b: a - b,
            lambda a, b: a * b,
            lambda a, b: a / b,
            lambda a, b: (a / b) ** 3,
            lambda a, b: abs(a).root(3) * b,
            lambda a, b: abs(b).sqrt(),
            lambda a, b: type(a).atan2(a, b),
            lambda a, b: a.min(b) + a.max(b),
        ):
            with bits(count):
                ours, theirs = (operation(kind(x), kind(y)) for kind in (plain_arb.arb, flint.arb))
                union = plain_arb.arb(x).union(plain_arb.arb(y))
            assert in_flint(ours).overlaps(theirs)
            assert in_flint(union).contains(flint.arb(x).union(flint.arb(y)).mid())
            assert in_flint(union).contains(x)
            if count > 90:
                assert float(ours) == pytest.approx(float(theirs), rel=1e-15, abs=0)


def test_what_is_certain_is_said_and_nothing_else():
    near = plain_arb.arb(1, 1e-3)
    assert near > 0
    assert near < 1.01
    assert not near > 1
    assert not near < 1
    assert near.contains(1)
    assert near.contains_integer()
    assert not plain_arb.arb(0.5, 0.1).contains_integer()
    assert near.overlaps(plain_arb.arb(1.002, 1e-3))
    assert not near.overlaps(plain_arb.arb(1.003, 1e-4))
    assert plain_arb.arb(4).sqrt().is_integer()
    nothing = plain_arb.arb(1) / near.union(plain_arb.arb(-1))
    assert not nothing.is_finite()
    assert not nothing > 0
    assert not nothing <= 0
    assert math.isnan(float(nothing))
    assert not plain_arb.arb("nan").is_finite()
    assert not plain_arb.arb(1e9).exp().is_finite()


def test_doubles_come_and_go_unchanged():
    for number in (0.1, -5e-324, 1.7976931348623157e308, 0.0, 2.0**-1074, 123456789.0):
        assert float(plain_arb.arb(number)) == number
    with bits(200):
        third = plain_arb.arb(plain_arb.fmpq(1, 3))
        assert float(third) == 1 / 3
        assert float(plain_arb.arb(10) ** 400) == math.inf
        assert third.gamma().overlaps(plain_arb.arb(2.678938534707747633))
