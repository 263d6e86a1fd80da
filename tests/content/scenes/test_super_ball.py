"""A small ball on a large one: what their weight does while they touch."""

import math

import pytest
from tests.ready_scene_files import names_in

from corollary.derive.ready_scenes import run
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import Weight
from corollary.scenes.line_collision import collide
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, GuardFailed, components
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

HARD = {"q": 1.0, "k": 1e9}


@pytest.mark.parametrize("mb", [0.06, 0.19, 0.5])
def test_weight_during_the_contacts_changes_little_and_less_than_g_times_their_time(mb):
    free, weighed = (run("super_ball", HARD | {"mB": mb, "weighed": w}) for w in (0, 1))
    fastest = max(weighed.observed["velocities"])
    bound = 2.0 * fastest * free.observed["duration"]
    lower, upper = (b - a for a, b in zip(free.observed["heights"], weighed.observed["heights"], strict=True))
    assert upper < 0.0
    assert 0.01 * bound < abs(upper) < bound
    assert abs(lower) < bound


def test_energy_is_what_the_fall_gave():
    """Both start h0 above their places at the touch, at rest."""
    for mb, h0 in ((0.06, 1.0), (0.5, 2.0)):
        found = run("super_ball", HARD | {"mB": mb, "h0": h0, "weighed": 1})
        lower, upper = found.observed["heights"]
        assert 0.6 * lower + mb * upper == pytest.approx((0.6 + mb) * h0, rel=1e-11)


def test_the_touch_is_as_long_with_weight_as_without_but_for_what_weight_does_to_the_speed():
    free, weighed = (run("super_ball", HARD | {"weighed": w}).observed["duration"] for w in (0, 1))
    assert weighed == pytest.approx(free, rel=9.8 * free / math.sqrt(2 * 9.8))
    assert weighed < free


def test_balls_so_soft_that_they_sink_in_as_deep_as_they_fell_are_refused():
    with pytest.raises(BadSetting, match="raise k"):
        run("super_ball", {"q": 1.0, "k": 10.0, "weighed": 1})


@pytest.mark.parametrize("law", [{"q": 1.0, "k": 1e9}, {"q": 1.5, "k": 1e12}, {"q": 1.5, "k": 1e9}])
@pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-6])
def test_with_weight_and_without_agree_within_what_leaving_it_out_may_do(law, gap):
    """Balls without a gap touch as they fall: what counts begins at the floor."""
    free, weighed = (run("super_ball", law | {"gap": gap, "weighed": w}) for w in (0, 1))
    for name in ("velocities", "duration", "heights"):
        values = (free.observed[name], weighed.observed[name], free.errors[name], weighed.errors[name])
        for a, b, c, d in zip(*(x if isinstance(x, tuple) else (x,) for x in values), strict=True):
            assert abs(a - b) <= c + d, name


def test_no_gap_is_the_limit_of_a_small_one():
    law = {"q": 1.0, "k": 1e9, "weighed": 1}
    none, small = (run("super_ball", law | {"gap": gap}) for gap in (0.0, 1e-12))
    assert none.observed["velocities"] == pytest.approx(small.observed["velocities"], rel=1e-6)
    assert none.observed["duration"] == pytest.approx(small.observed["duration"], rel=1e-6)


@pytest.mark.parametrize(
    "settings",
    [
        # The lower ball is turned back so slowly that weight decides when it touches again.
        {"mA": 7.107, "mB": 2.452, "h0": 1.0635, "k": 1.39e11, "q": 2.0, "gap": 2.11e-3},
        {"mA": 0.1113, "mB": 0.303, "h0": 0.98, "k": 1.486e9, "q": 1.0, "gap": 1e-3},
        # One touch less with it.
        {
            "mA": 0.5576112956192919,
            "mB": 1.0582156770697513,
            "h0": 0.293179044438173,
            "k": 40613019.09177301,
            "q": 1.0,
            "gap": 1e-3,
        },
    ],
)
def test_a_slow_ball_between_two_touches_makes_weight_count_for_more(settings):
    free, weighed = (run("super_ball", settings | {"weighed": w}) for w in (0, 1))
    for name, each in weighed.measured.items():
        rows = (each.value, free.observed[name], each.error, free.errors[name])
        for a, b, e, f in zip(*map(components, rows), strict=True):
            assert abs(a - b) <= e + f, name


MET_AGAIN = {
    "mA": 0.03971979654166992,
    "mB": 0.1191126973454789,
    "h0": 1.6157752941287855,
    "q": 1.5,
    "k": 13611078436.25629,
    "gap": 0.0021322453004471486,
}
FALLEN_BACK = [
    {
        "mA": 3.377736142018277,
        "mB": 6.331744952901499,
        "h0": 0.2541150772861272,
        "q": 1.0,
        "k": 2648728883.4491453,
        "gap": 0.0067312677789303265,
    },
    {
        "mA": 0.5576112956192919,
        "mB": 1.0582156770697513,
        "h0": 0.293179044438173,
        "q": 1.0,
        "k": 40613019.09177301,
        "gap": 0.001,
    },
]


@pytest.mark.parametrize("edge", [MET_AGAIN, FALLEN_BACK[0]])
def test_where_weight_makes_another_story_of_it_it_is_not_left_out(edge):
    """In flight the balls meet once more, or the lower one is back on the floor before."""
    with pytest.raises(GuardFailed, match=r"without weight bodies touch . times, with it . times"):
        run("super_ball", edge)


@pytest.mark.parametrize(
    "edge",
    [
        MET_AGAIN,
        *FALLEN_BACK,
        {"mA": 0.6, "mB": 0.06, "h0": 1.0, "q": 1.5, "k": 1e12, "gap": 0.001},
        {"mA": 0.6, "mB": 6.0, "h0": 1.0, "q": 1.5, "k": 1e9, "gap": 20.0},
    ],
)
def test_with_weight_they_do_as_when_they_are_followed_as_a_scene(edge):
    """Another program: places instead of gaps, and scipy's steps; it goes on a little longer, in free fall."""
    found, g = run("super_ball", edge | {"weighed": 1}), 9.8
    speed, radius = math.sqrt(2.0 * g * edge["h0"]), edge["gap"] + 0.01
    places = 0.0, radius, 3.0 * radius + edge["gap"]
    bodies = tuple(
        Body(m, (y,), (-speed if y else 0.0,), radius if y else 0.0)
        for m, y in zip((math.inf, edge["mA"], edge["mB"]), places, strict=True)
    )
    lasts = found.observed["duration"]
    until = lasts * (1.0 + 1e-7) + 1e-9
    scene = Scene(bodies, (Contact(edge["k"], edge["q"]), Weight(g)), until=until)
    known = play(scene, {O.VELOCITIES, O.TRAJECTORY}, 1e-11, times=(until,))
    then, error = known.observed["velocities"], known.errors["velocities"]
    for i in (0, 1):
        off = abs(then[1 + i] + g * (until - lasts) - found.observed["velocities"][i])
        assert off <= error[1 + i] + found.errors["velocities"][i]
        rises = known.observed["trajectory"][1 + i] - places[1 + i] + then[1 + i] ** 2 / (2.0 * g)
        off = known.errors["trajectory"][1 + i] + abs(then[1 + i]) / g * error[1 + i]
        assert abs(rises - found.observed["heights"][i]) <= off + found.errors["heights"][i]


def test_a_light_ball_thrown_to_and_fro_under_a_heavy_one_is_answered():
    """Hundreds of hits, which had been taken for hopeless."""
    found = run("super_ball", {"mA": 1e-3, "mB": 100.0, "q": 1.0, "k": 1e6})
    assert found.outcome == "released"
    assert found.observed["velocities"][1] == pytest.approx(math.sqrt(2.0 * 9.8), rel=1e-2)


def test_an_upper_ball_that_is_far_too_late_is_refused():
    for weighed in (0, 1):
        with pytest.raises(GuardFailed, match="bounces some 15811 times"):
            run("super_ball", {"gap": 1e9, "weighed": weighed})


@pytest.mark.parametrize(("gap", "mb"), [(535.0, 0.06), (100.0, 0.06), (4631.0, 5e-4), (9.1, 1e-9)])
def test_an_upper_ball_that_comes_long_after_the_lower_one_is_back_is_refused_before_a_step(
    gap, mb, monkeypatch
):
    lines = []
    watched = lambda line, *rest, **more: lines.append(line) or collide(line, *rest, **more)  # noqa: E731
    monkeypatch.setitem(names_in("super_ball"), "collide", watched)
    for weighed in (0, 1):
        with pytest.raises(GuardFailed, match="smaller"):
            run("super_ball", {"gap": gap, "mB": mb, "weighed": weighed})
    assert not any(line.weight for line in lines)


def test_where_places_do_not_show_the_contacts_weight_is_left_out_however_large_the_gap():
    """It is most of the error then."""
    assert run("super_ball", {"gap": 1e4, "k": 1e22}).error > 1.0
