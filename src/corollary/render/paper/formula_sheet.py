"""The formula sheet of a set: the general laws that its solutions use, by name, without which belongs where."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from corollary.derive.solution import AppliedLaw, Solution
from corollary.formula.ast import Name, Number, names
from corollary.formula.latex import latex, vector
from corollary.messages import catalogue
from corollary.render.paper.typst_formula import typst_formula
from corollary.render.paper.typst_text import words_of

_ = catalogue(__name__)
_law_name = catalogue("corollary.laws")


def typst_formulas(solutions: Iterable[Solution]) -> str:
    """In Typst's markup, a table of names and equations in the order of the alphabet; "" where no general law is used.

    General is a law whose equation stands in letters of its own: one that is written in the letters of the problem alone is a
    step of its solution, and that two things are the same is no law.
    """
    found: dict[tuple[str, str], str] = {}
    for solution in solutions:
        own = {name for find in solution.unknowns for name in find.names}
        own |= {given.symbol for given in solution.problem.givens}
        for law in _laws(solution):
            textbook = law.textbook
            in_own = names(textbook.left) | names(textbook.right) <= own | {"pi"} and law.here == (textbook,)
            if in_own or all(isinstance(side, Name | Number) for side in (textbook.left, textbook.right)):
                continue
            vectors = {name: vector(name) for name in law.vectors}
            equation = latex(textbook, vectors)
            found[_law_name(law.name), equation] = typst_formula(equation, display=True)
    if not found:
        return ""
    cells = ", ".join(f"[{words_of(name)}], [{equation}]" for (name, _tex), equation in sorted(found.items()))
    title = words_of(_("Formulas"))
    return f"#formulas([{title}], {cells})"


def _laws(solution: Solution) -> Iterator[AppliedLaw]:
    for find in solution.unknowns:
        yield from find.laws
        for route in find.routes:
            yield from route.stated.laws
    for entry in (*solution.examples.values(), *solution.proofs.values()):
        yield from entry.laws
    for regime in solution.regimes:
        if regime.solution is not solution:
            yield from _laws(regime.solution)
