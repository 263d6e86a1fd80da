"""The reading of an answer in words: the sentence of `check` in the notebook, before it is marked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from corollary.answers.answer import (
    Answer,
    Blank,
    Chain,
    Entries,
    Formulas,
    Letter,
    NamedForces,
    Numbers,
    Prose,
    Unclear,
)
from corollary.formula.plain_text import text
from corollary.messages import catalogue, in_convention

_ = catalogue(__name__)


@dataclass(frozen=True, slots=True)
class Preview:
    """What a student reads; `ok` when the answer can be marked as it stands."""

    ok: bool
    text: str


def about_open_words(words: str) -> str:
    """What the words beside a number make of it."""
    return _(
        "your teacher will read “{words}”; write only the number and its unit",
        words=words,
    )


def preview_of(answer: Answer) -> Preview:
    """How an answer was read, or why it could not be."""
    match answer:
        case Blank():
            return Preview(False, _("no answer yet"))
        case Unclear(why):
            return Preview(False, _("cannot be read: {why}", why=why))
        case Numbers(as_read=as_read, misfit=why) if why:
            return Preview(False, _("read as {answer}: {remark}", answer=in_convention(as_read), remark=why))
        case Numbers(as_read=as_read, missing=how) if how:
            return Preview(True, _("read as {answer}, {how}", answer=in_convention(as_read), how=how))
        case Numbers(as_read=as_read, open_words=words) if words:
            remark = about_open_words(words)
            return Preview(
                True, _("read as {answer}; {remark}", answer=in_convention(as_read), remark=remark)
            )
        case Numbers(figures=figures, as_read=as_read):
            count = figures[0] if len(set(figures)) == 1 else 0
            if not count:
                return Preview(True, _("read as {answer}", answer=in_convention(as_read)))
            read = _.plural(
                "read as {answer} ({count} figure)",
                "read as {answer} ({count} figures)",
                count,
                answer=in_convention(as_read),
            )
            return Preview(True, read)
        case Formulas(_trees, as_read) | Letter(_trees, as_read) | NamedForces(_trees, as_read):
            return Preview(True, _("read as {answer}", answer=in_convention(as_read)))
        case Entries(entries, as_read):
            return _of_entries(entries, _("read as {answer}", answer=in_convention(as_read)))
        case Chain(steps):
            read = _.plural(
                "read as {count} equation: {equations}",
                "read as {count} equations: {equations}",
                len(steps),
                equations="; ".join(text(step.relation) for step in steps),
            )
            if own := ", ".join(step.defines for step in steps if step.defines):
                read += "; " + _("letters of your own: {own}", own=own)
            unknown = next((step for step in steps if step.undefined), None)
            if unknown is None:
                return Preview(True, read)
            remark = _(
                "{letter} in line {line} is not a letter of the problem, and no line defines it",
                letter=unknown.undefined,
                line=unknown.line,
            )
            return Preview(False, f"{read}: {remark}")
        case Prose():
            return Preview(True, _("your teacher will read it"))
        case _:
            assert_never(answer)


def _of_entries(entries: tuple[Answer, ...], read: str) -> Preview:
    """A table can be marked as it stands when each of its entries can."""
    found = [preview_of(each) for each in entries if not isinstance(each, Blank)]
    if (bad := next((each for each in found if not each.ok), None)) is not None:
        return Preview(False, f"{read}; {bad.text}")
    empty = len(entries) - len(found)
    if empty:
        left = _.plural("{count} entry is empty", "{count} entries are empty", empty)
        return Preview(False, f"{read}; {left}")
    return Preview(True, read)
