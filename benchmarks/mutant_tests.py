"""The tests of three rooms in a copy of the tree: which covers which line, how long it takes, and which notices a change."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import site
import subprocess
import sys
import tempfile
import venv
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from mutant_server import ROOMS

SERVER = Path(__file__).with_name("mutant_server.py")
FEW = 8.0  # seconds of tests that use the module and are not seen to reach the line
# As under xdist, so that tests/conftest.py leaves the cache folder to us; a process has one core.
ENVIRONMENT = {"PYTEST_XDIST_WORKER": "one", "OPENBLAS_NUM_THREADS": "1"}


@dataclass
class Learned:
    """What was learned about the tests, kept in a file; good for the same sources, and for a file of tests that is the same."""

    kept: Path
    top: Path
    files: dict[str, Any] = field(default_factory=dict[str, Any])

    def __post_init__(self) -> None:
        sources = sorted((self.top / "src").rglob("*.py"))
        self._sources = _digest(*sources)
        if self.kept.is_file():
            found = json.loads(self.kept.read_text(encoding="utf-8"))
            if found["sources"] == self._sources:
                self.files = found["files"]

    def missing(self) -> list[str]:
        """The files of tests to be learned, the longest first."""
        tests = [path for room in ROOMS for path in (self.top / "tests" / room).rglob("test_*.py")]
        names = {path.relative_to(self.top).as_posix(): path for path in tests}
        self.files = {name: each for name, each in self.files.items() if name in names}
        return [
            name
            for name, path in sorted(names.items(), key=lambda each: -each[1].stat().st_size)
            if self.files.get(name, {}).get("digest") != _digest(path)
        ]

    def add(self, name: str, learned: dict[str, Any]) -> None:
        self.files[name] = learned | {"digest": _digest(self.top / name)}
        self.kept.write_text(json.dumps({"sources": self._sources, "files": self.files}), encoding="utf-8")

    def use(self) -> None:
        """To be called when nothing is missing any more."""
        self.seconds: dict[str, float] = {}
        self._lines: dict[str, dict[int, set[str]]] = {}
        self._collected: dict[str, set[int]] = {}
        for each in self.files.values():
            tests = list(each["seconds"])
            failing = set(each["failing"])
            self.seconds |= {name: each["seconds"][name] for name in tests if name not in failing}
            for file, lines in each["lines"].items():
                covered, collected = self._lines.setdefault(file, {}), self._collected.setdefault(file, set())
                for line, places in lines.items():
                    covered.setdefault(int(line), set()).update(
                        tests[place] for place in places if place >= 0 and tests[place] not in failing
                    )
                    if -1 in places:
                        collected.add(int(line))

    def collected(self, file: str) -> list[int]:
        """The lines of a module that run while tests are collected."""
        return sorted(self._collected.get(file, ()))

    def chosen(self, file: str, line: int) -> list[str]:
        """The tests that reach the line, and the fast ones of those that use its module, the fastest first.

        A line that runs once, when the module is imported or a fixture made, is counted to no test or to one.
        """
        covered = self._lines.get(file, {})
        near = next((tests for at in range(line, line - 15, -1) if (tests := covered.get(at))), set[str]())
        using, spent = set[str]().union(*covered.values()), 0.0
        tests = self._fastest_first(near)
        for test in self._fastest_first(using - near):
            spent += self.seconds[test]
            if spent > FEW:
                break
            tests.append(test)
        return tests

    def _fastest_first(self, tests: set[str]) -> list[str]:
        return sorted(tests, key=lambda test: (self.seconds[test], test))


class Tree:
    """A copy of the tree with an environment of its own that sees this one's packages, for as long as it is open."""

    def __init__(self, top: Path):
        self._scratch = tempfile.TemporaryDirectory(prefix="mutants-")
        self.folder = Path(self._scratch.name, "tree")
        self._cache = Path(self._scratch.name, "cache")
        wanted = (
            "src",
            "tests",
            "problems",
            "solutions",
            "docs",
            "benchmarks",
            "pyproject.toml",
            "README.md",
        )
        self.folder.mkdir()
        for name in wanted:
            copy = shutil.copytree if (top / name).is_dir() else shutil.copy2
            copy(top / name, self.folder / name)
        environment = Path(self._scratch.name, "environment")
        venv.create(environment, symlinks=True)
        self._python = environment / "bin/python"
        (packages,) = environment.glob("lib/python*/site-packages")
        others = [str(Path(place)) for place in site.getsitepackages()]
        put = f"import sys; sys.path.insert(0, {str(self.folder / 'src')!r})"
        (packages / "tree.pth").write_text("\n".join([*others, put, ""]))
        for place in others:  # what else the environment has put on the path; not its own copy of the package
            for path in sys.path:
                if path.endswith("site-packages") and path != place:
                    with (packages / "tree.pth").open("a") as file:
                        file.write(f"{path}\n")
        self._servers: dict[str, subprocess.Popen[str]] = {}

    def __enter__(self) -> Tree:
        return self

    def __exit__(self, *error: object) -> None:
        for server in self._servers.values():
            server.kill()
            server.wait()
        self._scratch.cleanup()

    def learned(self, tests: str) -> dict[str, Any]:
        """What is learned about a file of tests: which of them reach which lines, and their seconds."""
        found = self._asked("learning", {"learn": tests, "cache": str(self._cache), "seconds": {}})
        if "done" not in found:
            raise RuntimeError(f"{tests} cannot be learned: {found}")
        return found["done"] | {"failing": found["failing"]}

    def ready(self) -> None:
        """Nothing more is learned."""
        if "learning" in self._servers:
            server = self._servers.pop("learning")
            server.kill()
            server.wait()

    def failing(self, learned: Learned, file: str, text: str, tests: list[str]) -> str | None:
        """The first of these tests that fails when the module has this text, or that never ends."""
        place = self.folder / file
        before = place.read_text(encoding="utf-8")
        state = place.stat()
        derives = file.split("/")[2] in ("formula", "answers")  # these decide how derivations are solved
        job = {
            "file": file,
            "text": text,
            "before": before,
            "tests": tests,
            "cache": "" if derives else str(self._cache),
            "seconds": {test: learned.seconds[test] for test in tests},
            "collected": learned.collected(file),
        }
        place.write_text(text, encoding="utf-8")
        try:
            found = self._asked("collected", job)
            if "fresh" in found:
                found = self._asked("fresh", job)
        finally:
            place.write_text(before, encoding="utf-8")
            os.utime(place, ns=(state.st_atime_ns, state.st_mtime_ns))  # what was derived stays good
        return found.get("failed")

    def _asked(self, mode: str, job: dict[str, Any]) -> dict[str, Any]:
        if mode not in self._servers:
            self._servers[mode] = subprocess.Popen(
                [self._python, SERVER, mode],
                cwd=self.folder,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
                env=os.environ
                | ENVIRONMENT
                | ({} if mode == "learning" else {"PYTHONDONTWRITEBYTECODE": "1"}),
            )
        server = self._servers[mode]
        assert server.stdin is not None
        assert server.stdout is not None
        server.stdin.write(json.dumps(job) + "\n")
        server.stdin.flush()
        line = server.stdout.readline()
        if not line:
            raise RuntimeError(f"the server of {mode} tests has ended")
        return json.loads(line)


def _digest(*paths: Path) -> str:
    return hashlib.sha256(b"\0".join(path.read_bytes() for path in paths)).hexdigest()
