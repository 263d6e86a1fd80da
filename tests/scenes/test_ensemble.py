"""Many variants in one call: each is what it is when it is played alone, within its own errors; and it says what it refuses."""

import math

import numpy as np
import pytest

import corollary
from corollary.scenes.catalogue import run
from corollary.scenes.integrate import both_ways
from corollary.scenes.run import BadSetting


@pytest.fixture(params=["0", "1"])
def way(request, monkeypatch):
    """Plain Python, and compiled where numba is installed."""
    if request.param == "1":
        pytest.importorskip("numba")
    monkeypatch.setenv(both_ways.ASKED_BY, request.param)


def alone(monkeypatch, name, settings):
    monkeypatch.setenv(both_ways.ASKED_BY, "0")
    return run(name, settings, 1e-13)


def holds(found, i, single):
    for name, values in found.observed.items():
        if name in single.observed:
            apart = np.abs(np.array(single.observed[name]) - values[i])
            known = np.array(single.errors[name])
            assert (apart <= found.errors[name][i] + known).all(), (name, i, apart, found.errors[name][i])


@pytest.mark.parametrize("eta", [0.0, 1.0, 5.0, 20.0])
def test_spheres_are_those_that_are_played_alone(way, monkeypatch, eta):
    chance = np.random.default_rng(4)
    drawn = {
        "dy": chance.uniform(-0.0399, 0.0399, 12),
        "mA": chance.uniform(0.02, 0.3, 12),
        "vB": chance.uniform(-0.3, 0.3, (12, 2)),
        "k": 10.0 ** chance.uniform(3.7, 6.0, 12),
    }
    found = corollary.ensemble("spheres", eta=eta, tolerance=1e-9, **drawn)
    for i in range(12):
        one = alone(monkeypatch, "spheres", {"eta": eta, **{key: a[i].tolist() for key, a in drawn.items()}})
        assert found.outcomes[i] == one.outcome
        holds(found, i, one)
    gone = found.outcomes == "released"
    assert found.errors["velocities"][gone].max(initial=0.0) < 1e-6


@pytest.mark.parametrize("q", [1.37, 1.5, 3.0])
def test_cradles_are_those_that_are_played_alone(way, monkeypatch, q):
    chance = np.random.default_rng(5)
    drawn = {"masses": chance.uniform(0.05, 0.2, (6, 3)), "gaps": chance.uniform(0.0, 1e-3, (6, 2)), "v0": chance.uniform(0.1, 3.0, 6)}  # fmt: skip
    found = corollary.ensemble("cradle", q=q, tolerance=1e-9, **drawn)
    for i in range(6):
        one = alone(monkeypatch, "cradle", {"q": q, **{key: a[i].tolist() for key, a in drawn.items()}})
        assert found.outcomes[i] == one.outcome == "released"
        holds(found, i, one)
    momentum = (drawn["masses"] * found.observed["velocities"]).sum(axis=1)
    assert momentum == pytest.approx(drawn["masses"][:, 0] * drawn["v0"], rel=1e-12)


def test_what_meets_nothing_or_begins_inside_says_so(monkeypatch):
    monkeypatch.setenv(both_ways.ASKED_BY, "0")
    found = corollary.ensemble("spheres", dx=[0.08, 0.08, 0.01], dy=[0.0, 0.05, 0.0])
    assert found.outcomes.tolist() == ["released", "missed", "refused"]
    assert found.observed["velocities"][1].tolist() == [1.0, 0.0, 0.0, 0.0]
    assert np.isnan(found.observed["velocities"][2]).all()
    stuck = corollary.ensemble("spheres", eta=[1.0, 50.0])
    assert stuck.outcomes.tolist() == ["released", "sticks"]
    assert math.isinf(stuck.observed["duration"][1])
    assert stuck.observed["velocities"][1].tolist() == pytest.approx([0.5, 0.0, 0.5, 0.0])


@pytest.mark.parametrize(
    ("name", "settings", "says"),
    [
        ("atom", {}, "An ensemble is of"),
        ("spheres", {"eta": [1.0, -1.0]}, "must be at least 0"),
        ("spheres", {"eta": [1.0, 2.0], "dy": [0.0] * 3}, "different numbers of variants"),
        ("spheres", {"etta": [1.0]}, "not among its settings"),
        ("cradle", {"masses": np.ones((4, 5))}, "3 balls have 3 masses"),
        ("cradle", {"balls_in": 3.0}, "must be less than N = 3"),
        ("spheres", {"dy": [10**400]}, "401 digits"),
        ("spheres", {"dy": "far"}, "no array of numbers"),
        ("cradle", {"tolerance": 1e-20}, "ask for a tolerance"),
        ("spheres", {"mA": np.array([])}, "mA is empty"),
        ("spheres", {"mA": np.array(["a"])}, "no array of numbers"),
        ("spheres", {"mA": 10**400}, "no array of numbers"),
        ("spheres", {"vA": (1.0, 2.0, 3.0)}, "vA has 3 numbers, but there are 2 components"),
        ("spheres", {"vA": np.ones((2, 3))}, "vA has 3 numbers, but there are 2 components"),
        (
            "spheres",
            {"mA": np.ones((2, 2))},
            "mA is a table of 2 x 2; give one value, or one for each variant",
        ),
    ],
)
def test_refusals_are_sentences(name, settings, says):
    with pytest.raises(BadSetting, match=says):
        corollary.ensemble(name, **settings)


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("spheres", {"vA": [[1e200, 0.0], [1.0, 0.0], [1e-200, 0.0]]}),
        ("cradle", {"v0": [1e200, 1.0, 5e-324], "q": 1.5}),
    ],
)
def test_what_leaves_the_range_of_a_computer_is_refused_in_its_place(name, settings):
    found = corollary.ensemble(name, **settings)
    assert found.outcomes.tolist() == ["refused", "released", "refused"]
    for values in (*found.observed.values(), *found.errors.values()):
        assert np.isnan(values[[0, 2]]).all()
        assert np.isfinite(values[1]).all()


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize(
    ("name", "fixed"),
    [("cradle", {"N": 3, "q": 1.5}), ("cradle", {"N": 5, "q": 3.0}), ("spheres", {"eta": 0.0, "q": 1.5}), ("spheres", {"eta": 1.0, "q": 1.5})],
)  # fmt: skip
def test_errors_of_a_thousand_variants_hold(name, fixed, tolerance):
    """Errors stated as differences alone had been up to 450 times too small in one of a hundred: two runs may agree by chance."""
    pytest.importorskip("numba")
    n, chance = 1000, np.random.default_rng(11)
    if name == "cradle":
        drawn = {
            "masses": 10.0 ** chance.uniform(-1.0, 1.0, (n, fixed["N"])),
            "v0": 10.0 ** chance.uniform(-1.0, 1.0, n),
            "gaps": 10.0 ** chance.uniform(-6.0, -3.0, (n, fixed["N"] - 1)),
        }
    else:
        drawn = {
            "dy": chance.uniform(0.0, 0.0399, n),
            "k": 10.0 ** chance.uniform(4.0, 7.0, n),
            "mA": 10.0 ** chance.uniform(-2.0, 0.0, n),
        }
    rough, fine = (corollary.ensemble(name, **fixed, **drawn, tolerance=t) for t in (tolerance, 1e-13))
    kept = (rough.outcomes == fine.outcomes) & (fine.outcomes == "released") & ~rough.undecided
    assert kept.mean() > 0.98
    for what, values in rough.observed.items():
        off = np.abs(values - fine.observed[what])[kept] - fine.errors[what][kept]
        assert (off <= rough.errors[what][kept]).mean() > 0.999, what
        assert (off <= 3.0 * rough.errors[what][kept]).all(), what


def test_numbers_may_be_of_any_kind():
    one, other = (corollary.ensemble("spheres", R=r, dx=1.0, dy=0.1) for r in (np.float32(0.25), 0.25))
    assert one.observed["velocities"].tolist() == other.observed["velocities"].tolist()


def test_spheres_that_miss_keep_their_velocities_to_the_last_place():
    across = np.stack([np.linspace(0.01, 0.1, 500), np.linspace(-0.01, -0.001, 500)], axis=1)
    found = corollary.ensemble("spheres", vA=across, vB=(0.0, 0.0), dx=0.1, dy=0.4)
    assert set(found.outcomes) == {"missed"}
    assert (found.observed["velocities"][:, :2] == across).all()
    assert not found.observed["velocities"][:, 2:].any()
    assert not found.errors["velocities"].any()


@pytest.mark.parametrize("q", [1.0, 3.0, 7.0, 10.0])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-9])
def test_soft_spheres_that_pass_obliquely_are_within_their_errors(q, tolerance):
    """A few long steps were off by up to thousands of times what two runs of them told."""
    pytest.importorskip("numba")
    chance, n = np.random.default_rng(11), 250
    across, deep = chance.uniform(0.3, 1.0, n), 10.0 ** chance.uniform(-3.0, -0.2, n)
    mass = 0.1 * 10.0 ** chance.uniform(-2.0, 2.0, n)
    reduced = 0.1 * mass / (0.1 + mass)
    k = (q + 1.0) * reduced * (1.0 - across**2) / 2.0 / (0.04 * deep) ** (q + 1.0)
    drawn = {"dy": 0.04 * across, "mB": mass, "k": k}
    found = corollary.ensemble("spheres", q=q, eta=0.0, tolerance=tolerance, dx=0.06, **drawn)
    for i in np.flatnonzero(found.outcomes == "released"):
        given = {key: float(values[i]) for key, values in drawn.items()}
        holds(found, i, run("spheres", {"q": q, "eta": 0.0, "dx": 0.06, **given}))
