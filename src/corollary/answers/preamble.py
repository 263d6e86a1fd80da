"""Talk around an answer, and its left sides: `≈`, `ca.`, `Δp =`, `p = m v =`, quotation marks."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import NamedTuple

from corollary.answers import trace
from corollary.answers.changing_words import CHANGING, DENIED, OF_CHANGE, OF_DIRECTION, RATIO_WORDS
from corollary.answers.name import SYMBOL
from corollary.answers.number_words import NUMBERS
from corollary.answers.remark import BECAUSE, HARMLESS
from corollary.answers.sign_words import SIGNS
from corollary.formula.abbreviations import calculator_words
from corollary.units.unit import Unit, read_unit

QUOTES = "\"'“”„‟«»‹›`*_"  # also those of Markdown
ABOUT = (  # in English, and as German, French and Nordic students say
    "about exactly approx. approx approximately around roughly nearly circa cirka ca. ca c. etwa ungefähr rund env. environ omkring omtrent ungefär rundt"
)
TALK = (
    "the it its this that is was are be becomes equals answer ans. ans result value so thus hence therefore we get of in by to with momentum "
    "velocity speed force impulse energy height angle distance work power change changes average mean total net kinetic final common "
    "he she they still again then "
    "der die das den dem er sie es ist sind wird beträgt betragen um mit von antwort ergebnis lösung impuls impulsänderung kraftstoß änderung ändert "
    "sich geschwindigkeit kraft mittlere mittleren durchschnittliche energie höhe winkel betrag "
    "det blir ble er svaret svar på med bevegelsesmengden bevegelsesmengde endringen endring endres impulsen farten fart hastigheten kraften "
    "gjennomsnittlig gjennomsnittskraften energien høyden vinkelen "
    "la le les est vaut sont impulsion vitesse énergie hauteur quantité mouvement moyenne"
)
WORDS = "|".join(map(re.escape, sorted(f"{ABOUT} {TALK}".split(), key=len, reverse=True)))
# Harmless words, none of which changes what follows: those of `The average force on the ball is 86 N` up to the verb.
UNCHANGING = frozenset(
    word
    for word in {*HARMLESS, *TALK.split(), "it's"} - OF_CHANGE - SIGNS.keys()
    if word.isalpha() or word == "it's"
)
WITHOUT_CHANGE = "|".join(sorted(UNCHANGING, key=lambda word: (-len(word), word)))
SENTENCE = re.compile(
    rf"(?:(?:{WITHOUT_CHANGE})\s+){{1,12}}(?:(?:is|was|equals|ist|war|beträgt|er|var)\s+|(?:{WITHOUT_CHANGE}):\s*)(?=[-+]?[0-9.,√(])"
    r"|it['’]s\s+(?=[-+]?[0-9.,√(])",
    re.IGNORECASE,
)
SO = "so|thus|hence|therefore"
THEREFORE = rf"{SO}|damit|also|altså"
# A clause of words that ends with a mark or a verb: `twice as much: 172 N`, `perpendicular to the wall, 90°`, `I calculated 172 N`.
CLAUSE = re.compile(
    r"(?P<words>(?:[0-9]+ times|[^\W\d_]+(?:['’][^\W\d_]*)?)(?:,?[ -][^\W\d_]+(?:['’][^\W\d_]*)?){0,16})"
    rf"(?:\s*(?P<mark>[:;,.])\s+(?:(?:and\s+)?(?:{THEREFORE}|that is|i\.e\.|namely|at|by|about)\s+)?|(?P<colon>:)|\s+)"
    r"(?:(?<=\s)[^\W\d_]\w{0,3}\s*=\s*|[ΔδdD∆][^\W\d_]\w?\s*=\s*)?(?=(?P<signed>[-−])?[+≈~]?\s*(?:[0-9]|[.,][0-9]|√))"
)
TIMES_AS = re.compile(r"\b\w+ times\b")
HALF_OF_A_NAME = re.compile(
    r"\bhalf[- ](?=(?:sine|period|wave|life|swing|turn)\b)|\beach other\b", re.IGNORECASE
)
NO_WAY = re.compile(
    r"(?<=catches )up\b|(?<=catch )up\b|(?<=ends )up\b|(?<=adds )up\b"
)  # verbs that name no direction
AS_BEFORE = re.compile(r"\bas \w+ (?:as before|again)\b")
CONCLUDING = re.compile(rf", (?:and )?(?:{THEREFORE}) ", re.IGNORECASE)
CONCLUDES = re.compile(rf", (?:and )?(?:{THEREFORE}|namely)$", re.IGNORECASE)
RIGHT_ANGLE = re.compile(r"\bright angles?\b", re.IGNORECASE)
LABEL = re.compile(r"[a-z][0-9]?\)\s+|\([a-z][0-9]?\)\s*(?=[-+≈=~]?\s*[0-9.,√])")
NAME = rf"{SYMBOL}|\|{SYMBOL}\||<{SYMBOL}>"
COUNTED = re.compile(
    r"(?:(?:an? |in |on )(?:average|mean|total|maximum|sum)(?: (?:of|is))?"
    r"|im (?:Mittel|Durchschnitt)|i (?:snitt|gjennomsnitt)|insgesamt|totalt)\s+(?=[-+]?[0-9.,])",
    re.IGNORECASE,
)
# `v² = 2gh, so v = 12 m/s`: what is concluded is the answer.
CONCLUSION = re.compile(
    rf"[^?=]*=[^?]*[,;.]\s*(?:and\s+)?(?:{THEREFORE}|giving|which gives|daher|dermed)\s+(?:that\s+)?(?=[^=]*=)",
    re.IGNORECASE,
)
WORK = re.compile(
    rf"(?P<work>[^?]*[=≈][^?]*?)\s*(?:[,;.]\s|→|⇒|⟹|=>|-{{1,2}}>)\s*(?:(?:and|{SO})\s+)*(?P<name>{NAME})\s*[=≈]\s*(?:[^=≈,;?]{{1,40}}[=≈]\s*){{0,3}}[-+]?[0-9.,√(][^=,;]*"
)
CONCLUDED = re.compile(
    rf"[^=?]*[^\W\d_]{{2}}[^=?]*[,;.]\s*(?:and\s+)?(?:{SO})\s+(?=(?:{NAME})\s*[=≈])",
    re.IGNORECASE,
)
LEADING = (
    LABEL,
    SENTENCE,
    CONCLUSION,
    re.compile(r"[ld]['’](?=[^\W\d_]{3})", re.IGNORECASE),
    COUNTED,
    re.compile(
        r"I (?:get|got|find|found|have) |(?:the )?same as (?:before|in \(?[a-z]\)?)[,:]\s*", re.IGNORECASE
    ),
    re.compile(r"(?:=>|-{1,2}>|[→⇒⟹⟶➜∴])\s*"),
    re.compile(
        rf"[=≈~:]\s*|(?-i:(?![a-z]+[A-Z]))(?:{WORDS})(?![A-Za-z0-9_^*/(]|\s+ganger)\s*", re.IGNORECASE
    ),
)
LEFT_NAMES = (
    re.compile(rf"(?P<side>{NAME})\s+(?:is|was|equals|ist|beträgt|er|est)\s+(?=[-+]?[0-9.,√(])"),
    re.compile(rf"(?P<side>{NAME})\s*[:~](?=\s*[-+0-9.,√(])\s*"),
)
MINUS = re.compile(
    rf"(?:minus|negative)\s+(?=[0-9.,]|(?:{'|'.join(NUMBERS)})\b)|\(-\)\s*(?=[0-9.,])", re.IGNORECASE
)
REMARK = (
    r"approx(?:\.|imately)?|about|roughly|circa|ca\.?|rounded|exactly|or so|(?:final )?answer|mean|average|impulse[^()0-9]*"
    r"|(?:to )?[0-9] ?(?:s\.? ?f\.?|sig\.? ?figs?\.?|significant figures|significant digits|figures)"
)
ENDING = re.compile(
    rf"(?:[\s?;,✅✓✔☑\U0001f300-\U0001faff]|(?<=[^0-9)])!|(?<=[.,][0-9])!|(?<=[.,][0-9]{{2}})!)+$|(?<=[0-9])…$|\s#[^0-9]*[A-Za-z]{{4}}[^0-9]*$|(?<=[^0-9\s])\.$|(?<=[A-Za-z0-9²³)°%])[\s,;]+[\[(]?(?:{REMARK})[\])]?$",
    re.IGNORECASE,
)
CALL = re.compile(r"<[^<>=]{1,12}>|\([^()]*\)")  # `<F>`, `F(y = 0.6 m)`
SIDES = re.compile(r"[=≈]+\s*|\s~\s+")
NO_SIDE = re.compile(  # in `3 m/s with g = 9.8` what stands behind the last sign is not the answer
    r"[,;]\s|[?<>≤≥≠:]|[0-9][^=.]{0,8}\.\s+(?=[^\W\d_])|\b(?:with|using|where|for|if|when|and|or|taking|as|at|because|since|but|not|mit|med|avec)\b",
    re.IGNORECASE,
)
GRAVITY = re.compile(
    r"[\s,;]\s*\(?(?:(?:with|using|taking|for|if|when|where) )?g\s*[=≈]\s*(?:9[.,]8[0-9]?|10)\s*(?:m ?/ ?s ?(?:\^|\*\*)?[2²])?\s*\)?\s*$",
    re.IGNORECASE,
)


# `86 N because F = ma`: a clause that gives the reason, unless it takes the number back or speaks of a sign.
REASON = re.compile(
    rf"(?<=[^\W_]|[²³)°%½])[\s,;]+(?:{BECAUSE})\b(?P<why>.*)$",
    re.IGNORECASE | re.DOTALL,
)
OF_A_SIGN = re.compile(
    rf"\b(?:{'|'.join(SIGNS)}|minus|toward\w*|away|against|reverse\w*|los[est]\w*|gain\w*|(?:in|de)creas\w*)\b",
    re.IGNORECASE,
)


class WaysBefore(NamedTuple):
    """A text without the words before its number, and those of them that name a direction."""

    text: str
    ways: tuple[str, ...]


class Bare(NamedTuple):
    """An answer without talk: its text, how many signs stood before it, and the sides before its last equals sign."""

    text: str
    skipped: int
    sides: tuple[str, ...]


def answer_in(normalized: str, *, in_letters: bool = False, in_a_sentence: bool = False) -> Bare:
    """Return the answer itself in a text translated by TO_ASCII (of bounded length).

    `in_letters`: it is a formula, behind which `!` is a factorial and never talk. `in_a_sentence`: any words may stand before it
    that do not change it.
    """
    unreasoned = without_reason(normalized)
    found = GRAVITY.search(unreasoned)
    text, before = (unreasoned[: found.start()] if found and found.start() else unreasoned), 0
    if text != normalized:
        trace.took("split_remark", normalized[len(text) :], text)
    sides: list[str] = []
    while True:
        shorter = ENDING.sub("", text)
        if in_letters and "!" in text[len(shorter) :]:
            shorter = text
        if shorter != text and shorter:
            trace.took("split_remark", text[len(shorter) :], shorter)
            text = shorter
            continue
        if len(text) > 2 and text[0] in QUOTES and text[-1] in QUOTES:
            trace.took("strip_preamble", text[0] + text[-1], text[1:-1])
            text, before = text[1:-1], before + 1
            continue
        skipped, found_sides = _skipped(text, in_a_sentence)
        if skipped == 0:
            return Bare(_with_minus(text), before, tuple(sides))
        sides += found_sides
        if text[:skipped].strip():
            trace.took("solve_left_side" if found_sides else "strip_preamble", text[:skipped], text[skipped:])
        text, before = text[skipped:], before + skipped


def reason_in(text: str) -> re.Match[str] | None:
    """The clause behind an answer that gives its reason."""
    return REASON.search(text)


def without_reason(text: str) -> str:
    """A text of bounded length without the reason behind its answer, unless that may change the answer."""
    found = reason_in(text)
    if found is None or DENIED.search(found["why"]) or OF_A_SIGN.search(found["why"]):
        return text
    return text[: found.start()]


def _skipped(text: str, in_a_sentence: bool) -> tuple[int, list[str]]:
    """How much of the text leads up to the answer, 0 when nothing does; and the sides in it."""
    blank = len(text) - len(text.lstrip())
    if 0 < blank < len(text):
        return blank, []
    if MINUS.match(text):
        return 0, []
    if in_a_sentence and (end := _sentence_before(text)):
        return end, []
    for lead in LEADING:
        if (found := lead.match(text)) and found.end() < len(text):
            if lead is CONCLUSION and _gives_it_twice(found[0], text[found.end() :]):
                continue
            return found.end(), []
    for name in LEFT_NAMES:
        if (
            (found := name.match(text))
            and found.end() < len(text)
            and not (_is_unit(found["side"]) or found["side"].lower() in CHANGING)
        ):
            return found.end(), [found["side"]]
    return _last_side(text)


def _sentence_before(text: str) -> int:
    """Where the words, or the work, before a result end; 0 where there are none."""
    if end := _clause(text):
        return end
    if (concluded := CONCLUDED.match(text)) and not DENIED.search(concluded[0]):
        return concluded.end()  # `p goes from -8.6 to 8.6, so F = 17.2/0.1 = 172 N`
    if (work := WORK.fullmatch(text)) and not _names_a_value(work["work"], work["name"]):
        return work.start("name")  # `v² = 2gh = 98, v = 9.90 m/s`
    return 0


def _clause(text: str) -> int:
    """The end of a clause of words before a number that none of them changes; 0 where there is no such clause."""
    found = CLAUSE.match(text)
    if found is None:
        return 0
    concluded = None
    marked = bool(found["mark"] or found["colon"] or CONCLUDES.search(found["words"]))
    words = (
        NO_WAY.sub("", HALF_OF_A_NAME.sub("", RIGHT_ANGLE.sub("angle", found["words"])))
        .replace(",", " ")
        .split()
    )
    small = [part for word in words for part in word.lower().split("-")]
    if not marked and (concluded := CONCLUDING.search(found["words"])):
        small = found["words"][concluded.end() :].lower().split()  # `it is twice that, so the force is 3 N`
    changed = CHANGING if marked and len(words) > 2 else CHANGING | OF_CHANGE
    if found["signed"] and (marked or concluded):
        changed = changed - OF_DIRECTION  # `it is pushed backwards, so -3 N`
    lowered = AS_BEFORE.sub("", " ".join(small))
    small = (TIMES_AS.sub("", lowered) if marked else lowered).split()
    ratios = RATIO_WORDS.split() if marked and len(words) > 2 else ()
    if (
        changed.intersection(small)
        or DENIED.search(" ".join(word for word in small if word not in ratios))
        or any(len(word) == 1 and word.isupper() and word not in "AI" for word in words)
        or not any(len(word) > 3 for word in words)
        or (len(words) < 3 and any(_is_unit(word) for word in words) and small[0] not in ("it", "he", "she"))
        or any(_is_unit(word) for before, word in pairwise(small) if before in ("in", "unit", "units"))
        or words[-1] in calculator_words()
    ):
        return 0
    return found.end()


def _names_a_value(work: str, name: str) -> bool:
    """True if the lines before a result are a value of their own, or give this letter another one: `F = 86 N, F = 172 N`."""
    sides = [side.strip() for side in re.split(r"[=≈]|[,;]\s|→|->|=>", work)]
    return (
        name in sides
        or re.fullmatch(rf"(?:{NAME})\s*[=≈]\s*[-+]?[0-9.,]+\s*[^=≈,;]*", work.strip()) is not None
    )


def _gives_it_twice(work: str, conclusion: str) -> bool:
    """True of `F = 100 N; so F = 86 N`, where what is concluded is a letter that has a number before."""
    name = conclusion.partition("=")[0].strip()
    return re.match(rf"\s*{re.escape(name)}\s*[=≈]\s*[-+]?[0-9.,]+\s*[^=≈,;*/+]*[,;.]\s", work) is not None


def ways_before(text: str) -> WaysBefore | None:
    """A number without the clause before it that names its direction: `it flies back to the left at 9 m/s`."""
    text = text.lstrip()
    found = CLAUSE.match(text)
    ways = tuple(word for word in found["words"].lower().split() if word in SIGNS) if found else ()
    if (
        found is None
        or not ways
        or not (found["mark"] or found["words"].lower().endswith((" at", " with", " by")))
    ):
        return None
    rest, behind = (
        " ".join(word for word in found["words"].split() if word.lower() not in SIGNS),
        text[found.end() :],
    )
    return WaysBefore(behind, ways) if not rest or _clause(f"{rest} is {behind}") else None


def _is_unit(word: str) -> bool:
    """True for a unit spelt out, or a symbol of three letters or more: `in kilonewtons: 172`."""
    found = read_unit(word) if len(word) > 2 else None
    return isinstance(found, Unit) and "*" not in found.text  # `must` is no m us t


def _last_side(text: str) -> tuple[int, list[str]]:
    """Where the last side of `p = m v = 8.6` begins, and the sides before it; 0 when there is but one, or a sentence."""
    found = [each for each in SIDES.finditer(text) if _depth(text[: each.start()]) == 0]
    if not found or found[-1].end() == len(text):
        return 0, []
    starts, ends = [0, *(each.end() for each in found)], [each.start() for each in found]
    sides = [text[start:end].strip() for start, end in zip(starts, ends, strict=False)]
    return (
        (0, [])
        if NO_SIDE.search(CALL.sub("", text[: ends[-1]]))
        else (found[-1].end(), [side for side in sides if side])
    )


def _depth(text: str) -> int:
    return sum(text.count(sign) for sign in "([{") - sum(text.count(sign) for sign in ")]}")


def _with_minus(text: str) -> str:
    """A minus in words, or as a calculator writes it, as a sign."""
    found = MINUS.match(text)
    return "-".rjust(found.end()) + text[found.end() :] if found else text
