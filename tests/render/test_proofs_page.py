"""The page about what was verified: each problem with its obligations, its derivation and its plots, and nothing fetched."""

from __future__ import annotations

from corollary.problem.bank import find, open_bank
from corollary.render.proofs_page import write_report
from corollary.verify.verify import verify


def test_the_page_has_all_of_it(tmp_path):
    bank = open_bank(None)
    problem = find(bank, "X12.4")
    checked = verify(bank, problem, 5)
    write_report(tmp_path / "page.html", [(bank, problem)], [checked])
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert f"{problem.code} {problem.title}" in text
    assert text.count("<td>proven</td>") == len(checked.obligations) > 5
    assert "The answer to part a of X12.4, one given moved over its range" in text
    assert text.count("data:image/svg+xml;base64,") == 1
    assert "<math" in text
    assert 'src="http' not in text


def test_a_problem_with_a_fault_has_its_complaint_on_top(tmp_path):
    (tmp_path / "problems" / "carts").mkdir(parents=True)
    (tmp_path / "problems" / "carts" / "cart.md").write_text(
        "---\ncode: X1.1\ntitle: A cart\ngiven:\n  m: {is: mass, value: 2, from: 1, to: 3, step: 1, unit: kg}\n---\nA cart.\n\n"
        '## Mass {#a .value unit="kg"}\nHow large?\n',
        encoding="utf-8",
    )
    bank = open_bank(tmp_path)
    problem = find(bank, "X1.1")
    checked = verify(bank, problem, 5)
    assert not checked.ok
    write_report(tmp_path / "page.html", [(bank, problem)], [checked])
    assert "cart.md: is missing" in (tmp_path / "page.html").read_text(encoding="utf-8")
