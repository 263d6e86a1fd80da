"""The tests of three rooms in a copy of the tree: which covers which line, how long it takes, and which notices a change."""

from __future__ import annotations

import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from types import TracebackType

ROOMS = ("grading", "formula", "answers")
HEAVY = ("numpy", "sympy", "scipy.integrate", "flint", "hypothesis", "yaml", "msgspec", "pytest")
"""Imported once: each mutant is tried in a fork, which has them already."""
FEW = 8.0  # seconds of tests that use the module and are not seen to reach the line
LONGEST = 900  # seconds of wall clock for one mutant, at the lowest priority of a busy machine
MEMORY = 6_000_000_000

LEARN = """
import json, os, sys, time
import coverage, pytest

cover = coverage.Coverage(source=["src/corollary/" + room for room in sys.argv[2:]], data_file=None)

class Watch:
    found = {}

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item):
        cover.switch_context(item.nodeid)
        start = time.process_time()
        done = yield
        self.found.setdefault(item.nodeid, {})["seconds"] = time.process_time() - start
        return done

    def pytest_runtest_logreport(self, report):
        if not report.passed:
            self.found.setdefault(report.nodeid, {})["failed"] = True

cover.start()
pytest.main(["-q", "-p", "no:cacheprovider", *("tests/" + room for room in sys.argv[2:])], plugins=[Watch()])
cover.stop()
data = cover.get_data()
lines = {os.path.relpath(file): data.contexts_by_lineno(file) for file in data.measured_files()}
json.dump({"tests": Watch.found, "lines": lines}, open(sys.argv[1], "w"))
"""

WARM = """
from corollary.derive.cache import solution_of
from corollary.problem.bank import chapter_bank, load

for problem in load(chapter_bank()):
    solution_of(chapter_bank(), problem)
"""


class Tests:
    """A copy of the tree with its tests, for as long as it is open."""

    def __init__(self, top: Path, learned: Path):
        """`learned` is where what was learned about the tests lies, or is put."""
        self._learned = learned
        self._scratch = tempfile.TemporaryDirectory(prefix="mutants-")
        self.folder = Path(self._scratch.name, "tree")
        ignored = shutil.ignore_patterns(".git", ".venv", "demo", ".pytest_cache", ".ruff_cache")
        shutil.copytree(top, self.folder, ignore=ignored)

    def __enter__(self) -> Tests:
        os.chdir(self.folder)
        # As under xdist, so that tests/conftest.py leaves the cache folder to us: what is derived once serves every mutant.
        os.environ |= {"PYTHONPATH": str(self.folder / "src"), "PYTEST_XDIST_WORKER": "one"}
        os.environ["XDG_CACHE_HOME"] = str(self.folder / "cache")
        if not self._learned.is_file():
            subprocess.run([sys.executable, "-c", LEARN, str(self._learned), *ROOMS], check=True)
        subprocess.run([sys.executable, "-c", WARM], check=True)
        found = json.loads(self._learned.read_text(encoding="utf-8"))
        self.seconds = {
            test: each["seconds"] for test, each in found["tests"].items() if not each.get("failed")
        }
        self.lines: dict[str, dict[int, set[str]]] = {
            file: {
                int(line): {each for each in tests if each in self.seconds} for line, tests in lines.items()
            }
            for file, lines in found["lines"].items()
        }
        for library in HEAVY:
            __import__(library)
        sys.path.insert(0, str(self.folder / "src"))
        sys.dont_write_bytecode = True
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        os.chdir("/")
        self._scratch.cleanup()

    def tried(self, file: str, line: int, text: str) -> tuple[str, str]:
        """Whether a module with this text is noticed, and by which test.

        Run are the tests that reach the line, and the fast ones of those that use its module: a line that runs once, when
        the module is imported or a fixture made, is counted to no test or to one.
        """
        place = self.folder / file
        before, state = place.read_bytes(), place.stat()
        room = file.split("/")[2]
        covered = self.lines.get(file, {})
        near = next((tests for at in range(line, line - 15, -1) if (tests := covered.get(at))), set[str]())
        using = set[str]().union(*covered.values())
        place.write_text(text, encoding="utf-8")
        try:
            tests = self._fastest_first(near)
            others, spent = self._fastest_first(using - near), 0.0
            for test in others:
                spent += self.seconds[test]
                if spent > FEW:
                    break
                tests.append(test)
            for outcome, ours in (("killed", True), ("killed elsewhere", False)):
                for some in _portions([each for each in tests if each.startswith(f"tests/{room}/") == ours]):
                    by = self._failing(some)
                    if by is not None:
                        return outcome, by
        finally:
            place.write_bytes(before)
            os.utime(place, ns=(state.st_atime_ns, state.st_mtime_ns))  # what was derived stays good
        return "alive", ""

    def _fastest_first(self, tests: Iterable[str]) -> list[str]:
        return sorted(tests, key=lambda test: (self.seconds[test], test))

    def _failing(self, tests: list[str]) -> str | None:
        """The first of these tests that fails, in a process of its own; "time" when they never end."""
        with tempfile.TemporaryDirectory(prefix="mutant-") as scratch:
            shutil.copytree(self.folder / "cache", Path(scratch, "cache"))
            failed = Path(scratch, "failed")
            child = os.fork()
            if not child:
                _run(
                    tests, failed, Path(scratch, "cache"), 60 + 5 * sum(self.seconds[each] for each in tests)
                )
            status = _waited(child)
            if failed.is_file():
                return failed.read_text(encoding="utf-8")
            return None if status in (0, 5) else "time, memory, or the end of the process"


def _portions(tests: list[str]) -> list[list[str]]:
    """The fast tests first and alone: most mutants are noticed by these, and few files need be loaded for them."""
    return [each for each in (tests[:60], tests[60:]) if each]


def _run(tests: list[str], failed: Path, cache: Path, limit: float) -> None:
    """In the child: the tests in this order, up to the first that fails, whose name is written down."""
    status = 1
    try:
        os.setsid()
        os.environ["XDG_CACHE_HOME"] = str(cache)
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 5))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        nowhere = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nowhere, stream)
        import pytest

        order = {test: number for number, test in enumerate(tests)}

        class Watch:
            def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
                items[:] = sorted(
                    (each for each in items if each.nodeid in order), key=lambda each: order[each.nodeid]
                )

            def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
                if report.failed and not failed.exists():
                    failed.write_text(report.nodeid, encoding="utf-8")

            def pytest_collectreport(self, report: pytest.CollectReport) -> None:
                if report.failed and not failed.exists():
                    failed.write_text(f"{report.nodeid}, collected", encoding="utf-8")

        files = list(dict.fromkeys(test.partition("::")[0] for test in tests))
        status = int(pytest.main(["-q", "-x", "-p", "no:cacheprovider", *files], plugins=[Watch()]))
    finally:
        os._exit(status)


def _waited(child: int) -> int:
    """The status of the child; one that takes too long is ended with all that it started."""
    end = time.monotonic() + LONGEST
    status = None
    while status is None and time.monotonic() < end:
        ended, code = os.waitpid(child, os.WNOHANG)
        if ended:
            status = os.waitstatus_to_exitcode(code)
        else:
            time.sleep(0.05)
    with suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)
    if status is None:
        os.waitpid(child, 0)
        status = -signal.SIGKILL
    return status
