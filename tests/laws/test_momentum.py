"""Total momentum: additive, the same for one body in pieces, and changed by external impulses only."""

import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import external_impulse, magnitude, sticking, total_momentum
from corollary.laws.law import sides

number = st.fractions(-9, 9, max_denominator=10)
mass = st.fractions("1/10", 9, max_denominator=10)
velocity = st.tuples(number, number)
P = sympy.symbols("P_x P_y", real=True)


def total(bodies):
    return [right for _, right in sides(total_momentum(P, bodies))]


@given(st.lists(st.tuples(mass, velocity), min_size=1, max_size=5))
def test_the_order_of_the_bodies_does_not_matter(bodies):
    assert total(bodies) == total(bodies[::-1])


@given(mass, mass, velocity)
def test_a_body_in_two_pieces_has_the_same_momentum(one, other, v):
    assert total([(one, v), (other, v)]) == total([(one + other, v)])


@given(st.tuples(mass, velocity), st.tuples(mass, velocity))
def test_bodies_that_stick_keep_their_total_momentum(a, b):
    unknown = sympy.symbols("u_x u_y", real=True)
    found = sympy.solve(
        [left - right for left, right in sides(sticking(before=[a, b], together=unknown))], unknown
    )
    assert total([(a[0] + b[0], tuple(found[u] for u in unknown))]) == total([a, b])


@given(number, number)
def test_no_external_impulse_no_change(before, impulse):
    after = sympy.Symbol("after", real=True)
    ((left, right),) = sides(external_impulse(impulse, before=before, after=after))
    assert sympy.solve(left - right, after) == [sympy.Rational(before) + sympy.Rational(impulse)]


@given(number, number)
def test_the_magnitude_does_not_depend_on_signs(x, y):
    length = sympy.sqrt(sympy.Rational(x) ** 2 + sympy.Rational(y) ** 2)
    assert {sides(magnitude(0, (a, b)))[0][1] for a in (x, -x) for b in (y, -y)} == {length}
