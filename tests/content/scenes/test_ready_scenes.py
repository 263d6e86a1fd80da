"""The ready-made scenes through their one door."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.ready_scene_files import names_in

from corollary.derive.ready_scenes import ready_scenes, run
from corollary.scenes.forces.contact import Contact
from corollary.scenes.run import BadSetting, GuardFailed

SCENES = ready_scenes()


@pytest.mark.parametrize("name", SCENES)
def test_every_scene_runs_with_the_chapters_values_and_says_how(name):
    found = run(name, {})
    assert found.scene == name
    assert found.observed
    assert set(found.errors) == set(found.observed)
    assert 0.0 <= found.error < 1e-2
    assert "\n" not in found.why
    assert found.why
    assert found.settings.keys() == {setting.name for setting in SCENES[name].settings}


@pytest.mark.parametrize(
    ("name", "settings", "says"),
    [
        ("cradel", {}, "no scene 'cradel'"),
        ("cradle", {"M": 3}, "'M' is not among its settings (N, q,"),
        ("cradle", {"N": 2.5}, "whole number"),
        ("cradle", {"N": 201}, "at most 200"),
        ("cradle", {"m": 0}, "more than 0 kg"),
        ("cradle", {"m": "heavy"}, "not a number"),
        ("cradle", {"m": float("nan")}, "not finite"),
        ("cradle", {"gaps": (1e-3,)}, "there are 2 gaps"),
        ("cradle", {"balls_in": 3}, "must be less than N = 3"),
        ("wall", {"theta": 1.5708}, "= 1.5708 rad must be at most 1.570796 rad"),
        ("snowball", {"theta": 0.5 * math.pi}, "1.5707963267948966 rad must be less than 1.5707963267948966"),
        ("atom", {"d": math.nextafter(1.0, 2.0)}, "= 1.0000000000000002 m must be less than b = 1 m"),
        ("ball_on_floor", {"y0": 0.01}, "inside the floor"),
        ("spheres", {"dx": 0, "dy": 0}, "one centre on the other"),
        ("spheres", {"k": 1.0, "dy": 0.0, "eta": 0.0}, "so soft that they pass"),
        ("spheres", {"k": 1.0, "dy": 0.0, "eta": 0.1}, "so soft that they pass"),
        ("atom", {"d": 1.0}, "must be less than b"),
        ("atom", {"r0": 0.5}, "inside the core"),
        ("chain", {"y": 2.0}, "must be at most L = 1.5 m"),
        ("ions", {"s": 0.08}, "must be less than r0"),
        ("rocket", {"m1": 2000.0}, "rocket: m1 = 2000 kg must be at most m0 = 1000 kg (mass at the end)."),
        ("snowball", {"M": 0}, "snowball: M = 0 kg must be more than 0 kg (your mass)."),
        ("atom", {"dimension": 0}, "atom: dimension = 0 must be at least 1 (1 for a line, 2 for a plane)."),
        (
            "kick",
            {"F": 10**400},
            "kick: F = (a whole number of 401 digits) is beyond the numbers of a computer.",
        ),
        ("kick", {"F": "x" * 1000}, "is not a number (time-averaged force)."),
    ],
)
@pytest.mark.parametrize("second_way", [False, True])
def test_what_is_wrong_with_a_setting_is_said_in_a_sentence(name, settings, says, second_way):
    with pytest.raises(BadSetting) as caught:
        run(name, settings, second_way=second_way)
    assert says in str(caught.value)
    assert str(caught.value).endswith(".")
    assert len(str(caught.value)) < 400


@pytest.mark.parametrize(
    ("setting", "takes"),
    [
        (("cradle", "N"), "2 to 200, a whole number"),
        (("cradle", "gaps"), "at least 0; one number, or a row"),
        (("cradle", "balls_in"), "at least 1, less than N, a whole number"),
        (("rocket", "m1"), "more than 0, at most m0"),
        (("snowball", "theta"), "at least 0, less than 1.5708"),
        (("wall", "theta"), "more than 0, at most 1.5708"),
        (("kick", "v0"), ""),
    ],
)
def test_a_setting_says_what_it_takes(setting, takes):
    scene, name = setting
    assert next(each for each in SCENES[scene].settings if each.name == name).takes == takes


@pytest.mark.parametrize("second_way", [False, True])
def test_the_largest_force_of_a_kick_is_a_size(second_way):
    forth, back = (run("kick", {"F": push}, second_way=second_way).observed for push in (86.0, -86.0))
    assert back["peak_force"] == forth["peak_force"] == pytest.approx(43.0 * math.pi)
    assert back["impulse"] == pytest.approx(-forth["impulse"])


def test_masses_too_unequal_to_be_followed_are_said_in_whole_sentences():
    with pytest.raises(GuardFailed, match=r"Make the masses less unequal or the balls fewer\.$"):
        run("cradle", {"masses": (1.0, 1e-9, 1.0)})


def test_a_tolerance_nobody_can_keep_is_refused():
    with pytest.raises(BadSetting, match="tolerance"):
        run("cradle", {}, tolerance=1e-20)


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e9), st.floats(1e-3, 1e3))
@settings(max_examples=30, deadline=None)
def test_a_cradle_depends_on_its_size_in_one_way_only(m, k, v0):
    """Velocities scale with v0, times with (m/(k v0^(q-1)))^(1/(q+1)): one collision serves them all."""
    found, one = (
        run("cradle", {"q": 1.5, "m": m, "k": k, "v0": v0}),
        run("cradle", {"q": 1.5, "m": 1, "k": 1, "v0": 1}),
    )
    assert [v / v0 for v in found.observed["velocities"]] == pytest.approx(
        one.observed["velocities"], rel=1e-14
    )
    scale = (m * v0**2 / k) ** 0.4
    assert found.observed["duration"] / (scale / v0) == pytest.approx(one.observed["duration"], rel=1e-13)
    assert found.observed["peak_force"] / (m * v0**2 / scale) == pytest.approx(
        one.observed["peak_force"], rel=1e-13
    )


def test_a_tighter_cradle_behaves_more_like_the_toy():
    middle = [abs(run("cradle", {"q": q}).observed["velocities"][1]) for q in (1.0, 1.5, 3.0, 5.0)]
    assert middle == sorted(middle, reverse=True)


def test_two_bodies_without_damping_take_integrals_and_others_are_integrated():
    assert run("cradle", {"q": 1.0}).model == "integration"
    assert run("cradle", {"q": 1.5}).model == "integration"
    assert run("cradle", {"N": 2, "q": 1.5}).model == "quadrature"
    assert run("ball_on_floor", {}).model == "quadrature"
    assert run("ball_on_floor", {"eta": 1.0}).model == "integration"
    assert run("spheres", {"eta": 0.0}).model == "quadrature"


def test_balls_that_come_in_two_by_two_and_balls_apart():
    two = run("cradle", {"N": 4, "q": 3.0, "balls_in": 2}).observed["velocities"]
    assert two[2] == pytest.approx(1.0, abs=0.1)
    assert two[3] == pytest.approx(1.0, abs=0.1)
    apart = run("cradle", {"N": 4, "q": 1.5, "gaps": 0.1}).observed["velocities"]
    assert apart == pytest.approx((0.0, 0.0, 0.0, 1.0), abs=1e-12)
    heavy = run("cradle", {"N": 2, "q": 1.5, "masses": (0.3, 0.1)}).observed["velocities"]
    assert heavy == pytest.approx((0.5, 1.5), abs=1e-14)


def test_a_little_damping_is_continuous_with_none():
    for name in ("ball_on_floor", "spheres"):
        none, little = run(name, {"eta": 0.0}), run(name, {"eta": 1e-9})
        assert little.observed["velocities"] == pytest.approx(none.observed["velocities"], abs=1e-7)
        assert little.observed["duration"] == pytest.approx(none.observed["duration"], rel=1e-6)


def test_spheres_keep_momentum_and_their_energy_is_what_drag_leaves():
    for eta in (0.0, 1.0, 9.0, 20.0):
        found = run("spheres", {"eta": eta, "mA": 0.3, "mB": 0.07, "vB": (0.2, -0.1)})
        ax, ay, bx, by = found.observed["velocities"]
        assert 0.3 * ax + 0.07 * bx == pytest.approx(0.3 + 0.014, abs=1e-13)
        assert 0.3 * ay + 0.07 * by == pytest.approx(-0.007, abs=1e-13)
        assert found.observed["energy_ratio"] <= 1.0 + 1e-12
        assert found.outcome == ("sticks" if eta == 20.0 else "released")


def test_an_undamped_ball_takes_the_impulse_of_its_weight_too():
    found = run("ball_on_floor", {}).observed
    v = math.sqrt(2.8**2 + 2 * 9.8 * 0.001)
    assert found["rebound_speed"] == pytest.approx(v, rel=1e-15)
    assert found["impulse"] == pytest.approx(0.1 * (2 * v + 9.8 * found["duration"]), rel=1e-14)


def test_a_ball_that_sinks_into_honey_stays():
    for eta in (300.0, 3000.0, 1e6):
        found = run("ball_on_floor", {"eta": eta})
        assert found.outcome == "sticks"
        assert found.observed["rebound_speed"] == 0.0
        assert found.evaluations < 10_000


@pytest.mark.parametrize("q", [1.0, 1.25, 1.5, 3.0])
@pytest.mark.parametrize("g", [0.0, 9.8, 1e3])
@pytest.mark.parametrize("share", [0.999, 1.0, 1.001, 1.1, 10.0, 1e3, 1e6, 1e9])
def test_a_ball_at_and_beyond_critical_damping_ends_with_a_name(q, g, share):
    """`share` in units of the critical damping of the stiffest place met, which is at least the true one."""
    m, k, v = 0.1, 1e6 * 1e-3 ** (1.5 - q), 2.8
    deep = names_in("ball_on_floor")["depth_of"](Contact(k, q), m, v, g)
    found = run(
        "ball_on_floor",
        {
            "q": q,
            "g": g,
            "k": k,
            "v0": -v,
            "y0": 0.02,
            "eta": 2.0 * share * math.sqrt(q * k * m * deep ** (q - 1.0)),
        },
    )
    # A spring at its critical damping: whether it is that or just below, the rounding of eta decides.
    assert found.outcome == "sticks" or share < 1.0 or (share == 1.0 == q and g == 0.0)
    assert not any(
        math.isnan(x)
        for value in found.observed.values()
        for x in (value if isinstance(value, tuple) else (value,))
    )
    if found.outcome == "sticks":
        assert found.observed["rebound_speed"] == 0.0
        assert "duration" not in found.observed
        assert found.observed["largest_overlap"] >= (m * g / k) ** (1.0 / q) * (1.0 - 1e-9)


@pytest.mark.parametrize("g", [0.0, 9.8])
def test_honey_is_continuous_with_what_is_followed_in_steps(g):
    m, k, v = 0.1, 1e6, 2.8
    edge = names_in("ball_on_floor")["OVERDAMPED"] * math.sqrt(
        k * m * names_in("ball_on_floor")["depth_of"](Contact(k), m, v, g) ** 0.5
    )
    stepped, closed = (
        run("ball_on_floor", {"g": g, "v0": -v, "y0": 0.02, "eta": part * edge})
        for part in (1.0 - 1e-12, 1.0 + 1e-9)
    )
    assert (stepped.model, closed.model) == ("integration", "conservation")
    for name in ("largest_overlap", "peak_force"):
        assert closed.observed[name] == pytest.approx(
            stepped.observed[name], rel=3.0 * closed.relative_error(name) + 3e-9
        )


def test_any_restitution_is_reached_by_a_spring_and_a_dashpot():
    for r in (1e-300, 1e-12, 1e-9, 1e-3, 0.5, 0.999, 1.0):
        found = run("two_blocks", {"r": r})
        a, b = found.observed["velocities"]
        assert (b - a) / 6.0 == pytest.approx(r, abs=1e-15)
        assert found.outcome == "released"


def test_confirmations_of_the_exercises():
    kick = run("kick", {"m": 0.43, "F": 86.0, "dt": 0.1, "v0": 0.0})
    assert kick.observed["velocities"] == pytest.approx((20.0,), rel=1e-13)
    assert kick.observed["peak_force"] == pytest.approx(86.0 * math.pi / 2.0, rel=1e-14)
    flat = run("kick", {"F": 86.0, "pulse": 0})
    assert flat.observed["peak_force"] == pytest.approx(86.0, rel=1e-15)
    assert flat.observed["way"] == pytest.approx(0.5 * 20.0 * 0.1, rel=1e-13)
    wall = run("wall", {"m": 0.2, "v0": 8.0, "theta": math.pi / 6, "dt": 0.01})
    assert wall.observed["momentum_change"] == pytest.approx((0.0, 2 * 0.2 * 8.0 * 0.5), rel=1e-14)
    assert wall.observed["mean_force"][1] == pytest.approx(160.0, rel=1e-14)
    snow = run("snowball", {})
    level = 20.0 * math.cos(math.pi / 6)
    assert snow.observed["velocities"] == pytest.approx((-2 * level / 80, 2 * level / 22), rel=1e-14)
    thrown = run("snowball", {"Ms": 0.01, "theta": 1.0}).observed  # caught gently: the throw is the largest
    assert thrown["peak_force"] == pytest.approx(math.hypot(*thrown["momentum"]) / 0.1, rel=1e-14)
    bullet = run("bullet_block", {"v": 20.0})
    common = 2.0 / 2.1
    assert bullet.observed["distance"] == pytest.approx(common**2 / (2 * 0.5 * 9.8), rel=1e-13)
    assert bullet.observed["energy_change"] == pytest.approx(0.5 * 2.1 * common**2 - 20.0, rel=1e-13)


@pytest.mark.parametrize("links", [1, 10, 1000])
def test_a_chain_needs_the_force_of_the_textbook_and_loses_half_the_work_on_speed(links):
    found = run("chain", {"N": links, "y": 0.6}).observed
    assert found["mean_force"] == pytest.approx(2 / 1.5 * (4 + 9.8 * 0.6), rel=1e-13)
    assert found["energy_lost"] == pytest.approx(0.5 * 2.0 * 4.0, rel=1e-12)
    assert found["work"] == pytest.approx(2.0 * (4.0 + 9.8 * 0.75), rel=1e-12)


@given(st.integers(1, 3000), st.floats(1.01, 20.0))
@settings(max_examples=30, deadline=None)
def test_a_rockets_puffs_bracket_the_steady_burn(puffs, ratio):
    found = run("rocket", {"m0": 100.0 * ratio, "m1": 100.0, "v_rel": 1.0, "N": puffs})
    least, most = found.observed["bracket"]
    assert least < math.log(ratio) < most
    assert abs(found.observed["velocities"][0] - math.log(ratio)) <= found.errors["velocities"][0]
    assert most - least <= (ratio - 1.0) ** 2 / ratio / puffs * (1.0 + 1e-9)
