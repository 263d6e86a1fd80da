"""Errors of formulas: a text that has no reading or several, and a formula that has no value."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from corollary.messages import catalogue

_ = catalogue(__name__)


class Undefined(ArithmeticError):
    """The formula has no value at these numbers."""


class NotAvailable(ArithmeticError):
    """An arithmetic lacks a function of the formula."""


@dataclass(frozen=True, slots=True)
class ParseError:
    """Why a text is no answer yet: `asked` when it has several readings (`choices`), `refused` when it has none.

    `position` counts characters of the text from 0; None when the whole text is meant.
    """

    status: Literal["asked", "refused"]
    why: str
    position: int | None = None
    suggestion: str = ""
    choices: tuple[str, ...] = ()

    def moved(self, by: int) -> ParseError:
        """The same of a text that stands `by` characters further on in what was typed."""
        return self if self.position is None else replace(self, position=self.position + by)

    def without_place(self) -> ParseError:
        """The same of a text that was rewritten before it was read, so that no place in it is one in what was typed."""
        return replace(self, position=None)


def refused(why: str, position: int | None = None, suggestion: str = "") -> ParseError:
    """No reading."""
    return ParseError("refused", why, position, suggestion)


def ambiguous(why: str, position: int | None, *choices: str) -> ParseError:
    """Several readings: the student chooses."""
    return ParseError("asked", why, position, _("write {choices}", choices=_(" or ").join(choices)), choices)


def sentence(error: ParseError) -> str:
    """What the student reads: where, what, what to do."""
    where = "" if error.position is None else _("at character {place}: ", place=error.position + 1)
    return where + error.why + (f"; {error.suggestion}" if error.suggestion else "")
