"""Questions in QTI 2.1, for TAO and others: a zip with an item a variant, and a test that draws one a problem.

Ranges are written as `and(gte, lte)`, not with `equal` and its tolerance, which players read differently.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from xml.sax.saxutils import escape, quoteattr

from corollary.messages import catalogue
from corollary.render.exports import CarriedPart, ItemFiles, Target
from corollary.render.lms_item import ChoiceAsked, LmsItem, NotAsked, NumbersAsked, PartAsked, ProseAsked
from corollary.render.page import drawing_file
from corollary.render.pictures import as_files
from corollary.render.qti_item import block, float_text, inline, processing
from corollary.render.targets.feedback_zip import write_archive
from corollary.units.unit import show

_ = catalogue(__name__)

NAMESPACE = "http://www.imsglobal.org/xsd/imsqti_v2p1"
HEAD = (
    f'xmlns="{NAMESPACE}" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
    f'xsi:schemaLocation="{NAMESPACE} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"'
)
PACKAGE = "http://www.imsglobal.org/xsd/imscp_v1p1"
LOST = (
    "an answer that follows from the student's own earlier one is wrong",
    "the same slip costs in every part, not once",
    "figures are not counted: what is rounded to fewer than three is right or wrong as its value is",
    "a decimal comma is not a number in QTI; the question says so",
    "units that are typed: a field takes a number",
)
"""What no item carries."""


def write_items(name: str, items: Sequence[LmsItem], apart: bool) -> ItemFiles:
    """One archive with all items, the figures, a test and the manifest."""
    files: dict[str, bytes] = {}
    sections: dict[str, list[str]] = {}
    for item in items:
        if item.figure_name:
            files[item.figure_name] = drawing_file(item.exercise)
        problem = item.exercise.problem
        asked = [each for each in item.parts if not isinstance(each, NotAsked)]
        for parts, end in [([each], f"-{each.prompt.part.id}") for each in asked] if apart else [(asked, "")]:
            if parts:
                file = f"{problem.name}{end}-{item.number}.xml"
                text, pictures = as_files(_item(item, parts, file.removesuffix(".xml")))
                files |= {file: text.encode()} | pictures
                sections.setdefault(f"{problem.code} {problem.title}{end}", []).append(file)
    files["test.xml"] = _test(name, sections).encode()
    files["imsmanifest.xml"] = _manifest(name, files).encode()
    first = [item for item in items if item.number == 1]
    archive = write_archive(dict(sorted(files.items())))
    return ItemFiles({f"{name}-qti.zip": archive}, tuple(_carried(first)), LOST)


def _carried(items: Sequence[LmsItem]) -> Iterator[CarriedPart]:
    for item in items:
        for asked in item.parts:
            code, part = item.exercise.problem.code, asked.prompt.part.id
            match asked:
                case NumbersAsked():
                    yield CarriedPart(
                        code,
                        part,
                        "text entry" if len(asked.components) == 1 else "a text entry for each component",
                    )
                case ChoiceAsked():
                    yield CarriedPart(code, part, "choice")
                case ProseAsked():
                    yield CarriedPart(code, part, "extended text", "a person marks it")
                case NotAsked(why=why):
                    yield CarriedPart(code, part, "", why)


def _item(item: LmsItem, parts: Sequence[PartAsked], identifier: str) -> str:
    problem = item.exercise.problem
    rules, feedback = processing(parts)
    declared = "".join(map(_declared, parts))
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<assessmentItem {HEAD} identifier="{identifier}" '
        f'title={quoteattr(f"{problem.code} {problem.title}")} adaptive="false" timeDependent="false">\n'
        f"{declared}{_outcomes(parts)}<itemBody>{block(item.exercise.statement)}{_figure(item)}"
        f"<p>{escape(_numbers_only())}</p>{''.join(map(_asked, parts))}</itemBody>\n{rules}\n{feedback}"
        f'<modalFeedback outcomeIdentifier="SOLUTION" identifier="solution" showHide="show">{block(item.solution)}</modalFeedback>\n'
        "</assessmentItem>\n"
    )


def _numbers_only() -> str:
    return _(
        "In each number field, write only the number, in the unit beside the field, with at least "
        "three significant figures: 4.71 or 6.30e-5. Use a decimal point; digits behind a comma are "
        "not read."
    )


def _names(asked: PartAsked) -> list[str]:
    part = asked.prompt.part.id
    count = len(asked.components) if isinstance(asked, NumbersAsked) else 1
    return [f"RESPONSE_{part}_{place}" for place in range(1, count + 1)]


def _declared(asked: PartAsked) -> str:
    def response(name: str, base: str, right: str) -> str:
        correct = f"<correctResponse><value>{escape(right)}</value></correctResponse>" if right else ""
        return f'<responseDeclaration identifier="{name}" cardinality="single" baseType="{base}">{correct}</responseDeclaration>\n'

    names = _names(asked)
    match asked:
        case NumbersAsked(marks=marks):
            values = (float_text(float(f"{value:.7g}")) for value in marks[0].values)
            return "".join(response(name, "float", value) for name, value in zip(names, values, strict=True))
        case ChoiceAsked(options=options):
            right = "".join(each.option.letter for each in options if each.share == 1)
            return response(names[0], "identifier", right)
        case _:
            return response(names[0], "string", "")


def _outcomes(parts: Sequence[PartAsked]) -> str:
    def number(name: str, value: float = 0.0) -> str:
        default = f"<defaultValue><value>{value:g}</value></defaultValue>"
        return f'<outcomeDeclaration identifier="{name}" cardinality="single" baseType="float">{default}</outcomeDeclaration>\n'

    def word(name: str) -> str:
        return f'<outcomeDeclaration identifier="{name}" cardinality="single" baseType="identifier"/>\n'

    each = "".join(
        number(f"SCORE_{part}") + word(f"FEEDBACK_{part}") for part in (one.prompt.part.id for one in parts)
    )
    return f"{number('SCORE')}{number('MAXSCORE', sum(one.prompt.out_of for one in parts))}{each}{word('SOLUTION')}"


def _asked(asked: PartAsked) -> str:
    part = asked.prompt.part
    words = f"<h4>({part.heading_letter}) {inline(part.title)}</h4>{block(asked.prompt.text)}"
    names = _names(asked)
    match asked:
        case NumbersAsked(components=components):
            unit = f" {escape(show(asked.unit))}" if show(asked.unit) else ""
            fields = "".join(
                f'<p>{escape(f"{component}: " if component else "")}<textEntryInteraction responseIdentifier="{name}" '
                f'expectedLength="12"/>{unit}</p>'
                for name, component in zip(names, components, strict=True)
            )
            return words + fields
        case ChoiceAsked(options=options):
            choices = "".join(
                f'<simpleChoice identifier="{each.option.letter}">{inline(each.option.text)}</simpleChoice>'
                for each in options
            )
            return f'{words}<choiceInteraction responseIdentifier="{names[0]}" shuffle="false" maxChoices="1">{choices}</choiceInteraction>'
        case _:
            return f'{words}<extendedTextInteraction responseIdentifier="{names[0]}" expectedLines="8"/>'


def _figure(item: LmsItem) -> str:
    name = item.figure_name
    return f"<p><img src={quoteattr(name)} alt={quoteattr(item.exercise.figure_alt)}/></p>" if name else ""


def _test(name: str, sections: Mapping[str, Sequence[str]]) -> str:
    """A section for each problem, of which one item is drawn."""
    drawn = "".join(
        f'<assessmentSection identifier="section-{at}" title={quoteattr(title)} visible="true"><selection select="1"/>'
        + "".join(
            f'<assessmentItemRef identifier="{file.removesuffix(".xml")}" href="{file}"/>' for file in files
        )
        + "</assessmentSection>"
        for at, (title, files) in enumerate(sections.items(), 1)
    )
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<assessmentTest {HEAD} identifier="test-{name}" title={quoteattr(name)}>'
        f'<testPart identifier="part" navigationMode="nonlinear" submissionMode="individual">{drawn}</testPart></assessmentTest>\n'
    )


def _manifest(name: str, files: Mapping[str, bytes]) -> str:
    items = [file for file in files if file.endswith(".xml") and file != "test.xml"]
    figures = [file for file in files if not file.endswith(".xml")]
    resources = "".join(
        f'<resource identifier="item-{at}" type="imsqti_item_xmlv2p1" href="{file}"><file href="{file}"/></resource>'
        for at, file in enumerate(items, 1)
    ) + "".join(
        f'<resource identifier="figure-{at}" type="webcontent" href="{file}"><file href="{file}"/></resource>'
        for at, file in enumerate(figures, 1)
    )
    test = '<resource identifier="test" type="imsqti_test_xmlv2p1" href="test.xml"><file href="test.xml"/></resource>'
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<manifest xmlns="{PACKAGE}" identifier="manifest-{name}">'
        "<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>"
        f"<organizations/><resources>{test}{resources}</resources></manifest>\n"
    )


TARGET = Target(ending="zip", items=write_items)
