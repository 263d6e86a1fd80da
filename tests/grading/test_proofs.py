"""Derivations of the chapter's three claims: what is accepted, what waits for a person, and which line an error stands on."""

from __future__ import annotations

import pytest

from corollary.answers.verdict import Mistaken, Right, Unmarked, Unread, Verdict, Wrong

PARTS = {"X12.13": "p", "S12.5nc": "f", "S12.5two": "e"}
TARGET = "F = (m/L)*(v0^2 + g*y)"
NEWTON, MASS, RATE = "F - mu*g = v0*R", "mu = m/L*y", "R = m/L*v0"
ALONG_X, ALONG_Y, ENERGY = (
    "mA*v0 = mA*A_x + mA*B_x",
    "0 = mA*A_y + mA*B_y",
    "mA*v0^2/2 = mA*(A_x^2 + A_y^2)/2 + mA*(B_x^2 + B_y^2)/2",
)
ORTHOGONAL = "A_x*B_x + A_y*B_y = 0"
MOMENTUM, RESTITUTION = "mA*vA + mB*vB = mA*v_A1 + mB*v_B1", "v_B1 - v_A1 = r*(vA - vB)"
CHANGE = "dK = mA*v_A1^2/2 + mB*v_B1^2/2 - mA*vA^2/2 - mB*vB^2/2"
LOSS = "dK = -mA*mB/(2*(mA + mB))*(1 - r^2)*(vA - vB)^2"


@pytest.fixture
def verdict(verdicts):
    def of(code: str, *lines: str) -> Verdict:
        part = PARTS[code]
        return verdicts(code, **{part: list(lines)})[part]

    return of


@pytest.mark.parametrize(
    ("code", "lines", "where"),
    [
        ("X12.13", (MASS, RATE, "F/2 = (m/(2*L))*(v0^2+g*y)", TARGET), 3),
        ("S12.5nc", (ALONG_X, ALONG_Y, "v0 = A_x+A_y+B_x+B_y", ORTHOGONAL), 4),
        (
            "S12.5two",
            (MOMENTUM, RESTITUTION, "2*dK = -mA*mB/(mA + mB)*(1 - r^2)*(vA - vB)^2", LOSS),
            3,
        ),
    ],
)
def test_a_law_that_is_not_used_is_missed(verdict, code, lines, where):
    found = verdict(code, *lines)
    assert isinstance(found, Unmarked)
    assert f"could not derive line {where} from" in found.why


@pytest.mark.parametrize(
    ("code", "lines"),
    [
        ("X12.13", (NEWTON, MASS, RATE, TARGET)),
        ("X12.13", ("mu g + v0 R == F [Newton]", "R = m v0/L (rate)", "mu = m y/L", "F = m/L(v0^2 + g y)")),
        ("X12.13", ("lam = m/L", "M = lam*y", "W = M*g", "N = lam*v0", "F - W = v0*N", TARGET)),
        ("X12.13", ("P = F - mu*g - v0*R", "P = 0 by Newton's second law", MASS, RATE, TARGET)),
        ("S12.5nc", (ALONG_X, ALONG_Y, ENERGY, ORTHOGONAL)),
        (
            "S12.5nc",
            (
                "v0 = A_x + B_x",
                "B_y = -A_y",
                "v0^2 = A_x^2 + A_y^2 + (v0 - A_x)^2 + A_y^2, kinetic energy",
                "A_x*(v0 - A_x) = A_y^2",
                "A_x*B_x = -A_y*B_y",
            ),
        ),
        (
            "S12.5nc",
            ("m_A v_0 = m_A A_x + m_B B_x", "m_A = m_B", "m_A A_y + m_B B_y = 0", ENERGY, ORTHOGONAL),
        ),
        (
            "S12.5two",
            (
                "M = mA + mB",
                "V = (mA*vA + mB*vB)/M",
                "p0 = mA*vA + mB*vB = mA*v_A1 + mB*v_B1",
                "r = (v_B1 - v_A1)/(vA - vB)",
                "v_A1 = V - mB/M*r*(vA - vB) and v_B1 = V + mA/M*r*(vA - vB)",
                "K0 = mA*vA^2/2 + mB*vB^2/2",
                "K1 = mA*v_A1^2/2 + mB*v_B1^2/2",
                "K1 = M*V^2/2 + mA*mB/(2*M)*r^2*(vA - vB)^2",
                "K0 = M*V^2/2 + mA*mB/(2*M)*(vA - vB)^2",
                "dK = K1 - K0 = -mA*mB/(2*M)*(1 - r^2)*(vA - vB)^2",
            ),
        ),
        (
            "S12.5two",
            (
                MOMENTUM,
                RESTITUTION,
                "dK = mA/2*((mA*vA + mB*vB - mB*r*(vA - vB))/(mA + mB))^2 + mB/2*((mA*vA + mB*vB + mA*r*(vA - vB))/(mA + mB))^2"
                " - mA*vA^2/2 - mB*vB^2/2",
                LOSS,
            ),
        ),
    ],
)
def test_ways_to_the_claim(verdict, code, lines):
    assert isinstance(verdict(code, *lines), Right)


@pytest.mark.parametrize(
    ("code", "lines", "line"),
    [
        ("X12.13", (NEWTON, MASS, RATE, "F = mu*g - v0*R", TARGET), 4),
        ("X12.13", (NEWTON, "", MASS, "R = m/L*v0^2", TARGET), 4),
        ("X12.13", (NEWTON, "F = mu*g = 3"), 2),
        ("S12.5nc", (ALONG_X, "A_y = B_y", ENERGY, ORTHOGONAL), 2),
        ("S12.5nc", (ALONG_X, ALONG_Y, ENERGY, "A_x*B_x = A_y*B_y", ORTHOGONAL), 4),
        ("S12.5two", (MOMENTUM, "v_A1 - v_B1 = r*(vA - vB)", CHANGE, LOSS), 2),
        ("S12.5two", ("K0 = mA*vA^2 + mB*vB^2", MOMENTUM, "dK = mA*v_A1^2/2 + mB*v_B1^2/2 - K0"), 3),
    ],
)
def test_an_error_is_found_at_its_line(verdict, code, lines, line):
    found = verdict(code, *lines)
    assert isinstance(found, Wrong | Mistaken)
    assert f"Line {line}" in (found.why if isinstance(found, Wrong) else found.mistake)


def test_a_letter_of_ones_own_is_named_with_its_line(verdict):
    found = verdict("S12.5two", "K0 = mA*vA^2 + mB*vB^2", MOMENTUM, "dK = mA*v_A1^2/2 + mB*v_B1^2/2 - K0")
    assert isinstance(found, Wrong)
    assert "K0 as line 1 defines it" in found.why


@pytest.mark.parametrize(
    ("code", "lines"),
    [
        ("X12.13", (TARGET, NEWTON, MASS, RATE, TARGET)),  # the claim taken for granted
        (
            "X12.13",
            ("Q = (m/L)*(v0^2 + g*y)", NEWTON, "F = Q", TARGET),
        ),  # a letter that is the claim's right side
        ("X12.13", ("Q = F - mu*g - v0*R", MASS, RATE, "F*Q = (m/L)*(v0^2 + g*y)*Q", TARGET)),  # times zero
        ("X12.13", (MASS, RATE, "0 = 0", "F - F = 0", TARGET)),
        ("X12.13", (MASS, RATE, "F = m/L*g*y + m/L*v0^2", TARGET)),  # the claim multiplied out
        ("X12.13", (MASS, RATE, "F = (m*y/L + 0)*g + (0 + m*v0/L)*v0", TARGET)),
        ("X12.13", (MASS, RATE, "F - (m*y/L + mu - mu)*g = v0*(m*v0/L + R - R)", TARGET)),
        ("X12.13", (MASS, RATE, "F - (m*y/L)^1*g = v0*sqrt((m*v0/L)^2)", TARGET)),
        ("X12.13", (MASS, RATE, "2*F - F = m/L*g*y + m/L*v0^2", TARGET)),
        ("X12.13", (MASS, RATE, "F^2 = (m/L)^2*(v0^2 + g*y)^2", TARGET)),
        ("X12.13", (MASS, RATE, "F = X", "X = (m/L)*(v0^2 + g*y)", TARGET)),
        ("S12.5nc", (ALONG_X, ALONG_Y, "B_x*(A_x*B_x + A_y*B_y) = 0", ORTHOGONAL)),
        ("S12.5nc", (ALONG_X, "A_y^2 = -A_y*B_y", ENERGY, ORTHOGONAL)),  # a law times an unknown
        ("S12.5nc", (ALONG_X, ALONG_Y, "2*A_x*(v0 - A_x) - 2*A_y^2 = 0", ORTHOGONAL)),
        ("S12.5nc", (ENERGY, "v0^2 = (A_x + B_x)^2 + (A_y + B_y)^2", ORTHOGONAL)),
        ("S12.5two", (MOMENTUM, CHANGE, "v_A1 = (mA*vA + mB*vB - mB*r*(vA - vB))/(mA + mB)", LOSS)),
    ],
)
def test_no_trick_is_accepted(verdict, code, lines):
    assert isinstance(verdict(code, *lines), Unmarked)


@pytest.mark.parametrize(
    "lines",
    [
        ("Q = F - mu*g - v0*R", MASS, RATE, "5/Q = 7/Q", TARGET),  # divided by zero
        ("v0 = 2*v0", NEWTON, MASS, RATE, TARGET),
        ("V = v0", "V = 2*v0", NEWTON, MASS, RATE, TARGET),
    ],
)
def test_what_is_false_is_wrong_whatever_follows(verdict, lines):
    assert isinstance(verdict("X12.13", *lines), Wrong)


@pytest.mark.parametrize(
    "lines",
    [
        ("Q = v0^60", "P = Q^60", "N = (P + F)^60", "F*N = F*N + mu - m*y/L", TARGET),
        ("Q = (v0 + m + L + y + g + F + mu + R)^40", "F*Q = F*Q", "F*Q + F - mu*g = Q*F + R*v0", TARGET),
        (*(f"q{n} = sqrt({'q' + str(n - 1) if n else 'F'} + v0)" for n in range(40)), NEWTON, TARGET),
        (*(f"{TARGET[:-1]} + {n} - {n})" for n in range(58)), NEWTON),
    ],
)
def test_what_grows_is_left_to_a_person(verdict, lines):
    """Within the two seconds; and the next derivation is judged as ever."""
    assert isinstance(verdict("X12.13", *lines), Unmarked)
    assert isinstance(verdict("X12.13", NEWTON, MASS, RATE, TARGET), Right)


def test_a_bracket_behind_a_slash_is_a_factor_or_for_a_person(verdict):
    found = verdict(
        "S12.5two", MOMENTUM, RESTITUTION, CHANGE, "dK = -mA*mB/2(mA + mB)*(1 - r^2)*(vA - vB)^2", LOSS
    )
    assert isinstance(found, Unmarked)
    assert "Line 4 can be read in two ways" in found.why
    assert isinstance(verdict("S12.5two", MOMENTUM, RESTITUTION, "dK = 1/3(mA + mB)", LOSS), Wrong)


def test_a_letter_that_nothing_defines_is_for_a_person(verdict):
    found = verdict("X12.13", "(F - mu*g)*dt = dm*v0", "dm = m/L*v0*dt", MASS, TARGET)
    assert isinstance(found, Unmarked)
    assert "dt in line 1" in found.why
    false = verdict("X12.13", "mu = m/L*y^2", "(F - mu*g)*dt = dm*v0", "dm = m/L*v0*dt", MASS, TARGET)
    assert isinstance(false, Wrong)
    assert "Line 1" in false.why


@pytest.mark.parametrize(
    "lines",
    [
        (
            "from Newton's 2nd law F - mu*g = R*v0",
            "with mu = m*y/L and R = m*v0/L we get F = m*y*g/L + m*v0^2/L",
            TARGET,
        ),
        (NEWTON + "  (1)", MASS + "  (2)", RATE + "  (3)", "(2), (3) in (1): " + TARGET),
        ("momentum lost = momentum gained", NEWTON, MASS, RATE, TARGET, "for y = 0: F = m/L*v0^2"),
        ("- mu*g + F = R*v0", MASS, RATE, TARGET),
        ("- F - mu*g = R*v0", "- " + MASS, "- " + RATE, "- " + TARGET),
        ("R' = m/L*v0", "R = R'", "mu = m/L*y", NEWTON, TARGET),
        (
            "To show: " + TARGET,
            NEWTON + " (second law: sum of forces = rate of change)",
            MASS,
            RATE,
            TARGET,
            "q.e.d.",
        ),
        (NEWTON, MASS, RATE, TARGET + ", q.e.d."),
        (NEWTON, MASS, RATE, TARGET + " ∎"),
        ("F = R*v0 + mu*g since F - mu*g = R*v0", MASS + " # even", RATE + ", see [12.3]", TARGET),
    ],
)
def test_words_and_bullets_around_equations(verdict, lines):
    assert isinstance(verdict("X12.13", *lines), Right)


@pytest.mark.parametrize("lines", [("F = v0^9999",), ("F = " + "1+" * 500_000 + "1",), (NEWTON,) * 200])
def test_what_is_too_long_is_turned_away(verdict, lines):
    assert isinstance(verdict("X12.13", *lines), Unread)


def test_who_reads_what_was_left_open_is_told_what_to_look_for(verdict):
    found = verdict("X12.13", MASS, RATE, "F/2 = (m/(2*L))*(v0^2+g*y)", TARGET)
    assert isinstance(found, Unmarked)
    *laws, way = found.rubric
    assert len(laws) == 3
    assert all(law.startswith("states or uses correctly: ") for law in laws)
    assert way.startswith("arrives at F = ")
    assert way.endswith("without a gap")


@pytest.mark.parametrize(
    ("line", "divisor"),
    [
        ("A_x/A_y = -B_y/B_x", "A_y"),
        ("A_x*A_y^-1 = -B_y/B_x", "A_y"),
        ("-B_y = A_x*B_x/A_y", "A_y"),
    ],
)
def test_a_line_that_divides_by_what_may_be_zero_names_it(verdict, line, divisor):
    """In a head-on collision A stops, and B goes on along x: A_y = 0."""
    found = verdict("S12.5nc", ALONG_X, ALONG_Y, ENERGY, line, ORTHOGONAL)
    assert isinstance(found, Unmarked)
    assert f"Line 4 divides by {divisor}, which may be zero" in found.why


def test_dividing_by_givens_that_are_not_zero_is_right(verdict):
    along = "(A_x + B_x)/(mA*v0) = 1/mA"
    assert isinstance(verdict("S12.5nc", ALONG_X, ALONG_Y, ENERGY, along, ORTHOGONAL), Right)


@pytest.mark.parametrize(
    "lines",
    [
        (MASS, "R = dmu/dt", "R = m/L*v0", "F - mu*g = d(mu*v0)/dt", "F - mu*g = R*v0", TARGET),
        (MASS, "R = m/L*v0", "dp/dt = R*v0", "F - mu*g = dp/dt", TARGET),
        ("p = mu*v0", "dp/dt = F - mu*g", "R = m/L*v0", MASS, "dp/dt = m/L*v0^2", TARGET),
        ("p = mu*v0", "F = dp/dt + mu*g", MASS, "dmu/dt = m/L*dy/dt", "dy/dt = v0", "dp/dt = m/L*v0^2", TARGET),
        ("F - mu*g = d/dt (mu v0)", "mu = m y/L", "d/dt (mu) = m/L v0", TARGET),
        (r"F - \mu g = \frac{d(\mu v_0)}{dt}", r"\mu = m y/L", r"\frac{d\mu}{dt} = \frac{m}{L} v_0", TARGET),
        (r"F - \mu g = \frac{d}{dt}(\mu v_0)", r"\mu = m y/L", r"\frac{d \mu}{dt} = \frac{m}{L} v_0", TARGET),
        ("F - mu*g = v0*dmu/dt + mu*dv0/dt", "dv0/dt = 0", MASS, "dmu/dt = m*v0/L", TARGET),
        ("ṗ = R v0", "F - mu g = ṗ", MASS, RATE, TARGET),
        (r"\dot{\mu} = R", NEWTON, MASS, RATE, TARGET),
        ("∂p/∂t = R*v0", "F - mu*g = ∂p/∂t", MASS, RATE, TARGET),
        ("F - mu*g = d(mu v0)/dt = v0*dmu/dt = v0*R", "R = d(m*y/L)/dt = (m/L)*v0", MASS, TARGET),
    ],
)  # fmt: skip
def test_a_derivative_by_time_is_worked_out_by_what_the_problem_says_of_rates(verdict, lines):
    assert isinstance(verdict("X12.13", *lines), Right)


@pytest.mark.parametrize(
    ("lines", "line"),
    [
        ((NEWTON, "dmu/dt = 2*R", MASS, RATE, TARGET), "Line 2 does not hold: dmu/dt = 2*R"),
        ((NEWTON, r"\dot{\mu} = 2*R", MASS, RATE, TARGET), "Line 2 does not hold: dmu/dt = 2*R"),
        ((NEWTON, "dmu/dt = 0", MASS, RATE, TARGET), "Line 2 does not hold: dmu/dt = 0"),
        ((NEWTON, "d(mu*v0)/dt = R*v0/2", MASS, RATE, TARGET), "Line 2 does not hold"),
        (("p = mu*v0", "dp/dt = 0", NEWTON, MASS, RATE, TARGET), "Line 2 does not hold"),
        ((NEWTON, "dv0/dt = g", MASS, RATE, TARGET), "Line 2 does not hold: dv0/dt = g"),
    ],
)
def test_a_false_derivative_is_named_as_it_was_typed(verdict, lines, line):
    found = verdict("X12.13", *lines)
    assert isinstance(found, Wrong)
    assert line in found.why


@pytest.mark.parametrize(
    "lines",
    [
        (NEWTON, "dF/dt = 0", MASS, RATE, TARGET),
        (NEWTON, "dF/dt = m*g*v0/L", MASS, RATE, TARGET),
        (NEWTON, "d(sin(y))/dt = v0*cos(y)", MASS, RATE, TARGET),
        (NEWTON, "d(mu*v0)/dx = R", MASS, RATE, TARGET),
        (NEWTON, "d2y/dt2 = 0", MASS, RATE, TARGET),
        ("F - mu*g = dp/dt", "dp/dt = R*v0 + u", MASS, RATE, TARGET),
    ],
)
def test_a_derivative_of_which_nothing_is_known_is_for_a_person(verdict, lines):
    assert isinstance(verdict("X12.13", *lines), Unmarked)


def test_where_nothing_is_said_of_rates_a_person_reads_them(verdict):
    """Not known to be constant, a letter may change: neither its derivative nor a line with it is believed or called wrong."""
    for line in ("dvA/dt = 0", "d(mA*vA)/dt = mA*dvA/dt", "dr/dt = 1", "dvA/dt = dvB/dt"):
        assert isinstance(verdict("S12.5two", MOMENTUM, RESTITUTION, CHANGE, line, LOSS), Unmarked | Right), (
            line
        )
        assert not isinstance(verdict("S12.5two", MOMENTUM, RESTITUTION, CHANGE, line, LOSS), Wrong)
