"""Every hole, list and choice of words that the page of the problem file shows is read and filled."""

from __future__ import annotations

import re
from pathlib import Path

from corollary.problem.reader import read_problem
from corollary.problem.statement import filled
from corollary.problem.variant import at, size

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "problem_file.md").read_text(encoding="utf-8")
SECTION = PAGE.partition("- **Lists and words.**")[2].partition("\n## Units")[0]


def test_what_the_page_shows(tmp_path):
    rows = re.findall(r"`(\w+: \{is: .*?\})`", SECTION)
    holes = set(re.findall(r"\{\{[^{}]+\}\}", SECTION))
    assert len(rows) == 2
    assert {"{{2*m}}", "{{m in g}}", "{{m*v|3}}"} <= holes
    rows += ["v: {is: speed, value: 3, unit: m/s}", "dx: {is: way, value: 0.7, unit: m}"]
    path = tmp_path / "page.md"
    given = "".join(f"  {row}\n" for row in rows)
    part = '## Mass {#a .value unit="kg"}\nHow large?\n'
    path.write_text(
        f"---\ncode: P1\ntitle: A page\ngiven:\n{given}---\n{' '.join(sorted(holes))} {{{{body}}}}\n\n{part}"
    )
    problem = read_problem(path)
    assert size(problem) == 6
    texts = {filled(problem.statement, at(problem, index)) for index in range(6)}
    assert len(texts) == 6
    assert not any("{{" in text for text in texts)
    assert sum("a sledge" in text for text in texts) == 3
