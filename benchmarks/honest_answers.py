"""Answers as students type them, honest and wrong, marked by this version and by an earlier one: a table of what became of each.

python benchmarks/honest_answers.py [--before COMMIT]    (writes benchmarks/results/honest_answers.md)
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tarfile
import tempfile
from collections import Counter
from io import BytesIO
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
ANSWERS = ROOT / "tests" / "grading" / "answers"
RESULT = Path(__file__).parent / "results" / "honest_answers.md"
BEFORE = "5e3d326"  # the last version before answers were read by these rules
FULL = ("right", "follows")
LONGEST = 70


def asked() -> list[dict[str, Any]]:
    """Every question with its answers, "honest" or "wrong", by group."""
    return [
        {"honest": name == "honest", "group": group, **question}
        for name in ("honest", "wrong")
        for group, questions in json.loads(
            ANSWERS.joinpath(f"{name}.json").read_text(encoding="utf-8")
        ).items()
        for question in questions
    ]


def verdicts() -> list[list[str]]:
    """For each question the verdicts on its answers, each as if it were the only one given."""
    import corollary

    bank, solutions, found = corollary.load_bank(), dict[str, Any](), list[list[str]]()
    for question in asked():
        code, part = question["code"], question["part"]
        solution = solutions.setdefault(code, corollary.solve(bank[code]))
        line: list[str] = []
        for answer in question["answers"]:
            try:
                grade = corollary.judge(solution, {part: answer}, question["given"])
                verdict = next(each.verdict for each in grade.parts if each.part.id == part)
                line.append(type(verdict).__name__.lower())
            except Exception as error:
                line.append(type(error).__name__)
        found.append(line)
    return found


def verdicts_of(commit: str) -> list[list[str]]:
    """The same by an earlier version, taken out of git into a folder of its own."""
    archive = subprocess.run(
        ["git", "archive", commit, "src", "problems", "solutions"], cwd=ROOT, capture_output=True, check=True
    )
    with tempfile.TemporaryDirectory() as folder:
        with tarfile.open(fileobj=BytesIO(archive.stdout)) as files:
            files.extractall(folder, filter="data")
        environment = {**os.environ, "PYTHONPATH": str(Path(folder) / "src")}
        done = subprocess.run(
            [sys.executable, __file__, "--verdicts"],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
    return json.loads(done.stdout)


def table(before: list[list[str]], after: list[list[str]], commit: str) -> str:
    lines = [
        "# Answers as students type them",
        "",
        f"`python benchmarks/honest_answers.py --before {commit}`: the answers of `tests/grading/answers`, each marked alone.",
        "",
        "| | honest answers | right before | right now | wrong answers | right before | right now |",
        "|---|---|---|---|---|---|---|",
    ]
    counted: dict[str, Counter[str]] = {}
    for question, old, new in zip(asked(), before, after, strict=True):
        kind = "honest" if question["honest"] else "wrong"
        for group in (question["group"], "**all**"):
            count = counted.setdefault(group, Counter())
            count[kind] += len(new)
            count[f"{kind} before"] += sum(each in FULL for each in old)
            count[f"{kind} now"] += sum(each in FULL for each in new)
    columns = [f"{kind}{end}" for kind in ("honest", "wrong") for end in ("", " before", " now")]
    groups = [*(group for group in counted if group != "**all**"), "**all**"]
    lines += [
        f"| {group} | {' | '.join(str(counted[group][name]) for name in columns)} |" for group in groups
    ]
    lines += [
        "",
        "## Each honest answer that was not right before",
        "",
        "| part | answer | before | now |",
        "|---|---|---|---|",
    ]
    for question, old, new in zip(asked(), before, after, strict=True):
        for answer, was, is_now in zip(question["answers"], old, new, strict=True):
            if question["honest"] and was not in FULL:
                lines.append(
                    f"| {question['code']} {question['part']} | {_code(answer)} | {was} | {is_now} |"
                )
    return "\n".join(lines) + "\n"


def _code(answer: object) -> str:
    """The answer in a cell of a Markdown table."""
    text = json.dumps(answer, ensure_ascii=False)
    text = "".join(sign if sign.isprintable() else f"\\u{ord(sign):04x}" for sign in text)
    return f"`` {text[:LONGEST]} ``".replace("|", "\\|")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--before", default=BEFORE)
    parser.add_argument(
        "--verdicts", action="store_true", help="print the verdicts of the installed version only"
    )
    chosen = parser.parse_args()
    if chosen.verdicts:
        json.dump(verdicts(), sys.stdout)
        return
    before, after = verdicts_of(chosen.before), verdicts()
    RESULT.write_text(table(before, after, chosen.before), encoding="utf-8")
    print(RESULT.read_text(encoding="utf-8").partition("\n## ")[0])


if __name__ == "__main__":
    main()
