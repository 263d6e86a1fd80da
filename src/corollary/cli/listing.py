"""`corollary list`: every problem of a bank."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

from corollary import plug_ins, user_cache
from corollary.cli.ending import HOLDS, answer
from corollary.problem.bank import Bank, chapter_bank, files, load, open_bank
from corollary.version import __version__

HEADINGS = ("code", "title", "givens", "parts", "variants")
ROOMS = ("formula", "units", "answers", "problem", "cli/listed.py")  # what decides how a problem is listed
PLUG_INS = ("corollary.banks", "corollary.answers")


def run(bank: Path | None, as_json: bool) -> int:
    found = listed(open_bank(bank))
    if as_json:
        answer([record for record, _ in found])
        return HOLDS
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table(title=f"{len(found)} problems, {sum(len(record['parts']) for record, _ in found)} parts")
    for heading in HEADINGS:
        one_line = heading in ("code", "variants")
        table.add_column(heading, justify="right" if heading == "variants" else "left", no_wrap=one_line)
    for _, row in found:
        table.add_row(*map(escape, row))
    Console().print(table)
    return HOLDS


def listed(bank: Bank) -> list[tuple[dict[str, Any], list[str]]]:
    """Every problem, as a record and as a row of the table. Raises Malformed.

    Counting the variants takes most of a second; so it is done once for the same files and programs.
    """
    origin = _origin(bank)
    name = f"list-{hashlib.sha256(bank.place.encode()).hexdigest()[:16]}"
    if (text := user_cache.read(name, origin)) is not None:
        return json.loads(text)
    from corollary.cli.listed import listed as made  # with formulas, units and numpy

    found = made(load(bank))
    user_cache.write(name, origin, json.dumps(found).encode())
    return found


def _origin(bank: Bank) -> str:
    """Tells apart whatever could be listed differently: the files, the installed packages, our own programs."""
    brought = "" if bank == chapter_bank() else plug_ins.state(PLUG_INS)  # the chapter needs none of them
    digest = hashlib.sha256(repr((__version__, sys.version, user_cache.programs(ROOMS), brought)).encode())
    for path in files(bank):
        text = b""
        with suppress(OSError):  # what cannot be read is complained of when it is
            text = path.read_bytes()
        digest.update(b"\0".join((b"", os.fsencode(path), str(len(text)).encode(), text)))
    return digest.hexdigest()
