"""Pictures in a problem's or a set's text, which would not come along: each is refused with its line."""

from __future__ import annotations

import pytest

from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem_set import find_set

from .conftest import BODY, FRONT


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("![](cart.png)", "cart.png"),
        ("See ![a cart](https://example.org/cart.svg) here.", "https://example.org/cart.svg"),
        ("![a cart][photo]", "photo"),
        ('<img src="cart.png">', "<img>"),
        ("<SVG></SVG>", "<SVG>"),
        (f"![](data:image/png;base64,{'A' * 500})", "data:image/png;base64,"),
    ],
)
def test_a_picture_is_refused(complaints, text, name):
    ((line, sentence),) = complaints(FRONT, f"One.\n{text}\n{BODY}")
    assert line == 9
    assert sentence.startswith(f"the picture {name}")
    assert "figure:" in sentence
    assert len(sentence) < 300


def test_what_is_code_or_no_picture_is_left_alone(read):
    text = "Write `![](x.png)`, or n! [see](below).\n\n```\n<img src=1>\n![](y.png)\n```\n"
    assert read(FRONT, text + BODY).statement.startswith("Write")


def test_a_picture_in_the_words_of_a_set_is_refused(write, tmp_path):
    write()
    sets = tmp_path / "problems" / "sets"
    sets.mkdir()
    (sets / "week.md").write_text("---\ntitle: W\nproblems: [X1.1]\n---\nHello.\n![](x.png)\n")
    with pytest.raises(Malformed, match=r"week.md:6: the picture x.png"):
        find_set(Bank(tmp_path), "week")
