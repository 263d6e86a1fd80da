"""The templates that translators start from hold what the package says."""

from __future__ import annotations

import ast
import runpy
from collections.abc import Iterator
from pathlib import Path

from babel.messages.pofile import read_po

TOP = Path(__file__).parents[2]
PACKAGE = TOP / "src" / "corollary"


def test_templates_are_up_to_date() -> None:
    wanted = runpy.run_path(str(TOP / ".ci" / "messages.py"))["templates"]()
    assert len(wanted) >= 2
    templates = {*PACKAGE.glob("*/locale/*.pot"), *(TOP / "solutions").glob("locale/*.pot")}
    assert set(wanted) == templates, "run make messages"
    for place, text in wanted.items():
        assert place.read_text(encoding="utf-8") == text, f"run make messages: {place.name}"


def test_a_text_that_students_read_is_in_its_rooms_template() -> None:
    answers = (PACKAGE / "answers" / "locale" / "corollary.answers.pot").read_text(encoding="utf-8")
    assert 'msgid "' in answers
    assert "msgid_plural" in "".join(
        place.read_text(encoding="utf-8") for place in PACKAGE.glob("*/locale/*.pot")
    )


def spoken(path: Path) -> Iterator[str]:
    """The literal texts that a module gives to a catalogue."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and ast.unparse(node.func) in ("_", "_.plural", "N_"):
            for each in node.args[:1]:
                if isinstance(each, ast.Constant):
                    yield each.value


def test_no_text_is_hidden_from_who_extracts_them() -> None:
    """As one inside an f-string is."""
    for template in (*PACKAGE.glob("*/locale/*.pot"), TOP / "solutions" / "locale" / "messages.pot"):
        room = template.parents[1]
        with template.open("rb") as file:
            known = {
                each
                for message in read_po(file)
                for each in ((message.id,) if isinstance(message.id, str) else message.id)
            }
        for path in room.rglob("*.py"):
            assert set(spoken(path)) <= known, path
