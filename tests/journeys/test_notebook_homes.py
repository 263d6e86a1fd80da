"""A student's sheet in the programs that open notebooks: run, answered, checked, saved, handed in, and marked right."""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from urllib.request import urlopen

import pytest
from tests import forked

pytestmark = pytest.mark.browser
# Seconds: the pages are served, drawn and run on a machine that runs other tests too.
PATIENCE = 300


@dataclass(frozen=True)
class Home:
    """Where a notebook is opened, what is clicked to run all of it, and how cells and what is scrolled are found."""

    path: str
    run_all: tuple[str, ...]
    cell: str
    editor: str
    output: str
    scrolled: str


JUPYTER = Home(
    "/{kind}/sheet.ipynb",
    (".lm-MenuBar-itemLabel:text-is('Run')", ".lm-Menu-itemLabel:text-is('Run All Cells')"),
    ".jp-CodeCell",
    ".cm-content",
    ".jp-OutputArea-output",
    ".jp-WindowedPanel-outer",
)
CLASSIC = Home(
    "/nbclassic/notebooks/sheet.ipynb",
    ("#celllink", "#run_all_cells a"),
    ".code_cell",
    ".CodeMirror-lines",
    ".output_subarea",
    "#site",
)
HOMES = {"lab": ("lab/tree", JUPYTER), "notebook": ("notebooks", JUPYTER), "nbclassic": ("", CLASSIC)}


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One student for each program."""
    folder = tmp_path_factory.mktemp("class")
    (folder / "roster.csv").write_text("\n".join(["id", *HOMES, ""]), encoding="utf-8")
    corollary("generate", "momentum_1", "--roster", folder / "roster.csv", "--course", folder / "course")
    return folder / "course"


@pytest.mark.parametrize("kind", HOMES)
def test_a_sheet_is_answered_there_and_marked_right(
    kind: str, course: Path, tmp_path: Path, jupyter, chromium
):
    for folder in ("work", "own"):
        (tmp_path / folder).mkdir()
    sheet = tmp_path / "work" / "sheet.ipynb"
    shutil.copy(course / "release" / kind / "momentum_1" / "momentum_1.ipynb", sheet)
    right = corollary("key", "X12.5", "--student", kind, "--course", course)["parts"]["a"]["value"]
    typed = f"{right:.4f} kg m/s".replace(".", ",")
    place, home = HOMES[kind]
    with jupyter(kind, sheet.parent, tmp_path / "own") as address:
        page = chromium.new_page(viewport={"width": 1200, "height": 900})
        page.goto(address + home.path.format(kind=place))
        answer_cell = page.locator(home.cell, has_text="X12_5_a = None")
        check_cell = page.locator(home.cell, has_text='check("X12_5_a")')
        answer_cell.wait_for(timeout=PATIENCE * 1000)
        page.wait_for_function(
            """() => [...document.images].some(each => each.alt.startsWith("A ball of mass") && each.naturalWidth > 0)""",
            timeout=PATIENCE * 1000,
        )
        until(lambda: kernel_is_ready(address), "the page has no kernel")
        for click in home.run_all:
            page.click(click)
        # JupyterLab goes to the last cell and lets go of those far above it.
        page.wait_for_function(
            """([scrolled, cell, output]) => {
                const panel = document.querySelector(scrolled);
                if (panel) panel.scrollTo(0, 0);
                return [...document.querySelectorAll(cell)].some(each =>
                    each.textContent.includes('check("X12_5_a")') && each.querySelector(output)?.textContent.includes("no answer yet"));
            }""",
            arg=[home.scrolled, home.cell, home.output],
            polling=500,
            timeout=PATIENCE * 1000,
        )
        answer_cell.locator(home.editor).click()
        page.keyboard.press("Control+a")
        page.keyboard.insert_text(f'X12_5_a = "{typed}"')
        page.keyboard.press("Shift+Enter")
        page.keyboard.press("Shift+Enter")
        check_cell.locator(home.output, has_text="read as").wait_for(timeout=PATIENCE * 1000)
        page.keyboard.press("Control+s")
        until(lambda: "read as" in sheet.read_text(encoding="utf-8"), "the sheet was not saved")
        page.close()
    handed_in = course / "submitted" / kind / "momentum_1" / "momentum_1.ipynb"
    handed_in.parent.mkdir(parents=True)
    shutil.copy(sheet, handed_in)
    part = corollary("grade", "momentum_1", "--course", course)["students"][kind]["parts"]["X12_5_a"]
    assert (part["verdict"], part["points"]) == ("right", 1.0)


def kernel_is_ready(address: str) -> bool:
    """Whether a page is connected to a kernel that waits: all cells run before that end in a question which kernel is meant."""
    with urlopen(f"{address}/api/sessions") as answer:
        kernels = [session["kernel"] for session in json.load(answer)]
    return any(kernel["execution_state"] == "idle" and kernel["connections"] for kernel in kernels)


def until(holds: Callable[[], bool], otherwise: str) -> None:
    """Ask until it holds; in a test, what never holds is a failure after PATIENCE."""
    for _ in range(PATIENCE):
        if holds():
            return
        time.sleep(1)
    raise AssertionError(otherwise)


def corollary(*arguments: object) -> dict:
    done = forked.run([forked.COMMAND, *arguments, "--json"])
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
