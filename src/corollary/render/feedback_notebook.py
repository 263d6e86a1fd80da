"""Feedback as a notebook, for an LMS that gives it back under the name of the notebook that was handed in."""

from __future__ import annotations

import json
import re
from html import unescape

from corollary.messages import catalogue
from corollary.records.marks import Record
from corollary.render.feedback_facts import PageFacts
from corollary.render.feedback_page import MarkedPart, marked_exercises
from corollary.render.wording import earned

_ = catalogue(__name__)
TAG = re.compile(r"<[^>]*>")
# What Markdown would take for more than text, in an answer or in what a person wrote.
MARKED_UP = re.compile(r"([\\`*_\[\]<>#$|~!])")


def feedback_notebook(facts: PageFacts, record: Record) -> str:
    """The text of a notebook with the marks, the answers as they were read, and what is said of them."""
    total = _("of {out_of} points", out_of=earned(record.out_of))
    cells = [
        f"# {_literal(facts.set_title)}",
        _("Feedback for {name}", name=_literal(facts.student)),
        f"**{earned(record.points)}** {total}",
        *(_literal(note) for note in (record.trouble, *record.notes) if note),
    ]
    texts = ["\n\n".join(cells)]
    for exercise in marked_exercises(facts, record):
        texts.append(f"## {exercise.facts.code} {_literal(exercise.facts.title)}")
        texts += map(_of_part, exercise.parts)
    return json.dumps(
        {
            "cells": [
                {"cell_type": "markdown", "id": f"feedback-{number}", "metadata": {}, "source": text}
                for number, text in enumerate(texts)
            ],
            "metadata": {},
            "nbformat": 4,
            "nbformat_minor": 5,
        },
        ensure_ascii=False,
    )


def _of_part(part: MarkedPart) -> str:
    marks = _("{points} of {out_of}", points=earned(part.record.points), out_of=earned(part.record.out_of))
    texts = [
        f"### ({part.facts.id}) {_literal(unescape(TAG.sub('', part.facts.title)))}",
        f"**{part.look.phrase}** ({marks})",
        f"{part.facts.introduction} {_literal(part.answer)}" if part.facts.introduction else "",
        _literal(part.comment),
        part.feedback,
    ]
    return "\n\n".join(text for text in texts if text)


def _literal(text: str) -> str:
    return MARKED_UP.sub(r"\\\1", text)
