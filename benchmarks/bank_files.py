"""How many files of banks the audit reads: `python benchmarks/bank_files.py` writes `results/bank_files.md`."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

RESULT = Path(__file__).with_name("results") / "bank_files.md"


def main() -> None:
    sys.path.insert(0, str(Path(__file__).parents[1]))
    from tests.content.audit_files_read import FAMILIES, ORDER, files_read

    found = {family: list(files_read(family)) for family in FAMILIES}
    lines = [
        "# Files of banks that are read",
        "",
        "`python benchmarks/bank_files.py`, the files of `tests/content/audit_files`: twenty for each format, written before its reader "
        "was looked into, and `traps`, which mean something else than they seem to. A file is *right* where each of its answers has "
        "the finding that is true of it (which is *cannot say* of an essay); *refused* ones end the command with a sentence.",
        "",
        "| format | files | right | cannot say | refused | misread |",
        "|---|---|---|---|---|---|",
    ]
    for family, files in found.items():
        counts = Counter(each.outcome for each in files)
        lines.append(f"| {family} | {len(files)} | " + " | ".join(str(counts[each]) for each in ORDER) + " |")
    lines += ["", "What is not read, and why:", ""]
    for family, files in found.items():
        lines += [
            f"- {family}, `{each.name}`: {' '.join(each.why.split())}"
            for each in files
            if each.outcome != "right"
        ]
    RESULT.write_text("\n".join([*lines, ""]), encoding="utf-8")
    print("\n".join(lines[4 : 6 + len(found)]))


if __name__ == "__main__":
    main()
