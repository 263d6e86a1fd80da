"""What hostile files cost the audit: `python benchmarks/hostile_files.py` writes `results/hostile_files.md`."""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

RESULT = Path(__file__).with_name("results") / "hostile_files.md"
SIZE = 1_000_000  # characters
SLOW = 2.0  # seconds


def main() -> None:
    sys.path.insert(0, str(Path(__file__).parents[1]))
    from tests.audit.hostile_files import hostile_files

    from corollary.audit.limited_reading import SECONDS, WAITING, LimitedReader

    rows: list[tuple[float, str, str]] = []
    with tempfile.TemporaryDirectory() as name, LimitedReader(None, None) as reader:
        folder = Path(name)
        for path in hostile_files(folder, SIZE):
            started = time.perf_counter()
            found = reader.read(path)
            taken = time.perf_counter() - started
            why = found.trouble or next((each.unread for each in found.records if each.unread), "is read")
            rows.append((taken, str(path.relative_to(folder)), why.splitlines()[0]))
    slow = [row for row in sorted(rows, reverse=True) if row[0] > SLOW]
    stopped = sum("was not read within" in why for _, _, why in rows)
    lines = [
        "# Hostile files",
        "",
        f"`python benchmarks/hostile_files.py`: {len(rows)} files of `tests/audit/hostile_files.py`, those of repeated pieces of about "
        f"{SIZE:,} characters, each read in the interpreter that may take {SECONDS:.0f} s of the processor, {WAITING:.0f} s on the wall and "
        f"1 GiB. None ended the command; {stopped} had to be stopped; {len(rows) - len(slow)} took less than {SLOW:.0f} s "
        f"(the machine's load was {os.getloadavg()[0]:.0f} on {os.cpu_count()} cores). The others:",
        "",
        "| file | s | what is said of it |",
        "|---|---|---|",
        *(f"| `{name}` | {taken:.1f} | {why} |" for taken, name, why in slow),
    ]
    RESULT.write_text("\n".join([*lines, ""]), encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
