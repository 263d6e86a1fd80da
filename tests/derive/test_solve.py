"""A derivation solved, or refused with the line and the reason: laws too few, too many roots, letters nobody gave."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from tests.derive.conftest import ASKS, FRONT

from corollary.derive.solution import ClosedForms
from corollary.formula.ball import RationalPi, evaluate
from corollary.formula.plain_text import text
from corollary.grading.key import option_that_holds

TWO_CARTS = '## Velocities {#a .vector unit="m/s" components="A B"}\nWhich?\n'


def closed(solution, part: str) -> list[str]:
    find = solution.answer(part)
    assert find is not None
    assert find.in_givens is not None
    return [text(tree) for tree in find.in_givens]


def local(solution, part: str) -> list[str]:
    rule = solution.answer(part).local
    assert isinstance(rule, ClosedForms)
    return [text(tree) for tree in rule.trees]


def test_a_step_after_a_step(solved):
    found = solved(
        """
        return derivation(
            step(p, "Mass times velocity.", momentum(p, m, v)),
            step(F, "Per time.", mean_force(F, p, t), answers="a"),
        )""",
        asks='## Force {#a .value unit="N"}\n?\n',
    )
    assert local(found, "a") == ["p/t"]
    assert closed(found, "a") == ["m*v/t"]
    assert [find.names for find in found.unknowns] == [("p",), ("F",)]


def test_laws_too_few(refused):
    assert refused(
        """
        r, s, u = unknowns("r s u")
        return derivation(
            step((r, s, u), "Not enough.", law("One", "a = b", a=r, b=s), law("Two", "a = b", a=s, b=m*v), answers="a"))
        """,
        asks='## V {#a .vector unit="kg*m/s" components="x y z"}\n',
    ) == (10, "part a: 2 laws for 3 unknowns: u stays free")


def test_a_law_that_says_nothing_new_does_not_count(refused):
    line, sentence = refused(
        """
        return derivation(step((p, q), "Twice the same.",
                               law("One", "a = b", a=p, b=q), law("Two", "2*a = 2*b", a=p, b=q), answers="a"))
        """,
        asks='## V {#a .vector unit="kg*m/s" components="x y"}\n',
    )
    assert line == 8
    assert sentence.endswith("stays free")


def test_laws_that_contradict_each_other(refused):
    line, sentence = refused("""
        return derivation(step(p, "Both.",
                               law("One", "p = m*v", p=p, m=m, v=v), law("Two", "p = 2*m*v", p=p, m=m, v=v), answers="a"))
        """)
    assert line == 8
    assert sentence == "part a: 2 laws for 1 unknown: no p satisfies them all"


ELASTIC = """
    a, b = unknowns("a b")
    return derivation(step((a, b), "Both are kept.",
        conservation_of_momentum(before=[(m, v), (m, 0)], after=[(m, a), (m, b)]),
        elastic(before=[(m, v), (m, 0)], after=[(m, a), (m, b)]), answers="a"{more}))
"""


def test_two_answers(refused):
    line, sentence = refused(ELASTIC.format(more=""), asks=TWO_CARTS)
    assert line == 9
    assert sentence.startswith("part a: 2 answers (")
    assert "say which, with where or reject" in sentence


@pytest.mark.parametrize(
    "more", [", where=b > a", ", where=sympy.Gt(b, 0)", ', reject=[reject("no collision took place", a=v)]']
)
def test_the_root_that_is_meant(solved, more):
    found = solved(ELASTIC.format(more=more), asks=TWO_CARTS)
    assert closed(found, "a") == ["0", "v"]
    (refused,) = found.unknowns[0].rejected
    sentence = refused.spoken()
    assert "no collision" in sentence or "<" in sentence or ">" in sentence


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (", where=b > 2", "holds for"),
        (", where=b > 100", "no root is left"),
        (", where=b > unknown('z')", "z has no value here"),
        (', reject=[reject("never", a=2*v)]', "the root to reject (never) is not a root of the laws"),
        (', reject=[reject("one", a=0), reject("other", a=v)]', "no root is left"),
    ],
)
def test_a_choice_of_root_that_will_not_do(refused, more, words):
    line, sentence = refused(ELASTIC.format(more=more), asks=TWO_CARTS)
    assert line == 9
    assert words in sentence


def test_a_root_that_is_not_real_everywhere(refused):
    line, sentence = refused("""
        return derivation(step(p, "A root.", law("Odd", "p^2 = v - 2", p=p, v=v), where=p >= 0, answers="a"))""")
    assert line == 8
    assert "is not real for every value of the givens" in sentence


def test_an_equation_no_formula_solves(refused):
    _, sentence = refused(
        """return derivation(step(p, "Hard.", law("Odd", "p + exp(p) = sin(p)", p=p), answers="a"))"""
    )
    assert "part a:" in sentence


GOOD = 'step(p, "Here.", momentum(p, m, v), answers="a")'


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ('step(p, "Here.", momentum(p, m, q), answers="a")', "part a: Momentum: q is neither given nor found before"),
        ('step(p, "Here.", momentum(p, m, 2*v/t), answers="a")', "the answer is not in kg m/s, it is"),
        ('step(p, "Here.", law("Odd", "p = m + v", p=p, m=m, v=v), answers="a")',
         "the dimensions do not fit: m (kg) and v (m/s) cannot be added"),
        ('step(m, "Here.", momentum(m, m, v), answers="a")', "m is given or found already"),
        ('step(p, "Here.", law("Area", "p = A", p=p, A=sympy.Integral(sympy.exp(m**2), (m, 0, 1))), answers="a")',
         "cannot be written as a formula"),
        ('step(p, "Here.", momentum(p, m, v), answers="a", mistakes=[mistake("Slip.")])', "the mistake 'Slip.': it names no law"),
        ('step(p, "Here.", momentum(p, m, v), answers="a", mistakes=[mistake("Slip.", momentum(p, m, q))])',
         "q is neither given"),
        ('step(p, "Here.", momentum(p, q, v), law("Two", "q = m", q=q, m=m), also=[q], answers="a",'
         ' mistakes=[mistake("Slip.", momentum(p, m, v), instead="Three")])', "say which law it takes the place of"),
        ('step(p, "Here.", momentum(p, q, v), law("Two", "q = m", q=q, m=m), also=[q], answers="a",'
         ' mistakes=[mistake("Slip.", momentum(p, m, v), instead=["Two", "Three"])])', "or a list of them"),
        ('unknowns("gamma")', "gamma is a function in formulas; call the unknown gamma_1"),
        ('step(p, "Here.", momentum(p, m, v), answers="a", routes=[route("Other.", momentum(p, m, q))])', "q is neither given"),
        ('step((p, q), "Here.", momentum(p, m, v), momentum(q, m, v), answers="a")',
         "part a asks for one number, but p, q is found"),
        ('step(p, "Here.", momentum(p, m, v))', "answers no part a"),
        ('step(p, "Here.", momentum(p, m, v), answers="b")', "answers part b, which cart.md does not have"),
        ('GOOD, step(q, "Again.", momentum(q, m, v), answers="a")', "answers part a more than once"),
        ('choice("a", "Here.", a=True)', "part a is .value; answer it with step(…)"),
        ('explain("a", "Rubric.", answer="Here.")', "part a is .value; answer it with step(…)"),
        ('GOOD, None', "holds a NoneType, which is not an entry"),
        ('GOOD, printed("b", "1", "(1)")', "answers part b"),
        ('GOOD, printed("a", "1; 2", "(1)")', "part a has 1 numbers, but '1; 2' gives 2"),
        ('simulated(p, "Here.", scene="cradle", settings={}, observe="velocities")', "a simulated find must answer a part"),
        ('simulated(p, "Here.", scene="pool", settings={}, observe="velocities", answers="a")', "there is no scene pool"),
        ('simulated(p, "Here.", scene="cradle", settings={"M": m}, observe="velocities", answers="a")', "no setting M"),
        ('optimum(p, "Here.", of=m*q, over=v, between=(0, 1), answers="a")', "q has no value here"),
        ('optimum(p, "Here.", of=(v - m)**2, over=v, between=(0, m + 1), answers="a", largest=False)',
         "the answer is not in kg m/s, it is"),
    ],
)  # fmt: skip
def test_a_step_that_will_not_do(refused, body, words):
    line, sentence = refused(f"return derivation({body.replace('GOOD', GOOD)})")
    assert words in sentence
    assert line in {6, 8}  # derive itself, where the fault is of the whole, or the line of the entry


WHICH = "## Which? {#a .choice}\n\n- (a) one\n- (b) two\n"


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ('choice("a", "So.", a=v > 2)', "its options are a, b; give a condition for each of them"),
        ('choice("a", "So.", a=v > 2, b=v <= 2, c=False)', "its options are a, b"),
        ('choice("a", "So.", a=sympy.Piecewise((v, m > 1)) > 2, b=True)', "Piecewise"),
        ('step(p, "So.", momentum(p, m, v), answers="a")', "part a is .choice; answer it with choice(…)"),
    ],
)
def test_a_choice_that_will_not_do(refused, body, words):
    line, sentence = refused(f"return derivation({body})", asks=WHICH)
    assert words in sentence
    assert line == 8


def test_a_choice_that_follows_from_a_find(solved):
    found = solved(
        """
        return derivation(step(p, "First.", momentum(p, m, v)), choice("a", "So.", a=p > 1, b=p <= 1))""",
        asks=WHICH,
    )
    assert written(found.choices["a"]) == {"a": [["m*v > 1"]], "b": [["m*v <= 1"]]}


def written(choice):
    return {letter: [[text(one) for one in way] for way in ways] for letter, ways in choice.options.items()}


@pytest.mark.parametrize(
    ("a", "b", "first", "second"),
    [
        ("And(p > 1, p < 3)", "Or(p <= 1, p >= 3)", 2, 1),
        ("Not(Or(p <= 1, p >= 3))", "Not(And(p > 1, p < 3))", 2, 1),
        ("Xor(p > 1, p >= 3)", "Not(Xor(p > 1, p >= 3))", 2, 1),
        ("Or(p > 1, p <= 1)", "False", 2, None),
    ],
)
def test_options_of_several_relations(solved, a, b, first, second):
    """Whatever joins them, the option that holds is the one that Python's own arithmetic finds."""
    found = solved(
        f"""
        from sympy import And, Not, Or, Xor
        return derivation(step(p, "First.", momentum(p, m, v)), choice("a", "So.", a={a}, b={b}))""",
        asks=WHICH,
    )
    options = found.choices["a"].options
    for value, right in ((first, "a"), (second, "b")):
        if value is not None:
            givens = {"m": RationalPi(Fraction(value)), "v": RationalPi(Fraction(1))}
            assert option_that_holds(options, givens, "a") == right
    if second is not None:
        assert (
            option_that_holds(options, {"m": RationalPi(Fraction(4)), "v": RationalPi(Fraction(1))}, "a")
            == "b"
        )


def test_an_example_counts_what_stays_free(refused, solved):
    body = """
        a, b = unknowns("a b")
        return derivation(example("a", (a, b), "One law, two unknowns.",
            conservation_of_momentum(before=[(m, v)], after=[(m, a), (m, b)]), free={free}, scale=v))"""
    asks = '## E {#a .example unit="m/s" components="A B"}\n'
    line, sentence = refused(body.format(free=0), asks=asks)
    assert (line, sentence) == (9, "part a: 1 laws for 2 unknowns leave 1 free, not 0")
    truth = solved(body.format(free=1), asks=asks).examples["a"]
    givens = {"v": RationalPi(Fraction(3)), "m": RationalPi(Fraction(1, 2)), "t": RationalPi(Fraction(1))}
    assert truth.instance is not None
    assert float(sum(evaluate(tree, givens, 64) for tree in truth.instance)) == 3.0


def test_routes_and_mistakes_are_rules_of_their_own(solved):
    found = solved(
        """
        return derivation(
            step(p, "First.", momentum(p, m, v)),
            step(F, "Per time.", mean_force(F, p, t), answers="a",
                 routes=[route("At once.", law("Force", "F = m*v/t", F=F, m=m, v=v, t=t))],
                 mistakes=[mistake("You multiplied.", law("Force", "F = p*t", F=F, p=p, t=t))]))
        """,
        asks='## Force {#a .value unit="N"}\n?\n',
    ).answer("a")
    assert found is not None
    (way,), (wrong,) = found.routes, found.mistakes
    assert way.stated.because == "At once."
    assert isinstance(way.rule, ClosedForms)
    assert isinstance(wrong.rule, ClosedForms)
    assert [text(tree) for tree in (*way.rule.trees, *wrong.rule.trees)] == ["m*v/t", "p*t"]


def test_a_mistake_may_have_a_root_that_where_excludes(solved):
    find = solved("""
        return derivation(step(p, "Up.", law("Root", "p^2 = m^2*v^2", p=p, m=m, v=v), where=p > 0, answers="a",
            mistakes=[mistake("Wrong sign.", law("Root", "p = -m*v", p=p, m=m, v=v))]))""").answer("a")
    assert find is not None
    (wrong,) = find.mistakes
    assert isinstance(wrong.rule, ClosedForms)
    assert text(wrong.rule.trees[0]) == "-m*v"


def test_unknowns_nobody_asks_for(solved):
    found = solved("""
        return derivation(step(p, "With q.", momentum(p, q, v), law("Two", "q = 2*m", q=q, m=m), also=[q], answers="a"))""")
    assert closed(found, "a") == ["2*m*v"]
    assert [find.names for find in found.unknowns] == [("p",)]


@pytest.mark.parametrize(
    ("of", "between", "largest", "answer", "words"),
    [
        ("m*x*(2 - x)*v", "(0, 3)", True, "1", "the slope vanishes there"),
        ("m*x*(2 - x)*v", "(0, 3)", False, "3", "an end of the range"),
        ("m*x*(2 - x)*v", "(2, 3)", True, "2", "an end of the range"),
        ("v*sympy.sin(x)", "(0, HALF_PI)", True, "pi/2", "the slope vanishes there"),
        ("(x - m)**2", "(0, 2)", False, "m", "the slope vanishes there"),
    ],
)
def test_an_optimum(solved, of, between, largest, answer, words):
    front = "code: X1.1\ntitle: A\ngiven:\n  m: {is: m, value: 0.5, from: 0.1, to: 0.9, step: 0.1}\n"
    front += "  v: {is: v, value: 3, from: 1, to: 5, step: 1}\n"
    whole = f"""\
from corollary.author import *
import sympy
def derive(m, v):
    x, best = unknowns("x best")
    return derivation(optimum(best, "The best.", of={of}, over=x, between={between}, largest={largest}, answers="a"))
"""
    found = solved(whole=whole, front=front, asks="## Best {#a .value}\n")
    assert closed(found, "a") == [answer]
    assert words in found.unknowns[0].note.spoken()


def test_an_optimum_that_moves_with_the_givens(refused):
    line, sentence = refused(
        'return derivation(optimum(p, "Best.", of=(q - 1)*(v - 2.5), over=q, between=(0, 3), answers="a"))',
        asks="## Best {#a .value}\n",
    )
    assert line == 8
    assert "moves from" in sentence


def test_an_error_names_the_line_of_the_step_at_fault(refused):
    """Even where the same words stand above, and where what is wrong is one mistake or one route of the step."""
    body = """
        twice = step(p, "The same words.", momentum(p, m, v))
        return derivation(
            twice,
            step(q, "The same words.",
                 momentum(q, m, {law}),
                 answers="a",
                 mistakes=[
                     mistake("Half of it.", momentum(q, m, {mistake})),
                 ],
                 routes=[
                     route("At once.", momentum(q, m, {route})),
                 ]))
        """
    right = {"law": "v", "mistake": "v/2", "route": "v"}
    for place, line in (("law", 11), ("mistake", 15), ("route", 18)):
        at, sentence = refused(body.format(**(right | {place: "F"})))
        named = "the mistake 'Half of it.': " if place == "mistake" else ""
        assert sentence == f"part a: {named}Momentum: F is neither given nor found before"
        assert at == line


def test_a_word_spoken_by_a_function_stands_where_the_function_speaks_it(refused):
    line, _ = refused("""
        def found(symbol):
            return step(symbol, "Here.", momentum(symbol, m, F), answers="a")
        return derivation(found(p))""")
    assert line == 9


def test_a_circuit_of_two_loops_is_one_step(solved):
    """Three currents from a node and two loops; with 3 V and 0.5, 2 and 2 ohm the first is 2 A, and the others share it."""
    found = solved(
        """
        I1, I2, I3 = unknowns("I1 I2 I3")
        return derivation(step((I1, I2, I3), "Kirchhoff.", law("Node", "I1 = I2 + I3"),
            law("First loop", "v*m/m = m*I1*t/t + t*I2*m/m"), law("Second loop", "t*I2 = t*I3"), answers="a"))
        """,
        asks='## Currents {#a .vector unit="1" components="1 2 3"}\n?\n',
        front=FRONT.replace("unit: kg", 'unit: "1"')
        .replace("unit: m/s", 'unit: "1"')
        .replace("unit: s", 'unit: "1"'),
    )
    givens = {name: RationalPi(Fraction(number)) for name, number in (("m", "1/2"), ("v", "3"), ("t", "2"))}
    assert [float(evaluate(tree, givens, 60)) for tree in found.answer("a").in_givens] == [2, 1, 1]


def test_a_choice_knows_what_laws_needed_besides(solved, refused):
    asks = ASKS + "\n## Which? {#b .choice}\n?\n\n- (A) one\n- (B) other\n"
    step = 'step(p, "Both.", law("One", "p = q"), law("Two", "q = m*v"), also=[q], answers="a")'
    found = solved(f'return derivation({step}, choice("b", "So.", a=q > m*t, b=q <= m*t))', asks=asks)
    assert written(found.choices["b"]) == {"a": [["m*v > m*t"]], "b": [["m*v <= m*t"]]}
    assert refused(f'return derivation({step}, choice("b", "So.", a=F > 0, b=F < 0))', asks=asks) == (
        8,
        "part b: option a: F is neither given nor derived before",
    )


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ('step((p, q), "?", law("A", "p = q"), law("B", "q = m*v"), answers="a")', r"goes into also"),
        (
            'step(p, "?", law("A", "p^2 = -m*m*v*v"), answers="a")',
            "no p satisfies|is not real for every value",
        ),
        ('step(p, "?", law("A", "p^2 = m^2*v^2 - 3 kg"), answers="a")', "make 3 kg a given of the problem"),
        ('step(p, "?", law("A", "(p, q) = (m, v)"), answers="a")', "one law for each component"),
        (
            'step(p, "?", law("A", "p = m*v"), answers="a", mistakes=[upside_down(law("A", "p = m*v"))])',
            "as a text",
        ),
        (
            'step(p, "?", law("A", "m*v = sin(p/(m*v)) + 2"), answers="a")',
            "no root is left: p = .* is not real for .*narrow",
        ),
    ],
)
def test_what_a_new_author_runs_into_says_what_to_do(refused, body, words):
    _line, sentence = refused(
        "from corollary.misconceptions import upside_down\nreturn derivation(" + body + ")"
    )
    assert re.search(words, sentence), sentence
    assert "$" not in sentence


def test_a_formula_with_a_unit_says_how_to_ask_for_it(refused):
    _line, sentence = refused(
        'return derivation(step(p, "?", law("A", "p = m*v"), answers="a"))',
        asks="## Momentum {#a .expression}\n?\n",
    )
    assert sentence.endswith('say unit="kg m/s" in its heading')


ANGLE = '## Angle {#a .value unit="deg" points=1}\nWhich?\n'
WITH_ENDS = """\
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}
  v: {is: number, value: 1, from: -2, to: 2, step: 1}
  t: {is: time, value: 2, from: 1, to: 4, step: 1, unit: s}
"""


def step_for(equation: str, where: str) -> str:
    return (
        f'return derivation(step(q, "At the end.", law("Angle", "{equation}"), where={where}, answers="a"))'
    )


@pytest.mark.parametrize(
    ("equation", "where", "right"),
    [
        ("cos(q) = v/2", "sympy.And(q >= 0, q <= sympy.pi)", "acos(v/2)"),
        ("sin(q) = v/2", "sympy.And(q >= -sympy.pi/2, q <= sympy.pi/2)", "asin(v/2)"),
        ("q^2 = (v + 2)^2", "q >= 0", "v + 2"),
    ],
)
def test_a_root_may_lie_on_the_end_of_where_it_is_looked_for(solved, equation, where, right):
    found = solved(step_for(equation, where), asks=ANGLE, front=WITH_ENDS)
    assert closed(found, "a")[0] == right


def test_a_root_that_leaves_where_it_is_looked_for_is_still_refused(refused):
    inside = step_for("cos(q) = v/2", "sympy.And(q >= 0, q < sympy.pi)")
    _line, sentence = refused(inside, asks=ANGLE, front=WITH_ENDS)
    assert "holds for q = acos" in sentence


def test_a_cubic_with_one_real_root(solved):
    found = solved(
        'return derivation(step(q, "Cubic.", law("Cubic", "q^3 + m^2*q = (m*v)^3"), answers="a"))',
        asks='## Mass {#a .value unit="kg"}\n?\n',
        front=WITH_ENDS.replace("from: -2, to: 2", "from: 1, to: 3") + "require:\n  - m > 0\n  - v > 0\n",
    )
    (root,) = found.answer("a").in_givens
    ball = evaluate(root, {"m": RationalPi(Fraction(1)), "v": RationalPi(Fraction(2))}, 100)
    value = float(ball.mid())
    assert value**3 + value == pytest.approx(8)
