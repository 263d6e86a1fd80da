"""The worked solution of a variant as Markdown: the law, its letters here, the algebra, the number, and a sanity check."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from corollary.derive.solution import ClosedForms, LawShown, LeftOut, Measured, Solution, SolvedUnknown
from corollary.derive.statements import Code, Explain
from corollary.formula.ast import Expr, Number, Relation, names
from corollary.formula.ball import certified
from corollary.formula.latex import latex, letter
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.problem.part import Part
from corollary.problem.variant import Variant, number
from corollary.units.unit import Unit, si_unit
from corollary.units.unit import latex as unit_latex

FIGURES = 4
WIDEST = 75
FRACTION = re.compile(r"\\frac\{((?:[^{}]|\{[^{}]*\})*)\}\{((?:[^{}]|\{[^{}]*\})*)\}")
COMMAND = re.compile(r"\\(?:left|right|mathrm|cdot|sqrt|,)|[{}\\ ^]")


def story(
    solution: Solution, variant: Variant, values: Sequence[tuple[float, ...]], letters: Mapping[str, str],
    left_out: Sequence[tuple[float, float]],
) -> str:  # fmt: skip
    """The whole solution; `values` are the finds in SI, in the solution's order, `letters` the right option of each choice.

    `left_out` are the bounds of what is neglected, in the solution's order: in SI, and relative to the answer.
    """
    problem = solution.problem
    known = _given_numbers(variant)
    lines: list[str] = []
    for find, numbers in zip(solution.finds, values, strict=True):
        part = problem.part(find.answers) if find.answers else None
        lines += [
            _heading(part) if part else f"**First find {_names(find)}.**",
            "",
            *_find(find, numbers, part, known),
            "",
        ]
        for name, value, dimension in zip(find.names, numbers, find.dimensions, strict=True):
            known[name] = _quantity(value, si_unit(dimension), in_formula=True)
        for left, (most, share) in zip(solution.neglected, left_out, strict=True):
            if part and left.bound.answers == part.id:
                lines += [*_left_out(left, most, share, part, known), ""]
    for part in problem.parts:
        lines += _other(solution, part, letters, variant)
    return "\n".join(lines).strip() + "\n"


def _heading(part: Part) -> str:
    return f"### ({part.id}) {part.title}"


def _find(
    find: SolvedUnknown, numbers: tuple[float, ...], part: Part | None, known: Mapping[str, str]
) -> list[str]:
    lines = [find.because, ""]
    for stated in find.laws:
        lines += [_law(stated), ""]
    if find.note:
        lines += [find.note, ""]
    for reason in find.rejected:
        lines += [f"*Another root of these laws is refused:* {reason}.", ""]
    lines += _result(find, numbers, part, known)
    for way in find.routes_shown:
        lines += ["", f"*Another way.* {way.because}", "", *(_law(stated) + "\n" for stated in way.laws)]
    if find.check:
        lines += ["", f"*Check:* {find.check}"]
    return lines


def _left_out(left: LeftOut, most: float, share: float, part: Part, known: Mapping[str, str]) -> list[str]:
    """What the answer neglects, by which laws it is bounded, and how little of the answer that is."""
    find = left.bound
    texts = {
        value.name: r"\,".join(_roman(word) for word in value.text.split(" ", 1)) for value in left.supposing
    }
    supposed = "; ".join(
        f"${letter(value.name)} = {texts[value.name]}$: {value.why}" for value in left.supposing
    )
    lines = [
        f"*Neglected:* {left.what}. {find.because}" + (f" (Supposed: {supposed}.)" if supposed else ""),
        "",
    ]
    for stated in find.laws:
        lines += [_law(stated), ""]
    lines += _result(
        replace(find, closed=None),
        (most,),
        part,
        {**known, **{name: f"({text})" for name, text in texts.items()}},
    )
    size = f"{decimal_text(100 * share, 2)} % of the answer" if share else "nothing at all"
    return [
        *lines,
        f"At most {size}{', left out since the question asks for it.' if left.asked else ': it may be neglected.'}",
    ]


def _roman(word: str) -> str:
    """A unit upright; a number as it is."""
    return rf"\mathrm{{{word}}}" if word[0].isalpha() else word


def _law(stated: LawShown) -> str:
    """The textbook's equation, when it holds, and what it says here."""
    bold = {name: rf"\vec{{{letter(name)}}}" for name in stated.vectors}
    where = f" {stated.source}" if stated.source else ""
    holds = f", since {stated.holds}" if stated.holds else ""
    here = [latex(relation) for relation in stated.here if not _empty(relation)]
    textbook = latex(stated.textbook, bold)
    if here == [textbook]:
        return f"{stated.name}{where}{holds}:\n\n$${textbook}$$"
    shown = r" \qquad ".join(here) or "0 = 0"
    return f"{stated.name}{where}{holds}:\n\n$${textbook}$$\n\nHere:\n\n$${shown}$$"


def _result(
    find: SolvedUnknown, numbers: tuple[float, ...], part: Part | None, known: Mapping[str, str]
) -> list[str]:
    lines = []
    units = [part.unit if part else si_unit(dimension) for dimension in find.dimensions]
    for place, (name, value, unit) in enumerate(zip(find.names, numbers, units, strict=True)):
        answer = _quantity(value, unit)
        match find.local:
            case ClosedForms(trees):
                steps = [letter(name), latex(trees[place])]
                closed = find.closed[place] if find.closed else None
                if closed is not None and closed != trees[place] and names(closed):
                    steps.append(latex(closed))
                if names(trees[place]) - {"pi"}:
                    steps.append(latex(trees[place], known))
                steps.append(answer)
                lines += [*(f"$${line}$$" for line in broken(list(dict.fromkeys(steps)))), ""]
            case Measured(scene, _, observe):
                lines += [f"$${letter(name)} = {answer}$$", ""]
                if name == find.names[-1]:
                    lines += [
                        f"Measured in the simulated scene *{scene}* ({observe}), by Newton's second law.",
                        "",
                    ]
    return lines


def broken(steps: list[str]) -> list[str]:
    """A chain of equalities in lines that fit a page; a new line begins with its equals sign."""
    lines = [steps[0]]
    for step in steps[1:]:
        if width(lines[-1]) + width(step) > WIDEST and lines[-1] != steps[0]:
            lines.append(f"= {step}")
        else:
            lines[-1] += f" = {step}"
    return lines


def width(formula: str) -> int:
    """About how many letters wide a formula is set: the wider line of a fraction counts, commands do not."""
    while (inner := FRACTION.search(formula)) is not None:
        formula = formula[: inner.start()] + max(inner[1], inner[2], key=len) + formula[inner.end() :]
    return len(COMMAND.sub("", formula))


def _other(solution: Solution, part: Part, letters: Mapping[str, str], variant: Variant) -> list[str]:
    """Choices, examples, proofs, programs and explanations."""
    lines: list[str] = []
    if part.id in solution.choices:
        truth = solution.choices[part.id]
        lines += [f"**({letters[part.id]})** {truth.because}"]
    if part.id in solution.examples:
        truth = solution.examples[part.id]
        lines += [truth.because, "", *(_law(stated) + "\n" for stated in truth.laws)]
        if truth.instance is not None:
            numbers = [_quantity(certified(tree, variant.exact).value, part.unit) for tree in truth.instance]
            lines += [f"For example: $${', '.join(numbers)}$$"]
    if part.id in solution.proofs:
        truth = solution.proofs[part.id]
        lines += [
            truth.because,
            "",
            *(_law(stated) + "\n" for stated in truth.laws),
            f"To show:\n\n$${latex(truth.target)}$$",
            "",
            "One way:",
            "",
        ]
        lines += [f"$${latex(author_formula(line))}$$\n" for line in truth.lines]
    for entry in solution.entries:
        match entry:
            case Code(part.id, because, _, _, example):
                lines += [because, "", "```python", example.strip(), "```", ""]
            case Explain(part.id, rubric, answer):
                lines += [answer, "", *(f"- {each}" for each in rubric)]
            case _:
                continue
    return [_heading(part), "", *lines, ""] if lines else []


def _given_numbers(variant: Variant) -> dict[str, str]:
    """Each given as it stands in a formula: number and unit."""
    shown = {}
    for given in variant.problem.givens:
        unit = unit_latex(given.unit)
        text = number(given, variant.values[given.symbol]).replace("−", "-")
        mantissa, _, power = text.partition("e")
        text = rf"{mantissa}\cdot 10^{{{power}}}" if power else mantissa
        shown[given.symbol] = _bracketed(text + (rf"\,{unit}" if unit else ""), text)
    return shown


def _quantity(value: float, unit: Unit, *, in_formula: bool = False) -> str:
    size = float(unit.factor) * math.pi**unit.pi
    text = decimal_text(value / size, FIGURES) if value else "0"
    mantissa, _, power = text.partition("e")
    text = rf"{mantissa}\cdot 10^{{{power}}}" if power else mantissa
    symbol = unit_latex(unit)
    whole = text + (rf"\,{symbol}" if symbol else "")
    return _bracketed(whole, text) if in_formula else whole


def _bracketed(whole: str, text: str) -> str:
    """In brackets where a sign or a unit could be misread inside a product or a power."""
    return rf"({whole})" if whole != text or text.startswith("-") else whole


def _names(find: SolvedUnknown) -> str:
    return ", ".join(f"${letter(name)}$" for name in find.names)


def _empty(relation: Relation) -> bool:
    """0 = 0: a component in which a law says nothing."""
    return relation.left == relation.right or (_zero(relation.left) and _zero(relation.right))


def _zero(tree: Expr) -> bool:
    return isinstance(tree, Number) and tree.value == 0
