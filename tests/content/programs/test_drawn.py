"""Figures as students draw them, with matplotlib, run by the runner, marked: units, shared axes, markers, languages, and guesses."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from corollary.answers.verdict import Mistaken, Right, Unmarked, Unread, Verdict, Wrong
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.run_programs import ran
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.problem.bank import chapter_bank, find
from corollary.problem.variant import chapter
from corollary.sandbox.runner import Runner

BANK = chapter_bank()


@pytest.fixture(scope="module")
def drawn() -> Iterator[Callable[..., Verdict]]:
    """The verdict on the figure that a source draws for the chapter's numbers; `{m}` in it is the given m."""
    solutions, keys = Solutions(BANK), dict[str, Key]()
    with Runner() as runner:

        def verdict(code: str, part: str, source: str) -> Verdict:
            if code not in keys:
                problem = find(BANK, code)
                keys[code] = make_key(solutions.of(problem), chapter(problem))
            for name, value in keys[code].variant.si.items():
                source = source.replace(f"{{{name}}}", repr(value))
            run = ran(runner, keys[code], part, source)
            return judge(keys[code], {}, {part: run})[part][0][-1]

        yield verdict


BALL = """
m, k, R, g, y, v, dt = {m}, {k}, {R}, {g}, {y0}, {v0}, 1e-5
t, F, p, left, touched = [], [], [], 0, False
while left < 50:
    d = max(R - y, 0.0)
    touched = touched or d > 0
    left += touched and d == 0
    t.append(len(t) * dt); F.append(k * d**1.5 - m * g); p.append(m * v)
    v = v + F[-1] / m * dt
    y = y + v * dt
t, F, p = map(np.array, (t, F, p))
"""
TWO = "fig, (a, b) = plt.subplots(2, 1)\na.plot({x}, {F})\nb.plot({x}, {p})\n"


def two(
    t: str, force: str, momentum: str, *labels: str, figure: str = "plt.subplots(2, 1)", how: str = ""
) -> str:
    """Net force and momentum above each other: what is drawn, and the labels of the axes from above."""
    names = [f"a.set_xlabel({labels[0]!r})", f"a.set_ylabel({labels[1]!r})"]
    names += [f"b.set_xlabel({labels[2]!r})", f"b.set_ylabel({labels[3]!r})"]
    return "\n".join(
        [
            BALL,
            f"fig, (a, b) = {figure}",
            f"a.plot({t}, {force}{how})",
            f"b.plot({t}, {momentum}{how})",
            *names,
            "plt.show()",
        ]
    )


LABELS = ("t [s]", "F [N]", "t [s]", "p [kg m/s]")
RIGHT = {
    "as asked": two("t", "F", "p", *LABELS),
    "kN and ms": two("1e3*t", "F/1e3", "1e3*p", "t [ms]", "F [kN]", "t / ms", "p in g m/s"),
    "newton seconds": two("t", "F", "p", "t [s]", "$F_{net}$ (N)", "t [s]", r"$p$ [$\mathrm{N\,s}$]"),
    "German": two("t", "F", "p", "Zeit [s]", "Kraft [N]", "Zeit in s", "Impuls / (kg m/s)"),
    "Chinese": two("t", "F", "p", "时间 [s]", "力 (N)", "时间 [s]", "动量 [kg·m/s]"),
    "sharex": two(
        "t", "F", "p", "", "F [N]", "t [s]", "p [kg m/s]", figure="plt.subplots(2, 1, sharex=True)"
    ),
    "markers": two("t", "F", "p", *LABELS, how=", 'o'"),
    "markers and line": two("t", "F", "p", *LABELS, how=", '.-'"),
    "scatter": two("t", "F", "p", *LABELS).replace("a.plot", "a.scatter").replace("b.plot", "b.scatter"),
    "from the first touch": two("t - t[np.argmax(F > 0)]", "F", "p", *LABELS),
    "help for the eye": two("t", "F", "p", *LABELS).replace(
        "plt.show",
        "a.axhline(0); b.axvline(t[-1]); a.hlines(F.max(), 0, t[-1]); b.plot([0], [p[0]], 'ro')\nplt.show",
    ),
    "an empty line for the legend": two("t", "F", "p", *LABELS).replace(
        "plt.show", "a.plot([], [], label='F')\nplt.show"
    ),
    "twinx": BALL
    + "fig, a = plt.subplots()\na.plot(t, F)\nb = a.twinx()\nb.plot(t, p)\n"
    + "a.set_xlabel('t [s]'); a.set_ylabel('F [N]'); b.set_ylabel('p [kg m/s]')\nplt.show()",
    "two figures": BALL
    + "plt.plot(t, F); plt.xlabel('t [s]'); plt.ylabel('F [N]'); plt.show()\n"
    + "plt.plot(t, p); plt.xlabel('t [s]'); plt.ylabel('p [kg m/s]'); plt.show()",
}
WRONG = {
    "joules": (two("t", "F", "p", "t [s]", "F [J]", "t [s]", "p [kg m/s]"), "labelled"),
    "no unit": (two("t", "F", "p", "t", "F", "t", "p"), "labelled"),
    "no labels": (two("t", "F", "p", "", "", "", ""), "labelled"),
    "newtons called kilonewtons": (two("t", "F", "p", "t [s]", "F [kN]", "t [s]", "p [kg m/s]"), "labelled"),
    "the momentum called a force": (
        two("t", "F", "p", "t [s]", "F [N]", "t [s]", "F [kg m/s]"),
        "another quantity",
    ),
    "a triangle": (
        two(
            "t",
            "np.interp(t, [t[0], t[F > 0][0], t[F.argmax()], t[F > 0][-1], t[-1]], [F[0], 0, F.max(), 0, F[0]])",
            "p",
            *LABELS,
        ),
        "net force",
    ),
    "a straight momentum": (two("t", "F", "np.linspace(p[0], p[-1], len(p))", *LABELS), "momentum"),
    "nothing but NaN": (two("t", "F", "p * np.nan", *LABELS), "momentum"),
    "half of it NaN": (two("t", "np.where(t < t[F.argmax()], F, np.nan)", "p", *LABELS), "net force"),
    "a few points": (two("t[::60]", "F[::60]", "p[::60]", *LABELS, how=", 'o'"), "net force"),
    "twice as stiff": (
        two("t", "F", "p", *LABELS).replace("m, k, R", "m, k, R").replace("= {m}, {k},", "= {m}, 2 * {k},"),
        "net force",
    ),
    "the floor's force": (two("t", "F + m * g", "p", *LABELS), "force of the floor"),
    "a tenth too large": (two("t", "1.1 * F", "p", *LABELS), "net force"),
    "without a sign": (two("t", "F", "abs(p)", *LABELS), "momentum"),
    "cut at its peak": (two("t[: F.argmax()]", "F[: F.argmax()]", "p[: F.argmax()]", *LABELS), "end after"),
    "invisible": (two("t", "F", "p", *LABELS, how=", visible=False"), "No axes"),
    "sixty curves": (
        two("t", "F", "p", *LABELS).replace(
            "plt.show", "for n in range(1, 59): a.plot(t, F * n / 30)\nplt.show"
        ),
        "too many curves",
    ),
    "eight curves": (
        two("t", "F", "p", *LABELS).replace("plt.show", "for n in range(2, 9): a.plot(t, F * n)\nplt.show"),
        "many other curves",
    ),
}


@pytest.mark.parametrize("how", RIGHT)
def test_right_figures_of_force_and_momentum_are_right(drawn, how):
    found = drawn("E12.3.1s", "g", RIGHT[how])
    assert isinstance(found, Right), sentence(found)


@pytest.mark.parametrize("how", WRONG)
def test_figures_that_are_not_what_was_asked_for_earn_nothing(drawn, how):
    source, word = WRONG[how]
    found = drawn("E12.3.1s", "g", source)
    assert isinstance(found, Wrong | Mistaken)
    assert word in sentence(found)


def test_one_curve_more_is_for_a_person(drawn):
    source = two("t", "F", "p", *LABELS).replace("plt.show", "a.plot(t, 2 * F)\nplt.show")
    assert isinstance(drawn("E12.3.1s", "g", source), Unmarked)


VELOCITIES = """
T = np.pi * np.sqrt({m} / 2 / {k})
t = np.linspace(0, 1.3 * T, 300)
a = np.where(t < T, {v0} / 2 * (1 + np.cos(np.pi * t / T)), 0)
b = np.where(t < T, {v0} / 2 * (1 - np.cos(np.pi * t / T)), {v0})
"""
DRAW = "plt.plot(t, a, label='A'); plt.plot(t, b, label='B')\nplt.xlabel('t [s]'); plt.ylabel('v [m/s]'); plt.show()"
STRAIGHT = "t, a, b = np.linspace(0, T, 300), np.linspace({v0}, 0, 300), np.linspace(0, {v0}, 300)\n"


def test_velocities_of_two_balls(drawn):
    for change in (
        "",
        "t, a, b = 1e3 * t, 100 * a, 100 * b\n",
        "t = t + 0.5\n",
        "t, a, b = t[::20], a[::20], b[::20]\n",
    ):
        labels = ("t [ms]", "v [cm/s]") if "1e3" in change else ("t [s]", "v [m/s]")
        source = DRAW.replace("t [s]", labels[0]).replace("v [m/s]", labels[1])
        found = drawn("P12.14", "h", VELOCITIES + change + source)
        assert isinstance(found, Right), sentence(found)
    for change, draw in (
        (STRAIGHT, DRAW),
        ("", DRAW.replace("plt.plot(t, a, label='A'); ", "")),
        ("a, b = a * np.nan, b * np.nan\n", DRAW),
        ("a, b = np.where(t < T / 2, {v0}, 0), np.where(t < T / 2, 0, {v0})\n", DRAW),
        ("t = t * 3\n", DRAW),
        ("t, a, b = t[:150], a[:150], b[:150]\n", DRAW),
    ):
        found = drawn("P12.14", "h", VELOCITIES + change + draw)
        assert isinstance(found, Wrong), change
    assert "begin and end well" in sentence(drawn("P12.14", "h", VELOCITIES + STRAIGHT + DRAW))


BELOW = (
    "fig, (p, q) = plt.subplots(2, 1, sharex=True)\np.plot(1e3 * t, 100 * a, 'o', ms=2); q.plot(1e3 * t, b)\n"
    "p.set_ylabel('v_A [cm/s]'); q.set_ylabel('v_B / (m/s)'); q.set_xlabel('t [ms]')\nplt.show()"
)


def test_each_ball_may_have_axes_of_its_own_below_the_others(drawn):
    found = drawn("P12.14", "h", VELOCITIES + BELOW)
    assert isinstance(found, Right), sentence(found)
    for changed in (
        BELOW.replace("1e3 * t, b", "1e3 * t, a"),
        BELOW.replace("1e3 * t, b", "1e3 * (t + T / 2), b"),
        BELOW.replace("'v_B / (m/s)'", "'v_B [cm/s]'"),
        BELOW.replace("'v_B / (m/s)'", "'v_B'"),
        STRAIGHT + BELOW,
    ):
        assert isinstance(drawn("P12.14", "h", VELOCITIES + changed), Wrong), changed


ROW = """
def contact():
    return {k}, {q}

def motion(m, k, q, v0, dt, steps):
    v, s, out = np.array([v0, 0, 0]), np.zeros(3), []
    for step in range(steps):
        out.append(v)
        f = k * np.clip(s[:-1] - s[1:], 0, None) ** q
        v = v + (np.append(0, f) - np.append(f, 0)) / m * dt
        s = s + v * dt
    return np.array(out)

k, q = {k}, {q}
x = ((q + 1) * {m} * {v0} ** 2 / (4 * k)) ** (1 / (q + 1))
dt = 2.6 * x / {v0} / 100
v = {v}
for n in range(3):
    plt.plot(dt * np.arange(len(v)), v[:, n])
plt.xlabel("t [s]"); plt.ylabel("v [m/s]"); plt.show()
"""


def test_velocities_of_three_balls_are_those_of_the_contact_that_was_returned(drawn):
    def of(k: float, q: float, v: str = "motion({m}, k, q, {v0}, dt, 400)") -> Verdict:
        return drawn("P12.14", "j", ROW.replace("{v}", v).replace("{k}", repr(k)).replace("{q}", repr(q)))

    for k, q in ((1e9, 6.0), (1e6, 4.5), (3e4, 1.0)):
        found = of(k, q)
        assert isinstance(found, Right), sentence(found)
    straight = "np.array([np.linspace({v0}, 0, 400), np.zeros(400), np.linspace(0, {v0}, 400)]).T"
    for k, q, v in (
        (1e9, 6.0, straight),
        (1e9, 6.0, "motion({m}, k, 1.0, {v0}, dt, 400)"),
        (1e9, 6.0, "motion({m}, k, q, {v0}, dt, 400) * np.nan"),
    ):
        assert isinstance(of(k, q, v), Wrong), v
    assert isinstance(of(-1.0, 6.0), Unmarked)


ATOM = """
m, k, b, d, v0 = {m}, {k}, {b}, {d}, {v0}
T = 2 * np.pi * np.sqrt(m / k)
r, v, places = np.array([b, 0.0]), np.array([0.0, v0]), []
dt = T / 200
for n in range(1200):
    places.append(r)
    l = np.hypot(*r)
    F = -k * (l - b) * r / l if l < b + d else np.zeros(2)
    v = v + F / m * dt
    r = r + v * dt
x, y = np.array(places).T
"""
ORBIT = "plt.plot(x, y); plt.xlabel('x [m]'); plt.ylabel('y [m]'); plt.axis('equal'); plt.show()"


@pytest.mark.whole
def test_the_trajectory_of_an_atom(drawn):
    for change, draw in (
        ("", ORBIT),
        ("x, y = 100 * x, 100 * y\n", ORBIT.replace("[m]", "(cm)")),
        (
            "u = np.linspace(0, 7, 300)\nplt.plot(b * np.cos(u), b * np.sin(u), ':'); plt.plot(0, 0, 'o')\n",
            ORBIT,
        ),
        ("", ORBIT.replace("plot(x, y)", "plot(x, y, '.')")),
        ("", ORBIT.replace("x [m]", "Ort [m]").replace("y [m]", "[m]")),
    ):
        found = drawn("P12.15", "g", ATOM + change + draw)
        assert isinstance(found, Right), (change, sentence(found))
    for change, word in (
        ("x, y = x * np.nan, y * np.nan\n", "No trajectory"),
        ("x, y = np.where(np.arange(1200) % 40, np.nan, x), y\n", ""),
        ("x, y = x[:120], y[:120]\n", ""),
        (
            "a = np.arctan2(y, x); r = np.hypot(x, y); r = b + 1.3 * (r - b)\nx, y = r * np.cos(a), r * np.sin(a)\n",
            "greatest distance",
        ),
        (
            "a = 1.4 * np.unwrap(np.arctan2(y, x)); r = np.hypot(x, y)\nx, y = r * np.cos(a), r * np.sin(a)\n",
            "does not lead",
        ),
        ("x, y = y, x\n", "start at"),
    ):
        found = drawn("P12.15", "g", ATOM + change + ORBIT)
        assert isinstance(found, Wrong), change
        assert word in sentence(found)


WELL = """
k, b, d = {k}, {b}, {d}
U0 = k * d**2 / 2
x = np.linspace(b - d, b + 2 * d, 200)
U = np.where(x < b + d, k * (x - b) ** 2 / 2, U0)
"""
LEVELS = "plt.axhline({eps} * U0); plt.hlines({epsx} * U0, b - d, b + 2 * d)\nplt.xlabel('x [m]'); plt.ylabel('U [J]'); plt.show()"


def test_the_potential(drawn):
    for draw in (
        "plt.plot(x, U)\n" + LEVELS,
        "plt.vlines(b - d, 0, 5 * U0)\nplt.plot(x, U)\n" + LEVELS,
        "x = np.linspace(b - 1.3 * d, b + 2 * d, 500)\nplt.plot(x, np.where(x < b - d, 10 * U0, np.minimum(k * (x - b) ** 2 / 2, U0)))\n"
        + LEVELS,
        "x = np.linspace(b - 1.3 * d, b + 2 * d, 500)\nplt.plot(x, np.where(x < b - d, np.inf, np.minimum(k * (x - b) ** 2 / 2, U0)))\n"
        + LEVELS,
        "plt.plot(x, 1e3 * U)\nU0 = 1e3 * U0\n" + LEVELS.replace("U [J]", "Energie in mJ"),
        "plt.plot(100 * x, U)\nb, d = 100 * b, 100 * d\n" + LEVELS.replace("x [m]", "$r$ / cm"),
        "plt.plot(x, U)\n" + LEVELS.replace("[J]", "[N m]"),
    ):
        found = drawn("P12.15", "a", WELL + draw)
        assert isinstance(found, Right), (draw, sentence(found))
    for draw in (
        "plt.plot(x, np.abs(x - b) / d * U0)\n" + LEVELS,
        "plt.plot(x, U * np.nan)\n" + LEVELS,
        "plt.plot(x, k * (x - b) ** 2 / 2)\n" + LEVELS,
        "plt.plot(x, U)\n" + LEVELS.replace("U [J]", "U [N]"),
        "plt.plot(x, U)\n" + LEVELS.replace("plt.axhline({eps} * U0); ", ""),
    ):
        assert isinstance(drawn("P12.15", "a", WELL + draw), Wrong), draw


SPHERES = """
R, k, eta, m = {R}, {k}, {eta}, np.array([[{mA}], [{mB}]])
dt, n = 1e-4, 1000
r, v = np.zeros((n + 1, 2, 2)), np.zeros((n + 1, 2, 2))
r[0], v[0] = [[0, 0], [0.08, 0.018]], [[1.0, 0], [0, 0]]
for i in range(n):
    Dr, Dv = r[i, 1] - r[i, 0], v[i, 1] - v[i, 0]
    l = np.linalg.norm(Dr)
    F = -k * (2 * R - l) ** 1.5 * Dr / l + eta * Dv if l < 2 * R else np.zeros(2)
    v[i + 1] = v[i] + np.array([F, -F]) / m * dt
    r[i + 1] = r[i] + v[i + 1] * dt
t, p = dt * np.arange(n + 1), v * m
labels = [("x [m]", "y [m]"), ("t [s]", "p_x [kg m/s]"), ("t [s]", "p_y [kg m/s]")]
scale = [1, 1, 1, 1]
"""
THREE = """
fig, axes = plt.subplots(3, 1)
for j in range(2):
    axes[0].plot(scale[0] * r[:, j, 0], scale[0] * r[:, j, 1])
    axes[1].plot(scale[1] * t, scale[2] * p[:, j, 0])
    axes[2].plot(scale[1] * t, scale[2] * p[:, j, 1])
for axis, (x, y) in zip(axes, labels):
    axis.set_xlabel(x)
    axis.set_ylabel(y)
plt.show()
"""


def test_the_motion_of_two_spheres(drawn):
    for change in (
        "",
        "scale = [100, 1e3, 1]\nlabels = [('x / cm', 'y / cm'), ('t [ms]', '$p_x$ [N s]'), ('t [ms]', '$p_{y}$ (kg m/s)')]\n",
        "labels[1:] = [('Zeit [s]', 'Impuls [kg m/s]')] * 2\n",
    ):
        found = drawn("S12.6", "c", SPHERES + change + THREE)
        assert isinstance(found, Right), (change, sentence(found))
    for change, draw, word in (
        (
            "",
            THREE.replace("plt.show", "for n in range(56): axes[1].plot(t, n * p[:, 0, 0])\nplt.show"),
            "too many curves",
        ),
        ("p[:, :, 1] = np.linspace(p[0, :, 1], p[-1, :, 1], n + 1)\n", THREE, "p_y"),
        ("r[:, 0] = np.linspace(r[0, 0], r[-1, 0], n + 1)\n", THREE, "trajectories"),
        ("p = v\n", THREE, "p_x"),
        ("labels[1:] = labels[:0:-1]\n", THREE, "another quantity"),
        ("labels[0] = ('x [s]', 'y [m]')\n", THREE, "labelled"),
        ("eta = 0\n", THREE.replace("axes[1].plot(scale[1] * t, scale[2] * p[:, j, 0])", ""), "p_x"),
    ):
        found = drawn("S12.6", "c", SPHERES + change + draw)
        assert isinstance(found, Wrong), change
        assert word in sentence(found), sentence(found)


def test_no_figure_at_all(drawn):
    assert isinstance(drawn("P12.15", "a", "x = 1"), Unread)
