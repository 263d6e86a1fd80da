"""A package of npm, fetched and unpacked: programs for browsers, which pip does not have."""

from __future__ import annotations

import shutil
import subprocess
import tarfile
from pathlib import Path


class NotFetched(LookupError):
    """npm has no such package, or no network."""


class NoNpm(LookupError):
    """npm is not installed."""


def unpacked(package: str, place: Path) -> Path:
    """The folder of a package (`name@version`), unpacked into the empty folder `place`. Raises NoNpm, NotFetched."""
    npm = shutil.which("npm")
    if npm is None:
        raise NoNpm(package)
    done = subprocess.run([npm, "pack", package, "--silent"], cwd=place, capture_output=True, check=False)
    packed = next(place.glob("*.tgz"), None)
    if done.returncode or packed is None:
        raise NotFetched(package)
    with tarfile.open(packed) as archive:
        archive.extractall(place, filter="data")
    return place / "package"
