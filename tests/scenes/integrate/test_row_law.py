"""The kernel's law is the push of the contacts, in every variable; its step is the step of the table."""

import math
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.scenes import row
from corollary.scenes.forces import contact as force
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.regularised import state_of
from corollary.scenes.integrate.row_law import TIME, conserved, push, slope, stored
from corollary.scenes.integrate.runge_kutta import DOP853, step, weighted
from corollary.scenes.integrate.stages import STAGES, finish, stage
from corollary.scenes.row import RowOfBodies

lines = st.integers(2, 5).flatmap(
    lambda n: st.builds(
        RowOfBodies,
        st.tuples(*[st.sampled_from([0.1, 1.0, 7.0])] * n),
        st.tuples(*[st.floats(-1.0, 1.0)] * n),
        st.tuples(*[st.floats(-1.0, 1.0)] * (n - 1)),
        st.tuples(
            *[
                st.builds(
                    Contact,
                    st.floats(0.1, 10.0),
                    st.sampled_from([1.0, 1.25, 1.5, 2.0, 2.5, 3.0, math.pi, 10.0]),
                    st.sampled_from([0.0, 0.5]),
                )
            ]
            * (n - 1)
        ),
        st.sampled_from([0.0, 9.8]),
    )
)


def newton(line, y, touching):
    """The rate of change of the state in time, from the forces of the contacts."""
    overlaps, speeds = y[1::2], y[::2]
    rates = [u - v for u, v in pairwise(speeds)]
    forces = [
        force.push(c, d) + c.eta * r if on and d >= 0.0 else 0.0
        for c, d, r, on in zip(line.contacts, overlaps, rates, touching, strict=True)
    ]
    between = [0.0, *forces, 0.0]
    gained = [(between[i] - between[i + 1]) / m - line.weight for i, m in enumerate(line.masses)]
    return [x for pair in zip(gained, [*rates, None], strict=True) for x in pair][:-1]


def close(found, true):
    assert list(found) == pytest.approx(list(true), rel=1e-12, abs=1e-12)


@given(lines, st.data())
@settings(max_examples=40, deadline=None)
def test_the_law_is_the_push_of_the_contacts(line, data):
    touching = data.draw(st.tuples(*[st.booleans()] * len(line.gaps)))
    y, _, terms = state_of(line)
    true, found = newton(line, y, touching), [math.nan] * len(y)
    slope(TIME, 1, 0.3, y, found, 0, len(touching), touching, terms)
    close(found, true)


@given(lines, st.data(), st.floats(0.01, 0.9), st.sampled_from([1, 2, 4]))
@settings(max_examples=40, deadline=None)
def test_in_the_variable_of_a_contact_the_law_is_only_stretched(line, data, w, power):
    contact = data.draw(st.integers(0, len(line.gaps) - 1))
    y, _, terms = state_of(line)
    own = 2 * contact + 1
    y[own] = w**power
    touching = [True] * len(line.gaps)
    true = newton(line, y, touching)
    if abs(true[own]) < 1e-3:
        return
    stretch = power * w ** (power - 1) / true[own]
    stretched = [stretch * rate for rate in true]
    stretched[own] = stretch  # the time takes the place of the overlap that is the variable
    y[own], found = 0.3, [math.nan] * len(y)
    slope(contact, power, w, y, found, 0, len(touching), touching, terms)
    close(found, stretched)


@given(lines)
@settings(max_examples=20, deadline=None)
def test_a_part_of_a_row_obeys_the_law_of_the_whole(line):
    y, touching, terms = state_of(line)
    last = len(touching)
    whole, part = [math.nan] * len(y), [math.nan] * len(y)
    slope(TIME, 1, 0.3, y, whole, 0, last, touching, terms)
    if last > 1:
        slope(TIME, 1, 0.3, y, part, 1, last, touching, terms)
        assert part[3:] == whole[3:]
        assert math.isnan(part[1])


@given(lines)
@settings(max_examples=20, deadline=None)
def test_what_is_kept_is_that_of_the_row(line):
    y, _, terms = state_of(line)
    assert conserved(y, terms) == pytest.approx(row.conserved(line, y[1::2], y[::2]), rel=1e-13, abs=1e-13)


@given(
    st.floats(0.1, 10.0), st.sampled_from([1.0, 1.25, 1.5, 2.0, 2.5, 3.0, math.pi, 10.0]), st.floats(0.0, 3.0)
)
def test_pushes_and_what_they_store(k, q, overlap):
    contact = Contact(k, q)
    if overlap > 0.0:
        assert push(k, q, overlap) == pytest.approx(force.push(contact, overlap), rel=1e-15)
    assert stored(k, q, overlap) == pytest.approx(force.stored(contact, overlap), rel=1e-14)
    assert push(k, 10.0, 1e200) == math.inf


def pendulums(x, y):
    """Coupled and driven: every variable of one step counts for all of the next."""
    return [math.cos(x + i) - 0.3 * v * y[i - 1] + math.sin(y[i - 2]) for i, v in enumerate(y)]


@pytest.mark.parametrize("count", [3, 5, 9])
@pytest.mark.parametrize("h", [0.3, -0.01])
def test_the_stages_are_those_of_the_table(count, h):
    y = [0.1 * i - 0.2 for i in range(count)]
    slopes, out = [pendulums(0.7, y), *([0.0] * count for _ in range(STAGES - 1))], [0.0] * count
    after, of_the_table = step(DOP853, pendulums, 0.7, y, h, slopes[0])
    for i in range(1, STAGES):
        stage(i, h, y, slopes, out, 0, count)
        slopes[i] = pendulums(0.7 + DOP853.nodes[i] * h, out)
    fifth, third = finish(h, y, slopes, out, 0, count)
    assert out == pytest.approx(after, rel=1e-14)
    squares = [sum(d * d for d in weighted(row, of_the_table)) for row in DOP853.estimates]
    assert (fifth, third) == pytest.approx(tuple(squares), rel=1e-6)
