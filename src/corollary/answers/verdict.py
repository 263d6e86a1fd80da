"""Verdicts on one answer: a closed family of seven.

Of a table, `entries` are the verdicts on its entries, each worth the same.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Right:
    """The answer is right; `note` says what a good marker would add (coarse, an unusual form).

    `leniently`: too few figures bring it near, or a slip that was paid for before.
    """

    note: str = ""
    leniently: bool = False


@dataclass(frozen=True, slots=True)
class Follows:
    """Right, given what the student found in earlier parts. `nothing`: it is only written down again, and earns nothing."""

    earlier: tuple[str, ...]
    nothing: bool = False
    entries: tuple[Verdict, ...] = ()


@dataclass(frozen=True, slots=True)
class Mistaken:
    """A known misconception was at work; `earlier` names parts whose slips came along.

    `nothing`: it made the answer zero, which everybody can write down who has not begun, so that it earns nothing.
    """

    mistake: str
    earlier: tuple[str, ...] = ()
    nothing: bool = False
    entries: tuple[Verdict, ...] = ()


@dataclass(frozen=True, slots=True)
class Slip:
    """A generic slip: sign, factor, power of ten, unit. `once`: it costs once, as it does not where it leaves open what was meant.

    `nothing`: a guess would do as well, so that it earns nothing. `factor`: by which the answer is off, where it is one number;
    the sentence need not tell it, and another factor is another slip.
    """

    slip: str
    once: bool = True
    nothing: bool = False
    factor: float = 1.0


@dataclass(frozen=True, slots=True)
class Wrong:
    """Read and understood, and not right; `why` is what can be said without giving the value away."""

    why: str = ""
    entries: tuple[Verdict, ...] = ()


@dataclass(frozen=True, slots=True)
class Unread:
    """No answer could be read; `why` says what was met and how to write it. `blank`: nothing was handed in."""

    why: str
    blank: bool = False


@dataclass(frozen=True, slots=True)
class Unmarked:
    """Waits for a person, with the rubric; never counted as wrong."""

    why: str
    rubric: tuple[str, ...] = ()


Verdict = Right | Follows | Mistaken | Slip | Wrong | Unread | Unmarked


def word(verdict: Verdict) -> str:
    """The verdict's name in reports and records."""
    return type(verdict).__name__.lower()


def described(verdict: Verdict) -> str:
    """The verdict's name, with its reason in brackets."""
    match verdict:
        case Wrong(why) | Mistaken(why) | Unread(why) | Unmarked(why) if why:
            return f"{word(verdict)} ({why})"
        case _:
            return word(verdict)
