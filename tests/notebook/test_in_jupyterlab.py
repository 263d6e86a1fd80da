"""A worksheet in the real JupyterLab: what is drawn can be seen in both of its themes."""

from __future__ import annotations

import io
import json

import pytest
from PIL import Image

from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter

pytestmark = pytest.mark.browser
THEMES = {"JupyterLab Light": (0.9, 1.0), "JupyterLab Dark": (0.0, 0.15)}
"""How bright the page is."""


@pytest.fixture(scope="module")
def lab(tmp_path_factory, jupyter):
    """The address of a JupyterLab with one student's sheet in it, and the folder of its settings."""
    folder = tmp_path_factory.mktemp("lab")
    (folder / "work").mkdir()
    momentum = find_set(chapter_bank(), "momentum_1")
    sheet = worksheet(momentum, Student("ada", "Ada"), [chapter(problem) for problem in momentum.problems])
    (folder / "work" / "sheet.ipynb").write_text(file_text(notebook(sheet)), encoding="utf-8")
    with jupyter("lab", folder / "work", folder) as address:
        yield f"{address}/lab/tree/sheet.ipynb?reset", folder / "JUPYTER_CONFIG_DIR"


@pytest.mark.parametrize("theme", THEMES)
def test_the_figures_are_dark_on_light_in_every_theme(lab, chromium, theme: str):
    address, settings = lab
    chosen = (
        settings
        / "lab"
        / "user-settings"
        / "@jupyterlab"
        / "apputils-extension"
        / "themes.jupyterlab-settings"
    )
    chosen.parent.mkdir(parents=True, exist_ok=True)
    chosen.write_text(json.dumps({"theme": theme}))
    page = chromium.new_page(viewport={"width": 1100, "height": 3000})
    page.goto(address)
    low, high = THEMES[theme]
    page.wait_for_selector(f"body[data-jp-theme-name='{theme}'] .jp-RenderedMarkdown img", timeout=120_000)
    paper = _pixels(page.locator(".jp-RenderedMarkdown h2").first)
    assert low <= paper[len(paper) // 2] <= high
    figures = page.locator(".jp-RenderedMarkdown img")
    figures.nth(1).wait_for(timeout=120_000)
    for at in range(2):
        pixels = _pixels(figures.nth(at))
        assert pixels[len(pixels) // 2] > 0.9  # the sheet
        assert pixels[len(pixels) // 500] < 0.3  # the ink on it
    page.close()


def _pixels(element) -> list[float]:
    """The brightness of each pixel, from dark to light."""
    picture = Image.open(io.BytesIO(element.screenshot())).convert("L")
    return sorted(pixel / 255 for pixel in picture.get_flattened_data())
