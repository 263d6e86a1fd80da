"""The level follows from what was found to hold, and a sentence says what does not."""

from __future__ import annotations

import pickle

import pytest

from corollary.sandbox.isolation import WeakIsolation, isolation_of

FOUR = "reads writes signals network"


@pytest.mark.parametrize(
    ("held", "level"),
    [
        (f"namespaces Landlock seccomp rlimits disk processes {FOUR}", 3),
        (f"Landlock seccomp rlimits processes {FOUR}", 2),
        (f"namespaces seccomp rlimits disk processes {FOUR}", 2),
        (f"namespaces Landlock rlimits disk {FOUR}", 1),
        (f"namespaces rlimits disk {FOUR}", 1),
        ("seccomp rlimits processes signals network", 0),
        ("Landlock rlimits reads", 0),
        ("namespaces Landlock seccomp rlimits processes disk reads writes signals", 0),
        ("namespaces Landlock seccomp rlimits processes disk reads writes network", 0),
        ("rlimits", 0),
        ("", 0),
    ],
)
def test_the_level_is_counted_from_what_is_guaranteed(held: str, level: int) -> None:
    isolation = isolation_of(dict.fromkeys(held.split(), True), {"Landlock": "the kernel offers no Landlock"})
    assert isolation.level == level
    assert set(isolation.guaranteed) == set(FOUR.split()) & set(held.split())
    assert ("Landlock" in held) == ("Landlock: the kernel offers no Landlock" not in isolation.missing)
    assert ("do not grade" in isolation.line) == (level == 0)
    for name in set(FOUR.split()) - set(held.split()):
        assert name in isolation.line


def test_a_layer_that_should_be_there_and_does_not_hold_is_said_so() -> None:
    isolation = isolation_of({"namespaces": True}, {})
    assert "seccomp: did not hold when tried" in isolation.missing


def test_too_weak_an_isolation_can_be_raised_in_another_process() -> None:
    error = WeakIsolation(isolation_of({}, {"seccomp": "no"}), 3)
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error)
    assert "level 3 is required, but here only level 0" in str(again)
    assert again.isolation == error.isolation
