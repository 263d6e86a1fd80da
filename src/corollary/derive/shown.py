"""A law made ready to be shown: the textbook's form, and the same form in the letters of the problem."""

from __future__ import annotations

from corollary.derive.closed import tree
from corollary.derive.solution import LawShown
from corollary.law.law import Law, component
from corollary.quantity.tree import Relation, substitute


def shown(stated: Law) -> LawShown:
    """The law with its letters replaced and nothing simplified."""
    here = []
    for index in range(stated.components):
        meaning = {letter: tree(value) for letter, value in component(stated, index).items()}
        here.append(Relation("=", substitute(stated.textbook.left, meaning), substitute(stated.textbook.right, meaning)))
    return LawShown(stated.name, stated.source, stated.holds, stated.textbook, stated.vectors, tuple(here))
