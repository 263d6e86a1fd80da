"""The signs of a formula as they are read, and the ways to leave the reading: refuse, or ask."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NoReturn

from corollary.formula.ast import Expr
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.lexer import Token
from corollary.formula.plain_text import text
from corollary.messages import catalogue

_ = catalogue(__name__)

Lean = Literal[
    "ask", "near", "far"
]  # what has two readings: ask, let `cos θ/M` and `a/b c` end near, or let them reach far


class Stop(Exception):
    """Leaves the reading, wherever it is, with what is to be said."""

    def __init__(self, trouble: ParseError) -> None:
        self.trouble = trouble


@dataclass(slots=True)
class Line:
    """The signs, and how far they have been read."""

    tokens: list[Token]
    student: bool
    lean: Lean = "ask"
    numbers: bool = False
    at: int = 0
    depth: int = 0
    bars: list[int] = field(default_factory=list[int])  # depth of brackets at each | still open

    @property
    def next(self) -> Token:
        return self.tokens[self.at]

    @property
    def after(self) -> Token:
        return self.tokens[min(self.at + 1, len(self.tokens) - 1)]

    def take(self) -> Token:
        token = self.tokens[self.at]
        self.at += 1
        return token


def refuse(why: str, at: int, suggestion: str = "") -> NoReturn:
    raise Stop(refused(why, at, suggestion))


def ask(why: str, at: int, *choices: Expr) -> NoReturn:
    raise Stop(ambiguous(why, at, *map(text, choices)))


def unexpected(line: Line) -> NoReturn:
    token = line.next
    match token.kind:
        case "end":
            refuse(_("the formula stops too early"), token.at)
        case "comma":
            refuse(_("a comma does not belong here"), token.at, _("write decimals with a point, such as 1.5"))
        case "compare" if line.student:
            refuse(
                _("{text} does not belong here", text=token.text),
                token.at,
                _("write only the right side, one formula"),
            )
        case "compare":
            refuse(_("only two sides are compared at a time"), token.at, _("write two conditions"))
        case "close":
            refuse(_("this bracket closes nothing"), token.at)
        case _:
            refuse(_("{text} does not belong here", text=token.text), token.at)
