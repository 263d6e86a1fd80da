"""Statements of an author: unknowns because of laws, and the other things a part may need.

A statement that is also solved is generic in what its algebra is written in: sympy's expressions and `Law` where it is stated,
our own trees and `AppliedLaw` (derive/solution.py) where it is solved.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from corollary.messages import catalogue

if TYPE_CHECKING:
    import sympy
    from sympy.logic.boolalg import Boolean

    from corollary.formula.ast import Expr
    from corollary.laws.law import Law

_ = catalogue(__name__)

SOLUTION = "corollary_solution_"  # a solution's file is loaded as a module whose name begins so


@dataclass(frozen=True, slots=True)
class Statement:
    """What every entry says in words: the part it is for ("" for none), why, a sanity check, and the line it is written on.

    `system` are all letters that a step finds, where it answers several parts: the laws of all of these are solved as one.
    """

    part: str
    because: str
    line: int
    check: str = ""
    system: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for name, words in (("the part", self.part), ("because", self.because), ("check", self.check)):
            if not isinstance(words, str):  # pyright: ignore[reportUnnecessaryIsInstance]
                written = repr(words)
                what = f"a {type(words).__name__}" if len(written) > 40 or "<" in written[:1] else written
                raise TypeError(f"{name} is a text for the reader, not {what}; write it in quotation marks")

    def solved_with(self, other: Statement) -> bool:
        """Whether the laws of both were solved as one."""
        return bool(self.system) and (self.line, self.system) == (other.line, other.system)


class Stated(Protocol):
    """Whatever rests on a statement."""

    @property
    def statement(self) -> Statement: ...


Symbol = TypeVar("Symbol")  # an unknown: sympy.Symbol, then its name
Expression = TypeVar("Expression")  # sympy.Expr, then formula.ast.Expr
Condition = TypeVar("Condition")  # sympy's Boolean, then formula.ast.Relation, or True or False
LawT = TypeVar("LawT")  # Law, then AppliedLaw
RuleT = TypeVar("RuleT")  # Exchange, then a rule that computes the wrong value
BoundT = TypeVar("BoundT", bound=Stated)  # Step, then Unknown
SupposedT = TypeVar("SupposedT")  # Supposed, then SupposedValue


@dataclass(frozen=True, slots=True)
class Fault:
    """What a judge of programs and figures finds wrong, in a sentence; `known` when it is a usual mistake."""

    sentence: str
    known: bool = False


@dataclass(frozen=True, slots=True)
class Remark:
    """The program is right; this is what halving its step showed."""

    sentence: str


@dataclass(frozen=True, slots=True)
class Doubt:
    """What a judge cannot decide, in a sentence: a person will."""

    sentence: str


@dataclass(frozen=True, slots=True)
class Each:
    """Each whole number from `low` to `high`, by its letter."""

    letter: sympy.Symbol
    low: sympy.Expr
    high: sympy.Expr


@dataclass(frozen=True, slots=True)
class Exchange:
    """`laws` take the place of those named `instead`, or of the only one; `where` says which root is meant (None: as in the step), and
    `each` for which whole numbers there is one (None: those of the step). Without laws only these are mistaken."""

    laws: tuple[Law, ...]
    instead: tuple[str, ...]
    where: Boolean | bool | None = None
    each: Each | None = None


@dataclass(frozen=True, slots=True)
class Mistake(Generic[RuleT]):
    """A misconception: what a student is told, and by what rule it finds the unknown. `name` is the same wherever in a bank it
    is listed (empty: it has none)."""

    text: str
    rule: RuleT
    line: int
    name: str = ""


@dataclass(frozen=True, slots=True)
class Route(Generic[LawT]):
    """Another way to the same unknown, by other laws."""

    because: str
    laws: tuple[LawT, ...]
    line: int


@dataclass(frozen=True, slots=True)
class Sentence:
    """A sentence of a worked solution, found when the derivation is solved and spoken in the language of whoever reads it."""

    message: str
    holes: tuple[tuple[str, str], ...] = ()

    def spoken(self) -> str:
        return _(self.message, **dict(self.holes)) if self.message else ""


@dataclass(frozen=True, slots=True)
class Rejected:
    """A root that satisfies the laws and is not the answer, and why."""

    reason: str
    root: Mapping[sympy.Symbol, sympy.Expr]


@dataclass(frozen=True, slots=True)
class Step:
    """Unknowns found because of laws. `also` are unknowns that the laws need and nobody asks for; with `each` there is an unknown for
    each whole number of a range."""

    statement: Statement
    unknowns: tuple[sympy.Symbol, ...]
    laws: tuple[Law, ...]
    also: tuple[sympy.Symbol, ...]
    where: Boolean | bool
    rejected: tuple[Rejected, ...]
    mistakes: tuple[Mistake[Exchange], ...]
    routes: tuple[Route[Law], ...]
    scale: sympy.Expr | None
    each: Each | None = None


@dataclass(frozen=True, slots=True)
class Optimum:
    """The value of one letter, between bounds, that makes something as large (or small) as it can be."""

    statement: Statement
    unknowns: tuple[sympy.Symbol, ...]
    of: sympy.Expr
    over: sympy.Symbol
    between: tuple[sympy.Expr, sympy.Expr]
    largest: bool
    mistakes: tuple[Mistake[Exchange], ...]


@dataclass(frozen=True, slots=True)
class Simulated:
    """Unknowns measured in a simulated scene, where no closed form is at hand. Settings are formulas of givens and unknowns."""

    statement: Statement
    unknowns: tuple[sympy.Symbol, ...]
    scene: str
    settings: Mapping[str, sympy.Expr]
    observe: str
    mistakes: tuple[Mistake[Exchange], ...]


@dataclass(frozen=True, slots=True)
class Choice(Generic[Condition]):
    """The option whose condition holds for the numbers drawn; exactly one must. `mistakes` say what the others overlook."""

    statement: Statement
    options: Mapping[str, Condition]
    mistakes: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Example(Generic[Symbol, Expression, LawT]):
    """Numbers of the student's own that satisfy the laws, none of the `apart` values, and leave `free` unknowns free.

    `instance` is one good example, once solved; None where none was found.
    """

    statement: Statement
    unknowns: tuple[Symbol, ...]
    laws: tuple[LawT, ...]
    apart: tuple[tuple[tuple[Expression, ...], str], ...]
    free: int
    scale: Expression
    instance: tuple[Expression, ...] | None = None


def _filled(example: str, givens: Mapping[str, float]) -> str:
    """A program with the numbers of givens, in SI, in their holes."""
    text = example.strip()
    for name, value in givens.items():
        text = text.replace(f"{{{name}}}", repr(value))
    return text


@dataclass(frozen=True, slots=True)
class DrawnArgument:
    """An argument of a student's function, drawn between two numbers in SI; `whole`: a whole number."""

    name: str
    low: float
    high: float
    whole: bool = False


@dataclass(frozen=True, slots=True)
class FunctionFormula:
    """A judge of a student's function: a formula of its arguments and the givens, in SI.

    `corners` set some arguments, each in a call of its own. `within` is relative. `mistakes` are usual formulas, each with what the
    student is told.
    """

    name: str
    arguments: tuple[DrawnArgument, ...]
    formula: Expr
    corners: tuple[tuple[tuple[str, float], ...], ...] = ()
    within: float = 1e-6
    mistakes: tuple[tuple[Expr, str], ...] = ()

    @property
    def signature(self) -> str:
        return f"{self.name}({','.join(each.name for each in self.arguments)})"


@dataclass(frozen=True, slots=True)
class CurveFormula:
    """A judge of a figure: the curve of a formula of `letter` and the givens between two ends, in axes with these labels."""

    formula: Expr
    letter: str
    ends: tuple[Expr, Expr]
    labels: tuple[str, str]
    mistakes: tuple[tuple[Expr, str], ...] = ()


@dataclass(frozen=True, slots=True)
class LineFormula:
    """A judge of a figure: a straight line through the student's points, by its slope and, where it is asked for, its intercept.

    `within` is relative, of the intercept to the height of what is drawn.
    """

    slope: Expr
    intercept: Expr | None
    labels: tuple[str, str]
    within: float


@dataclass(frozen=True, slots=True)
class Code:
    """A function the student writes: drawn inputs, and a judge of what it returned for all of them; or a formula that is both."""

    statement: Statement
    inputs: (
        Callable[[Mapping[str, float], Callable[[float, float], float]], Sequence[Mapping[str, Any]]] | None
    )
    judge: Callable[..., Fault | Remark | None] | FunctionFormula
    example: str

    def example_for(self, givens: Mapping[str, float]) -> str:
        """The program, with a student's numbers where a formula made it."""
        return _filled(self.example, givens if isinstance(self.judge, FunctionFormula) else {})


@dataclass(frozen=True, slots=True)
class Plot:
    """What a figure must show: judged by its data, axes and labels. `judge` answers None, or what is missing.

    `with_calls`: it is also handed what the part's function returned.
    """

    statement: Statement
    judge: Callable[..., Fault | Doubt | None] | CurveFormula | LineFormula
    example: str
    with_calls: bool = False

    def example_for(self, givens: Mapping[str, float]) -> str:
        """The figure, with a student's numbers."""
        return _filled(self.example, givens)


@dataclass(frozen=True, slots=True)
class Proof(Generic[LawT]):
    """An equation to be shown from laws, and one good way; `given` is what the question states besides, `rates` are the derivatives by
    time of the letters that change."""

    statement: Statement
    laws: tuple[LawT, ...]
    target: LawT
    lines: tuple[str, ...]
    mistakes: tuple[Mistake[tuple[LawT, ...]], ...]
    given: tuple[LawT, ...] = ()
    rates: tuple[tuple[str, Any], ...] = ()


@dataclass(frozen=True, slots=True)
class Explain:
    """Free text for a person to mark: the rubric, and what a full answer says."""

    statement: Statement
    rubric: tuple[str, ...]
    answer: str


@dataclass(frozen=True, slots=True)
class Printed:
    """What the chapter prints for its own numbers, as printed; verification rounds ours to its figures. `erratum` says why what
    is printed is wrong, where it is known to be."""

    statement: Statement
    text: str
    where: str
    erratum: str = ""


@dataclass(frozen=True, slots=True)
class Supposed:
    """A positive value that the problem does not give, with its unit, and why it may be supposed."""

    name: str
    text: str
    why: str


@dataclass(frozen=True, slots=True)
class Neglected(Generic[BoundT, SupposedT]):
    """Something that the answer of a part leaves out: `bound` finds, from laws, the most that this can change of it.

    `asked`: the question itself wants it left out; then the bound is told, and may be large.
    """

    what: str
    bound: BoundT
    supposing: tuple[SupposedT, ...]
    asked: bool

    @property
    def statement(self) -> Statement:
        return self.bound.statement


@dataclass(frozen=True, slots=True)
class Confirm:
    """Laws that nothing is found from: they must hold for what was found otherwise, as an energy balance must."""

    statement: Statement
    laws: tuple[Law, ...]


Finding = Step | Optimum | Simulated
StatedChoice = Choice["Boolean | bool"]
StatedExample = Example["sympy.Symbol", "sympy.Expr", "Law"]
StatedProof = Proof["Law"]
StatedNeglected = Neglected[Step, Supposed]


@dataclass(frozen=True, slots=True)
class Acting(Generic[Expression]):
    """A force on a body: the letter of its name, its magnitude, and where it points, in a word or as an angle. Once solved
    that is an angle, and `word` what the author said."""

    letter: str
    magnitude: Expression
    way: str | Expression
    word: str = ""


@dataclass(frozen=True, slots=True)
class Along(Generic[LawT]):
    """A law about the components of forces along a direction."""

    way: str | sympy.Expr
    law: LawT


@dataclass(frozen=True, slots=True)
class Forces(Generic[Expression, LawT]):
    """All forces on a body; along each direction of `balances` they add up to what the law there says. `mistakes` say why others
    do not act, by their letters. Once solved, all is in givens, directions are angles, and `slope` is that of the part."""

    statement: Statement
    forces: tuple[Acting[Expression], ...]
    balances: tuple[Along[LawT], ...]
    mistakes: Mapping[str, str]
    slope: Expression | None = None
