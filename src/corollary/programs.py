"""Machinery for judging programs and figures, as the judges of any bank import it."""

from __future__ import annotations

from corollary.derive.ready_scenes import run
from corollary.derive.statements import Doubt, Fault, Remark
from corollary.grading.programs.convergence import (
    NAMED,
    SAFETY,
    SMOOTH,
    STEPS,
    Bound,
    Called,
    Draw,
    Family,
    Given,
    Inputs,
    Standard,
    halved,
    judged,
    measured,
    miscounted,
)
from corollary.grading.programs.curves import (
    NEAR,
    OFFSETS,
    Asked,
    DrawnCurve,
    Graph,
    Numbers,
    PlanePath,
    covers,
    near_all,
)
from corollary.grading.programs.fixed_step import EULER, EULER_CROMER, RK4, Method, Path, march, states
from corollary.grading.programs.panels import Axis, Panel, judge_panels
from corollary.messages import N_, catalogue, in_convention
from corollary.sandbox.job import Axes
from corollary.scenes.models.two_bodies import contact_time
from corollary.scenes.run import Run

__all__ = [
    "EULER",
    "EULER_CROMER",
    "NAMED",
    "NEAR",
    "N_",
    "OFFSETS",
    "RK4",
    "SAFETY",
    "SMOOTH",
    "STEPS",
    "Asked",
    "Axes",
    "Axis",
    "Bound",
    "Called",
    "Doubt",
    "Draw",
    "DrawnCurve",
    "Family",
    "Fault",
    "Given",
    "Graph",
    "Inputs",
    "Method",
    "Numbers",
    "Panel",
    "Path",
    "PlanePath",
    "Remark",
    "Run",
    "Standard",
    "catalogue",
    "contact_time",
    "covers",
    "halved",
    "in_convention",
    "judge_panels",
    "judged",
    "march",
    "measured",
    "miscounted",
    "near_all",
    "run",
    "states",
]
