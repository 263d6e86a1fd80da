"""A package of somebody else's brings a bank, an answer type, laws, a unit and an export; the ordinary commands know them all."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import nbformat
import pytest

import corollary

PACKAGE = Path(__file__).with_name("package")


@pytest.fixture(scope="module")
def python(tmp_path_factory) -> Path:
    """An environment of its own that sees this one's packages, with the course on springs installed by pip, offline."""
    folder = tmp_path_factory.mktemp("environment")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder], check=True)
    python = folder / "bin" / "python"
    places = sysconfig.get_path("purelib", vars={"base": str(folder), "platbase": str(folder)})
    seen = [
        Path(corollary.__file__).parents[1],
        *(place for place in sys.path if place.endswith("site-packages")),
    ]
    Path(places, "seen.pth").write_text("\n".join(map(str, seen)), encoding="utf-8")
    source = folder / "source"  # a copy, for building leaves files behind
    shutil.copytree(PACKAGE, source)
    offline = ["--no-deps", "--no-build-isolation", "--no-index", "--disable-pip-version-check", "--quiet"]
    pip = [sys.executable, "-m", "pip", "--python", python, "install", *offline, source]
    done = subprocess.run(list(map(str, pip)), capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return python


@pytest.fixture(scope="module")
def run(python: Path, tmp_path_factory):
    """The installed command: its standard output, when it ends with 0."""
    home = tmp_path_factory.mktemp("home")

    def call(*words: object, status: int = 0) -> str:
        command = [python, "-c", "from corollary.cli.main import main; main()", *words]
        environment = os.environ | {
            "XDG_CACHE_HOME": str(home),
            "PATH": os.pathsep.join(
                [str(python.parent), str(Path(sys.executable).parent), os.environ["PATH"]]
            ),
        }
        done = subprocess.run(
            list(map(str, command)),
            capture_output=True,
            text=True,
            timeout=300,
            env=environment,
            cwd=home,
            check=False,
        )
        assert done.returncode == status, done.stderr
        return done.stdout

    return call


def judged(run, tmp_path: Path, *answers: dict) -> list[dict]:
    """What `judge` says of answers to the problem with the printed numbers."""
    cases = tmp_path / "cases.json"
    cases.write_text(json.dumps([{"given": {}, "answers": each} for each in answers]), encoding="utf-8")
    return json.loads(run("judge", "SPR.1", "--bank", "springs", "--cases", cases, "--json"))


def test_its_problem_is_verified(run):
    assert json.loads(run("verify", "SPR.1", "--bank", "springs", "--json"))["ok"] is True


def test_the_key_is_in_the_unit_it_brings(run):
    """A = v √(m/k) = 0.80 · √(0.5/40) m = 0.0894 m = 3.52 inches; (0.8² − 0.4²)/0.4² = 3."""
    parts = json.loads(run("key", "SPR.1", "--bank", "springs", "--json"))["parts"]
    assert parts["a"]["value"] == pytest.approx(0.8 * (0.5 / 40) ** 0.5, rel=1e-15)
    assert parts["b"]["value"] == pytest.approx(3, rel=1e-15)


def test_its_answers_are_judged(run, tmp_path: Path):
    right = ["3 : 1", "6 to 2", "1.5 : 0.5", 3, "(v^2 - u^2) : u^2", "v^2/u^2 - 1"]
    wrong = {"1 : 3": "mistaken", "3 : 4": "mistaken", "5 : 1": "wrong", "a lot : little": "unread"}
    found = judged(run, tmp_path, *({"b": each} for each in [*right, *wrong]))
    verdicts = [each["parts"]["b"]["verdict"] for each in found]
    assert verdicts[: len(right)] == ["right"] * len(right)
    assert dict(zip(wrong, verdicts[len(right) :], strict=True)) == wrong
    amplitudes = judged(
        run, tmp_path, *({"a": each} for each in ("3.52 inch", "3.52 inches", "8.94 cm", "3.52"))
    )
    assert {each["parts"]["a"]["verdict"] for each in amplitudes} == {"right"}


@pytest.mark.whole
def test_it_is_dealt_answered_marked_and_exported(run, python: Path, tmp_path: Path):
    course, roster = tmp_path / "course", tmp_path / "roster.csv"
    roster.write_text("id\nada\nben\n", encoding="utf-8")
    run("generate", "springs", "--bank", "springs", "--roster", roster, "--course", course)
    sheets = {name: next(course.rglob(f"*{name}*/**/springs.ipynb")) for name in ("ada", "ben")}
    for name, sheet in sheets.items():
        nb = nbformat.read(sheet, as_version=4)
        shown = answered(nb, python, tmp_path, name)
        assert (" : 2" in shown) == (name == "ada"), shown
        handed_in = course / "submitted" / name / "springs"
        handed_in.mkdir(parents=True, exist_ok=True)
        nbformat.write(nb, handed_in / "springs.ipynb")
    students = json.loads(run("grade", "springs", "--course", course, "--json"))["students"]
    assert students["ada"]["points"] == students["ada"]["out_of"] == 3
    assert students["ben"]["points"] == 0
    folder = tmp_path / "cards"
    run("export", "springs", "--course", course, "--to", "cards", "-o", folder)
    cards = [path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.tsv"))]
    assert len(cards) == 2
    assert all("What is the ratio" in card for card in cards)


def answered(nb, python: Path, tmp_path: Path, name: str) -> str:
    """Ada's numbers as they come out for her (Ben leaves his cells alone); what `check` says of the ratio, run bare."""
    statement = next(cell.source for cell in nb.cells if "A block of mass" in cell.source)
    m, k, v = (float(number) for number in re.findall(r"(\d+\.?\d*)[^\d.]{1,20}?(?:kg|N/m|m/s)", statement))
    way = next(cell.source for cell in nb.cells if "On the way out" in cell.source)
    found = re.search(r"(\d+\.?\d*)[^\d.]{1,20}?m/s", way)
    assert found is not None
    inches, ratio = v * (m / k) ** 0.5 / 0.0254, (v / float(found[1])) ** 2 - 1
    sources = {
        "SPR_1_a_answer": f"SPR_1_a = '{inches:.4g} inches'",
        "SPR_1_b_answer": f"SPR_1_b = '{2 * ratio:.5g} : 2'",
    }
    code = []
    for cell in nb.cells:
        if cell.cell_type != "code":
            continue
        if name == "ada" and cell.id in sources:
            cell.source = sources[cell.id]
        code.append(cell.source)
    program = tmp_path / f"{name}.py"
    program.write_text("\n".join(code), encoding="utf-8")
    done = subprocess.run(
        [python, "-S", "-I", program], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout
