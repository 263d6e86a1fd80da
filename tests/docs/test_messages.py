"""The templates that translators start from hold what the package says."""

from __future__ import annotations

import runpy
from pathlib import Path

TOP = Path(__file__).parents[2]
PACKAGE = TOP / "src" / "corollary"


def test_templates_are_up_to_date() -> None:
    wanted = runpy.run_path(str(TOP / ".ci" / "messages.py"))["templates"]()
    assert len(wanted) >= 2
    assert set(wanted) == set(PACKAGE.glob("*/locale/*.pot")), "run make messages"
    for place, text in wanted.items():
        assert place.read_text(encoding="utf-8") == text, f"run make messages: {place.name}"


def test_a_text_that_students_read_is_in_its_rooms_template() -> None:
    answers = (PACKAGE / "answers" / "locale" / "corollary.answers.pot").read_text(encoding="utf-8")
    assert 'msgid "' in answers
    assert "msgid_plural" in "".join(
        place.read_text(encoding="utf-8") for place in PACKAGE.glob("*/locale/*.pot")
    )
