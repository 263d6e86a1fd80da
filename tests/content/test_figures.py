"""The words in the bank's figures can be read: none lies on another, none leaves the drawing, whatever the numbers are."""

from __future__ import annotations

import pytest
from tests.chapter_problems import PROBLEMS

from corollary.notebook.worksheet import exercise
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter
from corollary.render.page import drawing

pytestmark = pytest.mark.browser
ILLEGIBLE = """
() => {
  const svg = document.querySelector("svg"), view = svg.viewBox.baseVal, found = [];
  const toDrawing = svg.getScreenCTM().inverse();
  const words = [...svg.querySelectorAll("text")].map(each => {  // boxes in the drawing's units, whatever group they are in
    const box = each.getBBox(), shift = toDrawing.multiply(each.getScreenCTM());
    return [each.textContent.trim(), {x: box.x + shift.e, y: box.y + shift.f, width: box.width, height: box.height}];
  });
  const beyond = (low, size, start, length) => Math.max(start - low, low + size - start - length);
  const shared = (a, b, size, start) => Math.min(a[start] + a[size], b[start] + b[size]) - Math.max(a[start], b[start]);
  words.forEach(([text, box], at) => {
    if (Math.max(beyond(box.x, box.width, view.x, view.width), beyond(box.y, box.height, view.y, view.height)) > 1)
      found.push(`${text} leaves the drawing`);
    for (const [other, its] of words.slice(0, at))
      if (shared(box, its, "width", "x") > 1 && shared(box, its, "height", "y") > box.height / 4)
        found.push(`${text} lies on ${other}`);
  });
  return found;
}
"""


@pytest.mark.parametrize("problem", [each for each in PROBLEMS if each.figure], ids=lambda each: each.code)
def test_words_of_a_figure_can_be_read(problem, chromium):
    page = chromium.new_page()
    for variant in (chapter(problem), *sample(problem, 5, salt="figures")):
        page.set_content(f"<body style='font-family: DejaVu Sans'>{drawing(exercise(variant))}</body>")
        assert page.evaluate(ILLEGIBLE) == []
    page.close()
