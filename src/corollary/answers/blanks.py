"""Blank cells of numbers and lists: the names in a row, and how to write a number with its unit."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)


def blank_number(question: Question) -> str:
    """A name to which one number is assigned."""
    unit = show(question.unit)
    remark = (
        _('a number in {unit} (3.2), or text with a unit ("3,2 {unit}")', unit=unit)
        if unit
        else _("a number (3.2)")
    )
    return f"{question.name} = None   # {remark}"


def blank_numbers(question: Question) -> str:
    """A name to which a list is assigned, one number for each component."""
    unit, names = show(question.unit), ", ".join(question.components)
    remark = (
        _("[{names}] in {unit}: numbers, or texts with a unit", names=names, unit=unit)
        if unit
        else _("[{names}]: numbers", names=names)
    )
    return f"{question.name} = [{nones(question)}]   # {remark}"


def nones(question: Question) -> str:
    """An empty value for each component."""
    return ", ".join("None" for _name in question.components)
