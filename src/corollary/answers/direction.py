"""Directions in a text: axes of its own (`x to the left`) turn components, words behind a number (`to the left`, `lost`) are its sign."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from corollary.answers.answer import Answer, Blank, Formulas, Numbers, Unclear
from corollary.answers.bound import QUESTIONS
from corollary.answers.changing_words import CONTRARY, words_of
from corollary.answers.left_side import CHANGE
from corollary.answers.motion_words import way_behind
from corollary.answers.positive_direction import REFERENCE_LINE, line_of, sign_of_way, sign_of_words
from corollary.answers.preamble import OF_A_SIGN, reason_in, ways_before, without_reason
from corollary.answers.question import Question
from corollary.answers.remark import HARMLESS, remark_in
from corollary.answers.sentence import QuantitySentence, sentence_in
from corollary.answers.sign_words import AXIS_OF, SIGNS
from corollary.formula.ast import Negative
from corollary.formula.value import Text, Value
from corollary.messages import catalogue
from corollary.units.unit import ONE, unit

_ = catalogue(__name__)

LOSSES = (
    "losses loss lose loses lost losing decreases decreased decrease drops dropped drop reduced reduction dissipated "
    "verlust verliert verlieren verloren abnahme tap taper tapt mister mistet less weniger mindre"
)
GAINS = "gains gained gain increases increased increase gewinn zunahme økning more mehr mer"
COMPARING = "more mehr mer"
TIMES = re.compile(r"\b(?:times|mal|ganger)\s*$", re.IGNORECASE)  # `2 times more` is 2
WORDS = "|".join(f"{LOSSES} {GAINS}".split())
WHAT = r"(?:in |of )?(?:the |its |their )?(?:total |kinetic |mechanical |internal )*(?:energy|momentum|speed|velocity|K)"
BEFORE = re.compile(
    rf"^\s*(?:(?:the|a|an|it|they|we|there|system|car|energy|kinetic|mechanical|total|momentum|K|E|is|are|was|were|has|have)\s+)*"
    rf"(?P<word>{WORDS})(?:\s+{WHAT})?\s*(?:(?:of|by|is|was|about|um|von|på|med|:|=|≈)\s*)*(?=[-+]?\s*[0-9.,])",
    re.IGNORECASE,
)
VERB = re.compile(
    r"^\s*(?:the )?(?!no|never|n't)[a-z]+ (?P<word>loses|lost|gains|gained|dissipated)\s+(?:about\s+)?(?=[-+]?\s*[0-9.,])",
    re.IGNORECASE,
)
OF_ENERGY = re.compile(rf"\s+(?:of|in)\s+{WHAT}\s*$", re.IGNORECASE)
BEHIND = re.compile(
    rf"(?<=[A-Za-z0-9²)%])[\s,;(]+(?:(?:{WHAT}|is|are|was|were|has|have|been|gets?|got|a|geht|gehen|ging|gingen|går|gikk|er)\s+)*"
    rf"(?P<word>{WORDS})(?:\s+(?:{WHAT}|(?:to|as|into) (?:heat|friction|sound)"
    r"|than (?:before|at first|initially|in the beginning|at the (?:start|beginning)|vorher|zuvor|før)))?\)?\.?\s*$",
    re.IGNORECASE,
)
INTO_HEAT = re.compile(
    r"(?<=[A-Za-z0-9²)%])[\s,;(]+(?P<word>(?:(?:of energy|of kinetic energy|is|are|was|were|has been|have been)\s+)*"
    r"(?:becomes?|became|goes|go|went|turns?|turned|changed|converted|transformed|dissipated)(?: in)?(?: ?to| as)? (?:heat|thermal energy|internal energy))\)?\.?\s*$",
    re.IGNORECASE,
)
INDEXED = re.compile(  # `E_lost = 205 J`
    r"^\s*[EKQUW]_?\{?(?P<word>lost|loss|dissipated|verlust|verloren|tapt|tap)\}?\s*[:=≈]\s*(?=[-+]?\s*[0-9.,])",
    re.IGNORECASE,
)
# The loss itself is asked for: then what is lost is positive.
ASKED_AS_LOSS = re.compile(
    r"\b(?:lost|loss|losses|loses|dissipated|given (?:away|off)|verlust|verloren|tap|tapt)\b", re.IGNORECASE
)


@dataclass(frozen=True, slots=True)
class Gain:
    """A text without its word for gain or loss, the sign that the word gives, and the word; whether it says that there is more than
    of something else."""

    text: str
    sign: int
    word: str
    compares: bool = False


def gain_in(text: str, question: Question) -> Gain | None:
    """What a text of bounded length says is gained or lost, if anything. A loss is negative, unless the loss is asked for."""
    found = (
        INDEXED.search(text)
        or BEFORE.search(text)
        or VERB.search(text)
        or BEHIND.search(text)
        or INTO_HEAT.search(text)
    )
    if found is None:
        return None
    word = found["word"].lower()
    sign = 1 if word in GAINS.split() else -1
    if ASKED_AS_LOSS.search(f"{question.title} {' '.join(QUESTIONS.findall(question.text))}"):
        sign = -sign
    without = OF_ENERGY.sub("", text[: found.start()] + text[found.end() :])
    return Gain(
        without,
        sign,
        found[0].strip(" ,;().:=≈\t\n"),
        word in COMPARING.split() and not TIMES.search(without),
    )


LONGEST = 200
# A mass or an energy turns with no axis.
DIRECTED = frozenset(unit(text).dimension for text in ("m/s", "m/s^2", "kg*m/s", "N"))
AXES = re.compile(
    r"[\s,;]\s*\(?(?:with |where |taking )?(?P<axis>[xyz+]|positive)(?:[ -](?:axis|direction|component))?"
    r"(?: is| points?| pointing| taken)?(?: to)?(?: the)? (?P<way>left|right|up|down|upwards?|downwards?|reversed"
    r"|other way|opposite way|opposite)\)?\.?\s*$",
    re.IGNORECASE,
)
# x points to the right and y up, as in every figure of the chapter.
USUAL = frozenset({"right", "up", "upward", "upwards"})
ALONG = re.compile(
    r"[\s,;(]+(?:i\.e\.,? |that is,? |meaning |so )?(?:(?:and )?(?:is )?(?:pointing|directed|moving|moves|going|goes|acting|acts|pushing|straight) )?"
    rf"(?:(?:(?:in|along|to|towards|nach|vers|mot|til|i|im) )?(?:the |la |le |der |den )?(?P<way>{'|'.join(sorted(SIGNS, key=len, reverse=True))})(?:[ -](?P<axis>[xyz]))?"
    r"|(?:in|along) (?:the )?(?P<sign>[+−–-])(?P<of>[xyz]))(?:[ -](?:axis|direction|richtung|achse|retning|aksen))?\)?\.?\s*$",
    re.IGNORECASE,
)
BESIDE_AXIS = re.compile(
    r"[\s,;(]+(?:in|along)(?: the| positive| the positive)? (?P<axis>[xyz])(?:[- ](?:direction|axis))?\)?\.?\s*$"
)
IN_FRONT = re.compile(
    r"^\s*(?:to the )?(?P<way>left|right|up|upwards?|down|downwards?|backwards?|forwards?)\s*[:,]?\s+(?=[0-9.,])",
    re.IGNORECASE,
)
REFERENCE = (  # from where an angle is counted
    r"(?:(?: (?:from|to|of|as seen from))?(?: (?:the|der|den|die))?(?: positiven?)? \+?"
    r"(?:horizontal|ground|horizontalen|waagerechten|horisontalen|east|x)(?:[- ]?(?:axis|direction|plane|achse|richtung|aksen|retning))?)?"
)
UPWARDS = "up|upwards?|above|over|aufwärts|nach oben|über|oppover|counter-?clockwise|anticlockwise|gegen den Uhrzeigersinn|mot klokka|north"
DOWNWARDS = "down|downwards?|below|under|abwärts|nach unten|unter|unterhalb|nedover|clockwise|im Uhrzeigersinn|med klokka|south"
DIRECTION_BEHIND = re.compile(
    rf"[\s,;(]+(?:(?P<up>{UPWARDS})|(?:{DOWNWARDS})){REFERENCE}\)?\.?\s*$", re.IGNORECASE
)
TOWARDS = re.compile(
    r"(?<=[A-Za-z0-9²)])[\s,;(]+(?:i\.e\.,? |that is,? |meaning |so )?"
    r"(?P<words>(?:(?:straight|directly) )?"
    r"(?:in|towards?|(?<=straight )at|(?<=directly )at|away from|against|from|opposite to|along) "
    r"(?:(?:the|my|his|its|our|your) [a-z' ]{2,60}|me|him|her|it|us|you)(?: [0-9A-Z])?"
    r"|(?:towards?|away from) (?:[a-z]{2,20} ?[0-9A-Z]|[A-Z]))\)?\.?\s*$",
    re.IGNORECASE,
)

EXPLAINS = re.compile(r"\s*[,;(]|\s+(?:i\.e|that is|meaning|so)\b", re.IGNORECASE)  # `-3 N (to the left)`
WAYS = "|".join(sorted(SIGNS, key=len, reverse=True))
TWO_WAYS = re.compile(  # `(positive, up)`
    rf"[\s,;(]+(?:to the |in the )?(?P<way>{WAYS})(?:[ -]direction)?\s*(?:[,;/]|\band\b|\bi\.?e\.?,?|=|\()\s*(?:so |that is,? )?(?:to the )?(?P<other>{WAYS})\s*\)*\.?\s*$",
    re.IGNORECASE,
)
# `301 kg left`: what is asked for has no direction.
LEFT_OVER = re.compile(
    r"(?<=[A-Za-z%])(?<!\bthe)\s+(?:(?:is|are|was|were) )?(?:left(?: over)?|remaining)\.?\s*$", re.IGNORECASE
)
SIZE = re.compile(
    r"\b(?:speeds?|magnitude|size|how (?:fast|large|big|great|strong)|schnell\w*|betrag|tempo|fart|størrelse)\b",
    re.IGNORECASE,
)
REFERENCE_BEHIND = re.compile(
    rf"[\s,;(]+(?:measured |counted )?{REFERENCE_LINE.pattern}\)?\.?\s*$", re.IGNORECASE
)


# `0.8 m/s to the left, i.e. -0.8 m/s`, `9.9 m/s, which is about 36 km/h`: one value, given twice.
AGAIN = re.compile(
    r"(?:\s*\(\s*|[,;]?\s+)(?:i\.e\.,?|that is,?|which is|which means|so|hence|thus|das sind|dvs\.?)\s+"
    r"(?:about |approximately |(?:the|its) (?:\w+ ){1,2}is )?(?:[^\W\d_]\w{0,3}\s*=\s*)?(?=[-+−]?\s?[0-9.,])",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class AxisRemarks:
    """A text without its remarks on axes; the sign that takes each component to the usual axes; the remarks as written."""

    text: str
    signs: tuple[int, ...]
    words: str


@dataclass(frozen=True, slots=True)
class Direction:
    """A text without its words on direction; the sign they give, None where they alone do not tell it; the words."""

    text: str
    sign: int | None
    words: str


def directed(question: Question) -> bool:
    """Whether what is asked for turns with the axes, so that a remark on them means something."""
    named = any(not name.isdigit() for name in question.components)
    return named or question.unit.dimension in DIRECTED


def on_usual_axes(value: Value, question: Question, read: Callable[[Value], Answer]) -> Answer:
    """The answer on the problem's axes, when a text names others; `read` reads what stands beside the remark."""
    if not isinstance(value, Text) or not directed(question):
        return read(value)
    axes = axes_of(value.text, question.components)
    return _turned(read(Text(axes.text)), axes) if axes.words else read(value)


def with_direction(
    value: Value, question: Question, read: Callable[[Value], Answer], component: str = ""
) -> Answer:
    """One number with the sign that its words give; two readings where the words alone do not tell it.

    Of a `component` along an axis (x, y, z) only words along that axis give it.
    """
    if not isinstance(value, Text) or len(value.text) > LONGEST:
        return read(value)
    if (one := _value_again(value.text, question, read, component)) is not None:
        return one
    value = Text(without_reason(value.text))
    if not directed(question) and (rest := LEFT_OVER.search(value.text)):
        value = Text(value.text[: rest.start()])
    if reason_in(value.text):  # `12 N because left is negative`: what speaks of a sign there gives none
        answer = read(value)
        return _remarked(value.text, answer, question, read, component) if _is_unread(answer) else answer
    if gain := gain_in(value.text, question):
        answer = read(Text(gain.text))
        if gain.compares and not CHANGE.search(question.title):
            return _more_than_what(answer, gain.word, question)
        return _signed(answer, gain.sign, gain.word)
    angle = question.unit.text in ("rad", "deg")
    text = value.text if angle else way_behind(value.text)
    found = turn_of(text) if angle else direction_of(text, directed(question), component, question.positive)
    if angle and found is None and (counted := REFERENCE_BEHIND.search(text)):
        return _counted_from(read(Text(text[: counted.start()])), counted, question)
    if found is not None and found.sign is not None and SIZE.search(question.title):
        found = replace(found, sign=1)  # a speed has no sign: the words say more than was asked
    if angle and found is not None and found.sign is not None and question.reference.startswith("below"):
        found = replace(found, sign=-found.sign)  # the question counts downwards
    answer = read(value if found is None else Text(found.text))
    if found is None or _is_unread(answer):  # `-0.4 m/s (so I move backwards)`
        remarked = _remarked(value.text, answer, question, read, component) if _is_unread(answer) else answer
        if _is_unread(remarked) and not component and (led := ways_before(value.text)) is not None:
            signs = {sign_of_way(way, question.positive) for way in led.ways}
            behind = read(Text(led.text))
            if len(signs) == 1 and not _has_minus(behind):
                return _signed(behind, signs.pop(), " ".join(led.ways)) if directed(question) else behind
        if (
            _is_unread(remarked)
            and not component
            and (sentence := sentence_in(value.text, 1, question)) is not None
        ):
            return _only_quantity(sentence, read(Text(sentence.quantities[0])), question) or remarked
        if found is None or not _is_unread(remarked):
            return remarked
    if found.sign is None or (_has_minus(answer) and not EXPLAINS.match(text.removeprefix(found.text))):
        return _either(answer, found.words)
    return _signed(answer, found.sign, found.words)


def _value_again(
    text: str, question: Question, read: Callable[[Value], Answer], component: str
) -> Answer | None:
    """What a text says twice, in other words or another unit; None where it does not."""
    found = list(AGAIN.finditer(text))
    if len(found) != 1 or not re.search("[0-9]", text[: found[0].start()]) or "=" in text[: found[0].start()]:
        return None
    first, second = text[: found[0].start()], text[found[0].end() :].rstrip(" .)")
    spoken = [with_direction(Text(each), question, read, component) for each in (first, second)]
    if _is_unread(spoken[0]) and (sentence := sentence_in(first, 1, question)) is not None:
        first_read = read(Text(sentence.quantities[0]))
        spoken[0] = Unclear("", "", (first_read,)) if isinstance(first_read, Numbers) else first_read
    ways = {sign_of_way(word, question.positive) for word in SIGNS.keys() & words_of(first)}
    second_way = -1 if isinstance(spoken[1], Numbers) and spoken[1].values[0] < 0 else 1
    if ways - {second_way} and _has_minus(spoken[1]):
        return None  # `3 N towards it, to the right, i.e. -3 N`
    return _one_value(*spoken)


def _only_quantity(sentence: QuantitySentence, answer: Answer, question: Question) -> Answer | None:
    """The one quantity of a sentence; with either sign where its words may turn it."""
    if (
        not isinstance(answer, Numbers)
        or answer.misfit
        or (sentence.turned and not (directed(question) or _has_place(question)))
    ):
        return None
    (value,) = answer.values
    words = " ".join(" ".join(sentence.words).split()).strip(" .,;:()")
    if value < 0 or _repeats(words, question):
        return answer
    why = _(
        "\u201c{words}\u201d beside the number may be a sign; write the number alone, with its sign",
        words=words,
    )
    return _two_ways(answer, words, why, sign_alone=not sentence.turned and not _is_contrary(words, question))


def _one_value(first: Answer, second: Answer) -> Answer | None:
    """What two sayings of one value come to: the second, where their sizes agree and no sign contradicts; else None."""
    match first, second:
        case (Numbers((one,)) | Unclear(readings=(Numbers((one,)), *_)), Numbers((other,))) if not (
            isinstance(first, Unclear) and SIGNS.keys() & words_of(first.as_read)
        ):
            same = math.isclose(abs(one), abs(other), rel_tol=0.01)
            clashes = isinstance(first, Numbers) and one * other < 0
            return second if same and not clashes and not (second.misfit or second.missing) else None
        case _:
            return None


def _has_minus(answer: Answer) -> bool:
    """True of a number with a sign of its own, beside which words are a second one."""
    return isinstance(answer, Numbers) and len(answer.values) == 1 and answer.values[0] < 0


def _more_than_what(answer: Answer, word: str, question: Question) -> Answer:
    """`86 N more` where no change is asked for: that much, or that much more; of `100 %` more the whole is 200 %."""
    match answer:
        case Numbers((value,)):
            why = _("it is not clear what “{word}” compares with; write the number that is asked", word=word)
            whole = (replace(answer, values=(1 + value,)),) if question.unit.dimension == ONE else ()
            return Unclear(why, f"{answer.as_read} {word}", (answer, *whole))
        case _:
            return answer


def _remarked(
    text: str, unread: Answer, question: Question, read: Callable[[Value], Answer], component: str
) -> Answer:
    """What cannot be read with the words behind it, without them: as it is where they say nothing of it, else for a person."""
    remark = remark_in(text)
    if remark is None or AXES.search(
        text
    ):  # an axis that the answer does not have turns nothing, and is not passed over
        return unread
    if (component or not (directed(question) or _has_place(question))) and SIGNS.keys() & set(
        remark.words.lower().split()
    ):
        return unread
    answer = with_direction(Text(remark.text), question, read, component)
    if _is_unread(answer) or isinstance(answer, Blank):
        return unread
    if remark.harmless or not isinstance(answer, Numbers) or _repeats(remark.words, question):
        return answer
    # The sign may be given in words: `85.3 J lost by the block and gained by the bullet`.
    if answer.values[0] <= 0 and not answer.in_words:
        return answer
    why = _(
        "\u201c{words}\u201d beside the number may be a sign; write the number alone, with its sign",
        words=remark.words,
    )
    return _two_ways(answer, remark.words, why, sign_alone=not _is_contrary(remark.words, question))


def _has_place(question: Question) -> bool:
    """True for a length or an angle, which has no direction itself but may lie to the left."""
    return question.unit.is_angle or question.unit.dimension == unit("m").dimension


def _repeats(words: str, question: Question) -> bool:
    """True for words of the question itself beside what has no direction: `56 cm behind the mirror`, where just that is asked."""
    spoken, known = words_of(words), words_of(f"{question.title} {question.text}")
    return (
        not directed(question)
        and not spoken & SIGNS.keys()
        and not OF_A_SIGN.search(words)
        and spoken <= known | HARMLESS
    )


def _is_contrary(words: str, question: Question) -> bool:
    """True where words may name the other side of what is asked for, and are not the question's own."""
    spoken, known = words_of(words), words_of(question.text)
    named = re.search(r"\b[B-HJ-Z]\b|\bA\b(?! )|axis|-achse|-akse", words)
    if directed(question) and (OF_A_SIGN.search(words) or re.search("oppos|contrar", words, re.IGNORECASE)):
        return True
    share = question.unit.is_pure
    return share or named is not None or bool(spoken & SIGNS.keys()) or bool((spoken & CONTRARY) - known)


def _is_unread(answer: Answer) -> bool:
    return isinstance(answer, Unclear) and not answer.readings


def axis_named(text: str) -> str:
    """The axis that the words behind a number point along: y of `160 N upwards`; "" where they name none."""
    found = ALONG.search(text) if len(text) <= LONGEST else None
    if found is None:
        return ""
    way = (found["way"] or "").lower()
    return AXIS_OF.get(way) or (found["axis"] or found["of"] or "").lower()


def beside_axis(text: str) -> tuple[str, str]:
    """The number and the axis of `1.6 m/s in the y direction`; "" for the axis where none is named."""
    found = BESIDE_AXIS.search(text) if len(text) <= LONGEST else None
    return (text[: found.start()], found["axis"]) if found else (text, "")


def axes_of(text: str, components: tuple[str, ...]) -> AxisRemarks:
    """What a text says of axes. A remark on an axis that the answer does not have stays in the text, as in a text too long."""
    signs: list[int] = [1] * max(1, len(components))
    words: list[str] = []
    while len(text) <= LONGEST and (remark := AXES.search(text)) is not None:
        places = _places(remark["axis"].lower(), remark["way"].lower(), tuple(map(str.lower, components)))
        if not places:
            break
        if remark["way"].lower() not in USUAL:
            for place in places:
                signs[place] = -signs[place]
        words.insert(0, text[remark.start("axis") :].strip(" ,;().\t\n"))
        text = text[: remark.start()]
    return AxisRemarks(text.rstrip(" ,;") if words else text, tuple(signs), ", ".join(words))


def direction_of(text: str, directed: bool, component: str = "", positive: str = "") -> Direction | None:
    """The direction a text of bounded length names, if any; `directed` tells that what is asked for has one, `positive` what the
    problem calls the positive direction."""
    if not directed:
        return None
    if found := TWO_WAYS.search(text):
        signs = {sign_of_way(each, positive) for each in found.group("way", "other")}
        sign = signs.pop() if len(signs) == 1 else None
        return Direction(text[: found.start()], sign, found[0].strip(" ,;().\t\n"))
    if found := ALONG.search(text):
        if component in ("x", "y", "z") and axis_named(text) not in ("", component):
            return None
        sign = sign_of_way(found["way"], positive) if found["way"] else 1 if found["sign"] == "+" else -1
        return Direction(text[: found.start()], sign, found[0].strip(" ,;().\t\n"))
    if (found := IN_FRONT.search(text)) and component not in ("x", "y", "z"):
        return Direction(text[found.end() :], sign_of_way(found["way"], positive), found["way"])
    if found := TOWARDS.search(text):
        words = found["words"].strip()
        return Direction(text[: found.start()], sign_of_words(words, positive), words)
    return None


def turn_of(text: str) -> Direction | None:
    """The sense in which a text of bounded length says that an angle is counted: upwards, or counter-clockwise, is positive."""
    found = DIRECTION_BEHIND.search(text)
    return found and Direction(text[: found.start()], 1 if found["up"] else -1, found[0].strip(" ,;()."))


def _counted_from(answer: Answer, counted: re.Match[str], question: Question) -> Answer:
    """An angle whose words say from which line it is counted: as it stands where the problem counts from there, the horizontal where
    it does not say; asked about where the words name another line."""
    words = counted[0].strip(" ,;().\t\n")
    if line_of(counted) == (question.reference.removeprefix("below ") or "horizontal"):
        return replace(answer, as_read=f"{answer.as_read} {words}") if isinstance(answer, Numbers) else answer
    match answer:
        case Numbers((value,)):
            why = _(
                "it is not clear from where \u201c{words}\u201d counts the angle; write the angle that is asked",
                words=words,
            )
            other = math.copysign(math.pi / 2, value) - value
            return Unclear(why, f"{answer.as_read} {words}", (answer, replace(answer, values=(other,))))
        case _:
            return answer


def _places(axis: str, way: str, components: tuple[str, ...]) -> list[int]:
    """The components a remark is about. Where they are bodies on one line, or there is but one, it is about them all."""
    if not {"x", "y", "z"} & set(components):
        return list(range(max(1, len(components))))
    letter = axis if axis in {"x", "y", "z"} else AXIS_OF.get(way)
    return [place for place, name in enumerate(components) if letter in (None, name)]


def _turned(answer: Answer, axes: AxisRemarks) -> Answer:
    """An answer taken to the usual axes."""
    match answer:
        case Numbers() if len(answer.values) == len(axes.signs):
            values = tuple(sign * value + 0.0 for sign, value in zip(axes.signs, answer.values, strict=True))
            return replace(answer, values=values, as_read=f"{answer.as_read}, {axes.words}")
        case Formulas(trees, as_read) if len(trees) == len(axes.signs):
            there = (
                tree if sign > 0 else Negative(tree) for sign, tree in zip(axes.signs, trees, strict=True)
            )
            return Formulas(tuple(there), f"{as_read}, {axes.words}")
        case Unclear(readings=readings):
            found = (_turned(each, axes) for each in readings)
            return replace(answer, readings=tuple(each for each in found if isinstance(each, Numbers)))
        case _:
            return answer


def _signed(answer: Answer, sign: int, words: str) -> Answer:
    match answer:
        case Numbers((value,)) if value * sign < 0 < sign:
            return _either(answer, words)
        case Numbers((value,)):
            return replace(
                answer, values=(sign * abs(value),), as_read=f"{answer.as_read} {words}", in_words=(0,)
            )
        case Formulas((tree,), as_read) if sign < 0:
            return Formulas((Negative(tree),), f"{as_read} {words}")
        case Unclear(readings=readings):
            found = (_signed(each, sign, words) for each in readings)
            return replace(answer, readings=tuple(each for each in found if isinstance(each, Numbers)))
        case _:
            return answer


def _either(answer: Answer, words: str) -> Answer:
    why = _(
        "it is not clear which sign \u201c{words}\u201d gives; write the number with its sign", words=words
    )
    return _two_ways(answer, words, why)


def _two_ways(answer: Answer, words: str, why: str, *, sign_alone: bool = False) -> Answer:
    """A number that words beside it may turn, with either sign."""
    match answer:
        case Numbers((value,)) if value:
            either = (answer, replace(answer, values=(-value,)))
            return Unclear(why, f"{answer.as_read} {words}", either, sign_alone=sign_alone and value > 0)
        case _:
            return answer
