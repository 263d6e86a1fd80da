"""Tests held ready in a copy of the tree, and run in a fork for each mutant, or for each file whose lines are learned.

Started by `mutant_tests.py` in the folder of the copy: `collected` has imported and collected the tests once, and puts a mutant in
place by exchanging the code of the functions that are there; `fresh` has imported only the libraries, for mutants of what runs while
a module is imported. Jobs and what came of them are lines of JSON.
"""

# pyright: reportMissingImports=false, reportUnknownMemberType=false, reportPrivateUsage=false, reportAttributeAccessIssue=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
from __future__ import annotations

import gc
import json
import os
import resource
import select
import shutil
import signal
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import pytest

ROOMS = ("grading", "formula", "answers")
Job = dict[str, Any]
LIBRARIES = ("numpy", "sympy", "scipy.integrate", "flint", "hypothesis", "yaml", "msgspec")
MEMORY = 6_000_000_000
OPTIONS = ("-q", "-s", "-p", "no:cacheprovider", "-m", "not whole")


class Server:
    """Jobs from one stream, what came of them to the other, for as long as the first is open."""

    def __init__(self, jobs: int, answers: int):
        self._jobs, self._answers = os.fdopen(jobs), os.fdopen(answers, "w")
        self.session: pytest.Session | None = None
        self.cover: Any = None
        self._report = self._number = -1

    # Hooks of pytest

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        self.session = session
        if self._report >= 0:
            self._tests()
        else:
            self.serve()
        return True

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if self._report >= 0 and report.failed:
            self._say("failed", report.nodeid)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            assert self._report >= 0, report.longrepr
            self._say("failed", f"{report.nodeid}, collected")

    def serve(self) -> None:
        for line in self._jobs:
            json.dump(self._done(json.loads(line)), self._answers)
            self._answers.write("\n")
            self._answers.flush()

    # One job

    def _done(self, job: Job) -> Job:
        """What came of a job; its fork is ended, with all that it started, when a test takes far too long."""
        if self.session and "file" in job and not exchanged(job, False):
            return {"fresh": True}
        scratch = tempfile.mkdtemp(prefix="mutant-")
        reading, self._report = os.pipe()
        child = os.fork()
        if not child:
            os.close(reading)
            self._child(job, scratch)
        os.close(self._report)
        self._report = -1
        done, test, failed, idle, rest = {}, "", None, 0, b""
        broken: list[str] = []
        while failed is None and not done:
            ready, _, _ = select.select([reading], [], [], 10)
            if not ready:  # no limit to the clock on the wall: others may need the machine
                idle = 0 if _at_work(child) else idle + 1
                failed = f"time: {test}" if idle > 12 else None
                continue
            some, idle = os.read(reading, 1 << 20), 0
            if not some:
                failed = f"time or memory: {test}"
            *lines, rest = (rest + some).split(b"\n")
            for word, said in map(json.loads, lines):
                match word:
                    case "start":
                        test = said
                    case "failed" if "learn" in job:
                        broken.append(said)
                    case "failed":
                        failed = failed or said
                    case _:
                        done = {"done": said, "failing": broken}
        with suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
        os.close(reading)
        os.waitpid(child, 0)
        shutil.rmtree(scratch, ignore_errors=True)
        return {"failed": failed} if failed else done

    def _child(self, job: Job, scratch: str) -> None:
        try:
            os.setsid()
            for stream in (1, 2):
                os.dup2(0, stream)
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            os.environ["TMPDIR"] = tempfile.tempdir = scratch
            os.environ["XDG_CACHE_HOME"] = job["cache"] or scratch
            self._job = job
            if self.session is None:
                files = list(dict.fromkeys(test.partition("::")[0] for test in job["tests"]))
                pytest.main([*OPTIONS, f"--basetemp={scratch}/tests", *files], plugins=[self])
            else:
                self.session.config._tmp_path_factory._basetemp = Path(scratch, "tests")
                Path(scratch, "tests").mkdir()
                if "file" in job:
                    exchanged(job, True)
                self._tests()
        finally:
            os._exit(0)

    def _tests(self) -> None:
        """In the fork: the tests of the job in their order, up to the first that fails."""
        assert self.session is not None
        items = {item.nodeid: item for item in self.session.items}
        names = self._job.get("tests") or [
            name for name in items if name.startswith(self._job["learn"] + "::")
        ]
        chosen = [items[name] for name in names if name in items]
        found: dict[str, float] = {}
        for item, after in zip(chosen, [*chosen[1:], None], strict=False):  # none, in a file of long tests
            self._say("start", item.nodeid)
            if self.cover:
                self.cover.switch_context(item.nodeid)
            else:  # of the processor, so that a busy machine ends nothing
                signal.setitimer(signal.ITIMER_VIRTUAL, 10 + 20 * self._job["seconds"].get(item.nodeid, 10))
            start = sum(os.times()[:4])
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=after)
            found[item.nodeid] = sum(os.times()[:4]) - start
        self._say("done", self._learned(found) if self.cover else None)

    def _learned(self, seconds: dict[str, float]) -> Job:
        """Seconds of each test; by file and line, the places of the tests in `seconds`, -1 for what ran while collecting."""
        self.cover.stop()
        data = self.cover.get_data()
        places = {name: place for place, name in enumerate(seconds)} | {"": -1}
        lines = {
            os.path.relpath(file): {
                line: [places[name] for name in names]
                for line, names in data.contexts_by_lineno(file).items()
            }
            for file in data.measured_files()
        }
        return {"seconds": seconds, "lines": lines}

    def _say(self, word: str, what: object) -> None:
        text = json.dumps([word, what]).encode() + b"\n"
        while text:
            text = text[os.write(self._report, text) :]


def _at_work(process: int) -> bool:
    """Whether a process or one that it started has something to compute, or waits for the disk (proc(5))."""
    parents, busy = {}, set()
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            state, parent = stat.read_text().rpartition(")")[2].split()[:2]
            parents[int(stat.parent.name)] = int(parent)
            if state in "RD":
                busy.add(int(stat.parent.name))
    return any(process in _line(one, parents) for one in busy)


def _line(process: int, parents: dict[int, int]) -> Iterator[int]:
    while process:
        yield process
        process = parents.get(process, 0)


def exchanged(job: Job, really: bool) -> bool:
    """Whether a mutant is a change of functions that are there and have not run yet; `really` puts it in place."""
    path = str(Path(job["file"]).resolve())
    new = compile(job["text"], path, "exec", dont_inherit=True)
    old = compile(job["before"], path, "exec", dont_inherit=True)
    olds, news = dict(_functions(old)), dict(_functions(new))
    if _own(old) != _own(new) or len(olds) != len(list(_functions(old))):
        return False
    changed = {key for key, code in olds.items() if key in news and news[key] != code}
    ran = set(job["collected"])
    live = [
        each
        for each in gc.get_objects()
        if isinstance(each, FunctionType)
        and each.__code__.co_filename == path
        and _key(each.__code__) in changed
    ]
    if not changed or {_key(each.__code__) for each in live} != changed:
        return False
    for key in changed:
        within = {line for *_, line in olds[key].co_lines() if line} - {olds[key].co_firstlineno}
        if within & ran:
            return False
    if any(len(each.__code__.co_freevars) != len(news[_key(each.__code__)].co_freevars) for each in live):
        return False
    if really:
        for each in live:
            each.__code__ = news[_key(each.__code__)]
    return True


def _key(code: CodeType) -> tuple[str, int]:
    return code.co_qualname, code.co_firstlineno


def _functions(code: CodeType) -> Iterator[tuple[tuple[str, int], CodeType]]:
    """The outermost functions of a module, those of its classes among them."""
    for each in code.co_consts:
        if isinstance(each, CodeType):
            if each.co_flags & 1 and not each.co_name.startswith(
                "<"
            ):  # CO_OPTIMIZED: a function and no class
                yield _key(each), each
            else:
                yield from _functions(each)


def _own(code: CodeType) -> tuple[Any, ...]:
    """All of a module that is not in one of those functions."""
    inner = tuple(
        (_key(each) if each.co_flags & 1 and not each.co_name.startswith("<") else _own(each))
        if isinstance(each, CodeType)
        else (type(each), each)
        for each in code.co_consts
    )
    return code.co_code, code.co_names, inner


def main() -> None:
    mode = sys.argv[1]
    server = Server(os.dup(0), os.dup(1))
    os.dup2(os.open(os.devnull, os.O_RDWR), 0)
    os.dup2(2, 1)
    for library in LIBRARIES:
        __import__(library)
    if mode == "fresh":
        server.serve()
        return
    if mode == "learning":
        import coverage

        folders = [f"src/corollary/{room}" for room in ROOMS]
        server.cover = coverage.Coverage(source=folders, data_file=None)
        server.cover.start()
    pytest.main([*OPTIONS, *(f"tests/{room}" for room in ROOMS)], plugins=[server])


if __name__ == "__main__":
    main()
