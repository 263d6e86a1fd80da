"""Verification: what a sound problem passes, and that every planted fault is met, with its file and line."""

from __future__ import annotations

import re

import pytest
from tests.problem.test_pictures import png

from corollary.problem.bank import Bank, find
from corollary.verify.checked import Checked
from corollary.verify.verify import verify

SCENE = """

def scene(m, v, t, answer):
    return [simulate("kick", {"m": m, "v0": 0.0, "F": answer["b"], "dt": t}, velocities=(%s,), impulse=answer["a"])]
"""


def met(checked: Checked, words: str, line: int, file: str = "cart.py") -> None:
    assert not checked.ok
    assert any(
        words in complaint and complaint.startswith(f"{file}:{line}: ") for complaint in checked.complaints
    ), checked.complaints
    assert all(re.match(r"cart\.(md|py):\d+: ", complaint) for complaint in checked.complaints), (
        checked.complaints
    )


def test_a_picture_that_nothing_shows(verified, tmp_path):
    verified()
    path, bank = tmp_path / "problems" / "carts" / "cart.md", Bank(tmp_path)
    path.with_name("cart_old.png").write_bytes(png())
    checked = verify(bank, find(bank, "X1.1"), 20)
    assert checked.ok
    assert any(note.startswith("cart.md:1: cart_old.png is in its folder") for note in checked.notes)
    path.write_text(path.read_text().replace("A cart.", "A cart. ![an old cart](cart_old.png)"))
    assert not any("cart_old" in note for note in verify(bank, find(bank, "X1.1"), 20).notes)


def test_a_sound_problem(verified):
    checked = verified(more=SCENE % "v")
    assert checked.ok, checked.complaints
    assert (checked.code, checked.variants, checked.exact_count) == ("X1.1", 8 * 5 * 4, True)
    counts = checked.checks
    assert (counts["parts"], counts["laws put back"], counts["dimensions"], counts["mistakes"]) == (
        2,
        2,
        2,
        1,
    )
    assert counts["variants walked"] == 20
    assert counts["right answers"] == 2 * 20
    assert counts["simulations met"] == 2 * 8
    assert counts["printed values"] == 1
    assert counts["kind samples"] > 10


SHOW = """\
    rest = law("Force", "F = p/t", F=F, p=p, t=t)
    claim = law("Claim", "F = m*v/t", F=F, m=m, v=v, t=t)
    return derivation(
        step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
        step(F, "Per time.", mean_force(F, p, t), answers="b"),
        proof("c", "Both.", %s, target=claim, lines=["p = m*v", "F = p/t", "F = m*v/t"]),
    )
"""
TO_SHOW = '\n## Both {#c .proof components="p F"}\nShow it.\n'


def test_a_proof_with_an_unknown_letter_says_which(verified, problem):
    body = SHOW.replace('"F = p/t", "F', '"F = p/z", "F') % "momentum(p, m, v), rest"
    (first, *_) = verified(body, problem=problem + TO_SHOW).complaints
    assert "should be right and is unmarked (z in line 2 is not a letter of the problem" in first


def test_a_claim_that_the_laws_of_its_proof_imply(verified, problem):
    checked = verified(SHOW % "momentum(p, m, v), rest", problem=problem + TO_SHOW)
    assert checked.ok, checked.complaints
    assert checked.checks["claims shown"] == 1


def test_a_claim_that_the_laws_of_its_proof_do_not_imply(verified, problem):
    checked = verified(SHOW % "rest", problem=problem + TO_SHOW)
    met(checked, "are not found to imply F = m*v/t", 19, "cart.md")


RATES = SHOW.replace('"F = m*v/t"])', '"F = m*v/t"], rates={%s})')


def test_rates_that_a_law_of_the_proof_contradicts(verified, problem):
    """Where p changes and neither m nor v does, p = m*v does not go on to hold."""
    laws = "momentum(p, m, v), rest"
    checked = verified(RATES % (laws, "p: F"), problem=problem + TO_SHOW)
    met(checked, "by its rates= the law p = m*v does not go on to hold", 19, "cart.md")


def test_rates_by_which_the_laws_go_on_to_hold(verified, problem):
    assert verified(RATES % ("momentum(p, m, v), rest", "p: F, v: F/m"), problem=problem + TO_SHOW).ok


def test_a_rate_of_an_unknown_letter_says_which(verified, problem):
    strange = RATES % ("momentum(p, m, v), rest", 'p: unknown("q")')
    text = str(
        verified(
            strange.replace("rest = law", "from corollary.author import unknown\n    rest = law"),
            problem=problem + TO_SHOW,
        ).complaints
    )
    assert "q in rates= is neither given nor found" in text


def test_a_simulation_that_disagrees(verified):
    met(verified(more=SCENE % "2*v"), "where the algebra says", 17)


def test_a_scene_that_does_not_observe_it(verified):
    more = 'def scene(m, v, t, answer):\n    return [simulate("kick", {"m": m}, period=1.0)]\n'
    met(verified(more="\n" + more), "does not observe period; it observes", 16)


COMPOSED = """

def scene(m, v, t, answer):
    from corollary.scenes.forces.fields import ForceFunction
    from corollary.scenes.scene import Body, Scene
    push = ForceFunction(0, lambda at, x, w: (answer["b"],))
    return [simulate(Scene((Body(m, (0.0,), (0.0,)),), (push,), until=%s), trajectory=(%s,), velocities=(v,))]
"""


def test_a_composed_scene_confirms(verified):
    """Pushed from rest by m v/t for t, a body comes to v and v t/2 far; its place stands second, after a nail's."""
    nailed = COMPOSED.replace("Scene((", "Scene((Body(1.0, (0.0,), (0.0,)), ").replace(
        "(0, lambda", "(1, lambda"
    )
    checked = verified(more=nailed.replace("velocities=(v,)", "velocities=(0.0, v)") % ("t", "0.0, v*t/2"))
    assert checked.ok, checked.complaints
    assert checked.checks["simulations met"] == 2 * 8


@pytest.mark.parametrize(
    ("until", "where", "words"),
    [
        ("t", "v*t", "trajectory is"),
        ("None", "v*t/2", "say until="),
        ("t", 'v*t/2,), settings={"m": m}, x=(0', "a composed scene has no settings"),
        ("t", "v*t/2,), colour=(0.0", "does not observe colour; a composed scene observes velocities"),
    ],
)
def test_a_composed_scene_that_disagrees(verified, until, where, words):
    met(verified(more=COMPOSED % (until, where)), words, 20)


@pytest.mark.parametrize(
    ("result", "line", "words"),
    [
        ("[simulate('pool', {}, x=1.0)]", 17, "There is no scene 'pool'"),
        ("[simulate('kick', {'mass': m}, x=1.0)]", 17, "'mass' is not among its settings"),
        ("answer['z']", 17, "scene fails: KeyError"),
        ("None", 16, "scene fails: TypeError"),
        ("[1]", 16, "scene must return a list of simulate(…)"),
    ],
)
def test_a_scene_that_will_not_do(verified, result, line, words):
    met(verified(more=f"\n\ndef scene(m, v, t, answer):\n    return {result}\n"), words, line)


def test_a_route_that_leads_elsewhere(verified):
    met(verified("""\
        return derivation(
            step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
            step(F, "Per time.", mean_force(F, p, t), answers="b",
                 routes=[route("At once.", law("Twice", "F = 2*m*v/t", F=F, m=m, v=v, t=t))]))
        """), "Twice does not hold for the answers", 10)  # fmt: skip


def test_a_law_whose_terms_do_not_fit(verified):
    met(verified("""\
        return derivation(
            step(p, "Mass times velocity.", law("Odd", "p = m*v + (t - t + v - v)", p=p, m=m, v=v, t=t), answers="a"),
            step(F, "Per time.", mean_force(F, p, t), answers="b"))
        """), "Odd:", 9)  # fmt: skip


def test_a_printed_value_that_is_not_met(verified, good):
    met(
        verified(good.replace("1.5 kg m/s", "1.7 kg m/s")),
        "(1.1) prints 1.7 kg m/s for part a; the derivation gives 1.5",
        12,
    )


def test_a_printed_value_that_cannot_be_read(verified, good):
    met(
        verified(good.replace("1.5 kg m/s", "one and a half")),
        "the printed value 'one and a half' cannot be read",
        12,
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("~1 kg m/s", ""),
        ("~10 kg m/s", "is of another order of magnitude"),
        ("m*v", ""),
        ("2*m*v", "the derivation gives m*v"),
        ("1.6 kg m/s", "they differ by one in the last figure"),
        ("1.7 kg m/s", "the derivation gives 1.5 kg m/s"),
        ("1.5000004 kg m/s", "the derivation gives 1.5 kg m/s"),
        ("2 kg m/s", ""),  # 1.5 to one figure
    ],
)
def test_what_may_be_printed(verified, good, text, said):
    checked = verified(good.replace("1.5 kg m/s", text))
    assert bool(checked.complaints) == bool(said), checked.complaints
    assert all(said in each and each.startswith("cart.py:12: (1.1) prints") for each in checked.complaints)


def test_what_differs_in_the_eighth_figure_is_written_so(verified, good, problem):
    """A complaint that shows one number twice helps nobody."""
    fine = problem.replace("value: 0.5, from: 0.2", "value: 0.50000013, from: 0.2")
    (complaint,) = verified(good.replace("1.5 kg m/s", "1.5000000 kg m/s"), problem=fine).complaints
    assert "the derivation gives 1.5000004 kg m/s" in complaint


@pytest.mark.parametrize(("printed", "holds"), [("150 kg m/s", True), ("154 kg m/s", False)])
def test_a_zero_at_the_end_may_count_or_not(verified, good, problem, printed, holds):
    heavy = problem.replace("value: 0.5, from: 0.2", "value: 50.8, from: 0.2")  # 152.4
    checked = verified(good.replace("1.5 kg m/s", printed), problem=heavy)
    assert (not checked.complaints) == holds


def test_what_an_author_may_want_to_know(verified, good, problem):
    """The force has one mistake and then two of one value, the momentum none; nothing needs s, and 9 kg is never dealt."""
    more = problem.replace("value: 0.5", "value: 9").replace(
        "require:", "  s: {is: way, value: 2, unit: m}\nrequire:"
    )
    twice = good.replace(
        "F=F, p=p, t=t))])", 'F=F, p=p, t=t)),\n                   mistake("Times.", wrong("F = t*p"))])'
    )
    checked = verified(twice.replace('printed("a", "1.5 kg m/s", "(1.1)"),', ""), problem=more)
    assert checked.ok, checked.complaints
    assert list(checked.notes) == [
        "cart.md:5: value: 9 of m is outside from: 0.2 to: 0.9; no student gets it",
        "cart.md:8: the given s is used in no answer; leave it out, unless it is there to be left aside",
        "cart.py:9: part a foresees no mistake; say at least two",
        "cart.py:12: this mistake gives the same value as 'You multiplied.'; students are told that",
        "cart.md:8: the given s (2\N{NO-BREAK SPACE}m) is not in the text",
    ]


def test_one_mistake_is_few(verified, good):
    assert "cart.py:10: part b foresees one mistake; say at least two" in verified(good).notes


def test_a_letter_that_nothing_introduces_is_noted(verified, good):
    unnamed = good.replace(
        "return derivation(",
        '(r,) = unknowns("r")\nreturn derivation(\n    step(r, "Way.", law("Way", "2*r = 2*v*t")),',
    )
    said = [note for note in verified(unnamed).notes if "stands for" in note]
    assert [note.partition(";")[0] for note in said] == ["cart.py:10: r has no meaning for the reader"]


def test_an_erratum_is_on_record_and_one_that_is_none_is_said(verified, good):
    known = good.replace('"1.5 kg m/s", "(1.1)"', '"1.9 kg m/s", "(1.1)", erratum="v is 3.8 there"')
    checked = verified(known)
    assert checked.ok
    assert checked.notes[0].startswith(
        "cart.py:12: on record as an erratum (v is 3.8 there): (1.1) prints 1.9"
    )


def test_an_erratum_that_is_none(verified, good):
    agreed = good.replace('"(1.1)"', '"(1.1)", erratum="I thought so"')
    met(verified(agreed), "(1.1) agrees with the derivation for part a; leave erratum= out", 12)


def test_a_mistake_that_is_no_mistake(verified, good):
    """Everywhere on the grid it gives the truth: nothing may be dealt."""
    checked = verified(good.replace('"F = p*t"', '"F = p*t/t^2"'))
    met(checked, "100 % of the draws may not be assigned", 5, "cart.md")
    assert checked.redrawn == 1.0
    assert "cannot be told from the truth" in checked.why[0][0]


def test_a_mistake_that_coincides_here_and_there(verified, problem):
    """With t = 1 s, multiplying by the time is dividing by it: those draws are passed over, and counted."""
    checked = verified(problem=problem.replace("from: 2, to: 5", "from: 1, to: 4"), count=160)
    assert checked.ok, checked.complaints
    assert checked.checks["variants walked"] == 8 * 5 * 3
    assert checked.redrawn == 1 / 4
    assert checked.why == (("part b: the mistake 'You multiplied.' cannot be told from the truth", 8 * 5),)


def test_conditions_that_leave_nothing(verified, problem):
    met(
        verified(problem=problem.replace("---\nA cart.", "where: v > 100 m/s\n---\nA cart.")),
        "no variant keeps all the conditions",
        5,
        "cart.md",
    )


def test_the_chapters_own_numbers_against_the_physics(verified, problem):
    met(
        verified(problem=problem.replace("value: 0.5", "value: -0.5")),
        "the chapter's own numbers break m > 0",
        9,
        "cart.md",
    )


def test_the_chapters_own_numbers_without_an_answer(verified, problem):
    checked = verified(problem=problem.replace("value: 2, from", "value: 0, from"))
    met(checked, "is not real for every value of the givens", 10)


def test_a_choice_of_which_two_options_hold(verified, problem, good):
    which = problem + "\n## Fast? {#c .choice}\n\n- (a) yes\n- (b) no\n"
    checked = verified(
        good.replace("printed(", 'choice("c", "So.", a=v > 1, b=v < 4),\n    printed('), problem=which
    )
    met(checked, "the chapter's own numbers have no answer: part c: 2 options hold (a, b)", 5, "cart.md")


def test_a_figure_that_is_no_drawing(verified, problem):
    with_figure = problem.replace(
        "---\nA cart.", "figure: |\n  <svg><text>{{m}}</text>\nalt: A cart.\n---\nA cart."
    )
    met(
        verified(problem=with_figure),
        "the figure cannot be shown: the drawing is not well-formed XML",
        10,
        "cart.md",
    )


def test_a_figure_that_can_be_shown(verified, problem):
    with_figure = problem.replace(
        "---\nA cart.", "figure: |\n  <svg><text>{{m}}</text></svg>\nalt: A cart.\n---\nA cart."
    )
    checked = verified(problem=with_figure)
    assert checked.ok, checked.complaints
    assert checked.checks["figures"] == 1


def test_a_solution_that_does_not_derive(verified):
    met(
        verified('return derivation(step(p, "Here.", momentum(p, m, F), answers="a"))'),
        "answers no part b",
        6,
    )


def test_an_observation_that_a_find_rests_on(verified):
    checked = verified("""\
        return derivation(
            simulated(p, "By running it.", scene="kick", settings={"m": m}, observe="colour", answers="a"),
            step(F, "Per time.", mean_force(F, p, t), answers="b"))
        """)
    met(checked, "scene kick does not observe colour; it observes", 5, "cart.md")


CANCELS = """\
---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  v: {is: first speed, value: 34.1, from: 34.1, to: 35.1, step: 0.1, unit: m/s}
  t: {is: second speed, value: 36, from: 36, to: 37, step: 0.1, unit: m/s}
require:
  - m > 0
---
A cart of {{m}} at {{v}}, and then at {{t}}.

## Momentum {#a .value unit="kg*m/s"TOLERANCE}
How much momentum is won?
"""
DIFFERENCE = """\
return derivation(
    step(F, "Mass times velocity.", law("Before", "F = m*v")),
    step(p, "The difference.", law("Difference", "p = m*t - F"), answers="a"),
)
"""


def test_rounding_by_more_than_two_per_cent_names_the_tolerance(verified):
    cancelling = verified(DIFFERENCE, problem=CANCELS.replace("TOLERANCE", ""))
    (complaint,) = cancelling.complaints
    assert "honest rounding" in complaint
    assert 'give the part a tolerance="5 %"' in complaint


def test_numbers_that_rounding_moves_less_than_the_part_forgives_are_dealt(verified):
    own = ' tolerance="20 %" because="two terms nearly cancel"'
    assert verified(DIFFERENCE, problem=CANCELS.replace("TOLERANCE", own)).complaints == ()


MELTING = """\
---
code: X1.1
title: Ice in water
given:
  m: {is: mass of the ice, value: 10, from: 5, to: 100, step: 5, unit: g}
  M: {is: mass of the water, value: 100, unit: g}
  z: {is: rest, value: 0, unit: g}
require:
  - m > 0
  - M > 0
---
Ice of {{m}} swims in water of {{M}}; {{z}} are left.

## Rest {#a .value unit="g"}
How much more ice than water is there, at least nothing?
"""
IN_CASES = """\
## Case: there is more ice, if `m > M/2`

### (a) x

The difference.

- law: More, `x = 2*m - M`

## Case: there is more water, if `m <= M/2`

### (a) x

Nothing.

- law: Rest, `x = z`
"""


@pytest.mark.parametrize(("scale", "refused"), [("", True), ("- scale: `M`\n", False)])
def test_a_case_that_no_student_gets_is_a_fault(tmp_path, scale, refused):
    """An answer of zero is compared with nothing: all draws of its case are refused, until a scale is stated."""
    for folder, text in (("problems", MELTING), ("solutions", IN_CASES + scale)):
        (tmp_path / folder / "heat").mkdir(parents=True)
        (tmp_path / folder / "heat" / "ice.md").write_text(text, encoding="utf-8")
    found = verify(Bank(tmp_path), find(Bank(tmp_path), "X1.1"), 20).complaints
    never = [each for each in found if "the case 'there is more water' is never dealt" in each]
    assert bool(never) == refused, found
    assert all(each.startswith("solutions/heat/ice.md:9: ") for each in never)
    assert all("state it in its step, as scale" in each for each in never)
