"""What stopped the cells of a class is named with who, how many and what to do; a missing package costs nobody a mark unseen."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest
from tests import forked

from .conftest import COMMAND, grade

KEY = "X12_5_a"
BY_ITSELF = ("env",)  # an interpreter of its own, which looks for packages where it is told to


def changed(course: Path, student: str, source: str, *, ran: bool = False) -> None:
    """The student's answer cell of part (a) with another source, in which VALUE is the right value."""
    path = course / "submitted" / student / "one" / "one.ipynb"
    book = json.loads(path.read_text())
    cell = next(each for each in book["cells"] if each["id"] == f"{KEY}_answer")
    value = "".join(cell["source"]).partition("=")[2].strip()
    cell |= {"source": source.replace("VALUE", value), "execution_count": 3 if ran else None}
    path.write_text(json.dumps(book))


def rows(document: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {row["kind"]: row for row in document["stopped"]}


def part(document: dict[str, Any], student: str) -> dict[str, Any]:
    return document["students"][student]["parts"][KEY]


WITH_PACKAGE = "import pandas as pd\nX12_5_a = pd.value(VALUE)"


def installed(folder: Path) -> dict[str, str]:
    """The setting of an environment in which something called pandas is installed."""
    package = folder / "site-packages" / "pandas"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("def value(number):\n    return number\n")
    return {"PYTHONPATH": str(package.parent)}


@pytest.mark.whole
def test_a_missing_package_leaves_its_part_to_a_person_until_it_is_installed(
    handed_in: Path, tmp_path: Path
) -> None:
    changed(handed_in, "ada", WITH_PACKAGE)
    changed(handed_in, "ben", WITH_PACKAGE)
    document = grade(handed_in).document
    assert {part(document, one)["verdict"] for one in ("ada", "ben")} == {"unmarked"}
    row = rows(document)["package"]
    assert (row["about"], row["count"], row["students"], row["parts"]) == ("pandas", 2, ["ada", "ben"], [KEY])
    assert "pip install pandas" in row["do"]
    report = forked.run(
        [COMMAND, "report", "one", "--course", str(handed_in), "--json"],
        capture_output=True, encoding="utf-8", check=True, timeout=60,
    )  # fmt: skip
    assert json.loads(report.stdout)["stopped"] == document["stopped"]
    assert "the package pandas is missing" in (handed_in / "reports" / "one.html").read_text()
    assert grade(handed_in).document["graded"] == 0

    # Nobody has to agree to marks that were waited for; who missed nothing is not marked again.
    after = grade(handed_in, by=BY_ITSELF, **installed(tmp_path))
    assert (after.status, after.document["graded"]) == (0, 2)
    assert after.points == {"ada": 5.0, "ben": 5.0, "cyd": 5.0}
    assert {each["why"] for each in after.document["changed"]} == {"changed: the package pandas"}
    assert not after.document["stopped"]
    again = grade(handed_in, by=BY_ITSELF, PYTHONPATH=os.fspath(tmp_path / "site-packages"))
    assert again.document["graded"] == 0


IMPORT = "try:\n    import pandas as pd\nexcept ImportError:\n    pd = None\n"


def test_a_package_whose_absence_a_cell_catches_leaves_its_part_to_a_person(handed_in: Path) -> None:
    changed(handed_in, "ada", f"{IMPORT}if pd:\n    X12_5_a = pd.value(VALUE)")
    changed(handed_in, "ben", f"{IMPORT}X12_5_a = pd.value(VALUE) if pd else 0")
    changed(handed_in, "cyd", f"{IMPORT}X12_5_a = VALUE")
    document = grade(handed_in).document
    assert [part(document, one)["verdict"] for one in ("ada", "ben", "cyd")] == [
        "unmarked",
        "unmarked",
        "right",
    ]
    (row,) = document["stopped"]
    assert (row["about"], row["students"], row["parts"], row["waits"]) == (
        "pandas",
        ["ada", "ben"],
        [KEY],
        True,
    )
    assert "may depend on pandas" in part(document, "ben")["feedback"]

    changed(handed_in, "ada", f"{IMPORT}X12_5_a = pd.value(VALUE)")
    book = json.loads((file := handed_in / "submitted/ben/one/one.ipynb").read_text())
    at = next(k for k, each in enumerate(book["cells"]) if each["id"] == f"{KEY}_answer")
    above = {"cell_type": "code", "id": "extra", "metadata": {}, "outputs": [], "execution_count": 1}
    book["cells"].insert(at, above | {"source": f"{IMPORT}frame = pd and pd.value(1)"})
    book["cells"][at + 1]["source"] = "X12_5_a = frame + 1"
    file.write_text(json.dumps(book))
    document = grade(handed_in).document
    assert [part(document, one)["verdict"] for one in ("ada", "ben")] == ["unmarked", "unmarked"]
    assert [(row["about"], row["parts"]) for row in document["stopped"] if row["waits"]] == [
        ("pandas", [KEY])
    ]


def test_a_package_that_is_not_among_the_declared_is_the_students_matter(handed_in: Path) -> None:
    changed(handed_in, "ada", WITH_PACKAGE)
    grade(handed_in)
    settings = handed_in / "corollary.toml"
    settings.write_text(f"{settings.read_text()}\npackages = []\n")
    document = grade(handed_in).document
    assert part(document, "ada")["verdict"] == "unread"
    assert "this sheet's packages are numpy, scipy, matplotlib, sympy" in part(document, "ada")["feedback"]
    assert rows(document)["package"]["waits"] is False


STOPPED = {
    "input": ("X12_5_a = float(input('p?'))", "nobody sits at the keyboard"),
    "exit": ("import sys\nsys.exit()\nX12_5_a = VALUE", "sys.exit()"),
    "magic": ("# timed\n%%time\nX12_5_a = VALUE", "%%time"),
    "memory": ("numbers = bytearray(10**12)\nX12_5_a = VALUE", "memory"),
    "time": ("while True: pass", "ran longer than 20 s"),
    "version": ("import math\nmath.trapz()\nX12_5_a = VALUE", "math.trapz"),
}


@pytest.mark.whole
@pytest.mark.parametrize("kinds", [("input", "exit", "magic"), ("memory", "time", "version")])
def test_every_kind_of_stop_is_named_to_both(handed_in: Path, kinds: tuple[str, ...]) -> None:
    for student, kind in zip(("ada", "ben", "cyd"), kinds, strict=True):
        changed(handed_in, student, STOPPED[kind][0])
    document = grade(handed_in).document
    assert set(rows(document)) == set(kinds)
    for student, kind in zip(("ada", "ben", "cyd"), kinds, strict=True):
        assert rows(document)[kind]["students"] == [student]
        assert rows(document)[kind]["do"]
        feedback = part(document, student)["feedback"]
        assert STOPPED[kind][1] in feedback
        page = (handed_in / "feedback" / student / "one" / "one.html").read_text()
        marked = (handed_in / "autograded" / student / "one" / "one.ipynb").read_text()
        for word in (
            "KeyboardInterrupt",
            "StdinNotImplementedError",
            "UsageError",
            "SystemExit",
            "MemoryError",
        ):
            assert word not in feedback
            assert word not in page
        assert "KeyboardInterrupt" not in marked


def test_what_ran_on_the_students_computer_waits_for_a_person(handed_in: Path) -> None:
    """A function that another version of numpy has: the file shows that the cell ran to its end there."""
    source = "import numpy as np\nz = np.trapz_of_old([1, 2])\nX12_5_a = VALUE"
    changed(handed_in, "ada", source, ran=True)
    changed(handed_in, "ben", source)
    document = grade(handed_in).document
    assert [part(document, one)["verdict"] for one in ("ada", "ben")] == ["unmarked", "unread"]
    assert {row["students"][0]: row["waits"] for row in document["stopped"]} == {"ada": True, "ben": False}
