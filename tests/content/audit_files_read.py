"""What the audit makes of the files in `audit_files`: read right, not read, refused, or misread."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from corollary.audit.audit import audit_each
from corollary.audit.bank_file import laws_by_id, records_of
from corollary.audit.record import ExerciseRecord
from corollary.problem.bank import chapter_bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.front_matter import TableNode, TextNode, document

FOLDER = Path(__file__).with_name("audit_files")
FAMILIES = sorted(each.name for each in FOLDER.iterdir() if each.is_dir())


@dataclass(frozen=True, slots=True)
class FileRead:
    """`outcome` is the worst of its exercises'; `why` says of each that is not read, why."""

    name: str
    outcome: str
    why: str


ORDER = ("right", "cannot say", "refused", "misread")


def files_read(family: str) -> Iterator[FileRead]:
    """Every file of a family, in their order."""
    folder = FOLDER / family
    path = folder / "laws.yaml"
    laws = laws_by_id(path if path.is_file() else None)
    expected = _expected(folder / "expected.yaml")
    refused: dict[str, str] = {}
    records: list[tuple[str, ExerciseRecord]] = []
    for name in expected:
        try:
            records += [(name, each) for each in records_of(folder / name, laws)]
        except Malformed as error:
            refused[name] = str(error)
    found: dict[str, dict[str, tuple[str, str]]] = {name: {} for name in expected}
    with audit_each([each for _, each in records], chapter_bank()) as each_found:
        for (name, _), outcomes in zip(records, each_found, strict=True):
            found[name] |= {each.record.id: (each.finding, each.why) for each in outcomes}
    for name, truths in expected.items():
        if name in refused:
            yield FileRead(name, "refused", refused[name])
            continue
        judged = [_judged(truth, *found[name].get(one, ("missing", ""))) for one, truth in truths.items()]
        worst = max((outcome for outcome, _ in judged), key=ORDER.index)
        yield FileRead(name, worst, "; ".join(why for _, why in judged if why))


def _judged(truth: str, finding: str, why: str) -> tuple[str, str]:
    if finding == truth:
        return "right", ""
    if finding == "cannot say" and why:
        return "cannot say", why
    return "misread", f"{finding} for {truth}"


def _expected(path: Path) -> dict[str, dict[str, str]]:
    root = document(path, path.read_text(encoding="utf-8"))
    assert isinstance(root, TableNode)
    found: dict[str, dict[str, str]] = {}
    for name, inside in root.entries.items():
        assert isinstance(inside, TableNode)
        found[name] = {one: node.text for one, node in inside.entries.items() if isinstance(node, TextNode)}
    return found
