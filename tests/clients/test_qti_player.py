"""A QTI player from npm, in a browser, takes the package and gives the marks that we give on everything the answer tables try.

`@citolab/qti-convert` first makes QTI 3 of the package, which is what players in browsers play; `@citolab/qti-components` plays it.
The whole chapter takes it a quarter of an hour, so that is asked for by COROLLARY_QTI_PLAYER=all, and recorded; otherwise it plays
a problem of each kind.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from .qti_attempts import attempts, compared, package, unpack

PLAYER, CONVERTER = "@citolab/qti-components@7.27.4", "@citolab/qti-convert@0.3.52"
DRIVER = Path(__file__).with_name("qti_player.js").read_text(encoding="utf-8")
CLIENT = "qti-player"
FEW = ("X12.2", "X12.10", "X12.4", "X12.13")
EACH_KIND = {
    "S12.0": "prose alone",
    "S12.2": "two choices with a vector and a number",
    "S12.4n": "a vector alone",
    "S12.5nc": "four components",
    "X12.2": "a choice with prose, and a part that is refused",
    "X12.4": "a number alone",
    "X12.6": "two numbers",
}
WHOLE_CHAPTER = os.environ.get("COROLLARY_QTI_PLAYER") == "all"
PAGE = '<!doctype html><html lang="en"><title>Items</title><body></body></html>'
READY = """() => {
  const item = document.querySelector("item-container").shadowRoot?.querySelector("qti-assessment-item");
  return !!item && item.variables?.length > 0;
}"""


@pytest.fixture(scope="session")
def npm_folder(tmp_path_factory) -> Path:
    npm = shutil.which("npm")
    assert npm is not None, "npm is missing: it fetches the QTI player"
    folder = tmp_path_factory.mktemp("qti-player")
    command = [npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", folder]
    subprocess.run([*command, PLAYER, CONVERTER], check=True, timeout=300)
    return folder / "node_modules"


@pytest.fixture
def play(npm_folder, chromium, tmp_path):
    """The marks of a list of attempts, each item loaded as a student gets it."""

    def marks(archive: bytes, tried) -> list[list[dict]]:
        (tmp_path / "items.zip").write_bytes(archive)
        subprocess.run(
            [npm_folder / ".bin" / "qti-convert-pkg", "items.zip"], cwd=tmp_path, check=True, timeout=300
        )
        unpack((tmp_path / "items-qti3.zip").read_bytes(), tmp_path / "items")
        page = chromium.new_page()
        page.add_init_script(
            "console.log = () => {}"
        )  # a line for each comparison takes longer than comparing
        errors: list[str] = []
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.route("**/*", lambda route: serve(route, tmp_path / "items", npm_folder))
        found = []
        for each in tried:
            page.goto("http://127.0.0.1/")
            page.add_script_tag(type="module", url="/player.js")
            page.evaluate(
                "file => { document.body.innerHTML = `<qti-item><item-container item-url='/${file}'></item-container></qti-item>`; }",
                each.file,
            )
            page.wait_for_function(READY)
            found.append(page.evaluate(DRIVER, each.responses()))
        page.close()
        assert not errors
        return found

    return marks


def serve(route, folder: Path, modules: Path) -> None:
    name = route.request.url.partition("127.0.0.1/")[2]
    if not name:
        route.fulfill(body=PAGE, content_type="text/html")
    elif name == "player.js":
        route.fulfill(path=modules / "@citolab" / "qti-components" / "cdn" / "index.js")
    elif (folder / name).is_file():
        route.fulfill(path=folder / name)
    else:
        route.abort()


@pytest.mark.client
@pytest.mark.browser
@pytest.mark.parametrize("code", EACH_KIND)
def test_the_player_gives_what_we_give_on_each_kind(code, make_item, fingerprint, play, recorded, table):
    item = make_item(code)
    archive = package([item])
    tried = attempts([item], table, archive)
    assert len(tried) == 1
    found, nameless = compared(tried, play(archive, tried), fingerprint)
    assert not nameless
    assert found == {code: each for code, each in recorded(CLIENT)["items"].items() if code in found}
    assert bool(found) == any(each.rows for each in tried)


@pytest.mark.client
@pytest.mark.browser
@pytest.mark.skipif(not WHOLE_CHAPTER, reason="COROLLARY_QTI_PLAYER is not all")
def test_the_player_gives_what_we_give(chapter_items, fingerprint, play, record, table):
    archive = package(chapter_items)
    tried = attempts(chapter_items, table, archive)
    assert len(tried) > 30
    items, nameless = compared(tried, play(archive, tried), fingerprint)
    assert not nameless
    version = f"{PLAYER.rpartition('@')[2]}, in Chromium"
    record(CLIENT, {"client": "QTI 2.1, made QTI 3, in qti-components", "version": version, "items": items})


@pytest.mark.parametrize("code", FEW)
def test_what_decides_marks_is_what_the_player_was_asked(code, make_item, fingerprint, recorded):
    assert recorded(CLIENT)["items"][code]["hash"] == fingerprint(make_item(code))


@pytest.mark.whole
def test_nothing_has_changed_since_the_player_was_asked(chapter_items, fingerprint, recorded):
    found = {each.exercise.problem.code: fingerprint(each) for each in chapter_items}
    asked = {code: each["hash"] for code, each in recorded(CLIENT)["items"].items()}
    assert len(asked) > 20
    assert asked == {code: found[code] for code in asked}


def test_the_player_gave_no_mark_of_its_own(recorded):
    assert not [code for code, each in recorded(CLIENT)["items"].items() if each.get("different")]
