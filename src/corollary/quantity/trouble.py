"""What is said to a student whose answer could not be read, or could be read in two ways."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Trouble:
    """Why a text is no answer yet: `asked` when it has several readings (`choices`), `refused` when it has none.

    `position` counts characters of the text from 0; None when the whole text is meant.
    """

    status: Literal["asked", "refused"]
    why: str
    position: int | None = None
    suggestion: str = ""
    choices: tuple[str, ...] = ()


def refused(why: str, position: int | None = None, suggestion: str = "") -> Trouble:
    """No reading."""
    return Trouble("refused", why, position, suggestion)


def asked(why: str, position: int | None, *choices: str) -> Trouble:
    """Several readings: the student chooses."""
    return Trouble("asked", why, position, "write " + " or ".join(choices), choices)


def sentence(trouble: Trouble) -> str:
    """What the student reads: where, what, what to do."""
    where = "" if trouble.position is None else f"at character {trouble.position + 1}: "
    what = f"; {trouble.suggestion}" if trouble.suggestion else ""
    return f"{where}{trouble.why}{what}"
