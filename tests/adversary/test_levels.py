"""What each isolation level says it guarantees is so, seen from outside; as an ordinary user, and without each layer."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from . import kernel

FOUR = {"reads", "writes", "signals", "network"}
HERE = Path(__file__).parent


@pytest.fixture
def everybodys() -> Iterator[Path]:
    """A folder that any user may enter and write to; pytest's own are for one user, and each session makes them so again."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o777)
        yield Path(folder)


def as_ordinary_user(script: str, *arguments: str, folder: Path) -> dict[str, Any]:
    """What the script prints; `folder` is its home and holds its temporary files."""
    environment = {**os.environ, "HOME": str(folder), "TMPDIR": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, str(HERE / "ordinary_user.py"), str(HERE / script), *arguments]
    done = subprocess.run(command, env=environment, cwd="/", capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.parametrize(
    "without",
    [
        (),
        ("namespaces",),
        ("Landlock",),
        ("seccomp",),
        ("landlockpy", "pyseccomp"),
        *(
            pytest.param(without, marks=pytest.mark.whole)
            for without in (
                ("namespaces", "Landlock"),
                ("namespaces", "seccomp"),
                ("namespaces", "landlockpy", "pyseccomp"),
            )
        ),
    ],
    ids=" ".join,
)
@pytest.mark.usefixtures("open_to_everybody")
def test_what_is_guaranteed_to_an_ordinary_user_is_so(without: tuple[str, ...], everybodys: Path) -> None:
    found = as_ordinary_user("bystanders.py", *without, folder=everybodys)
    assert found["ran"] == ["ok", "ok"]
    assert found["level"] == found["promised"], found
    for guarantee in found["guaranteed"]:
        assert found[guarantee], (guarantee, found)
    assert (found["level"] >= 1) == (set(found["guaranteed"]) == FOUR)
    if not {"seccomp", "pyseccomp"} & set(without) and kernel.has_seccomp():
        assert {"signals", "network"} <= set(found["guaranteed"])
    assert found["zygote"], "a notebook opened the zygote's memory"
    for layer, library in (("Landlock", "landlockpy"), ("seccomp", "pyseccomp")):
        if library in without:
            assert any(each.startswith(layer) and "extra `isolation`" in each for each in found["missing"])


def test_the_kernel_is_asked_and_not_the_package() -> None:
    assert kernel.promised() >= kernel.promised(frozenset({"namespaces"}))
    assert kernel.promised(frozenset({"namespaces", "seccomp"})) == 0
