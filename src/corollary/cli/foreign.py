"""Said once of each bank, where a person reads it: its solutions are programs that run on this machine."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from corollary import user_cache

KNOWN = "banks-used"


def first_use(options: Mapping[str, Any]) -> str:
    """What to say of the banks that are used for the first time and are not the chapter's; nothing where no person reads it."""
    if not sys.stderr.isatty():
        return ""
    from corollary.problem.bank import CHAPTER, VARIABLE, chapter_bank

    banks = str(options["bank"] or os.environ.get(VARIABLE, "")).split(os.pathsep)
    code = str(options.get("code") or "")
    if not any(banks) and code.endswith(".md"):  # the bank is the folder above its problems/
        banks = [str(above.parent) for above in Path(code).resolve().parents if above.name == "problems"][:1]
    named = {str(Path(bank).resolve()) if Path(bank).is_dir() else bank for bank in banks if bank}
    new = named - {CHAPTER, str(chapter_bank().folder)} - set(known())
    if not new:
        return ""
    remember(new)
    return (
        f"{', '.join(sorted(new))}: solutions of a bank are Python programs, which run as you and may do what you may; "
        "use banks of people you trust (said once for each bank)"
    )


def known() -> list[str]:
    """The banks used before."""
    return json.loads(user_cache.read(KNOWN, KNOWN) or b"[]")


def remember(banks: set[str]) -> None:
    user_cache.write(KNOWN, KNOWN, json.dumps(sorted({*known(), *banks})).encode())
