"""What an author writes in a solution: finds because of laws, and the other things a part may need."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # what is solved already is used without any algebra, and sympy takes half a second to load
    import sympy
    from sympy.logic.boolalg import Boolean

    from corollary.grading.programs.remarks import Remark, Said
    from corollary.laws.law import Law


@dataclass(frozen=True, slots=True)
class Mistake:
    """The same step with one law exchanged: `laws` take the place of the law named `instead` (or of the only one)."""

    text: str
    laws: tuple[Law, ...]
    instead: str


@dataclass(frozen=True, slots=True)
class Route:
    """Another way to the same find, by other laws."""

    because: str
    laws: tuple[Law, ...]


@dataclass(frozen=True, slots=True)
class Rejected:
    """A root that satisfies the laws and is not the answer, and why."""

    reason: str
    root: Mapping[sympy.Symbol, sympy.Expr]


@dataclass(frozen=True, slots=True)
class Step:
    """Something found because of laws. `also` are unknowns that the laws need and nobody asks for."""

    finds: tuple[sympy.Symbol, ...]
    because: str
    laws: tuple[Law, ...]
    answers: str
    also: tuple[sympy.Symbol, ...]
    where: Boolean | bool
    rejected: tuple[Rejected, ...]
    mistakes: tuple[Mistake, ...]
    routes: tuple[Route, ...]
    check: str
    scale: sympy.Expr | None


@dataclass(frozen=True, slots=True)
class Optimum:
    """The value of one letter, between bounds, that makes something as large (or small) as it can be."""

    finds: tuple[sympy.Symbol, ...]
    because: str
    of: sympy.Expr
    over: sympy.Symbol
    between: tuple[sympy.Expr, sympy.Expr]
    largest: bool
    answers: str
    mistakes: tuple[Mistake, ...]
    check: str


@dataclass(frozen=True, slots=True)
class Simulated:
    """Finds measured in a simulated scene, where no closed form is at hand. Settings are formulas of givens and finds."""

    finds: tuple[sympy.Symbol, ...]
    because: str
    scene: str
    settings: Mapping[str, sympy.Expr]
    observe: str
    answers: str
    mistakes: tuple[Mistake, ...]
    check: str


@dataclass(frozen=True, slots=True)
class Choice:
    """The option whose condition holds for the numbers drawn; exactly one must. `mistakes` say what the others overlook."""

    part: str
    because: str
    options: Mapping[str, Boolean | bool]
    mistakes: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Example:
    """Numbers of the student's own that satisfy the laws, none of the `apart` values, and leave `free` unknowns free."""

    part: str
    finds: tuple[sympy.Symbol, ...]
    because: str
    laws: tuple[Law, ...]
    apart: tuple[tuple[tuple[sympy.Expr, ...], str], ...]
    free: int
    scale: sympy.Expr


@dataclass(frozen=True, slots=True)
class Code:
    """A function the student writes: drawn inputs, and a judge of what it returned for all of them."""

    part: str
    because: str
    inputs: Callable[[Mapping[str, float], Callable[[float, float], float]], Sequence[Mapping[str, Any]]]
    judge: Callable[..., Said | Remark | None]
    example: str


@dataclass(frozen=True, slots=True)
class Plot:
    """What a figure must show: judged by its data, axes and labels. `judge` answers None, or a sentence on what is missing."""

    part: str
    because: str
    judge: Callable[..., Said | None]
    example: str


@dataclass(frozen=True, slots=True)
class Proof:
    """A chain of equations, each following from the last: the first a law, the last the target."""

    part: str
    because: str
    laws: tuple[Law, ...]
    target: Law
    lines: tuple[str, ...]
    mistakes: tuple[Mistake, ...]


@dataclass(frozen=True, slots=True)
class Explain:
    """Free text for a person to mark: the rubric, and what a full answer says."""

    part: str
    rubric: tuple[str, ...]
    answer: str


@dataclass(frozen=True, slots=True)
class Printed:
    """A value the chapter prints for its own numbers, as printed; verification rounds ours to its figures."""

    part: str
    text: str
    where: str


@dataclass(frozen=True, slots=True)
class Supposed:
    """A value that the problem does not give, with its unit, and why it may be supposed."""

    symbol: sympy.Symbol
    text: str
    why: str


@dataclass(frozen=True, slots=True)
class Neglected:
    """Something that the answer of a part leaves out: `bound` finds, from laws, the most that this can change of it.

    `asked`: the question itself wants it left out; then the bound is told, and may be large.
    """

    what: str
    bound: Step
    supposing: tuple[Supposed, ...]
    asked: bool


Found = Step | Optimum | Simulated
Entry = Found | Choice | Example | Code | Plot | Proof | Explain | Printed | Neglected


@dataclass(frozen=True, slots=True)
class Derivation:
    """The entries in the order in which they are found."""

    entries: tuple[Entry, ...]
