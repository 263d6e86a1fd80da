"""Damped contacts of a row: what stays together for ever is told, and of several damped contacts nothing is."""

import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.regularised import state_of
from corollary.scenes.integrate.row_events import stays
from corollary.scenes.row import RowOfBodies


def laid_out(eta, speed, deep=0.1, count=2):
    """Two bodies or more that overlap, and part with this speed one after the other."""
    contacts = (Contact(1.0, 1.0, eta),) * (count - 1)
    line = RowOfBodies(
        (1.0,) * count, tuple(speed * i for i in range(count)), (-deep,) * (count - 1), contacts
    )
    return state_of(line)


@pytest.mark.parametrize("root", [0.5, 0.99])
def test_what_parts_slower_than_the_larger_root_stays_together(root):
    """z^2 - (eta/mu) z + k/mu with mu = 1/2: z = -rate/overlap below its larger root, here 3."""
    eta = 0.5 * (3.0 + 2.0 / 3.0)
    assert stays(*laid_out(eta, 3.0 * root * 0.1), 1e-12)
    assert not stays(*laid_out(eta, 3.0 / root * 0.1), 1e-12)


def test_without_damping_nothing_stays():
    assert not stays(*laid_out(0.0, 0.01), 1e-12)


def test_below_critical_damping_nothing_stays():
    """eta^2 < 4 k mu: the overlap swings through zero."""
    assert not stays(*laid_out(1.4, 0.0), 1e-12)
    assert stays(*laid_out(1.5, 0.0), 1e-12)


def test_of_several_damped_contacts_nothing_is_certain():
    assert not stays(*laid_out(100.0, 0.0, count=3), 1e-12)
