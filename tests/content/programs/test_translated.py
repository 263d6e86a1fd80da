"""What the chapter's judges say of usual wrong programs, in the languages of the chapter: none of it in English."""

from __future__ import annotations

import random
import re

import pytest
from tests.judges import judges

from corollary.messages import language
from corollary.programs import EULER, EULER_CROMER, Called, Fault

ion_force, judge_ions, ion_inputs = judges(
    "collisions/two_ions/judge_ions.py", "ion_force judge_ions ion_inputs"
)
(marched,) = judges("collisions/two_bodies.py", "marched")
forward_euler, judge_orbit, orbit_inputs, pull_of, start_of = judges(
    "projects/catching_an_atom/judge_orbit.py", "forward_euler judge_orbit orbit_inputs pull_of start_of"
)
ended, judge_catch, catch_inputs, euler = judges(
    "projects/catching_an_atom/judge_catch.py", "ended judge_catch catch_inputs forward_euler"
)
ENGLISH = re.compile(r"\b(the|this|is|what|step|does|with|velocity)\b", re.IGNORECASE)


def ions(inputs, method=EULER_CROMER, both=True):
    return marched(inputs, ion_force(inputs["C"]), method, round(inputs["T"] / inputs["dt"]), both=both)


WRONG = {
    "ions, forward Euler": (ion_inputs, judge_ions, lambda each: ions(each, EULER)),
    "ions, one-sided": (ion_inputs, judge_ions, lambda each: ions(each, both=False)),
    "orbit, forward Euler": (
        orbit_inputs,
        judge_orbit,
        lambda each: forward_euler(pull_of(each), start_of(each), each["T"], round(each["T"] / each["dt"]))[:2],
    ),
    "catch, forward Euler": (catch_inputs, judge_catch, lambda each: ended(each, each["dt"], walk=euler)[:2]),
    "catch, not shared": (catch_inputs, judge_catch, lambda each: ended(each, each["dt"], keeps=1.0)[:2]),
}  # fmt: skip


@pytest.mark.whole
@pytest.mark.parametrize("code", ["de", "nb"])
@pytest.mark.parametrize("wrong", WRONG)
def test_a_usual_mistake_is_named_in_the_language_of_the_course(wrong, code):
    inputs, judge, program = WRONG[wrong]
    called = [Called(each, tuple(program(each))) for each in inputs({}, random.Random(2).uniform)]
    english = judge({}, called)
    assert isinstance(english, Fault)
    assert english.known
    assert ENGLISH.search(english.sentence)
    with language(code):
        fault = judge({}, called)
    assert fault.known
    assert not ENGLISH.search(fault.sentence), fault.sentence
