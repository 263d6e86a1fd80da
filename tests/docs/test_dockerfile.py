"""The Dockerfile's steps, which the gate runs as plain commands: what is played, and what is not taken for played."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

TOP = Path(__file__).parents[2]


@pytest.fixture
def dockerfile(monkeypatch):
    monkeypatch.syspath_prepend(str(TOP / ".ci"))
    yield import_module("dockerfile")
    sys.modules.pop("dockerfile")


def test_every_step_of_ours_is_one_the_gate_knows(dockerfile):
    found = list(dockerfile.steps((TOP / "Dockerfile").read_text(encoding="utf-8")))
    assert found[0][0] == "FROM"
    played = [
        rest for word, rest in found if word == "RUN" and not rest.startswith(dockerfile.OF_THE_CONTAINER)
    ]
    assert any("pip install" in each and "constraints.txt" in each for each in played)
    assert [word for word, _ in found].index("USER") > max(
        at for at, (word, _) in enumerate(found) if word == "RUN"
    )
    assert "dockerfile.py" in (TOP / ".ci" / "run").read_text(encoding="utf-8")


def test_what_runs_and_what_is_copied_lies_in_the_fresh_folder(dockerfile, tmp_path: Path):
    text = """
# a comment
FROM nothing
WORKDIR /corollary
COPY . .
RUN mkdir -p /opt/tool/bin && \\
    printf '#!/bin/sh\\necho "$@" > said' > /opt/tool/bin/corollary
RUN chmod +x /opt/tool/bin/corollary
RUN useradd nobody-makes-this
ENTRYPOINT ["corollary"]
"""
    dockerfile.play(text, tmp_path)
    assert (tmp_path / "corollary" / "pyproject.toml").is_file()
    assert not (tmp_path / "corollary" / ".git").exists()
    assert (tmp_path / "said").read_text() == "doctor\n"


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("FROM nothing\nRUN exit 3\n", subprocess.CalledProcessError),
        ("FROM nothing\nADD https://somewhere /\n", ValueError),
        ('FROM nothing\nENTRYPOINT ["corollary"]\n', ValueError),
    ],
)
def test_a_step_that_fails_or_is_not_known_fails(
    dockerfile, tmp_path: Path, text: str, error: type[Exception]
):
    with pytest.raises(error):
        dockerfile.play(text, tmp_path)
