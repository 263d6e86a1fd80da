"""Runs the steps of the Dockerfile as plain commands, where there is no docker: what COPY copies and RUN runs, in a fresh folder.

FROM, USER, ENV and ENTRYPOINT describe the container and are not played, but that the entry point is there is looked at.
Paths below /opt and /corollary lead into the fresh folder; what only root may do in a container (useradd) is left out and said.
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
OF_THE_CONTAINER = ("useradd", "apt-get")
PLACES = ("/opt/", "/corollary")


def steps(text: str) -> Iterator[tuple[str, str]]:
    """The instructions of a Dockerfile and what follows each, lines that go on put together."""
    whole = ""
    for line in text.splitlines():
        if not whole and (not line.strip() or line.lstrip().startswith("#")):
            continue
        whole += line.removesuffix("\\")
        if not line.endswith("\\"):
            word, _, rest = whole.strip().partition(" ")
            yield word.upper(), rest.strip()
            whole = ""


def copied(source: Path, target: Path) -> None:
    """What COPY . . brings: the files that git knows, or would, as .dockerignore leaves them."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"],
        cwd=source,
        capture_output=True,
        check=True,
    )
    for name in filter(None, listed.stdout.decode().split("\0")):
        if (source / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source / name, target / name)


def play(text: str, fresh: Path) -> None:
    """Every step in its order. Raises CalledProcessError for the first that fails, ValueError for one that is not known."""
    work, entry = fresh, []
    for word, rest in steps(text):
        match word:
            case "WORKDIR":
                work = fresh / rest.lstrip("/")
                work.mkdir(parents=True, exist_ok=True)
            case "COPY" if rest == ". .":
                copied(TOP, work)
            case "RUN" if rest.startswith(OF_THE_CONTAINER):
                print(f"== not played here: {rest}", flush=True)
            case "RUN":
                command = rest
                for place in PLACES:
                    command = command.replace(f" {place}", f" {fresh}{place}")
                    command = f"{fresh}{command}" if command.startswith(place) else command
                print(f"== {rest}", flush=True)
                subprocess.run(
                    ["sh", "-euc", command], cwd=work, check=True, env=os.environ | {"HOME": str(fresh)}
                )
            case "ENTRYPOINT":
                entry = json.loads(rest)
            case "FROM" | "USER" | "ENV" | "CMD":
                continue
            case _:
                raise ValueError(f"Dockerfile: {word} {rest}: play it here too")
    found = next((fresh / "opt").glob(f"*/bin/{shlex.quote(entry[0])}"), None)
    if found is None:
        raise ValueError(f"Dockerfile: the entry point {entry} is nowhere in what was installed")
    subprocess.run([found, "doctor"], cwd=fresh, check=False)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        try:
            play((TOP / "Dockerfile").read_text(encoding="utf-8"), Path(folder))
        except (subprocess.CalledProcessError, ValueError) as error:
            sys.exit(str(error))
