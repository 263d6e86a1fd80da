"""Markdown and formulas on a terminal."""

from __future__ import annotations

import pytest

from corollary.render.terminal_text import formula_text, terminal_text


@pytest.mark.parametrize(
    ("latex", "said"),
    [
        (r"\bar F = \frac{m v - m v_0}{\Delta t} = 86\,\mathrm{N}", "F\u0304 = (m v − m v₀)/Δt = 86 N"),
        (r"\sqrt{2gh}", "√(2 g h)"),
        (r"\frac12 m v^2", "1/2 m v²"),
        (r"v_{A,0}\cos\theta", "v_A,0 cos θ"),
        (r"1.2\times10^{-5}\,\mathrm{m/s^2}", "1.2 × 10⁻⁵ m/s²"),
        (r"\int_0^T F\,dt", "∫₀ᵀ F dt"),
        (r"30^\circ", "30°"),
        (r"x = -1", "x = −1"),
        (r"-1, -2", "−1, −2"),
        (r"-x - 2", "−x − 2"),
        (r"F^{\text{net}}", "F^net"),
        (r"\vec p = m\vec v", "p\u20d7 = m v\u20d7"),
        (r"F_x = \frac{\Delta p_x}{\Delta t} \qquad F_y = 0", "F_x = Δp_x/Δt   F_y = 0"),
        (r"\frac{(a+b)(c+d)}{(e+f)}", "((a + b)(c + d))/(e + f)"),
        (r"\frac{\vec J}{2}", "J\u20d7/2"),
        (r"\frac{a", r"\frac{a"),
    ],
)
def test_a_formula_reads_in_a_line(latex, said):
    assert formula_text(latex) == said


def test_paragraphs_are_wrapped_and_lists_and_tables_kept():
    source = "A *long* paragraph on $p = mv$\nand more.\n\n1. one\n2. two\n\n- a\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\n"
    said = "A long paragraph on\np = m v and more.\n\n1. one\n2. two\n\n- a\n\na | b\n1 | 2"
    assert terminal_text(source, width=24) == said


def test_code_and_display_formulas_stand_apart():
    assert (
        terminal_text("so\n\n$$\nF = ma\n$$\n\n```\nx = 1\n  y\n```")
        == "so\n\n    F = m a\n\n    x = 1\n      y"
    )


def test_no_line_is_wider_than_asked():
    lines = terminal_text("- " + "word " * 100 + "\n\n" + "word " * 100, width=40).splitlines()
    assert max(map(len, lines)) <= 40
    assert sum(line.count("word") for line in lines) == 200


def test_the_letters_of_a_unit_stay_together():
    written = terminal_text(
        r"$A\, E = (77\,\mathrm{cm^{2}})\, (2.197\,\mathrm{\mu s})\, (3\,\mathrm{kg\,m})$"
    )
    assert written.replace("\N{GREEK SMALL LETTER MU}", "µ") == "A E = (77 cm²) (2.197 µs) (3 kg m)"
