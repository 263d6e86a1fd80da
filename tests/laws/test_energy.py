"""Energy laws: what a change of axes or of frame may not change, and where they must agree with each other."""

import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import (
    change_of_kinetic_energy,
    change_of_kinetic_energy_in_plane,
    energy_at_heights,
    falling,
    work_of_net_force,
)
from corollary.laws.law import sides

number = st.fractions(-9, 9, max_denominator=10)
mass = st.fractions("1/10", 9, max_denominator=10)
velocity = st.tuples(number, number)
dK = sympy.Symbol("dK", real=True)


def change(bodies_before, bodies_after):
    ((_, right),) = sides(change_of_kinetic_energy_in_plane(dK, before=bodies_before, after=bodies_after))
    return right


@given(mass, mass, velocity, velocity, velocity)
def test_the_loss_of_bodies_that_stick_is_the_same_for_every_observer(a, b, v, w, frame):
    together = tuple((a * p + b * q) / (a + b) for p, q in zip(v, w, strict=True))

    def seen(u):
        return tuple(p - q for p, q in zip(u, frame, strict=True))

    here = change([(a, v), (b, w)], [(a, together), (b, together)])
    there = change([(a, seen(v)), (b, seen(w))], [(a, seen(together)), (b, seen(together))])
    assert here == there
    assert here <= 0


@given(mass, number, number)
def test_along_one_axis_it_is_the_law_of_the_line(m, v, w):
    ((_, line),) = sides(change_of_kinetic_energy(dK, before=[(m, v)], after=[(m, w)]))
    assert change([(m, (v, 0))], [(m, (w, 0))]) == change([(m, (0, v))], [(m, (0, w))]) == line


@given(st.fractions(0, 9, max_denominator=10), st.fractions(1, 20, max_denominator=10), number)
def test_a_fall_from_rest_is_the_same_from_any_height(h, g, floor):
    v = sympy.Symbol("v", nonnegative=True)
    ((left, right),) = sides(energy_at_heights(g, before=(0, floor + h), after=(v, floor)))
    ((here, there),) = sides(falling(v, g, h))
    assert sympy.expand((left - right) - (here - there)) == 0


@given(mass, number, number, st.fractions(1, 9, max_denominator=10))
def test_work_agrees_with_uniform_acceleration(m, v, a, time):
    way, end = v * time + a * time**2 / 2, v + a * time
    ((left, right),) = sides(work_of_net_force(m * a, way, m, before=v, after=end))
    assert left == right
