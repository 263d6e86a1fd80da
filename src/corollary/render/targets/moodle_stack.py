"""Questions for a Moodle that has STACK: those of the target moodle, and each part that asks for a formula as a STACK question."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final
from xml.sax.saxutils import escape

from corollary.answers.expression.reading import in_numbers
from corollary.formula.ast import Call, Expr, Number, Relation, map_children, names, walk
from corollary.formula.plain_text import text
from corollary.render.exports import CarriedPart, ItemFiles, Target
from corollary.render.lms_item import LmsItem, NotAsked
from corollary.render.markdown import tex_html, tex_inline
from corollary.render.targets import moodle

FUNCTIONS: Final = {
    **{name: name for name in ("sqrt", "abs", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "ln")},
    "log10": "lg",
    "floor": "floor",
    "ceil": "ceiling",
}
"""What STACK calls the functions that it has."""
CONSTANTS: Final = frozenset({"e", "i", "%e", "%i", "%pi", "inf", "infinity"})
"""Letters that are numbers there."""


class NotInStack(ValueError):
    """STACK cannot hold the formula; the sentence says why."""


def stack_formula(tree: Expr) -> str:
    """In Maxima's words, numbers as fractions. Raises NotInStack."""
    for node in walk(tree):
        if isinstance(node, Relation):
            raise NotInStack("the answer is an equation")
        if isinstance(node, Call) and node.function not in FUNCTIONS:
            raise NotInStack(f"STACK has no function {node.function}")
    if letters := sorted(names(tree) & CONSTANTS):
        raise NotInStack(f"STACK takes the letter {', '.join(letters)} for a number")
    return text(_renamed(tree))


def _renamed(tree: Expr) -> Expr:
    match tree:
        case Call(function):
            return map_children(replace(tree, function=FUNCTIONS[function]), _renamed)
        case Number():
            return replace(tree, figures=0)
        case _:
            return map_children(tree, _renamed)


FORMULA_LOST = "the dimension of what is typed is not looked at; a constant off by a root, by pi/180 or by rounding is wrong"
NUMBERS_LOST = "; a formula with numbers in place of the givens is wrong, and the question does not offer it"


@dataclass(frozen=True, slots=True)
class StackNode:
    """One comparison: the formula in Maxima's words, the share of the points, the note in the statistics, HTML for the student."""

    formula: str
    share: float
    note: str
    feedback: str


@dataclass(frozen=True, slots=True)
class StackPart:
    """A part that asks for a formula: its comparisons in their order, or why STACK cannot hold it (then there are none)."""

    item: LmsItem
    asked: NotAsked
    nodes: Sequence[StackNode]
    why: str


def write_items(name: str, items: Sequence[LmsItem], apart: bool) -> ItemFiles:
    """The questions of the target `moodle`, and STACK questions after them."""
    of_formulas = [
        _stack_part(item, asked)
        for item in items
        for asked in item.parts
        if isinstance(asked, NotAsked) and asked.formulas
    ]
    stack = (text for each in of_formulas if each.nodes for text in _question(name, each))
    file = moodle.quiz([*moodle.questions(name, items, apart), *stack])
    parts, lost = moodle.became(items, apart)
    found = {(each.item.exercise.problem.code, each.asked.prompt.part.id): each for each in of_formulas}
    carried = tuple(_carried(part, found.get((part.code, part.part))) for part in parts)
    return ItemFiles({f"{name}-moodle-stack.xml": file}, carried, lost)


def _stack_part(item: LmsItem, asked: NotAsked) -> StackPart:
    try:
        return StackPart(item, asked, _nodes(asked), "")
    except NotInStack as why:
        return StackPart(item, asked, (), str(why))


def _carried(part: CarriedPart, found: StackPart | None) -> CarriedPart:
    if found is None:
        return part
    if found.why:
        return replace(part, lost=found.why)
    of_variable = bool(found.asked.prompt.part.of)
    return replace(part, how="STACK", lost=FORMULA_LOST + (NUMBERS_LOST if of_variable else ""))


def _question(name: str, of_formula: StackPart) -> Iterator[str]:
    """The category of its own, before the first variant, and the question."""
    item, asked, nodes = of_formula.item, of_formula.asked, of_formula.nodes
    part, problem = asked.prompt.part, item.exercise.problem
    title = f"{problem.code} {problem.title}, ({part.heading_letter})"
    if item.number == 1:
        pool = f"{problem.code} {problem.title}".replace("/", "//")
        yield moodle.category(name, pool, f"({part.heading_letter})")
    fields = [f"ans{at}" for at in range(1, len(part.components or ("",)) + 1)]
    typed = "".join(
        f"<p>{escape(f'{component}: ' if component else '')}[[input:{field}]] [[validation:{field}]]</p>"
        for component, field in zip(part.components or ("",), fields, strict=True)
    )
    prompt = asked.prompt
    letters_only = prompt.text.replace(in_numbers(prompt.question), "").rstrip()
    words = f"{moodle.words(replace(asked, prompt=replace(prompt, text=letters_only)))}{typed}"
    stem = f"{tex_html(item.exercise.statement)}{moodle.figure(item)}"
    sans = fields[0] if len(fields) == 1 else f"[{', '.join(fields)}]"
    yes = int(asked.positive)
    yield "\n".join(
        [
            f'<question type="stack"><name><text>{escape(f"{title}, {item.number}")}</text></name>',
            moodle.question_text(item, _harmless(stem + words)),
            f'<generalfeedback format="html">{_text(tex_html(item.solution))}</generalfeedback>',
            f"<defaultgrade>{asked.prompt.out_of:g}</defaultgrade><penalty>0</penalty><hidden>0</hidden>",
            "<stackversion><text></text></stackversion>",
            f"<questionvariables><text>{escape(_variables(nodes))}</text></questionvariables>",
            '<specificfeedback format="html"><text>[[feedback:prt1]]</text></specificfeedback>',
            '<questionnote format="html"><text></text></questionnote>',
            '<questiondescription format="html"><text></text></questiondescription>',
            f"<questionsimplify>1</questionsimplify><assumepositive>{yes}</assumepositive><assumereal>1</assumereal>",
            *(f'<{kind} format="html"><text></text></{kind}>' for kind in ("prtcorrect", "prtpartiallycorrect", "prtincorrect")),
            *(_input(field, "ta1" if len(fields) == 1 else f"ta1[{at}]") for at, field in enumerate(fields, 1)),
            "<prt><name>prt1</name><value>1</value><autosimplify>1</autosimplify><feedbackstyle>1</feedbackstyle>",
            "<feedbackvariables><text></text></feedbackvariables>",
            *(_node(at, len(nodes), sans, node) for at, node in enumerate(nodes)),
            "</prt></question>",
        ]
    )  # fmt: skip


def _nodes(asked: NotAsked) -> list[StackNode]:
    """Raises NotInStack."""
    nodes: list[StackNode] = []
    for each in asked.formulas:
        formulas = [stack_formula(tree) for tree in each.trees]
        formula = formulas[0] if len(formulas) == 1 else f"[{', '.join(formulas)}]"
        if formula not in (node.formula for node in nodes):
            note = f"{each.verdict}-{len(nodes)}"
            nodes.append(StackNode(formula, each.share, note, tex_inline(each.feedback)))
    return nodes


def _variables(nodes: Sequence[StackNode]) -> str:
    return "\n".join(f"ta{at}: {node.formula};" for at, node in enumerate(nodes, 1))


def _input(name: str, right: str) -> str:
    return (
        f"<input><name>{name}</name><type>algebraic</type><tans>{right}</tans><boxsize>30</boxsize><strictsyntax>1</strictsyntax>"
        "<insertstars>1</insertstars><syntaxhint></syntaxhint><syntaxattribute>0</syntaxattribute><forbidwords></forbidwords>"
        "<allowwords></allowwords><forbidfloat>0</forbidfloat><requirelowestterms>0</requirelowestterms>"
        "<checkanswertype>0</checkanswertype><mustverify>1</mustverify><showvalidation>1</showvalidation><options></options></input>"
    )


def _node(at: int, count: int, sans: str, node: StackNode) -> str:
    following = at + 1 if at + 1 < count else -1
    return (
        f"<node><name>{at}</name><description></description><answertest>AlgEquiv</answertest><sans>{sans}</sans><tans>ta{at + 1}</tans>"
        "<testoptions></testoptions><quiet>1</quiet>"
        f"<truescoremode>=</truescoremode><truescore>{node.share:.6g}</truescore><truepenalty>0</truepenalty><truenextnode>-1</truenextnode>"
        f'<trueanswernote>{node.note}</trueanswernote><truefeedback format="html">{_text(node.feedback)}</truefeedback>'
        f"<falsescoremode>=</falsescoremode><falsescore>0</falsescore><falsepenalty>0</falsepenalty><falsenextnode>{following}</falsenextnode>"
        f'<falseanswernote>not-{node.note}</falseanswernote><falsefeedback format="html"><text></text></falsefeedback></node>'
    )


def _text(html: str) -> str:
    return moodle.cdata(_harmless(html))


def _harmless(html: str) -> str:
    """Without what STACK's own language would take for a command, save for fields."""
    return html.replace("{@", "{ @").replace("{#", "{ #")


TARGET = Target(ending="xml", items=write_items)
