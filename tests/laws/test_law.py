"""A law: the textbook's equation kept as it is, and a meaning for every letter of it."""

from __future__ import annotations

import inspect
import sys
from pathlib import Path

import pytest
import sympy

import corollary.laws as laws
from corollary.formula.ast import names
from corollary.formula.errors import ParseError
from corollary.formula.functions import FUNCTIONS
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula
from corollary.laws import Law, law
from corollary.laws.law import component, sides, symbols
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import Dimension, unit

m, v, p, t, x, y = sympy.symbols("m v p t x y", real=True)


@pytest.mark.parametrize(
    ("meaning", "exactly"),
    [(273.15, sympy.Rational(27315, 100)), (0.1 * x, x / 10), (1e-7, sympy.Rational(1, 10**7))],
)
def test_a_decimal_number_of_an_author_is_exact(meaning, exactly):
    ((_left, right),) = sides(law("Shift", "p = t + T_0", p=p, t=t, T_0=meaning))
    assert right - t == exactly


def test_the_textbook_form_is_kept():
    stated = law("Momentum", "p = m*v + 0*v - m*v", p=p, m=m, v=v)
    assert text(stated.textbook) == "p = m*v + 0*v - m*v"
    ((left, right),) = sides(stated)
    assert left == p
    assert sympy.expand(right) == 0  # sympy may simplify; the textbook's form does not change
    assert text(stated.textbook) == "p = m*v + 0*v - m*v"


def test_letters_mean_what_is_said():
    stated = law("Momentum", "p = m*v", p=0, m=2 * m, v=v - 1)
    assert sides(stated) == [(sympy.Integer(0), 2 * m * (v - 1))]
    assert symbols(stated) == {m, v}


def test_pi_is_no_letter():
    stated = law("Half a period", "T = pi*sqrt(m/k)", T=t, m=m, k=x)
    ((_, right),) = sides(stated)
    assert right == sympy.pi * sympy.sqrt(m / x)
    assert symbols(stated) == {t, m, x}


def test_a_vector_law_is_a_law_for_each_component():
    stated = law("Momentum", "p = m*v", p=(x, y), m=m, v=(v, 0))
    assert stated.components == 2
    assert stated.vectors == {"p", "v"}
    assert sides(stated) == [(x, m * v), (y, 0)]
    assert component(stated, 1) == {"p": y, "m": m, "v": 0}


@pytest.mark.parametrize(
    ("formula", "letters", "words"),
    [
        ("p = m*v", {"p": p, "m": m}, "what does v mean in 'p = m\\*v'"),
        ("p = m*v", {"p": p}, "what does m, v mean"),
        ("p = m*v", {"p": p, "m": m, "v": v, "t": t}, "t does not occur in 'p = m\\*v'"),
        ("p = m*v", {"p": (x, y), "m": m, "v": (v, v, v)}, "different numbers of components"),
        ("m*v", {"m": m, "v": v}, "has no = sign"),
        ("m < v", {"m": m, "v": v}, "has no = sign"),
        ("p = m v", {"p": p, "m": m, "v": v}, "formula 'p = m v'"),
        ("p = ", {"p": p}, "formula 'p = '"),
    ],
)
def test_a_law_that_will_not_do(formula, letters, words):
    with pytest.raises(ValueError, match=words):
        law("A law", formula, **letters)


def test_every_function_of_the_list_has_its_meaning():
    for name, row in FUNCTIONS.items():
        count = row.arity
        arguments = ", ".join(["a", "b"][:count])
        stated = law(
            "Any",
            f"c = {name}({arguments})",
            c=x,
            **{letter: sympy.Rational(1, 2) for letter in ["a", "b"][:count]},
        )
        ((_, right),) = sides(stated)
        assert right.is_number


KG, MS, NEWTON, JOULE = (unit(each).dimension for each in ("kg", "m/s", "N", "J"))
PEE, SECOND, METRE, NOTHING = (unit(each).dimension for each in ("kg*m/s", "s", "m", "1"))
STATED: list[tuple[Law, dict[str, Dimension]]] = []


def stated(made: Law, **dimensions: Dimension) -> None:
    STATED.append((made, dimensions))


a, b, c, d, e = sympy.symbols("a b c d e")
stated(laws.momentum(a, b, c), p=PEE, m=KG, v=MS)
stated(laws.change_of_momentum(a, b, before=c, after=d), dp=PEE, m=KG, v_0=MS, v_1=MS)
stated(laws.conservation_of_momentum(before=[(a, b), (c, 0)], after=[(a, d), (c, e)]),
       m_A=KG, m_B=KG, v_A0=MS, v_B0=MS, v_A1=MS, v_B1=MS)  # fmt: skip
stated(laws.sticking(before=[(a, b), (c, d)], together=e), m_A=KG, m_B=KG, v_A0=MS, v_B0=MS, v_1=MS)
stated(laws.total_momentum(a, [(b, c), (d, e)]), P=PEE, m_1=KG, v_1=MS, m_2=KG, v_2=MS)
stated(laws.external_impulse(a, before=b, after=c), J=PEE, P_0=PEE, P_1=PEE)
stated(laws.magnitude(a, (b, c)), p=PEE, p_x=PEE, p_y=PEE)
stated(laws.impulse_momentum(a, b), J=PEE, dp=PEE)
stated(laws.mean_force(a, b, c), F=NEWTON, J=PEE, dt=SECOND)
stated(laws.third_law(a, b), J_AB=NEWTON, J_BA=NEWTON)
stated(laws.impulse_of_constant_force(a, b, c), J=PEE, F=NEWTON, dt=SECOND)
stated(laws.force_on_standing(a, b, c, d), F=NEWTON, N=NEWTON, m=KG, g=MS / SECOND)
stated(laws.direction(a, (b, c)), beta=NOTHING, J_x=PEE, J_y=PEE)
stated(laws.kinetic_energy(a, b, c), K=JOULE, m=KG, v=MS)
stated(
    laws.change_of_kinetic_energy(a, before=[(b, c)], after=[(b, d)]),
    dK=JOULE,
    m_0=KG,
    m_1=KG,
    v_0=MS,
    v_1=MS,
)
stated(laws.change_of_kinetic_energy_in_plane(a, before=[(b, (c, d))], after=[(b, (e, 0))]),
       dK=JOULE, m_A=KG, v_Ax0=MS, v_Ay0=MS, v_Ax1=MS, v_Ay1=MS)  # fmt: skip
stated(laws.falling(a, b, c), v=MS, g=MS / SECOND, h=METRE)
stated(
    laws.elastic(before=[(a, b), (c, 0)], after=[(a, d), (c, e)]),
    m_A=KG,
    m_B=KG,
    v_A0=MS,
    v_B0=MS,
    v_A1=MS,
    v_B1=MS,
)
stated(laws.sliding_to_rest(m=a, v=b, mu=c, N=d, d=e), m=KG, v=MS, mu=NOTHING, N=NEWTON, d=METRE)
stated(laws.spring_at_rest(m=a, v=b, k=c, x=d), m=KG, v=MS, k=NEWTON / METRE, x=METRE)
stated(
    laws.energy_at_heights(a, before=(b, c), after=(d, e)),
    g=MS / SECOND,
    v_0=MS,
    v_1=MS,
    y_0=METRE,
    y_1=METRE,
)
stated(laws.work_of_net_force(a, b, c, before=d, after=e), F=NEWTON, s=METRE, m=KG, v_0=MS, v_1=MS)
stated(laws.restitution(a, A=(b, c), B=(d, e)), r=NOTHING, v_A0=MS, v_A1=MS, v_B0=MS, v_B1=MS)
stated(laws.reduced_mass(a, b, c), mu=KG, m_A=KG, m_B=KG)
stated(laws.half_oscillation(a, b, c), T=SECOND, m=KG, k=NEWTON / METRE)
stated(laws.level_floor(a, b, c), N=NEWTON, m=KG, g=MS / SECOND)
stated(laws.same(a, b), x=NEWTON, y=NEWTON)


@pytest.mark.parametrize(("made", "dimensions"), STATED, ids=[text(made.textbook) for made, _ in STATED])
def test_both_sides_of_a_law_measure_the_same(made, dimensions):
    assert names(made.textbook) - {"pi"} == dimensions.keys() == made.letters.keys()
    found = dimension_of(made.textbook, dimensions)
    assert not isinstance(found, ParseError)


@pytest.mark.parametrize(("made", "dimensions"), STATED, ids=[text(made.textbook) for made, _ in STATED])
def test_a_law_reads_back_as_it_is_written(made, dimensions):
    assert author_formula(text(made.textbook)) == made.textbook


def test_the_impulse_of_a_pulse_is_its_area():
    """A triangle of height F and width 2T, by hand: F T."""
    F, T = sympy.symbols("F T", positive=True)
    made = laws.impulse_of(p, t, (F * t / T, 0, T), (F * (2 - t / T), T, 2 * T))
    ((left, right),) = sides(made)
    assert left == p
    assert sympy.simplify(right - F * T) == 0


def test_a_body_that_comes_to_be_has_a_mass_of_its_own():
    made = laws.conservation_of_momentum(before=[(a + b, 0)], after=[(a, c), (b, d)])
    assert text(made.textbook) == "m_A0*v_A0 = m_A1*v_A1 + m_B1*v_B1"
    assert sides(made) == [(0, a * c + b * d)]


OWN = sorted(set(laws.__all__) - {"Law", "law", "wrong"})


@pytest.mark.parametrize("name", OWN)
def test_every_law_says_its_equation_and_is_tested_here(name):
    """The equation a law's description gives is the one it states; where the sum is as long as the list, it has an ellipsis."""
    made = getattr(laws, name)
    about, source = inspect.getdoc(made), inspect.getsource(made)
    assert about
    equations = [part for part in about.split("`")[1::2] if "=" in part]
    assert equations or "law(" not in source
    assert all(
        f'"{equation}"' in source or "…" in equation or "+ (1 + 18" in equation for equation in equations
    )
    tests = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("test_*.py"))
    assert f"{name}(" in tests


HEAT = """
from corollary.laws import law
def heat(Q, m, c, dT):
    return law("Heat", "Q = c*m*dT", Q=Q, m=m, c=c, dT=dT)
def momentum(p):
    return None
"""


def test_laws_of_an_installed_package_are_found_under_ours(installed):
    installed("warmth", {"corollary.laws": ["warmth = warm"]}, {"warm.py": HEAT})
    laws._plugged_in.cache_clear()
    try:
        from corollary.laws import heat, momentum

        assert text(heat(p, m, x, t).textbook) == "Q = c*m*dT"
        assert momentum is sys.modules["corollary.laws.momentum"].momentum  # ours is not replaced
        with pytest.raises(ImportError, match="cannot import name 'entropy'"):
            from corollary.laws import entropy  # noqa: F401
        installed("winter", {"corollary.laws": ["winter = cold"]}, {"cold.py": HEAT})
        laws._plugged_in.cache_clear()
        with pytest.raises(ImportError, match=r"the law heat is in both (warm and cold|cold and warm)"):
            laws.chill  # noqa: B018
    finally:
        laws._plugged_in.cache_clear()
