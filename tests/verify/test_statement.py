"""What a statement must say, and must not: planted in a problem that holds."""

from __future__ import annotations

import re

import pytest

from corollary.verify.checked import Checked

ASKED = '## Momentum {#a .value unit="kg*m/s"}\nHow large?'
TOLD = [
    ("How large is {{m*v}}?", ""),
    ("How large? Round {{m*v|3}}.", ""),
    ("How large? It is {{m*v in g*m/s}}.", ""),
    ("How large? Use $p = m v$.", "p = m v"),
    ("How large? Use `v*m`.", "v*m"),
    ("How large? Use $\\frac{m v^2}{v}$.", "frac"),
]
NOT_TOLD = [
    "How large? It is not $m v^2$.",
    "How large? Think of {{2*m*v}}.",
    "How large? The mass is {{m in g}}.",
]
STATED = "A cart of {{m}} and {{v}} is pushed for {{t}}."


def with_text(problem: str, text: str, statement: str = STATED) -> str:
    return problem.replace("A cart. It is of {{m}}, and has {{v}} after {{t}}.", statement).replace(
        ASKED, ASKED.replace("How large?", text)
    )


def of_statement(checked: Checked) -> list[str]:
    return [
        each
        for each in (*checked.complaints, *checked.notes)
        if "tells the answer" in each or "in the text" in each or "without its unit" in each
    ]


@pytest.mark.parametrize(("text", "told"), TOLD)
def test_an_answer_told_is_found_with_its_part(verified, problem, text, told):
    checked = verified(problem=with_text(problem, text))
    found = of_statement(checked)
    assert found
    assert checked.ok == bool(told)  # a formula leaves the number to be worked out
    assert all(each.startswith("cart.md:13: the statement tells the answer to part a: ") for each in found)
    assert told in found[0]


@pytest.mark.parametrize("text", NOT_TOLD)
def test_what_is_no_answer_is_none(verified, problem, text):
    checked = verified(problem=with_text(problem, text))
    assert checked.ok, checked.complaints
    assert checked.checks["statement"] == 5


def test_an_answer_in_the_figure(verified, problem):
    drawn = problem.replace(
        "require:", 'figure: |\n  floor\n  ball a at=0,0 "p = {{m*v}}"\nalt: A cart.\nrequire:'
    )
    found = of_statement(verified(problem=with_text(drawn, "How large?")))
    assert found
    assert all("the figure tells the answer to part a" in each for each in found)


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("A cart of {{m}} and {{v}} is pushed.", r"cart\.md:7: the given t \(\d\ss\) is not in the text"),
        ("A cart of {{m|number}} and {{v}}, for {{t}}.", ""),
        ("A cart of {{m in g}} and {{v}}, for {{t}}.", ""),
    ],
)
def test_a_given_that_is_not_there(verified, problem, statement, words):
    found = of_statement(verified(problem=with_text(problem, "How large?", statement)))
    assert any(re.match(words, each) for each in found) if words else not found
