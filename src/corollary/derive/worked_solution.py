"""The worked solution of a sheet: its steps in words, its laws, letters introduced where they are met, and chains of equalities."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from corollary.answers.option_names import option_named
from corollary.answers.spellings import main_spelling
from corollary.answers.ways import in_words
from corollary.derive.comparisons import decided, way_that_holds
from corollary.derive.formulas_of_variable import formulas_of_variable, printed_form
from corollary.derive.intermediate_units import units_of
from corollary.derive.introduced_letters import (
    asked_for,
    constants_of_nature,
    explained,
    found_first,
    introduced,
)
from corollary.derive.matrices import is_matrix, matrix_steps
from corollary.derive.numbers_in_formulas import (
    broken,
    given_numbers,
    quantity,
    whole_quantity,
    without_repetition,
)
from corollary.derive.solution import (
    AppliedLaw,
    ClosedForms,
    Numbering,
    Rule,
    SceneOutcome,
    Solution,
    SolvedForces,
    SolvedFunction,
    SolvedNeglected,
    SolvedRoute,
    Unknown,
    dependent,
)
from corollary.derive.statements import Code, CurveFormula, Explain, Plot
from corollary.formula.ast import Expr, Name, Number, Relation, names
from corollary.formula.ball import certified
from corollary.formula.latex import latex, letter, letters_printed, vector
from corollary.formula.layout import cost
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.messages import catalogue, in_convention
from corollary.problem.part import Part
from corollary.problem.statement import formulas_in_convention
from corollary.problem.translation import in_language
from corollary.problem.variant import Variant
from corollary.units.unit import Unit, si_unit
from corollary.units.unit import unit as unit_of

_ = catalogue(__name__)

TOO_LONG = 45  # the cost of a formula in givens that nobody reads any more


def listed_forces(stated: SolvedForces, part: Part) -> Iterator[str]:
    """A line of a Markdown list for each force that acts, magnitudes and angles in givens."""
    names = {option.letter: main_spelling(option.text) for option in part.options}
    for each in stated.forces:
        assert isinstance(each.way, Expr)  # once solved
        way = (
            in_words(each.word)
            if each.word
            else _("at {angle}, counter-clockwise from the right", angle=f"${latex(each.way)}$")
        )
        yield f"- {names[each.letter]}, {way}: ${latex(each.magnitude)}$"


def asked_steps(solution: Solution, asked: Collection[str]) -> dict[int, Unknown]:
    """By their places, in the solution's order. The answer of a part that is not `asked` stands there where a step needs it,
    as something that nobody asks about; another way that starts from what is left out is left out, too."""
    found = dict(enumerate(solution.unknowns))
    if all(not find.part or find.part in asked for find in found.values()):
        return found
    homes = {name: place for place, find in found.items() for name in _named(find)}
    left_out = {place for place, find in found.items() if find.part and find.part not in asked}
    beside = {homes[name] for part in asked for name in _beside(solution, part) if name in homes}
    answers = {place for place, find in found.items() if find.part in asked}
    needed = _with_those_before(solution, answers | beside, homes)
    for_others = _with_those_before(solution, left_out, homes)

    def by_itself(place: int) -> bool:
        """Whether no part needs it, and all it starts from is there: the texts may speak of it."""
        return place not in for_others and for_others & _with_those_before(solution, {place}, homes) <= needed

    places = [place for place in found if place in needed or by_itself(place)]
    hidden = {name for name, place in homes.items() if place not in places}
    return {place: _without(found[place], asked, hidden) for place in places}


def _with_those_before(solution: Solution, places: Collection[int], homes: Mapping[str, int]) -> set[int]:
    """The places given, and of all steps whose letters lead there or stand in the equations."""
    found, left = set[int](), [*places]
    while left:
        place = left.pop()
        if place not in found:
            found.add(place)
            left += [homes[name] for name in _used(solution.unknowns[place]) if name in homes]
    return found


def _without(find: Unknown, asked: Collection[str], hidden: Collection[str]) -> Unknown:
    """As one that nobody asks about where its part is not asked, and without ways over letters that are hidden."""
    routes = tuple(route for route in find.routes if not _letters(route) & set(hidden))
    statement = find.statement if find.part in asked else replace(find.statement, part="")
    return replace(find, statement=statement, routes=routes)


def _letters(route: SolvedRoute) -> frozenset[str]:
    return frozenset(_in_laws(route.stated.laws)) | _in_rule(route.rule)


def _named(find: Unknown) -> tuple[str, ...]:
    return (*find.names, *(each.name for each in find.functions))


def _used(find: Unknown) -> frozenset[str]:
    return (frozenset(_in_laws(find.laws)) - set(find.statement.system)) | _in_rule(find.local)


def _beside(solution: Solution, part: str) -> Iterator[str]:
    """The letters in what a part neglects, shows, or draws."""
    for each in solution.neglected:
        if each.statement.part == part:
            yield from _used(each.bound)
    for entries in (solution.proofs, solution.examples):
        if part in entries:
            yield from _in_laws(entries[part].laws)
    if part in solution.forces:
        yield from _in_laws(each.law for each in solution.forces[part].balances)


def _in_laws(laws: Iterable[AppliedLaw]) -> Iterator[str]:
    for law in laws:
        for relation in law.here:
            yield from names(relation)


def _in_rule(rule: Rule) -> frozenset[str]:
    """Every letter that a rule mentions."""
    trees = rule.trees if isinstance(rule, ClosedForms) else rule.settings.values()
    return names(*trees)


_law_name = catalogue("corollary.laws")

DEGREES = unit_of("deg")


def worked_solution(
    solution: Solution,
    variant: Variant,
    values: Sequence[tuple[float, ...]],
    letters: Mapping[str, str],
    neglected: Sequence[tuple[float, float]],
) -> str:
    """The whole solution; `values` are the unknowns in SI, in the solution's order, `letters` the right option of each choice.

    `neglected` are the bounds of what is neglected, in the solution's order: in SI, and relative to the answer.
    """
    return whole(worked_steps(solution, variant, values, letters, neglected))


def whole(steps: Iterable[str]) -> str:
    """The steps as one text."""
    return "\n".join(steps).strip() + "\n"


def worked_steps(
    solution: Solution,
    variant: Variant,
    values: Sequence[tuple[float, ...]],
    letters: Mapping[str, str],
    neglected: Sequence[tuple[float, float]],
) -> Sequence[str]:
    """The same step by step: what is found, one after the other, and then what needs no finding. Of parts that the variant does
    not ask there is only what the others need."""
    with letters_printed(solution.problem.printed_letters):
        return tuple(_steps(solution, variant, values, letters, neglected))


def _steps(
    solution: Solution,
    variant: Variant,
    values: Sequence[tuple[float, ...]],
    letters: Mapping[str, str],
    neglected: Sequence[tuple[float, float]],
) -> Iterator[str]:
    problem, asked = in_language(solution.problem), {part.id for part in variant.problem.parts}
    steps = asked_steps(solution, asked)
    known, si = given_numbers(variant), dict(variant.letters_in_si)
    formulas = dependent(solution)
    lines = constants_of_nature(problem)
    lines = [*introduced(steps.values(), problem), *lines, *[""] * bool(lines)]
    if solution.case:
        lines += [_("**Here {case}.**", case=solution.case), ""]
        lines += decided(
            solution.decided_by or solution.conditions, _all_values(solution, values, si), solution
        )
    met = set[str]()
    before: Unknown | None = None
    for place, find in steps.items():
        numbers = values[place]
        part = problem.part(find.part) if find.part else None
        heading = (
            f"{_heading(part)}: {asked_for(find, part.of)}"
            if part
            else _("**First find {names}.**", names=found_first(find, solution))
        )
        letters_here = explained(find, solution, met)
        met |= {*find.names} | names(*(relation for law in find.laws for relation in law.here))
        again = before is not None and find.statement.solved_with(before.statement)
        if formulas.intersection(find.names) and not find.numbering:
            values_here = zip(find.names, numbers, strict=True)
            result = formulas_of_variable(find, problem, known, si | dict(values_here))
            lines += [heading, "", *letters_here, *_unknown(find, result, again), ""]
            before = find
            si |= zip(find.names, numbers, strict=True)
            yield formulas_in_convention("\n".join(lines))
            lines = []
            continue
        units = units_of(find, part, numbers, solution)
        result = _result(find, numbers, units, part, known, si)
        lines += [heading, "", *letters_here, *_unknown(find, result, again), ""]
        before = find
        for name, value, unit in zip(find.names, numbers, units, strict=True):
            in_formula = si_unit(unit.dimension) if unit.offset else unit  # a temperature in kelvin
            known[name] = quantity(value, in_formula, in_formula=True)
            si[name] = value
        for each, (most, share) in zip(solution.neglected, neglected, strict=True):
            if part and each.statement.part == part.id:
                lines += [*_neglected(each, most, share, part, known, si), ""]
        yield formulas_in_convention("\n".join(lines))
        lines = []
    for part in problem.parts:
        if part.id in asked and (other := _other(solution, part, letters, variant, values)):
            lines += [_heading(part), "", *other, ""]
        if lines:
            yield formulas_in_convention("\n".join(lines))
        lines = []


def model_answer(solution: Solution, part: Part, letters: Mapping[str, str], variant: Variant) -> str:
    """What answers a part that asks for no quantity: an option with its reason, a proof, a program, an explanation with its rubric.

    Markdown; empty for a part that asks for a quantity."""
    with letters_printed(solution.problem.printed_letters):
        return formulas_in_convention("\n".join(_other(solution, part, letters, variant)).strip())


def _heading(part: Part) -> str:
    return f"### ({part.heading_letter}) {part.title}"


def _unknown(find: Unknown, result: list[str], again: bool) -> list[str]:
    """`again`: its laws are a system that stands in the step before, which gives this, too."""
    reasons = [_("The same laws give this, too."), ""] if again else _reasons_for(find)
    lines = [*reasons, *result]
    if not again:
        lines += _routes(find)
    if find.statement.check:
        lines += ["", _("*Check:* {check}", check=find.statement.check)]
    return lines


def _reasons_for(find: Unknown) -> list[str]:
    """The author's reason, the laws, and how they give what is found."""
    lines = [find.statement.because, ""]
    for law in find.laws:
        lines += [_law(law), ""]
    if find.numbering:
        lines += [_numbers_of_entries(find.numbering, len(find.entries)), ""]
    for function in find.functions:
        lines += [*_function(function), ""]
    if find.note:
        lines += [find.note.spoken(), ""]
    for reason in find.rejected:
        lines += [_("*Another root of these laws is rejected:* {reason}.", reason=reason.spoken()), ""]
    return lines


def _routes(find: Unknown) -> Iterator[str]:
    for route in find.routes:
        because, laws = route.stated.because, route.stated.laws
        yield from (
            "", _("*Another way.* {because}", because=because), "", *(_law(law) + "\n" for law in laws)
        )  # fmt: skip


def _numbers_of_entries(numbering: Numbering, count: int) -> str:
    """Which whole numbers the entries of a list belong to."""
    return _(
        "One for each whole ${letter}$ from ${low}$ to ${high}$: {count} in all.",
        letter=letter(numbering.letter),
        low=latex(numbering.low),
        high=latex(numbering.high),
        count=count,
    )


def _function(function: SolvedFunction) -> list[str]:
    """A function as it follows from the laws."""
    found = rf"$${letter(function.name)}({letter(function.letter)}) = {latex(function.printed or function.formula)}$$"
    if not function.form:
        return [_("So at any ${letter}$:", letter=letter(function.letter)), "", found]
    solved = _(
        "This differential equation ({form}) has one solution with these initial values; put back, it satisfies both:",
        form=_(function.form),
    )
    return [solved, "", found]


def _neglected(
    each: SolvedNeglected,
    most: float,
    share: float,
    part: Part,
    known: Mapping[str, str],
    si: Mapping[str, float],
) -> list[str]:
    """What the answer neglects, by which laws it is bounded, and how little of the answer that is."""
    find = each.bound
    texts = {
        value.stated.name: r"\,".join(_roman(word) for word in value.stated.text.split(" ", 1))
        for value in each.supposing
    }
    assumed = {value.stated.name: float(value.ratio) for value in each.supposing}
    supposed = "; ".join(f"${letter(name)} = {texts[name]}$: {why}" for name, why in _reasons(each))
    opening = _("*Neglected:* {what}. {because}", what=each.what, because=find.statement.because)
    if supposed:
        opening += " " + _("(Assumed: {supposed}.)", supposed=supposed)
    lines = [opening, ""]
    for law in find.laws:
        lines += [_law(law), ""]
    bracketed = {name: f"({text})" for name, text in texts.items()}
    units = part.units_for(len(find.dimensions))
    lines += _result(
        replace(find, in_givens=None), (most,), units, part, {**known, **bracketed}, {**si, **assumed}
    )
    size = (
        _("{percent} % of the answer", percent=in_convention(decimal_text(100 * share, 2)))
        if share
        else _("nothing at all")
    )
    if each.asked:
        return [*lines, _("At most {size}, left out since the question asks for it.", size=size)]
    return [*lines, _("At most {size}: it may be neglected.", size=size)]


def _reasons(each: SolvedNeglected) -> list[tuple[str, str]]:
    return [(value.stated.name, value.stated.why) for value in each.supposing]


def _roman(word: str) -> str:
    """A unit upright; a number as it is."""
    return rf"\mathrm{{{word}}}" if word[0].isalpha() else word


def _law(law: AppliedLaw) -> str:
    """The textbook's equation, when it holds, and what it says here."""
    bold = {name: vector(name) for name in law.vectors}
    title = _law_name(law.name) + (f" {law.source}" if law.source else "")
    if law.holds:
        title = _("{law}, since {condition}", law=title, condition=_law_name(law.holds))
    here = [latex(relation) for relation in law.here if not _empty(relation)]
    textbook = latex(law.textbook, bold)
    if here == [textbook]:
        return f"{title}:\n\n$${textbook}$$"
    equations = r" \qquad ".join(here) or "0 = 0"
    here_is = _("Here:")
    return f"{title}:\n\n$${textbook}$$\n\n{here_is}\n\n$${equations}$$"


def _result(
    find: Unknown,
    numbers: tuple[float, ...],
    units: Sequence[Unit],
    part: Part | None,
    known: Mapping[str, str],
    si: Mapping[str, float],
) -> list[str]:
    if part and is_matrix(part) and isinstance(find.local, ClosedForms):
        forms = [
            printed_form(find.printed, find.local.trees, place, value, si)
            for place, value in enumerate(numbers)
        ]
        return [
            *(f"$${line}$$" for line in broken(matrix_steps(find.names, forms, numbers, part, units[0]))),
            "",
        ]
    lines: list[str] = []
    if find.slope:
        lines += [f"$${latex(find.slope[0])} = {latex(find.slope[1])} = 0$$", ""]
    for place, (name, value, unit) in enumerate(zip(find.names, numbers, units, strict=True)):
        exact = part is not None and part.answer_type in ("count", "integer")
        answer = whole_quantity(value, unit) if exact else quantity(value, unit)
        match find.local:
            case ClosedForms(trees):
                local = printed_form(find.printed, trees, place, value, si)
                whole = (
                    printed_form(find.printed_in_givens, find.in_givens, place, value, si)
                    if find.in_givens
                    else None
                )
                steps = [
                    letter(name),
                    *_algebra(local, whole, known),
                    answer,
                    *_degrees(value, unit),
                ]
                lines += [*(f"$${line}$$" for line in broken(without_repetition(steps))), ""]
            case SceneOutcome(scene, _settings, observe):
                lines += [f"$${letter(name)} = {answer}$$", ""]
                if name == find.names[-1]:
                    measured = _(
                        "Measured in the simulated scene *{scene}* ({observable}), by Newton's second law.",
                        scene=scene,
                        observable=observe,
                    )
                    lines += [measured, ""]
    return lines


def _algebra(tree: Expr, in_givens: Expr | None, known: Mapping[str, str]) -> list[str]:
    """What an unknown equals: by earlier unknowns, by givens alone, and with the numbers put in; nothing for a mere number."""
    if isinstance(tree, Number):
        return []
    steps = [latex(tree)]
    if in_givens is not None and in_givens != tree and names(in_givens) and not _needless(tree, in_givens):
        steps.append(latex(in_givens))
    if names(tree) - {"pi"} and not isinstance(tree, Name):
        steps.append(latex(tree, known))
    return steps


def _needless(tree: Expr, in_givens: Expr) -> bool:
    """True if the formula in givens says the same in other words, or takes a page where the step itself takes a line."""
    return names(tree) == names(in_givens) or cost(in_givens) > max(TOO_LONG, 2 * cost(tree))


def _degrees(value: float, unit: Unit) -> list[str]:
    """An angle in degrees, too: so it is measured, and so it may be answered."""
    return [quantity(value, DEGREES)] if unit == unit_of("rad") else []


def _all_values(
    solution: Solution, values: Sequence[tuple[float, ...]], si: Mapping[str, float]
) -> dict[str, float]:
    """The givens and all that is found, in SI."""
    found = zip(solution.unknowns, values, strict=False)
    return {
        **si,
        **{name: value for find, each in found for name, value in zip(find.names, each, strict=True)},
    }


def _other(
    solution: Solution,
    part: Part,
    letters: Mapping[str, str],
    variant: Variant,
    values: Sequence[tuple[float, ...]] = (),
) -> list[str]:
    """Choices, examples, proofs, programs and explanations."""
    lines: list[str] = []
    if part.id in solution.choices:
        option = option_named(part, letters.get(part.id, ""))
        stop = "" if option.startswith("(") else "."  # a word and its reason are two sentences
        lines += [f"{f'**{option}**{stop} ' if option else ''}{solution.choices[part.id].statement.because}"]
        si = _all_values(solution, values, variant.si)
        way = way_that_holds(solution.choices[part.id].options.get(letters.get(part.id, ""), ()), si)
        if comparisons := decided(way, si, solution):
            lines += ["", *comparisons]
    if part.id in solution.forces:
        lines += _forces(solution.forces[part.id], part)
    if part.id in solution.examples:
        example = solution.examples[part.id]
        lines += [example.statement.because, "", *(_law(law) + "\n" for law in example.laws)]
        if example.instance is not None:
            known = variant.exact
            numbers = [quantity(certified(tree, known).value, part.unit) for tree in example.instance]
            lines += [_("For example: {numbers}", numbers=f"$${', '.join(numbers)}$$")]
    if part.id in solution.proofs:
        proof = solution.proofs[part.id]
        lines += [proof.statement.because, "", *(_law(law) + "\n" for law in proof.laws)]
        lines += [_("To show:"), "", f"$${latex(proof.target.here[0])}$$", "", _("One way:"), ""]
        lines += [f"$${latex(author_formula(line))}$$\n" for line in proof.lines]
    for entry in solution.entries:
        match entry:
            case Code() if entry.statement.part == part.id:
                lines += [entry.statement.because, "", "```python", entry.example_for(variant.si), "```", ""]
            case Plot(judge=CurveFormula() as judge) if entry.statement.part == part.id:
                lines += [entry.statement.because, "", f"$${latex(judge.formula)}$$", ""]
            case Explain() if entry.statement.part == part.id:
                lines += [entry.answer, "", *(f"- {each}" for each in entry.rubric)]
            case _:
                continue
    return lines


def _forces(stated: SolvedForces, part: Part) -> list[str]:
    """Why, and each force with its magnitude in givens; then the laws that they add up to."""
    laws = [_law(each.law) + "\n" for each in stated.balances]
    return [stated.statement.because, "", *listed_forces(stated, part), "", *laws]


def _empty(relation: Relation) -> bool:
    """0 = 0: a component in which a law says nothing."""
    return relation.left == relation.right or (_zero(relation.left) and _zero(relation.right))


def _zero(tree: Expr) -> bool:
    return isinstance(tree, Number) and tree.value == 0
