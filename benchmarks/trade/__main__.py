"""The work-precision study in one command: python benchmarks/trade [--quick] [--draws 20] [--output docs/trade].

Makes the runs round by round, each family's draw after the other, and writes after each round, so that a run that is ended has what it
made; then tables and figures. `--drawn` makes only those, from runs that are there.
"""

from __future__ import annotations

import argparse
import json
import platform
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
if str(HERE.parent) not in sys.path:
    sys.path.insert(0, str(HERE.parent))
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != HERE]

DOCS = HERE.parents[1] / "docs" / "trade"


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="one draw of each family, a trial")
    parser.add_argument("--draws", type=int, default=20)
    parser.add_argument("--family", action="append", help="only this one; may be repeated")
    parser.add_argument("--output", type=Path, default=DOCS)
    parser.add_argument(
        "--drawn", action="store_true", help="only tables and figures of the runs that are in the folder"
    )
    asked = parser.parse_args(arguments)
    asked.output.mkdir(parents=True, exist_ok=True)
    path = asked.output / "runs.json"
    if not asked.drawn:
        _made(path, 1 if asked.quick else asked.draws, asked.family)
    from trade.study import figures, tables

    document = json.loads(path.read_text(encoding="utf-8"))
    figures.drawn(document, asked.output)
    text = tables.of(document)
    (asked.output / "tables.md").write_text(text, encoding="utf-8")
    print(text)
    return 0


def _made(path: Path, draws: int, families: list[str] | None) -> None:
    """All runs, in rounds; after each the file is whole."""
    from trade.study import measured

    chosen = families or list(measured.FAMILIES)
    runs: list[measured.Timed] = []
    begin, commit = time.process_time(), _commit()
    for draw in range(draws):
        for family in chosen:
            runs += measured.one_round(family, draw)
            print(
                f"draw {draw + 1}, {family}: {time.process_time() - begin:.0f} s of the processor",
                file=sys.stderr,
                flush=True,
            )
        found = {
            "commit": commit,
            "machine": _machine(),
            "draws": draw + 1,
            "seconds": round(time.process_time() - begin),
        }
        path.write_text(
            json.dumps(found | {"runs": measured.as_rows(runs)}, separators=(",", ":")) + "\n",
            encoding="utf-8",
        )
        print(
            f"draw {draw + 1} of {draws}: {time.process_time() - begin:.0f} s of the processor",
            file=sys.stderr,
            flush=True,
        )


def _commit() -> str:
    """What is checked out, with a plus where something is changed."""
    asked = ["git", "-C", str(HERE), "describe", "--always", "--dirty=+"]
    try:
        return subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _machine() -> str:
    import numpy
    import scipy

    return f"Python {platform.python_version()}, numpy {numpy.__version__}, scipy {scipy.__version__}, one core of a shared machine"


if __name__ == "__main__":
    sys.exit(main())
