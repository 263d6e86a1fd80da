"""Verdicts as the student reads them alone: in a notebook, on a page, in a browser without a key."""

from __future__ import annotations

from typing import assert_never

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.messages import catalogue

_ = catalogue(__name__)


def sentence(verdict: Verdict) -> str:
    """What is said of an answer beside its verdict, as Markdown; the verdict itself where there is nothing else."""
    match verdict:
        case Right(note):
            return note or _("Right.")
        case Follows(earlier, True):
            return _(
                "This repeats your answer in {parts}, which is not right, so it earns nothing here.",
                parts=_parts(earlier),
            )
        case Follows(earlier):
            return _(
                "This follows correctly from your answer in {parts}, though that answer is not right.",
                parts=_parts(earlier),
            )
        case Mistaken(mistake, earlier):
            if not earlier:
                return mistake
            return _(
                "{mistake} (Your answer in {parts} was carried along and costs nothing here.)",
                mistake=mistake,
                parts=_parts(earlier),
            )
        case Slip(slip):
            return slip
        case Wrong(why):
            return why or _("Not right yet.")
        case Unread(why):
            return why
        case Unmarked(why):
            return why
        case _:
            assert_never(verdict)


def _parts(earlier: tuple[str, ...]) -> str:
    return _(" and ").join(f"({part})" for part in earlier)
