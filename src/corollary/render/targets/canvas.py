"""Questions as Canvas imports them, into Classic and New Quizzes: a quiz in QTI 1.2, with a question for each part."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

from corollary.formula.errors import ParseError
from corollary.messages import catalogue
from corollary.render.exports import CarriedPart, ItemFiles, Target
from corollary.render.lms_item import ChoiceAsked, LmsItem, NotAsked, NumbersAsked, PartAsked, ProseAsked
from corollary.render.markdown import tex_html
from corollary.render.page import drawing_file
from corollary.render.pictures import as_files
from corollary.render.qti_item import block, inline
from corollary.render.targets.feedback_zip import write_archive
from corollary.units.unit import Unit, read_unit, show
from corollary.units.unit_table import PREFIXES

_ = catalogue(__name__)

LONGEST = 16_000
"""Signs of HTML: Canvas puts a sentence of its own in the place of more than 16 384."""
SPACE = re.compile(r"<mspace[^>]*?(?:/>|></mspace>)")  # whose width Canvas takes away
ANSWER = 'respident="response1"'
TYPED = '<response_str ident="response1" rcardinality="Single"><render_fib{}><response_label ident="answer1"/></render_fib></response_str>'


@dataclass(frozen=True, slots=True)
class CanvasOption:
    """One option: HTML, whether it is right, and what is said of it (HTML, or "")."""

    html: str
    right: bool
    feedback: str


@dataclass(frozen=True, slots=True)
class CanvasQuestion:
    """A field with its text. Of a number, `ranges` are (lowest, right, highest); with neither ranges nor options it is an essay.

    `ident` is its own, `body` and `comments` (which everybody reads afterwards) are HTML.
    """

    ident: str
    title: str
    points: float
    body: str
    comments: str
    ranges: Sequence[tuple[float, float, float]] = ()
    options: Sequence[CanvasOption] = ()

    @property
    def fits(self) -> bool:
        return len(_spaced(as_files(self.body)[0])) <= LONGEST

    def xml(self) -> str:
        kind, field, rules, feedback = _parts(self)
        if self.comments:
            everybody = "<conditionvar><other/></conditionvar>"
            rules = (
                f'<respcondition continue="Yes">{everybody}{_displayed("general_fb")}</respcondition>{rules}'
            )
            feedback += _feedback("general_fb", self.comments)
        about = {
            "question_type": kind,
            "points_possible": f"{self.points:.12g}",
            "original_answer_ids": ",".join(map(str, _idents(self))),
        }
        fields = "".join(
            f"<qtimetadatafield><fieldlabel>{label}</fieldlabel><fieldentry>{entry}</fieldentry></qtimetadatafield>"
            for label, entry in about.items()
        )
        return (
            f"<item ident={quoteattr(self.ident)} title={quoteattr(self.title)}><itemmetadata><qtimetadata>{fields}</qtimetadata></itemmetadata>"
            f"<presentation>{_material(f'<div>{self.body}</div>')}{field}</presentation>"
            '<resprocessing><outcomes><decvar maxvalue="100" minvalue="0" varname="SCORE" vartype="Decimal"/></outcomes>'
            f"{rules}</resprocessing>{feedback}</item>\n"
        )


def _parts(question: CanvasQuestion) -> tuple[str, str, str, str]:
    """The type, the field, the rules and what is said of single answers."""
    if question.ranges:
        rules = "".join(_scored(_range(*each)) for each in question.ranges)
        return "numerical_question", TYPED.format(' fibtype="Decimal"'), rules, ""
    if not question.options:
        rules = '<respcondition continue="No"><conditionvar><other/></conditionvar></respcondition>'
        return "essay_question", TYPED.format(""), rules, ""
    named = list(zip(_idents(question), question.options, strict=True))
    labels = "".join(
        f'<response_label ident="{name}">{_material(each.html)}</response_label>' for name, each in named
    )
    field = f'<response_lid ident="response1" rcardinality="Single"><render_choice>{labels}</render_choice></response_lid>'
    reactions = "".join(
        f'<respcondition continue="Yes"><conditionvar><varequal {ANSWER}>{name}</varequal></conditionvar>{_displayed(f"{name}_fb")}</respcondition>'
        for name, each in named
        if each.feedback
    )
    right = "".join(_scored(f"<varequal {ANSWER}>{name}</varequal>") for name, each in named if each.right)
    feedback = "".join(_feedback(f"{name}_fb", each.feedback) for name, each in named if each.feedback)
    return "multiple_choice_question", field, reactions + right, feedback


def _idents(question: CanvasQuestion) -> Sequence[int]:
    """Canvas numbers its answers."""
    return range(101, 101 + len(question.options))


def _range(low: float, right: float, high: float) -> str:
    """`right` with its margin, which Canvas reads off the upper end; the bounds alone where they are not alike."""
    bounds = f"<vargte {ANSWER}>{_float(low)}</vargte><varlte {ANSWER}>{_float(high)}</varlte>"
    if abs((high - right) - (right - low)) > 1e-6 * (high - low):
        return bounds
    return f"<or><varequal {ANSWER}>{_float(right)}</varequal><and>{bounds}</and></or>"


def _float(value: float) -> str:
    """Without an exponent, which is lost on the way."""
    text = f"{value + 0.0:.12f}".rstrip("0")
    return f"{text}0" if text.endswith(".") else text


def _scored(condition: str) -> str:
    score = '<setvar action="Set" varname="SCORE">100</setvar>'
    return f'<respcondition continue="No"><conditionvar>{condition}</conditionvar>{score}</respcondition>'


def _displayed(name: str) -> str:
    return f'<displayfeedback feedbacktype="Response" linkrefid="{name}"/>'


def _feedback(name: str, html: str) -> str:
    return f'<itemfeedback ident="{name}"><flow_mat>{_material(html)}</flow_mat></itemfeedback>'


def _material(html: str) -> str:
    return f'<material><mattext texttype="text/html">{escape(_spaced(html))}</mattext></material>'


def _spaced(html: str) -> str:
    return SPACE.sub("<mtext>\u2009</mtext>", html)


LEAST_REACH = 5e-3
"""A hundred times what rounding to four decimals can move: hardly anybody's mark hangs on it."""
LEAST, MOST = 0.1, 1e6
"""Between them a number is typed as it is, without an exponent."""
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class TypedScale:
    """`power` of ten that one typed stands for, in the unit of the part; `text` is what is asked for: mN, or 10⁻³ kg m/s."""

    power: int
    text: str

    def typed(self, value: float) -> float:
        """What is typed for a value in the unit of the part."""
        return value / 10**self.power if self.power > 0 else value * 10**-self.power


def typed_scale(unit: Unit, values: Sequence[float], reach: float) -> TypedScale:
    """Powers are multiples of three, none for temperatures, whose unit has a zero of its own."""
    size = max(map(abs, values), default=0.0) or reach
    if unit.offset or (reach >= LEAST_REACH and LEAST <= size < MOST) or not size:
        return TypedScale(0, show(unit))
    power = 3 * math.floor(math.log10(size) / 3)
    while reach / 10.0**power < LEAST_REACH:
        power -= 3
    return TypedScale(
        power, _prefixed(unit, power) or f"10{str(power).translate(SUPERSCRIPTS)} {show(unit)}".strip()
    )


def _prefixed(unit: Unit, power: int) -> str:
    """The unit with a prefix, where one symbol has it; "" where none does."""
    wanted = float(unit.si) * 10.0**power
    symbol = unit.text
    for stem in (symbol, symbol[1:]):
        for prefix in PREFIXES:
            found = read_unit(prefix + stem) if stem else None
            if found is None or isinstance(found, ParseError) or found.dimension != unit.dimension:
                continue
            if math.isclose(float(found.si), wanted, rel_tol=1e-9) and found.text == prefix + stem:
                return show(found)
    return ""


QTI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
FOLDER = "figures/"
PACKAGE = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
LOST = (
    "a known mistake, a slip and an option that is worth a share earn nothing: Canvas gives all of the points or none",
    "what is said of a mistake in a number; of a wrong option it is said",
    "an answer that follows from the student's own earlier one is wrong",
    "figures are not counted: what is rounded to fewer than three is right or wrong as its value is",
    "a decimal comma is read where Canvas speaks a language that has one; the question says so",
    "units that are typed: a field takes a number",
)
"""What no question carries."""
POOLED = (
    "each part is a separate question with its own pool, so its numbers differ from those of the other parts"
)


def write_items(name: str, items: Sequence[LmsItem], apart: bool) -> ItemFiles:
    """One archive with a quiz, which draws one variant of each part, and the figures; parts are always apart."""
    asked_as: dict[tuple[str, str], tuple[str, str]] = {}
    pools: dict[str, list[CanvasQuestion]] = {}
    for item in items:
        solution = _solution(item)
        for asked in item.parts:
            part = item.exercise.problem.code, asked.prompt.part.id
            questions = list(_questions(item, asked, solution))
            if item.number == 1:
                asked_as[part] = _how(item, asked, solution, all(each.fits for _pool, each in questions))
            if asked_as[part][0]:
                for pool, question in questions:
                    pools.setdefault(pool, []).append(question)
    quiz, pictures = as_files(_quiz(name, pools), FOLDER)
    figures = {
        FOLDER + item.figure_name: drawing_file(item.exercise) for item in items if item.exercise.figure
    }
    figures |= {FOLDER + picture: content for picture, content in pictures.items()}
    files = {
        "imsmanifest.xml": _manifest(name, sorted(figures)).encode(),
        f"{name}/{name}.xml": quiz.encode(),
        **figures,
    }
    carried = tuple(CarriedPart(*part, *how) for part, how in asked_as.items())
    lost = (*LOST, POOLED) if any(item.number > 1 for item in items) else LOST
    return ItemFiles({f"{name}-canvas.zip": write_archive(dict(sorted(files.items())))}, carried, lost)


def scale_of(asked: NumbersAsked) -> TypedScale:
    """The unit that the numbers of a part are asked for in, the same for all components."""
    return typed_scale(asked.unit, asked.marks[0].values, asked.marks[0].reach)


def _how(item: LmsItem, asked: PartAsked, solution: str, fits: bool) -> tuple[str, str]:
    """How a part is asked ("" where it is not), and what is lost of it."""
    if not fits:
        return "", "the question is longer than a text that Canvas takes"
    if not solution:
        without = "the worked solution is longer than a text that Canvas takes"
    elif solution != block(item.solution):
        without = "the worked solution has its formulas in TeX, since MathML is longer than a text that Canvas takes"
    else:
        without = ""
    match asked:
        case NumbersAsked(components=("",)):
            how, lost = "number", ""
        case NumbersAsked():
            how, lost = (
                "a number for each component",
                "each component is a question, which earns its share by itself",
            )
        case ChoiceAsked():
            how, lost = "multiple choice", ""
        case ProseAsked():
            how, lost = "essay", "a person marks it; the rubric"
        case NotAsked(why=why):
            return "", why
    return how, "; ".join(filter(None, (lost, without)))


def _questions(item: LmsItem, asked: PartAsked, comments: str) -> Iterator[tuple[str, CanvasQuestion]]:
    """The pool that a question belongs to, and the question: one for each field."""
    problem, part = item.exercise.problem, asked.prompt.part
    pool, title = f"{problem.name}_{part.id}", f"{problem.code} {problem.title}, ({part.heading_letter})"
    words = f"<h4>({part.heading_letter}) {inline(part.title)}</h4>{block(asked.prompt.text)}"
    stem, points = f"{block(item.exercise.statement)}{_figure(item)}{words}", asked.prompt.out_of
    match asked:
        case NumbersAsked(components=components, marks=marks):
            scale = scale_of(asked)
            for place, component in enumerate(components):
                ranges = [
                    (scale.typed(low), scale.typed(mark.values[place]), scale.typed(high))
                    for mark in marks
                    if mark.share == 1
                    for low, high in [mark.ranges()[place]]
                ]
                one = f"{pool}_{place + 1}" if component else pool
                yield (
                    one,
                    CanvasQuestion(
                        f"{one}_{item.number}",
                        f"{title} {component}".strip(),
                        points / len(components),
                        f"{stem}<p>{escape(_number(component, scale))}</p>",
                        comments,
                        ranges=ranges,
                    ),
                )
        case ChoiceAsked(options=options):
            choices = [
                CanvasOption(inline(each.option.text), each.share == 1, block(each.feedback))
                for each in options
            ]
            yield (
                pool,
                CanvasQuestion(f"{pool}_{item.number}", title, points, stem, comments, options=choices),
            )
        case ProseAsked():
            yield pool, CanvasQuestion(f"{pool}_{item.number}", title, points, stem, comments)
        case NotAsked():
            return


def _number(component: str, scale: TypedScale) -> str:
    if scale.text:
        asked = _(
            "Write only the number, in {unit}, with at least three significant figures.", unit=scale.text
        )
    else:
        asked = _("Write the number with at least three significant figures.")
    point = _("Use a decimal point, not a comma.")
    return f"{component + ': ' if component else ''}{asked} {point}"


def _solution(item: LmsItem) -> str:
    """Of the whole problem, for everybody to read afterwards. TeX is shorter than MathML; "" where it is too long, too."""
    written = (write(item.solution) for write in (block, tex_html))
    return next((html for html in written if len(html) <= LONGEST), "")


def _quiz(name: str, pools: Mapping[str, Sequence[CanvasQuestion]]) -> str:
    drawn = "".join(
        _drawn(pool, questions) if len(questions) > 1 else questions[0].xml()
        for pool, questions in pools.items()
    )
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<questestinterop xmlns="{QTI}"><assessment ident="{name}" title={quoteattr(name)}>'
        f'<section ident="root_section">{drawn}</section></assessment></questestinterop>\n'
    )


def _drawn(pool: str, questions: Sequence[CanvasQuestion]) -> str:
    """A group of which a student gets one."""
    points = f"<selection_extension><points_per_item>{questions[0].points:.12g}</points_per_item></selection_extension>"
    selection = f"<selection_ordering><selection><selection_number>1</selection_number>{points}</selection></selection_ordering>"
    items = "".join(each.xml() for each in questions)
    return f'<section ident="{pool}" title={quoteattr(questions[0].title)}>{selection}{items}</section>\n'


def _manifest(name: str, figures: Sequence[str]) -> str:
    resources = "".join(
        f'<resource identifier="figure_{at}" type="webcontent" href="{file}"><file href="{file}"/></resource>'
        for at, file in enumerate(figures, 1)
    )
    quiz = f'<resource identifier="{name}" type="imsqti_xmlv1p2" href="{name}/{name}.xml"><file href="{name}/{name}.xml"/></resource>'
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<manifest xmlns="{PACKAGE}" identifier="{name}_manifest">'
        "<metadata><schema>IMS Content</schema><schemaversion>1.1.3</schemaversion></metadata>"
        f"<organizations/><resources>{quiz}{resources}</resources></manifest>\n"
    )


def _figure(item: LmsItem) -> str:
    if not item.exercise.figure:
        return ""
    return (
        f"<p><img src={quoteattr(FOLDER + item.figure_name)} alt={quoteattr(item.exercise.figure_alt)}/></p>"
    )


TARGET = Target(ending="zip", items=write_items)
