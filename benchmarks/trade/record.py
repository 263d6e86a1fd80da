"""A race as plain data: what `corollary trade --json` prints of a scene."""

from __future__ import annotations

import math
from typing import Any

from .measures import WANTED, cheapest, frontier, lies_beyond, orders
from .race import Timing, WorkPrecision


def record(raced: WorkPrecision) -> dict[str, Any]:
    """Reference, runs, orders, frontier, the cheapest method for each accuracy, and the planner's choice."""
    case, measured = raced.case, orders(raced)
    best = {label(wanted): cheapest(raced, wanted) for wanted in WANTED}
    honest = lies_beyond(raced)
    return {
        "scene": case.name,
        "ready": case.ready,
        "settings": dict(case.settings),
        "observable": case.observable,
        "reference": {
            "value": list(case.reference.values),
            "digits": case.reference.digits,
            "source": case.reference.source,
        },
        "contact_time": case.contact_time,
        "runs": [timing_record(timing) for timing in raced.timings],
        "order": {method: round(order.value, 3) for method, order in measured.items()},
        "order_bounds": {
            method: [round(order.low, 3), round(order.high, 3)] for method, order in measured.items()
        },
        "cheapest": {wanted: timing.method if timing else None for wanted, timing in best.items()},
        "cheapest_runs": {
            wanted: timing_record(timing) if timing else None for wanted, timing in best.items()
        },
        "frontier": [timing_record(timing) for timing in frontier(raced)],
        "lies_beyond": {"euler_cromer": honest},
        "planned": raced.planned,
        "missing": dict(raced.missing),
    }


def label(wanted: float) -> str:
    """1e-3, as the contract writes it."""
    return f"1e{round(math.log10(wanted))}"


def timing_record(timing: Timing) -> dict[str, Any]:
    error = timing.error if math.isfinite(timing.error) else "inf"
    return {
        "method": timing.method,
        timing.knob: timing.setting,
        "error": error,
        "evaluations": timing.evaluations,
        "seconds": timing.seconds,
    }
