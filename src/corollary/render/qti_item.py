"""Items of QTI: Markdown as the XHTML that it allows, and the marks of numbers in fields."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.etree import ElementTree as Xml

from corollary.render.lms_item import ChoiceAsked, Credit, NumbersAsked, PartAsked
from corollary.render.markdown import html
from corollary.render.markdown import inline as inline_html

MATHML = "http://www.w3.org/1998/Math/MathML"
ALLOWED = frozenset({"class", "id"})
"""Attributes of QTI's XHTML; those of formulas are MathML's own."""
OF_PICTURES = frozenset({"src", "alt"})


def block(text: str) -> str:
    """Paragraphs, lists, tables, formulas on lines of their own."""
    return _within_qti(html(text))


def inline(text: str) -> str:
    """One line, without a paragraph around it."""
    return _within_qti(inline_html(text))


def _within_qti(found: str) -> str:
    root = Xml.fromstring(f"<div>{found}</div>")
    for element in root:
        _cleaned(element)
    inside = (root.text or "").replace("&", "&amp;").replace("<", "&lt;")
    return inside + "".join(Xml.tostring(each, encoding="unicode") for each in root)


def _cleaned(element: Xml.Element) -> None:
    """Without attributes that QTI does not know; formulas in their namespace."""
    if element.tag == "math":
        element.set("xmlns", MATHML)
        if displayed := element.attrib.pop(
            "displaystyle", ""
        ):  # which this schema has for a part of a formula only
            style = Xml.Element("mstyle", {"displaystyle": displayed})
            style.extend(list(element))
            for child in list(element):
                element.remove(child)
            element.append(style)
        return
    for name in [
        name for name in element.attrib if name not in (OF_PICTURES if element.tag == "img" else ALLOWED)
    ]:
        del element.attrib[name]
    for child in element:
        _cleaned(child)


def processing(parts: Sequence[PartAsked]) -> tuple[str, str]:
    """The `responseProcessing` of an item, and the feedback that it shows."""
    rules: list[str] = []
    messages: list[str] = []
    for asked in parts:
        part = asked.prompt.part.id
        branches = list(_branches(asked))
        if not branches:
            continue
        conditions: list[str] = []
        for place, (condition, share, feedback) in enumerate(branches, 1):
            word = "responseIf" if place == 1 else "responseElseIf"
            then = _set(f"SCORE_{part}", "float", float_text(share * asked.prompt.out_of))
            if feedback:
                then += _set(f"FEEDBACK_{part}", "identifier", f"{part}_{place}")
                messages.append(
                    f'<modalFeedback outcomeIdentifier="FEEDBACK_{part}" identifier="{part}_{place}" showHide="show">'
                    f"{block(feedback)}</modalFeedback>\n"
                )
            conditions.append(f"<{word}>{condition}{then}</{word}>")
        rules.append(f"<responseCondition>{''.join(conditions)}</responseCondition>\n")
    scores = "".join(f'<variable identifier="SCORE_{asked.prompt.part.id}"/>' for asked in parts)
    rules.append(f'<setOutcomeValue identifier="SCORE"><sum>{scores}</sum></setOutcomeValue>')
    rules.append(_set("SOLUTION", "identifier", "solution"))
    return f"<responseProcessing>\n{''.join(rules)}</responseProcessing>", "".join(messages)


def float_text(value: float) -> str:
    """With a point also before an exponent, as in 4.0e-06: TAO takes no 4e-06."""
    mantissa, exponent, power = f"{value + 0.0:.12g}".partition("e")
    return f"{mantissa if '.' in mantissa else mantissa + '.0'}{exponent}{power}"


def _set(outcome: str, base: str, value: str) -> str:
    return f'<setOutcomeValue identifier="{outcome}">{_value(base, value)}</setOutcomeValue>'


def _value(base: str, value: str) -> str:
    return f'<baseValue baseType="{base}">{value}</baseValue>'


def _branches(asked: PartAsked) -> Iterator[tuple[str, float, str]]:
    """A condition, the share of the points that it earns, and what is said; in the order of trying."""
    part = asked.prompt.part.id
    match asked:
        case NumbersAsked(marks=marks):
            for mark in marks:
                yield _met(part, mark), mark.share, mark.feedback
        case ChoiceAsked(options=options):
            for each in options:
                chosen = (
                    f'<variable identifier="RESPONSE_{part}_1"/>{_value("identifier", each.option.letter)}'
                )
                yield f"<match>{chosen}</match>", each.share, each.feedback
        case _:
            return


def _met(part: str, mark: Credit) -> str:
    """Each component in its range and, where there are several, all of them as near together as they should be.

    A blank field is nothing near, though some players would take it for 0.
    """
    conditions: list[str] = []
    squares: list[str] = []
    for place, ((low, high), value) in enumerate(zip(mark.ranges(), mark.values, strict=True), 1):
        variable = f'<variable identifier="RESPONSE_{part}_{place}"/>'
        conditions.append(f"<not><isNull>{variable}</isNull></not>")
        conditions.append(f"<gte>{variable}{_value('float', float_text(low))}</gte>")
        conditions.append(f"<lte>{variable}{_value('float', float_text(high))}</lte>")
        off = f"<subtract>{variable}{_value('float', float_text(value))}</subtract>"
        squares.append(f"<product>{off}{off}</product>")
    if len(squares) > 1:
        conditions.append(
            f"<lte><sum>{''.join(squares)}</sum>{_value('float', float_text(mark.reach**2))}</lte>"
        )
    return f"<and>{''.join(conditions)}</and>"
