"""A release: its name and version in one place, what its files hold, and the workflow that publishes them."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
import tomllib
import zipfile
from importlib import import_module
from pathlib import Path

import pytest
import yaml

from corollary.version import __version__

TOP = Path(__file__).parents[2]
NAME = "corollary-physics"


def text(name: str) -> str:
    return (TOP / name).read_text(encoding="utf-8")


@pytest.fixture
def distribution(monkeypatch):
    monkeypatch.syspath_prepend(str(TOP / ".ci"))
    yield import_module("distribution")
    sys.modules.pop("distribution")


def version() -> str:
    done = subprocess.run(
        [sys.executable, "-m", "corollary", "--version"], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def test_the_version_stands_in_one_file_and_the_changelog_and_the_citation_follow():
    project = tomllib.loads(text("pyproject.toml"))
    assert project["project"]["name"] == NAME
    assert "version" in project["project"]["dynamic"]
    assert project["tool"]["hatch"]["version"]["path"] == "src/corollary/version.py"
    assert f'"{NAME}"' in text("src/corollary/version.py")
    released = re.findall(r"^## \[([\d.]+)\] - (\S+)$", text("docs/changelog.md"), re.MULTILINE)
    cited = yaml.safe_load(text("CITATION.cff"))
    assert released[0][0] == cited["version"]
    assert __version__ == released[0][0] or re.fullmatch(r"[\d.]+\.dev0", __version__)
    assert [int(each) for each in __version__.removesuffix(".dev0").split(".")] >= [
        int(each) for each in released[0][0].split(".")
    ]
    assert released[0][1] == str(cited["date-released"])
    assert cited["cff-version"] == "1.2.0"
    assert {"message", "title", "authors"} <= cited.keys()


def test_the_version_names_the_commit_between_releases(tmp_path: Path):
    """In a checkout; a copy of the sources without git has the bare version, or that of the source distribution."""
    commit = subprocess.run(
        ["git", "-C", TOP, "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True, check=False
    ).stdout.strip()
    assert version() == (f"{__version__}+{commit}" if commit and "dev" in __version__ else __version__)
    copied = tmp_path / "src" / "corollary" / "version.py"
    copied.parent.mkdir(parents=True)
    copied.write_text(
        re.sub(r"(?m)^__version__ = .*$", '__version__ = "7.1.0.dev0"', text("src/corollary/version.py"))
    )
    (tmp_path / "pyproject.toml").write_text("")

    def found() -> str:
        return str(runpy.run_path(str(copied))["full_version"]())

    assert found() == "7.1.0.dev0"
    (tmp_path / "PKG-INFO").write_text("Name: corollary-physics\nVersion: 7.1.0.dev0+1a2b3c4d\n")
    assert found() == "7.1.0.dev0+1a2b3c4d"
    copied.write_text(copied.read_text().replace("7.1.0.dev0", "7.1.0"))
    assert found() == "7.1.0"


def test_what_installs_an_extra_names_the_distribution():
    """In double quotes, which cmd.exe takes as well as a shell does; and the extra is there."""
    extras = tomllib.loads(text("pyproject.toml"))["project"]["optional-dependencies"]
    named = {
        (path.name, name, extra)
        for path in [TOP / "README.md", *(TOP / "docs").rglob("*.md")]
        for name, extra in re.findall(
            r'pip install "([\w.-]+)\[([\w,]+)\]"', path.read_text(encoding="utf-8")
        )
    }
    assert len(named) > 3
    for page, name, asked in named:
        assert name == NAME, page
        assert set(asked.split(",")) <= extras.keys(), page


def test_the_workflow_publishes_what_was_tried_and_keeps_no_secret():
    workflow = text(".github/workflows/release.yml")
    jobs = yaml.safe_load(workflow)["jobs"]
    triggers = yaml.safe_load(workflow)[True]  # YAML reads `on` as a truth value
    assert triggers == {"push": {"tags": ["v*"]}}
    commands = [step.get("run", "") for step in jobs["build"]["steps"]]
    assert any(".ci/distribution.py" in each and "--tag" in each for each in commands)
    assert jobs["publish"]["permissions"] == {"id-token": "write"}
    assert jobs["publish"]["needs"] == ["install", "site"]
    assert {"run": "make site"} in jobs["site"]["steps"]
    assert jobs["install"]["needs"] == "build"
    assert [name for name, job in jobs.items() if "permissions" in job] == ["publish"]
    assert "secrets." not in workflow
    assert ".ci/distribution.py" in text(".ci/run")


@pytest.mark.whole
def test_both_files_are_built_and_hold_what_they_should(distribution, tmp_path: Path):
    """The source distribution builds the same wheel, or building both raises."""
    sdist, wheel = distribution.build_both(tmp_path)
    assert sdist.name == f"corollary_physics-{version()}.tar.gz"
    names = zipfile.ZipFile(wheel).namelist()
    for folder, ours in (("problems", "corollary/bank/problems"), ("solutions", "corollary/bank/solutions")):
        files = [path.relative_to(TOP / folder) for path in (TOP / folder).rglob("*") if path.is_file()]
        wanted = {f"{ours}/{path.as_posix()}" for path in files if "__pycache__" not in path.parts}
        assert len(wanted) > 40
        assert wanted <= set(names)
    modules = {path.relative_to(TOP / "src").as_posix() for path in (TOP / "src").rglob("*.py")}
    assert modules <= set(names)
    assert {"corollary/py.typed", "corollary/answers/locale/de/LC_MESSAGES/corollary.answers.mo"} <= set(
        names
    )
    assert not [each for each in names if each.startswith(("tests", "docs", "benchmarks"))]
    about = zipfile.ZipFile(wheel).read(f"corollary_physics-{version()}.dist-info/METADATA").decode()
    assert f"Name: {NAME}\n" in about


@pytest.mark.whole
def test_a_wheel_that_the_source_does_not_build_is_refused(distribution, tmp_path: Path, monkeypatch):
    real = distribution.unpacked

    def bent(sdist: Path, folder: Path) -> Path:
        source = real(sdist, folder)
        (source / "src/corollary/extras.py").write_text("")
        return source

    monkeypatch.setattr(distribution, "unpacked", bent)
    with pytest.raises(distribution.Unfit, match=r"differs in corollary/extras\.py"):
        distribution.build_both(tmp_path)
