"""Each finding, of keys whose fault is known because it was planted; and of right keys, which must never be called wrong."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.audit.examine import examine
from corollary.audit.mistaken import mistake_in
from corollary.audit.record import ForgivenError
from corollary.audit.record_file import records_in

THROW = """
- id: throw
  given: {{v: 20 m/s, theta: 30 deg}}
  convention: {convention}
  laws: [R = v^2*sin(2*theta)/g]
  asked: R
  published: {published}
"""


def one(found):
    (outcome,) = found
    return outcome


@pytest.mark.parametrize(
    ("convention", "published", "finding"),
    [
        ("g = 9.8 m/s^2", "35.3 m", "agrees"),  # 400*sin(60 deg)/9.8 = 35.348
        ("g = 9.8 m/s^2", "35 m", "agrees"),
        ("g = 9.8 m/s^2", "0.0353 km", "agrees"),
        ("g = 9.8 m/s^2", "35.4 m", "last figure"),
        ("g = 9.8 m/s^2", "34.6 m", "ambiguous"),  # g = 10 m/s^2
        ("g = 9.8 m/s^2", "35.31 m", "ambiguous"),  # g = 9.81 m/s^2
        ("g = 9.8 m/s^2", "40.8 m", "wrong"),
        ("g = 9.8 m/s^2", "35.3 s", "wrong"),
        ("g = 9.8 m/s^2", "35.3", "cannot say"),
        ("g = 9.8 m/s^2", "about a field's length", "cannot say"),
        ("g = 9.8 m/s^2", "~10^2 m", "agrees"),
        ("g = 9.8 m/s^2", "~10^4 m", "wrong"),
    ],
)
def test_a_range_of_a_throw(audited, convention, published, finding):
    assert one(audited(THROW.format(convention=convention, published=published))).finding == finding


def test_what_is_given_is_no_convention(audited):
    """With g in the statement, the answer with another g is wrong."""
    text = THROW.replace("30 deg", "30 deg, g: 9.8 m/s^2").format(
        convention="up is positive", published="34.6 m"
    )
    assert one(audited(text)).finding == "wrong"


def test_the_law_that_a_wrong_answer_breaks_is_named(audited):
    found = audited("""
- id: atwood
  given: {m1: 2 kg, m2: 3 kg, mu: 0.25, g: 9.8 m/s^2}
  laws:
    - Newton's second law on the table: m1*a = T - f
    - Newton's second law for what hangs: m2*a = m2*g - T
    - Kinetic friction: f = mu*m1*g
  asked: [a, f]
  published: [4.9 m/s^2, 9.8 N]
""")
    assert [each.finding for each in found] == ["agrees", "wrong"]
    assert found[1].violates == "Kinetic friction"
    assert found[1].sides == ("9.800 N", "4.900 N")
    assert found[1].derived == "4.900 N"


def test_the_other_root_is_named(audited):
    outcome = one(audited("""
- id: high and low
  given: {v: 20 m/s, R: 30 m, g: 9.8 m/s^2}
  laws: [R = v^2*sin(2*theta)/g]
  asked: theta in deg
  published: "23.7"
"""))  # fmt: skip
    assert outcome.finding == "not unique"
    assert outcome.others == ("66.346°",)  # the complement of 23.654 degrees


def test_a_condition_chooses_the_root(audited):
    text = """
- id: fall
  given: {v0: 15 m/s, h: 20 m, g: 9.8 m/s^2}
  laws: ["0 = h + v0*t - g*t^2/2"]
  where: t > 0
  asked: t
  published: 4.1 s
"""
    assert one(audited(text)).finding == "agrees"
    assert one(audited(text.replace("where: t > 0", "where: t > 0 s"))).finding == "agrees"
    unsaid = one(audited(text.replace("  where: t > 0\n", "")))
    assert (unsaid.finding, unsaid.others) == ("not unique", ("-1.004 s",))
    late = one(audited(text.replace("t > 0", "t > 5 s")))
    assert late.finding == "impossible"
    assert "4.065 s against t > 5 s" in late.why


def test_no_real_numbers(audited):
    outcome = one(audited("""
- id: too far
  given: {v: 20 m/s, R: 60 m, g: 9.8 m/s^2}
  laws: [R = v^2*sin(2*theta)/g]
  asked: theta in deg
  published: "23.7"
"""))  # fmt: skip
    assert outcome.finding == "impossible"


def test_givens_that_contradict_each_other(audited):
    text = """
- id: too many
  given: {v: 10.0 m/s, t: 3.00 s, s: 40.0 m, m: 1.00 kg}
  laws: [Way: s = v*t, Kinetic energy: K = m*v^2/2]
  asked: K
  published: 50 J
"""
    outcome = one(audited(text))
    assert (outcome.finding, outcome.violates) == ("impossible", "Way")
    assert one(audited(text.replace("40.0", "30.0"))).finding == "agrees"
    assert one(audited(text.replace("40.0", "30.1"))).finding == "agrees"  # as rounded numbers do


def test_only_the_sign_differs(audited):
    text = """
- id: lift
  given: {m: 2 kg, F: 3 N, g: 9.8 m/s^2}
  laws: [m*a = F - m*g]
  asked: a
  published: 8.3 m/s^2
"""
    assert one(audited(text)).finding == "ambiguous"
    assert one(audited(text + "  convention: up is positive\n")).finding == "wrong"
    assert one(audited(text + "  where: a < 0\n")).finding == "wrong"


def test_degrees_without_a_unit(audited):
    text = "- {{id: a, given: {{x: 3 m, y: 4 m}}, laws: [tan(theta) = y/x], asked: {}, published: '53.1'}}"
    assert one(audited(text.format("theta in deg"))).finding == "agrees"
    assert one(audited(text.format("theta"))).finding == "ambiguous"


@pytest.mark.parametrize(
    ("record", "why"),
    [
        ("given: {m: 2 kg, F: 3 N}, laws: [m*a = F - m], asked: a, published: 1 m/s^2", "cannot be added"),
        ("given: {m: 2 kg}, laws: [m*a = F], asked: a, published: 1 m/s^2", "1 laws for 2 unknowns"),
        (
            "given: {M: 2 kg, m: 1 kg, r: 1 m}, laws: [F = G*m*M/r^2], asked: F, published: 1 N",
            "constants: [G]",
        ),
        ("given: {m: 2 kg}, laws: [F = m*a], asked: b, published: 1 N", "b is asked for"),
        ("given: {m: 2 kg}, laws: [F = m*a], asked: m, published: 1 N", "m is asked for, and is given"),
        ("given: {m: 2..3 kg, a: 1 m/s^2}, laws: [F = m*a], asked: F, published: 1 N", "m has a range"),
        (
            "given: {m: 2 kg, a: 1 m/s^2}, laws: [F = m*a], where: F > 1 kg, asked: F, published: 1 N",
            "where F > 1 kg",
        ),
    ],
)
def test_what_cannot_be_said_is_said_why(audited, record, why):
    outcome = one(audited(f"- {{id: x, {record}}}"))
    assert outcome.finding == "cannot say"
    assert why in outcome.why


FORMULA = """
- id: formula
  given: {{v: {v}, theta: {theta}, g: m/s^2}}
  laws: [x = v*cos(theta)*t, 0 = v*sin(theta)*t - g*t^2/2]
  where: x > 0
  asked: x
  published: {published}
"""


@pytest.mark.parametrize(
    ("published", "finding"),
    [
        ("v^2*sin(2*theta)/g", "agrees"),
        ("2*v^2*sin(theta)*cos(theta)/g", "agrees"),
        ("x = v^2 sin(2 theta)/g", "agrees"),
        ("v*cos(theta)*t", "agrees"),  # in a letter that the laws tell
        ("v^2*sin(theta)/g", "wrong"),
        ("v^2*sin(2*theta)/(2*g)", "wrong"),
        ("v*sin(2*theta)/g", "wrong"),
        ("1.0000001*v^2*sin(2*theta)/g", "wrong"),  # far below any figures that a book prints
    ],
)
def test_a_formula_is_compared_as_a_function(audited, published, finding):
    for v, theta in (("m/s", "deg"), ("2..5 m/s", "20..40 deg")):
        outcome = one(audited(FORMULA.format(v=v, theta=theta, published=published)))
        assert outcome.finding == finding
        assert bool(outcome.counterexample) == (finding == "wrong")


RISE = """
- id: rise
  given: {{m: kg, M: kg, v: {v}, g: m/s^2}}
  laws: [m*v = (m + M)*u, u^2/2 = g*h]
  asked: h
  published: {published}
"""


@pytest.mark.parametrize("v", ["m/s", "2..5 m/s"])
@pytest.mark.parametrize(
    ("published", "finding", "compared"),
    [
        ("m^2*v^2/(2*g*(m + M)^2)", "agrees", "algebra"),
        ("(v*m/(M + m))^2/2/g", "agrees", "algebra"),
        ("(sqrt(v^2)*m/(M + m))^2/(2*g)", "agrees", "algebra"),
        ("m^2*v^2/(2*g*(m^2 + M^2))", "wrong", "algebra"),
        ("(1 + 1e-70)*m^2*v^2/(2*g*(m + M)^2)", "wrong", "algebra"),  # at points the same to 2^-200
    ],
)
def test_quotients_of_polynomials_are_settled_for_all_numbers(audited, v, published, finding, compared):
    outcome = one(audited(RISE.format(v=v, published=published)))
    assert (outcome.finding, outcome.compared) == (finding, compared)
    assert "proven" in outcome.sentence
    assert outcome.as_json()["compared"] == compared


@pytest.mark.parametrize("published", ["v^2*sin(2*theta)/g", "v^2*cos(pi/2 - 2*theta)/g"])
def test_what_is_only_the_same_at_points_is_not_called_proven(audited, published):
    outcome = one(audited(FORMULA.format(v="m/s", theta="deg", published=published)))
    assert outcome.finding == "agrees"
    assert ("proven" in outcome.sentence) == (outcome.compared == "algebra")


def test_the_counterexample_is_one(audited):
    """Its numbers, put into the true formula of the range of a throw and into the published one, give what it says."""
    outcome = one(audited(FORMULA.format(v="2..5 m/s", theta="20..40 deg", published="v^2*sin(theta)/g")))
    numbers = {
        name: float(text.replace("°", " ").split()[0]) for name, text in outcome.counterexample.items()
    }
    v, theta, g = numbers["v"], math.radians(numbers["theta"]), numbers["g"]
    assert 2 <= v <= 5
    assert 20 <= numbers["theta"] <= 40
    assert numbers["derived"] == pytest.approx(v**2 * math.sin(2 * theta) / g, rel=1e-4)
    assert numbers["published"] == pytest.approx(v**2 * math.sin(theta) / g, rel=1e-4)


def test_a_formula_for_one_root_of_two_is_not_unique(audited):
    outcome = one(audited("""
- {id: x, given: {h: m, v: m/s, g: m/s^2}, laws: [h = v*t - g*t^2/2], asked: t, published: (v + sqrt(v^2 - 2*g*h))/g}
"""))  # fmt: skip
    assert outcome.finding == "not unique"


def rounded(value: float, figures: int) -> str:
    return f"{value:.{figures - 1}e}"


@settings(max_examples=12)
@given(m1=st.integers(1, 99), m2=st.integers(1, 99), mu=st.integers(5, 90), figures=st.integers(2, 6))
def test_right_keys_are_never_called_wrong(tmp_path_factory, m1, m2, mu, figures):
    """The acceleration of two bodies by a textbook's formula, rounded to so many figures."""
    from corollary.audit.examine import examine
    from corollary.audit.record_file import records_in

    a = (m2 - mu / 100 * m1) * 9.81 / (m1 + m2)
    path = tmp_path_factory.mktemp("audit") / "r.yaml"
    path.write_text(f"""
- id: two bodies
  given: {{m1: {m1} kg, m2: {m2} kg, mu: {mu / 100}, g: 9.81 m/s^2}}
  laws: [m1*a = T - mu*m1*g, m2*a = m2*g - T]
  asked: a
  published: {rounded(a, figures)} m/s^2
""")  # fmt: skip
    (outcome,) = examine(records_in(path)[0])
    assert outcome.finding == "agrees"


@settings(max_examples=12)
@given(
    v=st.integers(10, 40),
    h=st.integers(1, 60),
    figures=st.integers(2, 6),
    off=st.sampled_from([2, 5, 40, -3]),
)
def test_wrong_keys_are_never_said_to_agree(tmp_path_factory, v, h, figures, off):
    """A number that is off by some units of its last figure."""
    from corollary.audit.examine import examine
    from corollary.audit.record_file import records_in

    t = (v + math.sqrt(v * v + 2 * 9.81 * h)) / 9.81
    mantissa, exponent = rounded(t, figures).split("e")
    changed = float(f"{mantissa}e{exponent}") + off * 10.0 ** (int(exponent) - figures + 1)
    path = tmp_path_factory.mktemp("audit") / "r.yaml"
    path.write_text(f"""
- id: fall
  given: {{v: {v} m/s, h: {h} m, g: 9.81 m/s^2}}
  laws: ["0 = h + v*t - g*t^2/2"]
  where: t > 0
  asked: t
  published: {rounded(changed, figures)} s
""")  # fmt: skip
    (outcome,) = examine(records_in(path)[0])
    assert outcome.finding in {"wrong", "ambiguous"}


def test_a_part_of_the_ranges_without_an_answer_is_named(audited):
    """x^2 = a - b has no root where b is the larger."""
    outcome = one(audited("""
- {id: x, given: {a: 1..5 m^2, b: 2..6 m^2}, laws: [x^2 = a - b], where: x > 0, asked: x, published: sqrt(a - b)}
"""))  # fmt: skip
    assert outcome.finding == "agrees"
    assert outcome.why.startswith("a part of the ranges admits no answer: a = ")


def test_a_number_that_the_formula_has_no_letter_for_is_put_in(audited):
    text = "- {{id: x, given: {{w: m, g: m/s^2, theta: 45 deg}}, laws: [t = 4*sqrt(w/(g*sin(2*theta)))], asked: t, published: {}}}"
    assert one(audited(text.format("4*sqrt(w/g)"))).finding == "agrees"
    assert one(audited(text.format("2*sqrt(w/g)"))).finding == "wrong"


def test_the_mistake_in_a_formula(audited):
    outcome = one(audited(FORMULA.format(v="m/s", theta="deg", published="2*v^2*cos(theta)^2/g")))
    says, law = mistake_in(outcome)
    assert "sine and cosine are interchanged" in says
    assert law == "0 = v*sin(theta)*t - g*t^2/2"


def test_the_mistake_on_record_names_the_law_it_replaces(audited):
    outcome = one(audited("""
- id: circle
  given: {r: 2 m, T: 4 s}
  laws: [Speed: v = 2*pi*r/T, Towards the centre: a = v^2/r]
  mistakes:
    - {says: The circle is not closed., law: v = pi*r/T, instead: Speed}
  asked: a
  published: 1.23 m/s^2
"""))  # fmt: skip
    assert mistake_in(outcome) == ("The circle is not closed.", "Speed")  # (pi/2)^2/2 = 1.2337


def test_a_rounding_is_no_other_convention(audited):
    """44.7 m for 44.64 m: one in the last figure, though another g would give it, too."""
    outcome = one(audited("""
- {id: x, given: {t: 3.018 s}, convention: g = 9.80 m/s^2, laws: [h = g*t^2/2], asked: h, published: 44.7 m}
"""))  # fmt: skip
    assert outcome.finding == "last figure"


def test_sides_that_differ_little_are_shown_to_differ(audited):
    (found,) = audited(
        "- {id: a, given: {m: 2 kg, a: 3.0001 m/s^2}, laws: [F = m*a], asked: F, published: 6.00032 N}"
    )
    assert (found.finding, found.sides) == ("wrong", ("6.0003 N", "6.0002 N"))


@pytest.mark.parametrize(
    ("given", "laws", "asked", "published", "finding"),
    [
        ("v: -0.54 m/s", "s = abs(v)", "s", "-0.54 m/s", "wrong"),
        ("v: 3 m/s, m: 2 kg", "K = m*v^2/2", "K", "-9.0 J", "wrong"),
        ("h: 0.5 m, k: 9.8 m/s^2", "u = sqrt(2*k*h)", "u", "-3.13 m/s", "wrong"),
        ("F: 6 N, a: 2 m/s^2", "F = m*a", "m", "-3.0 kg", "wrong"),
        ("x: 3 m, y: 4 m", "r^2 = x^2 + y^2, r > 0", "r", "-5.0 m", "wrong"),
        ("v: 3 m/s, m: 2 kg", "p = m*v", "p", "-6.0 kg m/s", "ambiguous"),  # the other way is positive
        ("F: 6 N, s: 2 m, a: 60 deg", "W = F*s*cos(a)", "W", "-6.0 J", "ambiguous"),
        ("I: 2 A, R: 5 ohm", "U = R*I", "U", "-10 V", "ambiguous"),
    ],
)
def test_a_sign_is_a_matter_of_direction_only_where_there_is_one(
    audited, given, laws, asked, published, finding
):
    law, _, where = laws.partition(", ")
    text = f"- {{id: a, given: {{{given}}}, laws: ['{law}'], asked: {asked}, published: {published}"
    outcome = one(audited(text + (f", where: {where}" if where else "") + "}"))
    assert outcome.finding == finding


def test_what_is_missing_is_named(audited):
    """Never what is asked for, be it called as a constant is."""
    text = "- {{id: a, given: {{h: 0.04 m{}}}, laws: ['{}'], where: u > 0, asked: u, published: 0.8854 m/s}}"
    outcome = one(audited(text.format("", "u^2 = 2*g*h")))
    assert (outcome.finding, outcome.why.partition("; ")[2]) == (
        "cannot say",
        "g is missing: write it into given",
    )
    outcome = one(audited(text.format(", M: 6e24 kg", "u^2 = 2*G*M/h")))
    assert outcome.why.endswith("; G is missing: write it into given, or constants: [G]")


@pytest.mark.parametrize(
    ("published", "relative", "finding"),
    [("35 m", 1e-2, "agrees"), ("35 m", 1e-3, "wrong"), ("35.348 m", 1e-3, "agrees")],
)
def test_a_key_coarser_than_its_question_forgives(tmp_path, published, relative, finding):
    path = tmp_path / "r.yaml"
    path.write_text(THROW.format(convention="g = 9.8 m/s^2", published=published), encoding="utf-8")
    record = replace(records_in(path)[0], forgives=(ForgivenError(relative, 1e-8),))
    outcome = one(examine(record))
    assert outcome.finding == finding
    assert ("coarsely" in outcome.why) == (finding == "wrong")
