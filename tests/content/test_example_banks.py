"""The banks in `examples/banks`, installed by pip as anybody's: verified, dealt in one set of three banks, and played by simulated students."""

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

PACKAGES = sorted((Path(__file__).parents[2] / "examples" / "banks").glob("corollary-*"))
BANKS = tuple(package.name.removeprefix("corollary-") for package in PACKAGES)
PROBLEMS = {
    bank: sorted(path for path in package.glob("src/*/problems/*/*.md") if "." not in path.stem)
    for bank, package in zip(BANKS, PACKAGES, strict=True)
}
"""Translations, as `two_gliders.de.md`, left out."""
SAMPLE = {"fields": "CIR.1", "matter": "FLU.4", "mechanics": "KIN.6"}
"""A problem of each bank."""


def codes(bank: str) -> list[str]:
    """The codes of a bank's problems, sets left out."""
    texts = [path.read_text(encoding="utf-8") for path in PROBLEMS[bank] if path.parent.name != "sets"]
    return [found[1] for text in texts if (found := re.search(r"^code: (\S+)$", text, re.MULTILINE))]


@pytest.fixture(scope="module")
def python(tmp_path_factory) -> Path:
    """An environment of its own that sees this one's packages, with the banks installed by pip, offline."""
    folder = tmp_path_factory.mktemp("environment")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder], check=True)
    python = folder / "bin" / "python"
    places = sysconfig.get_path("purelib", vars={"base": str(folder), "platbase": str(folder)})
    seen = [
        Path(corollary.__file__).parents[1],
        *(place for place in sys.path if place.endswith("site-packages")),
    ]
    Path(places, "seen.pth").write_text("\n".join(map(str, seen)), encoding="utf-8")
    sources = [folder / package.name for package in PACKAGES]  # copies, for building leaves files behind
    for package, source in zip(PACKAGES, sources, strict=True):
        shutil.copytree(package, source)
    offline = ["--no-deps", "--no-build-isolation", "--no-index", "--disable-pip-version-check", "--quiet"]
    pip = [sys.executable, "-m", "pip", "--python", python, "install", *offline, *sources]
    done = subprocess.run(list(map(str, pip)), capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return python


@pytest.fixture(scope="module")
def run(python: Path, tmp_path_factory):
    """A program of that environment, with all banks open: its standard output, when it ends with 0."""
    home = tmp_path_factory.mktemp("home")
    seen = [str(python.parent), str(Path(sys.executable).parent), os.environ["PATH"]]
    environment = os.environ | {
        "XDG_CACHE_HOME": str(home), "PATH": os.pathsep.join(seen), "COROLLARY_BANK": os.pathsep.join(BANKS),
    }  # fmt: skip

    def call(*words: object) -> str:
        command = list(map(str, [python, *words]))
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=1200, env=environment, cwd=home, check=False
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return call


@pytest.fixture(scope="module")
def command(run):
    """The installed `corollary`."""
    return lambda *words: run("-c", "from corollary.cli.main import main; main()", *words)


def verified(command, variants: int, *problems: str) -> dict:
    found = json.loads(command("verify", *problems, "--variants", variants, "--json"))
    assert found["ok"], found
    return found


def played(run, variants: int, *problems: str) -> dict[str, int]:
    """Everybody right is judged right, and everybody with one of the solution's mistakes is told so."""
    found = json.loads(run(Path(__file__).with_name("simulated_students.py"), variants, *problems))
    assert not found["faults"], "\n".join(found["faults"])
    return found["counts"]


def test_there_are_sixty_problems_of_eleven_topics():
    """As many as were asked for, each with a solution beside it, at least two mistakes in it, and what other teachers want to know."""
    assert BANKS == ("fields", "matter", "mechanics")
    texts = {
        path: path.read_text(encoding="utf-8")
        for bank in BANKS
        for path in PROBLEMS[bank]
        if path.parent.name != "sets"
    }
    assert len(texts) >= 60
    assert len({path.parent.name for path in texts}) >= 11
    for path, text in texts.items():
        solution = Path(str(path).replace("/problems/", "/solutions/")).read_text(encoding="utf-8")
        assert solution.count("- mistake:") >= 2, path
        assert re.search(r"^difficulty: [1-5]$", text, re.MULTILINE), path
        assert re.search(r"^tags: \[.+\]$", text, re.MULTILINE), path
    every = [code for bank in BANKS for code in codes(bank)]
    assert len(every) == len(set(every)) == len(texts)


@pytest.mark.whole
def test_students_of_one_of_each(run):
    counts = played(run, 1, *SAMPLE.values())
    assert counts["right"] == 4 + 3 + 4
    assert counts["mistaken"] == 6 + 7 + 9


@pytest.mark.whole
def test_a_set_of_three_banks_is_dealt_and_marked(command, tmp_path: Path):
    """The set *A mixed week*, whose problems are of all three; one student hands in what the key says for one part of each, one nothing."""
    course, roster = tmp_path / "course", tmp_path / "roster.csv"
    roster.write_text("id\nada\nben\n", encoding="utf-8")
    command("generate", "mixed_week", "--roster", roster, "--course", course)
    for name in ("ada", "ben"):
        notebook = next(course.rglob(f"*{name}*/**/mixed_week.ipynb"))
        sheet = nbformat.read(notebook, as_version=4)
        for cell in sheet.cells:
            if name == "ada" and cell.id in {"FLU_4_a_answer", "CIR_1_a_answer", "KIN_6_d_answer"}:
                formula = {"F": "pi*D^2*v/4", "C": "U/(R + S)", "K": "v*cos(theta)"}[cell.id[0]]
                cell.source = f"{cell.id.removesuffix('_answer')} = {formula!r}"
        handed_in = course / "submitted" / name / "mixed_week"
        handed_in.mkdir(parents=True, exist_ok=True)
        nbformat.write(sheet, handed_in / "mixed_week.ipynb")
    students = json.loads(command("grade", "mixed_week", "--course", course, "--json"))["students"]
    assert students["ada"]["points"] == 3
    assert students["ben"]["points"] == 0


@pytest.mark.whole
@pytest.mark.parametrize("bank", BANKS)
def test_every_problem_is_verified(command, bank):
    assert len(verified(command, 3, *codes(bank))["problems"]) == len(codes(bank))


@pytest.mark.whole
@pytest.mark.parametrize("bank", BANKS)
def test_students_of_every_problem(run, bank):
    counts = played(run, 2, *codes(bank))
    assert counts["mistaken"] >= 2 * 2 * len(codes(bank))
