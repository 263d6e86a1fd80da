"""A file written whole or not at all, whenever the power goes or the disk fills."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Final

SIDE_BY_SIDE: Final = 8
"""Files that wait for the disk at a time."""


def write_whole(path: Path, content: str | bytes, *, mode: int = 0o644) -> None:
    """Writes aside and moves into place: readers find the old file or the new one. Folders are made as needed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, draft = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:40]}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
            file.flush()
            os.fsync(file.fileno())  # else the move may reach the disk before what was moved
        os.chmod(draft, mode)
        os.replace(draft, path)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise


def write_each_whole(files: Mapping[Path, str | bytes]) -> None:
    """Many files, each whole or not at all, in no order and side by side: what takes the time is waiting for the disk."""
    from concurrent.futures import ThreadPoolExecutor  # most commands write no files, or one

    with ThreadPoolExecutor(min(SIDE_BY_SIDE, len(files) or 1)) as pool:
        for written in [pool.submit(write_whole, path, content) for path, content in files.items()]:
            written.result()


def write_files(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Writes them below the folder, and says where they are."""
    placed = {folder / name: content for name, content in files.items()}
    write_each_whole(placed)
    return list(placed)
