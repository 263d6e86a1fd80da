"""The user's cache: a text under a name, good for as long as what it was made from is the same."""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path

from corollary.atomic import write_whole

PACKAGE = Path(__file__).parent
LARGEST = 8_000_000


def read(name: str, origin: str) -> bytes | None:
    """The text of that name, if it is whole, the user's own, and was made from `origin`."""
    with suppress(OSError, ValueError, RuntimeError):
        with _place(name).open("rb") as file:
            if not _own(file.fileno()):
                return None
            made_from, digest, text = file.read(LARGEST).split(b"\n", 2)
        if (made_from.decode(), digest.decode()) == (origin, hashlib.sha256(text).hexdigest()):
            return text
    return None


def write(name: str, origin: str, text: bytes) -> None:
    """Written aside and moved, so that whoever reads at the same time finds all of it or nothing new.

    Readable to the user alone, since there may be answers in it. Where nothing can be written, nothing is.
    """
    with suppress(OSError, RuntimeError):
        place = _place(name)
        place.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        digest = hashlib.sha256(text).hexdigest()
        write_whole(place, b"\n".join((origin.encode(), digest.encode(), text)), mode=0o600)


def name_of(stem: str, path: Path) -> str:
    """A name for what is kept of a file: two that are called alike have each their own."""
    return f"{stem}-{hashlib.sha256(str(path).encode()).hexdigest()[:16]}"


def state(paths: Iterable[Path]) -> str:
    """Files by size and moment of change, not by text: reading whole programs takes longer than a command."""
    states = [(path, path.stat()) for path in paths]
    return "".join(f"{path} {each.st_size} {each.st_mtime_ns}\n" for path, each in states)


def programs(rooms: Iterable[str]) -> str:
    """The state of our own programs in these rooms (or files) of the package."""
    places = [PACKAGE / room for room in rooms]
    return state(
        path for place in places for path in ([place] if place.suffix else sorted(place.rglob("*.py")))
    )


def _own(descriptor: int) -> bool:
    """Whether the file is the user's; on Windows the user's folder is."""
    user: Callable[[], int] | None = getattr(os, "getuid", None)
    return user is None or os.fstat(descriptor).st_uid == user()


def folder() -> Path | None:
    """Where all of it lies; None when the user has no home."""
    try:
        return _place("any").parent
    except RuntimeError:
        return None


def _place(name: str) -> Path:
    """Raises RuntimeError when the user has no home, and so no folder of the platform's for what may be lost."""
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    if not named.is_absolute():
        named = Path.home() / ("Library/Caches" if sys.platform == "darwin" else ".cache")
    return named / "corollary" / f"{name}.json"
