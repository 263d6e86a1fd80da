"""The trade: references found again by other means, orders as theory has them, and the planner held to the table."""

from __future__ import annotations

import json
import math
import runpy
from pathlib import Path

import pytest

from corollary.derive.ready_scenes import run
from corollary.grading.programs.fixed_step import RK4
from corollary.scenes.integrate.runge_kutta import DOP853
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.pair import meet
from corollary.trade import colliding_spheres, methods, raced_scene
from corollary.trade.colliding_spheres import through
from corollary.trade.race import (
    Order,
    Timing,
    WorkPrecision,
    cases,
    cheapest,
    fitted,
    frontier,
    lies_beyond,
    orders,
    race,
    reaching,
    record,
)
from corollary.trade.raced_scene import MethodAnswer, error_of

HERE = Path(__file__).parent
TABLE = {
    "ball_on_floor": raced_scene.BALL,
    "atom bound": raced_scene.ATOM_BOUND,
    "atom escaping": raced_scene.ATOM_ESCAPING,
    "spheres eta=0": raced_scene.SPHERES,
    "spheres eta=1": raced_scene.SPHERES_DAMPED,
}


@pytest.fixture(scope="module")
def raced() -> dict[str, WorkPrecision]:
    return {case.name: race(case, quick=True) for case in cases()}


@pytest.mark.parametrize("name", TABLE)
def test_references_are_found_again(name):
    import mpmath as mp

    found = runpy.run_path(str(HERE / "references_in_40_digits.py"))["TABLE"][name]()
    for written, value in zip(TABLE[name].values, found, strict=False):
        assert abs(mp.mpf(written) - value) < mp.mpf(10) ** -(TABLE[name].digits - 1)


def test_references_of_cradles_are_those_of_the_other_program():
    known = json.loads((HERE.parent / "scenes" / "references.json").read_text(encoding="utf-8"))
    assert tuple(known["3 1"]) == raced_scene.CRADLE_3_SPRINGS.values
    assert tuple(known["3 1.5"]) == raced_scene.CRADLE_3_HERTZ.values
    assert tuple(known["3 3"]) == raced_scene.CRADLE_3_CUBIC.values
    assert tuple(known["5 1.5"]) == raced_scene.CRADLE_5_HERTZ.values


@pytest.mark.whole
def test_the_planned_route_agrees_with_the_reference_to_twelve_digits(raced):
    for name, each in raced.items():
        assert min(timing.error for timing in each.timings if timing.method == each.planned) < 1e-12, name


@pytest.mark.whole
def test_the_planner_takes_what_is_cheapest_for_twelve_digits(raced):
    """In evaluations, which no other work on the machine can change; a model without steps pays none or few."""
    for name, each in raced.items():
        ways = {method: timing.evaluations for method, timing in reaching(each, 1e-12).items()}
        assert each.planned in ways, name
        # Equal steps have no opinion about their own error; an adaptive route pays for its own.
        rivals = [cost for method, cost in ways.items() if method != each.planned]
        assert ways[each.planned] <= 1.5 * min(rivals, default=math.inf), (name, ways)


def test_what_every_method_finds_gets_better(raced):
    for name, each in raced.items():
        for method in dict.fromkeys(timing.method for timing in each.timings):
            errors = [timing.error for timing in each.timings if timing.method == method]
            if len(errors) > 3:
                assert min(errors[-2:]) < 0.3 * max(errors[:2]), (name, method)


@pytest.mark.parametrize(
    ("scene", "method", "low", "high"),
    [
        ("cradle N=3 q=1.5", "euler_cromer", 1.8, 2.2),
        ("cradle N=3 q=3", "velocity_verlet", 1.95, 2.05),
        ("atom bound", "rk4", 3.9, 4.1),
        ("atom bound", "yoshida6", 5.8, 6.2),
        ("atom escaping", "rk4", 0.9, 1.1),
        ("spheres eta=0", "regularised_rk4", 3.9, 5.2),
        ("spheres eta=1", "regularised_rk4", 3.97, 4.1),
        ("spheres eta=0", "regularised_dop853", 8.0, 12.0),
        ("spheres eta=1", "regularised_dop853", 8.0, 12.0),
    ],
)
def test_observed_orders(raced, scene, method, low, high):
    assert low < orders(raced[scene])[method].value < high


def test_a_step_that_lies(raced):
    """Euler-Cromer is off by less than one per cent up to about a tenth of the contact time."""
    for name in ("cradle N=3 q=1", "cradle N=3 q=1.5", "spheres eta=0", "ball_on_floor"):
        honest = lies_beyond(raced[name])
        assert honest is not None
        assert 0.05 < honest < 0.3, name


def test_the_step_suggested_to_students_is_a_hundredth_of_the_contact_and_good(raced):
    for name in ("cradle N=3 q=1.5", "cradle N=3 q=3"):
        each = raced[name]
        near = [
            timing
            for timing in each.timings
            if timing.method == "euler_cromer" and timing.setting < each.case.contact_time / 70.0
        ]
        assert near[0].error < 5e-4, name


def test_equal_steps_of_the_phase_and_adaptive_steps_agree():
    both = colliding_spheres.pair(1.0)
    met = meet(both)
    assert met is not None
    stepped, adaptive = through(both, met, DOP853, 40), follow(both, met, 1e-14)
    assert stepped.outward == pytest.approx(adaptive.outward, rel=1e-12)
    assert stepped.duration == pytest.approx(adaptive.duration, rel=1e-12)
    assert through(both, met, RK4, 10).evaluations == 40


def test_a_straight_line_has_its_slope_and_no_doubt():
    found = fitted([(2.0**-i, 3.0 * 8.0**-i) for i in range(6)])
    assert found == Order(pytest.approx(3.0), pytest.approx(3.0), pytest.approx(3.0))


def timing(method, error, evaluations, seconds):
    return Timing(method, "step", 1.0 / evaluations, error, evaluations, seconds)


def test_a_lucky_hit_is_not_an_accuracy():
    lucky = (
        timing("a", 1e-2, 10, 1e-3),
        timing("a", 1e-7, 20, 2e-3),
        timing("a", 1e-4, 40, 4e-3),
        timing("a", 1e-6, 80, 8e-3),
    )
    found = WorkPrecision(cases()[0], (*lucky, timing("b", 1e-7, 9, 9e-3)), "a", {})
    best = cheapest(found, 1e-5)
    assert best is not None
    assert (best.method, best.evaluations) == ("a", 80)
    assert cheapest(found, 1e-9) is None
    assert [each.evaluations for each in frontier(found)] == [10, 20]


def test_a_run_out_of_range_is_no_answer():
    case = cases()[0]
    assert (
        math.isnan(error_of(case, MethodAnswer((math.nan,) * 3, 1)))
        or error_of(case, MethodAnswer((math.nan,) * 3, 1)) > 1.0
    )
    assert error_of(case, MethodAnswer(case.reference.numbers, 1)) == 0.0


def test_without_scipy_the_race_goes_on_and_says_why(monkeypatch):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert methods.solver_routes(cases()[0]) == {}


def test_the_record_is_the_contracts(raced):
    data = json.loads(json.dumps(record(raced["cradle N=3 q=1.5"]), allow_nan=False))
    assert {"scene", "observable", "reference", "runs", "order", "cheapest", "planned"} <= data.keys()
    assert set(data["cheapest"]) == {"1e-3", "1e-6", "1e-9", "1e-12"}
    assert {"value", "digits"} <= data["reference"].keys()
    for each in data["runs"]:
        assert {"method", "error", "evaluations", "seconds"} <= each.keys()
        assert ("step" in each) != ("tolerance" in each)


@pytest.mark.parametrize("eta", [0.0, 1.0, 5.0])
def test_momentum_is_kept(eta):
    ax, ay, bx, by = run("spheres", {"eta": eta}).observed["velocities"]
    assert abs(ax + bx - 1.0) < 1e-13
    assert abs(ay + by) < 1e-13
