"""What holds for all tests: none is timed, so none fails on a busy machine; none draws examples by luck; none touches what a user keeps."""

from __future__ import annotations

import gc
import io
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import pytest
from babel.messages.catalog import Catalog
from babel.messages.mofile import write_mo
from hypothesis import settings
from tests import programs
from tests.lender import Lender

from corollary import messages, plug_ins
from corollary.cli import main
from corollary.sandbox import runner

# The same examples in every run; `HYPOTHESIS_PROFILE=searching make test` draws others, and more of them.
settings.register_profile("repeatable", deadline=None, derandomize=True)
settings.register_profile("searching", deadline=None, max_examples=1000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "repeatable"))

NOT_NEEDED: dict[str, Any] = {main.NOT_NEEDED: None}
"""As the command has it: jsonschema would take seconds to load it."""
CACHE = "COROLLARY_TESTS_CACHE"
"""Names a folder of solved derivations that outlives a run: what one run has solved, the next one with the same programs has not to."""


def pytest_configure(config) -> None:
    """One cache folder for all tests of a run; processes that run tests side by side have it from the first.

    Nor does the width of whoever's terminal started the tests reach them.
    """
    os.environ.pop("COLUMNS", None)
    sys.modules.update(NOT_NEEDED)
    if "PYTEST_XDIST_WORKER" not in os.environ:
        config.stash_folder = tempfile.mkdtemp(prefix="corollary-tests-")
        os.environ["XDG_CACHE_HOME"] = os.environ.get(CACHE) or config.stash_folder
        config.stash_programs = os.environ[programs.FOLDER] = tempfile.mkdtemp(prefix="corollary-programs-")
        programs.make_folder(Path(config.stash_programs))


def pytest_collection_finish() -> None:
    """What is there before the first test stays: looking through it again and again would be a tenth of the time."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)


def pytest_unconfigure(config) -> None:
    if "PYTEST_XDIST_WORKER" not in os.environ:
        shutil.rmtree(config.stash_folder, ignore_errors=True)
        shutil.rmtree(config.stash_programs, ignore_errors=True)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """A test that no marker keeps out of `make test` finds the programs of a bare machine, and its fixtures do."""
    before = os.environ["PATH"]
    os.environ["PATH"] = programs.path_for(item) or before
    try:
        return (yield)
    finally:
        os.environ["PATH"] = before


AXE = "axe-core@4.14.1"


@pytest.fixture(scope="session")
def chromium():
    """A browser, for tests with the marker `browser`; it may reach this machine and nothing else."""
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=120_000)  # a loaded machine takes its time; a page that is wrong stays wrong
    names = ("chromium", "chromium-browser", "google-chrome")
    program = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, names)), None)
    quiet = "--no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking"
    alone = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"
    with sync_playwright() as player:
        # Without a program of the system's, playwright takes its own (`playwright install chromium`), or says that it is missing.
        browser = player.chromium.launch(executable_path=program, args=[*quiet.split(), alone])
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def axe(tmp_path_factory) -> str:
    """The accessibility engine axe-core, fetched by npm."""
    npm = shutil.which("npm")
    assert npm is not None, "npm is missing: it fetches axe-core, which looks for what shuts readers out"
    folder = tmp_path_factory.mktemp("axe")
    subprocess.run(
        [npm, "install", "--no-audit", "--no-fund", "--prefix", folder, AXE], check=True, timeout=600
    )
    return (folder / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def jupyter():
    """A function that starts a Jupyter of a kind (`lab`, `server`) on a folder of notebooks, and gives its address while it is
    needed; its own files lie in another folder."""

    @contextmanager
    def started(kind: str, root: Path, own: Path, *options: str) -> Iterator[str]:
        with socket.create_server(("127.0.0.1", 0)) as found:
            port = found.getsockname()[1]
        command = [str(Path(sys.executable).parent / "jupyter"), kind, "--no-browser", "--allow-root"]
        served = [f"--port={port}", f"--ServerApp.root_dir={root}", "--IdentityProvider.token=", *options]
        places = {name: str(own / name) for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "IPYTHONDIR")}
        log = own / "jupyter.log"
        with log.open("w") as written:
            server = subprocess.Popen(
                [*command, *served], cwd=root, env=os.environ | places, stdout=written, stderr=written
            )
        address = f"http://127.0.0.1:{port}"
        try:
            while True:
                try:
                    urlopen(f"{address}/api").close()
                    break
                except OSError:
                    assert server.poll() is None, log.read_text()
                    time.sleep(0.2)
            yield address
        finally:
            server.terminate()
            server.wait()

    return started


@pytest.fixture(scope="session")
def _lender() -> Iterator[Lender]:
    lender = Lender()
    yield lender
    lender.end()


@pytest.fixture
def one_zygote(_lender: Lender, monkeypatch: pytest.MonkeyPatch) -> None:
    """For tests whose matter is what becomes of answers: the runners of this process run notebooks with one zygote in turn."""
    monkeypatch.setattr(runner, "Zygote", _lender)


@pytest.fixture(autouse=True)
def in_english() -> Iterator[None]:
    """A course in another language has this process speak it from then on."""
    yield
    messages.speak("en")


@pytest.fixture
def calls_of():
    """How many functions something calls, those of C included: work that does not depend on the machine."""

    def count_of(run) -> int:
        count = 0

        def counted(frame, event, argument):
            nonlocal count
            count += event in ("call", "c_call")

        before = sys.getprofile()
        sys.setprofile(counted)
        try:
            run()
        finally:
            sys.setprofile(before)
        return count

    return count_of


@pytest.fixture
def open_to_everybody() -> None:
    """For tests that run as an ordinary user, who must be able to read the checkout and the environment."""
    for place in (Path(sys.executable), Path(sys.prefix), Path(__file__)):
        for folder in place.absolute().parents:
            if not folder.stat().st_mode & 0o001:
                pytest.skip(f"only its owner may enter {folder}, so no ordinary user can run what lies in it")


@pytest.fixture
def installed(tmp_path_factory, monkeypatch):
    """Installs a package for this test: its name, its entry points by group, and its files' texts by path."""
    folder = tmp_path_factory.mktemp("packages")
    before = set(sys.modules)

    def install(name: str, points: dict[str, list[str]], files: dict[str, str] | None = None) -> Path:
        place = folder / name
        about = place / f"{name}-1.0.dist-info"
        about.mkdir(parents=True)
        (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        lines = [line for group, named in points.items() for line in (f"[{group}]", *named)]
        (about / "entry_points.txt").write_text("\n".join([*lines, ""]))
        for file, text in (files or {}).items():
            path = place / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        monkeypatch.syspath_prepend(place)
        plug_ins.plug_ins.cache_clear()
        plug_ins.state.cache_clear()
        return place

    yield install
    plug_ins.plug_ins.cache_clear()
    plug_ins.state.cache_clear()
    for module in set(sys.modules) - before:
        if str(folder) in (getattr(sys.modules[module], "__file__", "") or ""):
            del sys.modules[module]


@pytest.fixture
def translated() -> Iterator[Callable[[str, Mapping[str, str]], None]]:
    """Translates texts of a room into a language that no room knows, for one test: `translated("corollary.derive", texts)`."""
    domains: list[str] = []

    def put(domain: str, texts: Mapping[str, str]) -> None:
        catalogue, out = Catalog(locale="eo"), io.BytesIO()
        for english, other in texts.items():
            catalogue.add(english, other)
        write_mo(out, catalogue)
        messages.carry(domain, "eo", out.getvalue())
        domains.append(domain)

    yield put
    for domain in domains:
        messages.carry(domain, "eo", b"")
