"""The expectation of an answer: all that an answer type may judge it by; derivations are computed when asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from corollary.answers.question import Question
from corollary.answers.verdict import Verdict
from corollary.formula.ast import Expr, Relation

if TYPE_CHECKING:  # numbers are judged in a browser, too, where there is no ball arithmetic
    from corollary.formula.ball import RationalPi

Values = tuple[float, ...]
Point = Mapping[str, "RationalPi"]
"""A value for every letter, in SI."""


@dataclass(frozen=True, slots=True)
class FollowThrough:
    """A value that the laws give with the student's own answers to the parts `earlier` (none: with the givens alone).

    `misconceptions` and `slips` are the values that a known misconception, or a slip in what goes into the formulas, makes of
    it; with each the sentence that the student reads. None where the way is not the author's: then only the value itself counts.
    `moved` is the value with each number of those answers moved by half of its last figure: whoever went on with more figures
    than were written down comes to something between. `turned` are the values with the sign of one term of the part's own formula
    the other way round.
    """

    values: Values
    earlier: tuple[str, ...]
    misconceptions: Callable[[], Iterable[tuple[Values, str]]] | None = None
    slips: Callable[[], Iterable[tuple[Values, str]]] | None = None
    moved: Callable[[], Iterable[Values]] | None = None
    turned: Callable[[], Iterable[Values]] | None = None


@dataclass(frozen=True, slots=True)
class Quantity:
    """One number or several, in SI, and the formulas for them.

    `tolerance` is relative to `scale`: the length of the answer, or what the problem names where that is zero. A component
    smaller than `uncertain` (absolute) has no sign of its own, for rounding moves it that far. `formulas` are in givens alone
    (None: the values come from a simulation), to be compared on `domain`; `givens` are the student's numbers. `routes` are the
    values by each way from the givens, `follow_through` those and the ones by earlier answers. `scales` are what
    the tolerance of each entry of a table is relative to. `residue` says of each component that is zero how large (absolute) a
    number may be that stands for it. `counted`: a whole number, which nobody rounds. `signed` says which components
    have a sign to get wrong (empty: each). `explained_by_rounding` says of wrong values whether the right formulas give them when too
    few figures are carried.
    """

    values: Values
    scale: float
    tolerance: float
    uncertain: Values
    givens: Callable[[], Point]
    formulas: tuple[Expr, ...] | None
    domain: Callable[[], Mapping[str, tuple[float, float]]]
    wrong_formulas: Callable[[], Iterable[tuple[tuple[Expr, ...], str]]]
    routes: Callable[[], Iterable[FollowThrough]]
    follow_through: Callable[[], Iterable[FollowThrough]]
    scales: Values = ()
    residue: Values = ()
    counted: bool = False
    signed: tuple[bool, ...] = ()
    explained_by_rounding: Callable[[Values], bool] = lambda _values: False


@dataclass(frozen=True, slots=True)
class RightOption:
    """The letter of the right option, and what students who choose another overlook."""

    letter: str
    misconceptions: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class FreeBody:
    """The forces on a body, each by the letter of its name and its angle (rad, counter-clockwise from the right).

    `misconceptions` say why others do not act; `slope` is the angle of the slope, where there is one.
    """

    forces: tuple[tuple[str, float], ...]
    misconceptions: Mapping[str, str]
    slope: float | None
    givens: Callable[[], Point]


@dataclass(frozen=True, slots=True)
class NamedLaw:
    """A law, and its equations in the letters of the problem."""

    name: str
    equations: tuple[Relation, ...]


@dataclass(frozen=True, slots=True)
class Requirement:
    """What numbers of the student's own, called `names`, must satisfy: `laws`, at `known`.

    `excluded` are values that satisfy them without being an example, and why; distances are relative to `scale`.
    """

    names: tuple[str, ...]
    laws: tuple[NamedLaw, ...]
    known: Point
    excluded: tuple[tuple[tuple[Expr, ...], str], ...]
    scale: Expr


@dataclass(frozen=True, slots=True)
class Claim:
    """An equation to be shown from laws.

    `given` are equations that the question states besides, `rates` the derivatives by time of the letters that change; where there
    are some, every other given is constant. `wrong` are equations that tell a misconception. `points` are
    values at which every law holds, `domain` says between which values the givens lie.
    """

    laws: tuple[Relation, ...]
    target: Relation
    wrong: tuple[tuple[Relation, str], ...]
    points: Callable[[], Sequence[Point]]
    given: tuple[Relation, ...] = ()
    domain: Callable[[], Mapping[str, tuple[float, float]]] = dict[str, tuple[float, float]]
    rates: tuple[tuple[str, Expr], ...] = ()


@dataclass(frozen=True, slots=True)
class Expected:
    """What is right for one question; of a sort that the question does not ask for there is none.

    `rubric` is for the person who marks. `runs` are the verdicts on what was run, by answer type; none where nothing ran.
    """

    question: Question
    quantity: Quantity | None = None
    option: RightOption | None = None
    requirement: Requirement | None = None
    claim: Claim | None = None
    free_body: FreeBody | None = None
    rubric: tuple[str, ...] = ()
    runs: Mapping[str, Callable[[], Verdict]] = field(default_factory=dict[str, Callable[[], Verdict]])
