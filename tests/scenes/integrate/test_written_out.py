"""A step and a law written out say the same as the table and the contacts they come from; so do their arrays for long rows."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.scenes.forces.contact import Contact, push
from corollary.scenes.integrate import long_row, written_out
from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.row_problem import error_size
from corollary.scenes.integrate.runge_kutta import error_estimate, step
from corollary.scenes.integrate.time_variable import TIME, TimeVariable, beside, in_time
from corollary.scenes.integrate.written_out import power_text
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


def newton(line, state, touching):
    """The rates of change of (overlaps, velocities) in time, from the forces of the contacts."""
    count = len(line.contacts)
    overlaps, speeds = state[1 : count + 1], state[count + 1 :]
    rates = [speeds[j] - speeds[j + 1] for j in range(count)]
    forces = [
        push(c, d, r) if on and d >= 0.0 else 0.0
        for c, d, r, on in zip(line.contacts, overlaps, rates, touching, strict=True)
    ]
    between = [0.0, *forces, 0.0]
    gained = [(between[i] - between[i + 1]) / m - line.weight for i, m in enumerate(line.masses)]
    return [*rates, *gained]


def close(found, true):
    assert list(found) == pytest.approx(list(true), rel=1e-12, abs=1e-12)


@given(lines, st.data())
@settings(max_examples=40, deadline=None)
def test_the_law_written_out_is_the_push_of_the_contacts(line, data):
    touching = data.draw(st.tuples(*[st.booleans()] * len(line.gaps)))
    state = [0.3, *(-gap for gap in line.gaps), *line.velocities]
    true = newton(line, state, touching)
    for law in (written_out.law_of_motion, long_row.law_of_motion):
        close(law(line, touching)(0.3, state[1:]), true)


@given(lines, st.data(), st.floats(0.01, 0.9), st.sampled_from([1, 2, 4]))
@settings(max_examples=40, deadline=None)
def test_in_the_variable_of_a_contact_the_law_is_only_stretched(line, data, w, power):
    contact = data.draw(st.integers(0, len(line.gaps) - 1))
    variable = TimeVariable(contact, power)
    state = [0.3, *(-gap for gap in line.gaps), *line.velocities]
    state[1 + contact] = variable.overlap(w)
    touching = [True] * len(line.gaps)
    true = newton(line, state, touching)
    if abs(true[contact]) < 1e-3:
        return
    stretch = power * w ** (power - 1) / true[contact]
    stretched = [stretch * rate for rate in true]
    stretched[contact] = stretch  # the time takes the place of the overlap that is the variable
    for law in (written_out.law_of_motion, long_row.law_of_motion):
        close(law(line, touching, variable)(w, beside(variable, state)), stretched)
    close(in_time(variable, w, beside(variable, state)), state)
    assert in_time(TIME, 0.3, beside(TIME, state)) == state


def pendulums(x, y):
    """Coupled and driven: every variable of one step counts for all of the next."""
    return [math.cos(x + i) - 0.3 * v * y[i - 1] + math.sin(y[i - 2]) for i, v in enumerate(y)]


@pytest.mark.parametrize("count", [3, 5, 9])
@pytest.mark.parametrize("h", [0.3, -0.01])
def test_a_step_written_out_is_the_step_of_the_table(count, h):
    y = [0.1 * i - 0.2 for i in range(count)]
    first = pendulums(0.7, y)
    after, slopes = step(DOP853, pendulums, 0.7, y, h, first)
    for taken in (written_out.step(DOP853, count), long_row.step):
        found, fifth, third = taken(pendulums, 0.7, h, y, first)
        assert list(found) == pytest.approx(after, rel=1e-14)
        assert error_size(fifth, third, h, count) == pytest.approx(
            error_estimate(DOP853, slopes, h, [1.0] * count), rel=1e-6
        )


@pytest.mark.parametrize("exponent", [0.0, 1.0, 1.5, 2.0, 3.0, 3.5, 6.0, 1.25, 2.7, 10.0])
def test_powers_are_products_and_roots_where_these_do(exponent):
    text = power_text("d", exponent)
    assert eval(text, {"d": 1.7, "sqrt": math.sqrt}) == pytest.approx(1.7**exponent, rel=1e-15)
    assert ("**" in text) == (exponent in (1.25, 2.7, 10.0))
