"""What is said to a student whose answer could not be read, or could be read in two ways."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


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


def refused(why: str, position: int | None = None, suggestion: str = "") -> ParseError:
    """No reading."""
    return ParseError("refused", why, position, suggestion)


def ambiguous(why: str, position: int | None, *choices: str) -> ParseError:
    """Several readings: the student chooses."""
    return ParseError("asked", why, position, "write " + " or ".join(choices), choices)


def sentence(trouble: ParseError) -> str:
    """What the student reads: where, what, what to do."""
    where = "" if trouble.position is None else f"at character {trouble.position + 1}: "
    what = f"; {trouble.suggestion}" if trouble.suggestion else ""
    return f"{where}{trouble.why}{what}"
