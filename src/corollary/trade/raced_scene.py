"""A scene to race on: what is observed, the ways to find it, and references by methods that share nothing with those judged.

The cradles: extrapolated midpoint steps in 34 digits; the damped contact: Taylor series of order 50 in 50 digits; the rest:
energy integrals by tanh-sinh quadrature in 50 digits. The tests hold the programs that found them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from corollary.scenes.run import Observed

State = Sequence[float]
Knob = Literal["step", "tolerance"]

TOLERANCES = tuple(10.0 ** (-0.75 * i) for i in range(3, 20))
"""From 6e-3 to 6e-15, three quarters of a power of ten apart."""

ONCE = (1e-15,)
"""A model that has no setting is run once."""


@dataclass(frozen=True, slots=True)
class Reference:
    """True values, written out in decimals; `digits` of them are right, and `source` says how they were found."""

    values: tuple[str, ...]
    digits: int
    source: str

    @property
    def numbers(self) -> tuple[float, ...]:
        return tuple(map(float, self.values))


@dataclass(frozen=True, slots=True)
class MethodAnswer:
    """What a method found, and how many times it asked for the force (or for the integrand)."""

    values: tuple[float, ...]
    evaluations: int


@dataclass(frozen=True, slots=True)
class StepProgram:
    """A scene as a program of the chapter sees it: Newton's second law from a start until a time (s).

    `acceleration(x, v)` gives one number for each of x; `switches` are values (of x followed by v) whose signs say which law
    holds; `read(x, v)` makes the observed values of the last state.
    """

    x: tuple[float, ...]
    v: tuple[float, ...]
    acceleration: Callable[[State, State], Sequence[float]]
    until: float
    switches: tuple[Callable[[State], float], ...]
    read: Callable[[State, State], tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class MethodRoute:
    """One method on one scene: each of `settings` (steps in s, or tolerances) is a run, the coarsest first."""

    knob: Knob
    settings: tuple[float, ...]
    run: Callable[[float], MethodAnswer]


@dataclass(frozen=True, slots=True)
class RacedScene:
    """`scales` are the natural sizes of the observed values, `contact_time` (s) is what a step is compared with.

    `own` are the routes that belong to this scene alone; every method in steps comes from the program.
    """

    name: str
    ready: str
    settings: Mapping[str, Observed]
    observable: str
    reference: Reference
    scales: tuple[float, ...]
    contact_time: float
    program: StepProgram
    own: Mapping[str, MethodRoute]


def error_of(case: RacedScene, answer: MethodAnswer) -> float:
    """The largest difference from the reference, in units of each value's natural size."""
    apart = zip(answer.values, case.reference.numbers, case.scales, strict=True)
    return max(abs(value - true) / scale for value, true, scale in apart)


MIDPOINT = "extrapolated midpoint steps in 34 digits, shrinking toward every opening and closing"
TAYLOR = "Taylor series of order 50 in the root of the overlap, 50 digits"
QUADRATURE = "energy integral by tanh-sinh quadrature, 50 digits"

CRADLE_3_SPRINGS = Reference(
    ("-0.13026169506452104705", "0.15022956943477408931", "0.98003212562974695774"), 19, MIDPOINT
)
CRADLE_3_HERTZ = Reference(
    ("-0.070952353651436871016", "0.076403039071206993021", "0.994549314580229878"), 18, MIDPOINT
)
CRADLE_3_CUBIC = Reference(
    ("-0.010396841805952597532", "0.010506083831367518745", "0.99989075797458507879"), 19, MIDPOINT
)
CRADLE_5_HERTZ = Reference(
    (
        "-0.071085017086094278231",
        "-0.030273764097076231762",
        "-0.014463629032065613681",
        "0.12704498606786918731",
        "0.98877742414736693637",
    ),
    18,
    MIDPOINT,
)
SPHERES = Reference(
    (
        "0.31176559562219855276950438937185351855",
        "-0.46321464679836530764653271530391169452",
        "0.68823440437780144723049561062814648145",
        "0.46321464679836530764653271530391169452",
    ),
    38,
    TAYLOR,
)
SPHERES_DAMPED = Reference(
    (
        "0.31831839230500605906278028086158339067",
        "-0.34394425458223763165360716371437010999",
        "0.68168160769499394093721971913841660933",
        "0.34394425458223763165360716371437010999",
    ),
    38,
    TAYLOR,
)
BALL = Reference(
    ("0.022757714217275922677232697718646344632", "2.7938412269385302195847474676144565823"), 38, QUADRATURE
)
ATOM_BOUND = Reference(
    ("2.0892637700104348133823191740944232869", "2.1528996491526921480499983593452551328"), 38, QUADRATURE
)
ATOM_ESCAPING = Reference(
    ("-1.381558431269189836961915661960494893", "3.8847517682586895582142787413698119125"), 38, QUADRATURE
)
