"""The page on plug-ins has the tested package's files, and what answers, expectations and questions hold, as the code is now."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import fields
from pathlib import Path
from typing import get_args

from corollary.answers.answer import Answer
from corollary.answers.question import Question

TOP = Path(__file__).parents[2]
PAGE = (TOP / "docs" / "howto" / "add_an_answer_type.md").read_text(encoding="utf-8")


def test_the_page_is_up_to_date():
    done = subprocess.run([sys.executable, TOP / ".ci" / "plug_in_page.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/plug_in_page.py writes it anew"


def test_every_form_of_an_answer_and_every_field_of_a_question_is_named():
    for kind in get_args(Answer):
        assert f"`{kind.__name__}`" in PAGE
    for each in fields(Question):
        assert f"`{each.name}`" in PAGE
