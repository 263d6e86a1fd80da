"""A first draft checked as this module is imported: processes forked later have all loaded that a check needs."""

from __future__ import annotations

import os
import tempfile
from contextlib import suppress
from pathlib import Path

from corollary.cli.draft import Draft, found_in
from corollary.cli.new import create
from corollary.problem.bank import Bank


def check_first_problem(folder: Path) -> None:
    """Check the problem that `corollary new` writes, as far as an author waits for it."""
    problem, _ = create(Bank(folder / "bank"), "Q1", "ride")
    for what, _ in found_in(folder / "draft", Draft(str(folder / "bank"), problem, {}, "en", False)):
        if what == "html":
            break


with suppress(Exception), tempfile.TemporaryDirectory(prefix="corollary-preview-") as made:
    before = os.environ.get("XDG_CACHE_HOME")
    os.environ["XDG_CACHE_HOME"] = made  # nothing of it stays
    try:
        check_first_problem(Path(made))
    finally:
        if before is None:
            del os.environ["XDG_CACHE_HOME"]
        else:
            os.environ["XDG_CACHE_HOME"] = before
