"""The wheel and the source distribution: built, compared with each other, and the wheel installed and tried in a fresh environment.

    python .ci/distribution.py [--keep FOLDER] [--tag v1.0.0]

Needs hatchling, and an index for what the package depends on. `--keep` leaves both files there; `--tag` must name the version.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import venv
import zipfile
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
TYPED = [{"given": {}, "answers": {"a": "8,6 Ns", "c": "86 kg*m/s^2"}}]


class Unfit(Exception):
    """The distribution is not what it should be; one sentence says how."""


def build(source: Path, folder: Path, kind: str) -> Path:
    """The file of this kind, `sdist` or `wheel`, built from a source folder. Raises Unfit."""
    line = [sys.executable, "-m", "hatchling", "build", "--target", kind, "--directory", str(folder)]
    done = subprocess.run(line, cwd=source, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Unfit(f"the {kind} cannot be built: {done.stderr.strip()}")
    (built,) = folder.glob("*.whl" if kind == "wheel" else "*.tar.gz")
    return built


def unpacked(sdist: Path, folder: Path) -> Path:
    """The source folder that a source distribution holds."""
    shutil.unpack_archive(sdist, folder)
    (source,) = folder.iterdir()
    return source


def digests(wheel: Path) -> dict[str, str]:
    """The name of every file in a wheel, with the SHA-256 of what is in it."""
    with zipfile.ZipFile(wheel) as archive:
        return {name: hashlib.sha256(archive.read(name)).hexdigest() for name in archive.namelist()}


def build_both(folder: Path) -> tuple[Path, Path]:
    """The source distribution and the wheel. Raises Unfit where the wheel built from the former is another one."""
    for name in ("files", "source", "again"):
        (folder / name).mkdir()
    sdist = build(TOP, folder / "files", "sdist")
    wheel = build(TOP, folder / "files", "wheel")
    again = build(unpacked(sdist, folder / "source"), folder / "again", "wheel")
    one, other = digests(wheel), digests(again)
    if one != other:
        differing = sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))
        raise Unfit(f"the wheel from the source distribution differs in {', '.join(differing[:10])}")
    return sdist, wheel


def install(wheel: Path, folder: Path) -> Path:
    """The folder of programs of a fresh environment in which the wheel is installed with the pinned versions of what it needs."""
    venv.create(folder, symlinks=os.name != "nt")
    line = [
        sys.executable,
        "-m",
        "pip",
        "--python",
        folder,
        "--disable-pip-version-check",
        "install",
        "--quiet",
    ]
    pinned = [
        "--no-compile",
        "--constraint",
        TOP / ".ci/constraints.txt",
    ]  # a fifth of it is ever imported here
    subprocess.run([*line, *pinned, wheel], cwd=folder, check=True)
    return folder / ("Scripts" if os.name == "nt" else "bin")


def smoke(programs: Path, folder: Path, version: str) -> None:
    """The commands of a first minute, in an empty folder. Raises Unfit."""
    environment = {
        name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "COROLLARY"))
    }
    environment["XDG_CACHE_HOME"] = str(folder / "cache")

    def run(*words: str) -> str:
        line = [str(programs / "corollary"), *words]
        done = subprocess.run(
            line, cwd=folder, env=environment, capture_output=True, text=True, encoding="utf-8", check=False
        )
        if done.returncode:
            raise Unfit(f"corollary {' '.join(words)} ends with {done.returncode}: {done.stderr.strip()}")
        return done.stdout

    def expect(told: object, wanted: object, words: str) -> None:
        if told != wanted:
            raise Unfit(f"corollary {words}: {told!r} instead of {wanted!r}")

    expect(run("--version").strip(), version, "--version")
    key = json.loads(run("key", "X12.5", "--set", "m=0.43", "--set", "v=72 km/h", "--json"))
    expect((key["parts"]["a"]["value"], key["parts"]["a"]["certified"]), (8.6, True), "key X12.5")
    (folder / "typed.json").write_text(json.dumps(TYPED), encoding="utf-8")
    marked = json.loads(run("judge", "X12.5", "--cases", "typed.json", "--json"))[0]["parts"]
    expect((marked["a"]["verdict"], marked["c"]["verdict"]), ("right", "right"), "judge X12.5")
    read = json.loads(run("read", "8,6 Ns", "--unit", "kg m/s", "--json"))
    expect((read["value"], read["verdict"]), (8.6, "compatible"), "read '8,6 Ns'")
    (folder / "roster.csv").write_text("id\nada\nben\n", encoding="utf-8")
    run("generate", "momentum_1", "--roster", "roster.csv", "--course", "mechanics", "--json")
    sheet = folder / "mechanics/release/ada/momentum_1/momentum_1.ipynb"
    expect(sheet.is_file(), True, "generate momentum_1")
    expect(json.loads(run("verify", "X12.5", "--json"))["ok"], True, "verify X12.5")


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--keep", type=Path)
    options.add_argument("--tag")
    chosen = options.parse_args()
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        os.chmod(folder, 0o755)
        try:
            sdist, wheel = build_both(folder)
            project, version = wheel.name.split("-")[:2]
            wanted = tomllib.loads((TOP / "pyproject.toml").read_text(encoding="utf-8"))["project"]["name"]
            if project.replace("_", "-") != wanted:
                raise Unfit(f"the wheel is named {project}, and pyproject.toml says {wanted}")
            if chosen.tag is not None and chosen.tag != f"v{version}":
                raise Unfit(f"the tag is {chosen.tag}, and the version {version}")
            print(f"== {sdist.name} and {wheel.name}, which the former builds as well", flush=True)
            programs = install(wheel, folder / "environment")
            (folder / "empty").mkdir()
            smoke(programs, folder / "empty", version)
        except (Unfit, subprocess.CalledProcessError) as error:
            sys.exit(f"distribution: {error}")
        print(f"== installed in a fresh environment and tried: {time.monotonic() - began:.0f} s in all")
        if chosen.keep is not None:
            chosen.keep.mkdir(parents=True, exist_ok=True)
            for file in (sdist, wheel):
                shutil.copy2(file, chosen.keep / file.name)


if __name__ == "__main__":
    main()
