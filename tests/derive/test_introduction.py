"""A worked solution says what its letters stand for, those that occur in it and no others."""

from __future__ import annotations

from tests.derive.conftest import ASKS, FRONT

from corollary.derive.cache import solution_of
from corollary.derive.introduced_letters import introduced, unexplained
from corollary.grading.solutions import Solutions
from corollary.messages import language
from corollary.problem.bank import find
from corollary.problem.variant import chapter

STEPS = 'return derivation(step(p, "Mass times velocity.", momentum(p, m, v), answers="a"))'


def test_the_givens_that_occur_are_named(solved):
    solution = solved(STEPS)
    assert introduced(solution.unknowns, solution.problem) == ["*Letters:* $m$ (mass), $v$ (speed).", ""]
    with language("de"):
        assert introduced(solution.unknowns, solution.problem)[0].startswith("*Buchstaben:* $m$ (")


def test_a_given_that_stands_in_no_law_but_in_what_it_comes_to_is_named(solved):
    found = solved('return derivation(step(p, "So.", law("Two", "p = 2*q", q=m*v), answers="a"))')
    assert introduced(found.unknowns, found.problem)[0] == "*Letters:* $m$ (mass), $v$ (speed)."


def test_a_constant_of_nature_has_a_line_of_its_own(solved):
    found = solved(
        'c = sympy.Symbol("c", positive=True)\nreturn derivation(step(F, "So.", law("Energy", "F = m*c^2", c=c), answers="a"))',
        front=FRONT.replace("require:", "constants: [c]\nrequire:"),
        asks=ASKS.replace("kg*m/s", "J"),
    )
    assert introduced(found.unknowns, found.problem)[0] == "*Letters:* $m$ (mass)."


PULLED = """
    N, T, p = unknowns("N", T="tension of the rope", p="momentum at last")
    return derivation(
        step(N, "The floor carries it.", law("Floor", "2*N = 2*m*v/t")),
        step(q, "It is pulled.", law("Rope", "q = T*t"), law("Pull", "T = N"), also=[T]),
        step(p, "So it goes on.", law("Momentum", "p = q + m*v"), answers="a"),
    )
"""


def told(bank, code="X1.1"):
    return Solutions(bank).worked_solution(chapter(find(bank, code)))


def test_each_letter_is_introduced_where_it_is_first_met(make):
    text = told(make(PULLED))
    first, second, third = (
        text.index("**First find $N$.**"),
        text.index("**First find $q$.**"),
        text.index("### (a)"),
    )
    assert text.count("tension of the rope") == 1
    assert second < text.index("*Letters:* $T$ (tension of the rope).") < third
    assert text[third:].startswith("### (a) Momentum: $p$\n\n*Letters:* $p$ (momentum at last).\n")
    assert first < second


def test_what_is_found_on_the_way_has_its_meaning_behind_it(make):
    text = told(make(PULLED.replace('"N", T=', 'N="normal force", T=')))
    assert "**First find $N$ (normal force).**" in text
    assert text.count("normal force") == 1


def test_a_meaning_is_read_in_the_language_of_the_reader(make):
    bank = make(PULLED)
    beside = find(bank, "X1.1").path.with_suffix(".de.md")
    beside.write_text(
        "---\ntitle: Ein Wagen\n---\n# Texts\n\n> tension of the rope\ndie Seilkraft\n", encoding="utf-8"
    )
    with language("de"):
        assert "*Buchstaben:* $T$ (die Seilkraft)." in told(bank)


def test_components_of_a_vector_have_it_said_once(make):
    steps = """
        J = vector("J", meaning="impulse of the cart")
        return derivation(
            step(J, "Both.", law("Impulse", "J = w", w=(m*v, 2*m*v))),
            step(p, "One.", law("Momentum", "p = w", w=J[0]), answers="a"),
        )"""
    assert "**First find $J_{x}$, $J_{y}$ (impulse of the cart).**" in told(make(steps))


def test_meanings_are_kept_with_what_is_solved(make):
    bank = make(PULLED)
    problem = find(bank, "X1.1")
    assert solution_of(bank, problem).meanings == solution_of(bank, problem).meanings
    assert solution_of(bank, problem).meanings["T"] == "tension of the rope"


def test_a_letter_that_nothing_introduces_is_found(solved):
    assert [letter for _line, letter in unexplained(solved(PULLED))] == ["N"]
    # q stands alone on the left of its law, p is asked for, T is explained
    assert not list(unexplained(solved(PULLED.replace('"N", T=', 'N="normal force", T='))))


def test_a_letter_asked_for_later_is_not_introduced_by_that(solved):
    steps = """
        a = unknown("a")
        return derivation(
            step(q, "Both.", law("Pull", "2*q = F*t"), law("Rope", "2*F = m*a"), law("Rise", "a*t = v"), also=[F, a]),
            step(p, "So.", law("Momentum", "p = q"), answers="a"),
        )"""
    assert [letter for _line, letter in unexplained(solved(steps))] == ["F", "a", "q"]


def test_a_meaning_is_a_text(refused):
    line, sentence = refused(PULLED.replace('"N", T=', "N=3, T="))
    assert (line, sentence) == (
        8,
        "derive fails: TypeError: what N stands for is a text for the reader, not 3",
    )
