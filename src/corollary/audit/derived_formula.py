"""The formula behind a derived number: the laws solved in letters, where that can be done in reasonable time."""

from __future__ import annotations

from corollary.audit.exercise import exercise_of, quantity
from corollary.audit.outcome import AuditedAnswer
from corollary.derive.roots import NoRoot
from corollary.derive.system import system_roots
from corollary.formula.text import text

LONGEST = 200  # characters that still tell a reader something


def derived_formula(outcome: AuditedAnswer) -> str:
    """The formula of the root that the outcome was compared with; "" where none is found, or it is too long to be read."""
    exercise = exercise_of(outcome.record)
    try:
        roots = system_roots(exercise.laws, exercise.unknowns)
    except NoRoot:
        return ""
    for root in roots:
        values = root.at(exercise.numbers)
        displayed = {
            name: quantity(value, exercise.unit_of(name), 4) for name, value in (values or {}).items()
        }
        tree = root.formula(outcome.asked) if displayed == outcome.values else None
        if tree is not None and len(written := text(tree)) <= LONGEST:
            return written
    return ""
