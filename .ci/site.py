"""What the site has beside the pages of docs/: the README as its first page, a gallery of every problem, the laws in the reference.

A hook of mkdocs (`make site`). The gallery shows each problem of the chapter's bank and of examples/banks with the numbers of its
statement, as `corollary show --format html --solution` does.
"""

from __future__ import annotations

import html
import logging
import pkgutil
import posixpath
import re
import tempfile
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import Any

from mkdocs.plugins import event_priority
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import corollary.laws
from corollary.answers.questions import askable
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise
from corollary.problem.bank import Bank, chapter_bank, open_bank
from corollary.problem.problem import Problem
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.render.page import drawing_address
from corollary.render.practice_site import NoNpm, NotFetched, unpacked
from corollary.render.targets.html import write_exercise

TOP = Path(__file__).parents[1]
BESIDE = (
    "benchmarks/results/*.md",
    "examples/audit/README.md",
    "examples/banks/README.md",
    "examples/banks/*/README.md",
)
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)#:\s]*)(#[^)]*)?\)")
SHIM = "iframe-worker@1.0.4"  # by whom the theme is: the search of a page that lies in a folder, where browsers start no worker
SHIM_ADDRESS = "assets/iframe-worker.js"
SEARCH = 'data-md-component="search" role="dialog"'
LOG = logging.getLogger("mkdocs")
LETTERS_ALONE = {"law"}  # modules of corollary.laws that hold no laws


@event_priority(100)
def on_config(config: Any) -> Any:
    """Without the shim the search works on a server alone, and nothing is asked of another machine either."""
    shim = _shim()
    config.extra |= {"polyfills": [SHIM_ADDRESS] if shim else [], "shim": shim}
    config.plugins["material/offline"].config.enabled = bool(shim)
    return config


def on_files(files: Files, config: Any) -> Files:
    """The pages that are not in docs/, added."""
    pages = [path for pattern in BESIDE for path in sorted(TOP.glob(pattern))]
    generated = {
        _address(path): _linked(path.read_text(encoding="utf-8"), path)
        for path in (TOP / "README.md", *pages)
    }
    for address, content in (generated | dict(_gallery())).items():
        files.append(File.generated(config, address, content=content))
    if config.extra["shim"]:
        files.append(File.generated(config, SHIM_ADDRESS, content=config.extra["shim"]))
    return files


def on_page_markdown(markdown: str, page: Page, config: Any, files: Files) -> str:
    """Links of docs/ to files outside of it, turned to where these stand here; and the reference, filled."""
    if page.file.abs_src_path is not None:
        markdown = _linked(markdown, Path(page.file.abs_src_path))
    return markdown + "".join(_laws()) if page.file.src_uri == "reference/python.md" else markdown


def on_post_page(output: str, page: Page, config: Any) -> str:
    """The search, which the theme leaves without a name, is named for screen readers."""
    return output.replace(SEARCH, f'{SEARCH} aria-label="Search"')


def on_post_template(output_content: str, template_name: str, config: Any) -> str:
    """The page for what is not there has the same search, and no label for its switch."""
    return output_content.replace(SEARCH, f'{SEARCH} aria-label="Search"').replace(
        'id="__search"', 'id="__search" aria-label="Search"'
    )


def _shim() -> str:
    """The shim as npm gives it; "" without npm or a network."""
    with tempfile.TemporaryDirectory() as place:
        try:
            return (unpacked(SHIM, Path(place)) / "shim" / "index.js").read_text(encoding="utf-8")
        except (NoNpm, NotFetched):
            LOG.info("npm cannot fetch %s: the search of this site needs a server", SHIM)
            return ""


def _address(path: Path) -> str:
    """Where a file of the repository stands in the site."""
    place = path.relative_to(TOP).as_posix()
    return "index.md" if place == "README.md" else place.removeprefix("docs/")


def _linked(text: str, path: Path) -> str:
    """What the site does not have is named without a link."""

    def turned(found: re.Match[str]) -> str:
        image, words, target, anchor = found.groups(default="")
        if not target:
            return found[0]
        other = Path(posixpath.normpath((path.parent / target).as_posix()))
        here = other.is_relative_to(TOP / "docs") or any(
            other in TOP.glob(each) for each in ("README.md", *BESIDE)
        )
        if not here:
            return words
        address = posixpath.relpath(_address(other), posixpath.dirname(_address(path)) or ".")
        return f"{image}[{words}]({address}{anchor})"

    return LINK.sub(turned, text)


def _laws() -> Iterator[str]:
    yield "## Laws\n"
    for module in pkgutil.iter_modules(corollary.laws.__path__):
        if not module.ispkg and module.name not in LETTERS_ALONE:
            yield f"\n### {module.name.replace('_', ' ').capitalize()}\n\n::: corollary.laws.{module.name}\n    options: {{heading_level: 4}}\n"


def _gallery() -> Iterator[tuple[str, str]]:
    """The page of all problems, and one page for each."""
    text = [
        "# Gallery\n\nEvery problem, with the numbers of its statement. Its page has the worked solution behind a click, and beside it stands the source: problem and solution as their author wrote them.\n"
    ]
    for name, bank in _banks():
        text.append(f"\n## {name}\n")
        solutions = Solutions(bank)
        readable, broken = askable(bank)
        for complaint in broken:
            LOG.warning("not in the gallery: %s", complaint)
        topics = list(dict.fromkeys(problem.topic for problem in readable))
        for topic, problems in groupby(
            sorted(readable, key=lambda each: topics.index(each.topic)), key=lambda each: each.topic
        ):
            heading = topic.replace("_", " ").capitalize()
            text.append(f'\n### {heading}\n\n<div class="grid cards" markdown>\n\n')
            for problem in problems:
                address = f"gallery/{problem.code}.html"
                try:
                    source = f"gallery/{problem.code}_source.md"
                    page, card = _page(problem, solutions), _card(problem, address, source)
                except Exception as error:  # of one problem: it costs the others nothing
                    LOG.warning("not in the gallery: %s: %s", problem.code, error)
                    continue
                yield address, page
                yield source, _source(problem, bank.solution(problem))
                text.append(card)
            text.append("\n</div>\n")
    yield "gallery.md", "".join(text)


def _banks() -> Iterator[tuple[str, Bank]]:
    yield "Momentum, Impulse, and Collisions", chapter_bank()
    for folder in sorted((TOP / "examples" / "banks").glob("*/src/*")):
        yield folder.name.removeprefix("corollary_").capitalize(), open_bank(folder)


def _page(problem: Problem, solutions: Solutions) -> str:
    variant = chapter(problem)
    return write_exercise(exercise(variant), Student("you"), solutions.worked_solution(variant))


def _source(problem: Problem, solution: Path) -> str:
    """A page of both files of a problem."""
    kinds = {".md": "markdown", ".py": "python"}
    blocks = (
        f"## `{path.relative_to(path.parents[2]).as_posix()}`\n\n`````{kinds[path.suffix]}\n{path.read_text(encoding='utf-8').rstrip()}\n`````\n"
        for path in (problem.path, solution)
    )
    return "\n".join((f"# {problem.code} {problem.title}: source\n", *blocks))


def _card(problem: Problem, address: str, source: str) -> str:
    asked = exercise(chapter(problem))
    figure = (
        f'<img src="{drawing_address(asked)}" alt="{html.escape(asked.figure_alt, quote=True)}">'
        if asked.figure
        else ""
    )
    return f"-   [**{problem.code}** {problem.title}]({address})\n\n    {figure}\n\n    [Source]({source})\n\n"
