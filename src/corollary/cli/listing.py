"""`corollary list`: every problem of a bank."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from corollary import plug_ins, user_cache
from corollary.cli.ending import FAILS, HOLDS, answer, counted, refuse
from corollary.cli.terminal import console
from corollary.messages import did_you_mean
from corollary.problem.bank import Bank, chapter_bank, chapter_order, files, open_bank
from corollary.version import __version__

HEADINGS = ("code", "title", "topic", "givens", "parts", "answers", "variants")
ROOMY, LEFT_OUT = 110, ("topic", "answers")  # on a narrower terminal words would be cut in two
_SORT: dict[str, Callable[[dict[str, Any]], Any]] = {
    "code": lambda record: chapter_order(record["code"]),
    "title": lambda record: record["title"].lower(),
    "topic": lambda record: (record["topic"], chapter_order(record["code"])),
    "parts": lambda record: len(record["parts"]),
    "variants": lambda record: record["variants"],
}
ROOMS = ("formula", "units", "answers", "problem", "cli/listed.py")  # what decides how a problem is listed
PLUG_INS = ("corollary.banks", "corollary.answers")


def run(
    bank: Path | None,
    as_json: bool,
    topic: list[str],
    kind: list[str],
    person: bool,
    sort: str | None,
) -> int:
    found, broken = listed(open_bank(bank))
    _known("--topic", topic, {record["topic"] for record, _ in found})
    _known("--type", kind, {name for record, _ in found for name in _kinds(record)})
    found = [
        (record, row)
        for record, row in found
        if (not topic or record["topic"] in topic)
        and (not kind or _kinds(record) & set(kind))
        and (not person or any(part["person"] for part in record["parts"].values()))
    ]
    if sort is not None:
        found.sort(key=lambda each: _SORT[sort](each[0]))
    if as_json:
        answer([record for record, _ in found])
        return _status(broken)
    from rich.markup import escape
    from rich.table import Table

    problems, parts = len(found), sum(len(record["parts"]) for record, _ in found)
    out = console()
    headings = [name for name in HEADINGS if out.width >= ROOMY or name not in LEFT_OUT]
    table = Table(
        title=f"{counted(problems, 'problem')}, {counted(parts, 'part')} (* waits for a person)",
        title_justify="left",
        title_style="bold",
        caption=None
        if len(headings) == len(HEADINGS)
        else f"{' and '.join(LEFT_OUT)}: from {ROOMY} columns on",
        caption_justify="left",
    )
    for heading in headings:
        table.add_column(
            heading,
            justify="right" if heading == "variants" else "left",
            no_wrap=heading in ("code", "variants"),
            overflow="fold",
        )
    for _, row in found:
        table.add_row(*(escape(cell) for name, cell in zip(HEADINGS, row, strict=True) if name in headings))
    out.print(table)
    return _status(broken)


def _status(broken: list[str]) -> int:
    """What is wrong with files that cannot be listed, on standard error, and the exit status."""
    if broken:
        print("", *broken, sep="\n", file=sys.stderr)
    return FAILS if broken else HOLDS


def _known(option: str, named: list[str], have: set[str]) -> None:
    for name in named:
        if name not in have:
            refuse(
                f"{option} {name} is in no problem{did_you_mean(name, have)}; choose one of {', '.join(sorted(have))}"
            )


def _kinds(record: dict[str, Any]) -> set[str]:
    """The answer types of a problem's parts."""
    return {name for part in record["parts"].values() for name in part["kind"].split("+")}


def listed(bank: Bank) -> tuple[list[tuple[dict[str, Any], list[str]]], list[str]]:
    """Every problem that can be read, as a record and as a row of the table, and what is wrong with the others.

    Counting the variants takes most of a second; so it is done once for the same files and programs.
    """
    origin = _origin(bank)
    name = f"list-{hashlib.sha256(bank.place.encode()).hexdigest()[:16]}"
    if (text := user_cache.read(name, origin)) is not None:
        return json.loads(text), []
    from corollary.answers.questions import askable  # with formulas, units and numpy
    from corollary.cli.listed import listed as made

    problems, broken = askable(bank)
    found = made(problems)
    if not broken:
        user_cache.write(name, origin, json.dumps(found).encode())
    return found, list(map(str, broken))


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
