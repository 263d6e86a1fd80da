"""Talk around an answer, and its left sides: `≈`, `ca.`, `Δp =`, `p = m v =`, quotation marks."""

from __future__ import annotations

import re
from typing import NamedTuple

from corollary.answers import trace
from corollary.answers.name import OF_CHANGE, SYMBOL
from corollary.answers.number_words import NUMBERS
from corollary.answers.remark import BECAUSE, DENIED, HARMLESS
from corollary.answers.sign_words import SIGNS

QUOTES = "\"'“”„‟«»‹›`*_"  # also those of Markdown
ABOUT = (  # in English, and as German, French and Nordic students say
    "about exactly approx. approx approximately around roughly nearly circa cirka ca. ca c. etwa ungefähr rund env. environ omkring omtrent ungefär rundt"
)
TALK = (
    "the it its this that is was are be becomes equals answer ans. ans result value so thus hence therefore we get of in by to with momentum "
    "velocity speed force impulse energy height angle distance work power change changes average mean total net kinetic final common "
    "he she they still again "
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
LABEL = re.compile(r"[a-z][0-9]?\)\s+|\([a-z][0-9]?\)\s*(?=[-+≈=~]?\s*[0-9.,√])")
NAME = rf"{SYMBOL}|\|{SYMBOL}\||<{SYMBOL}>"
COUNTED = re.compile(
    r"(?:(?:an? |in |on )(?:average|mean|total|maximum|sum)(?: (?:of|is))?"
    r"|im (?:Mittel|Durchschnitt)|i (?:snitt|gjennomsnitt)|insgesamt|totalt)\s+(?=[-+]?[0-9.,])",
    re.IGNORECASE,
)
# `v² = 2gh, so v = 12 m/s`: what is concluded is the answer.
CONCLUSION = re.compile(
    r"[^?=]*=[^?]*[,;.]\s*(?:and\s+)?(?:so|thus|hence|therefore|giving|which gives|damit|daher|also|dermed|altså)\s+(?:that\s+)?(?=[^=]*=)",
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
    r"[,;]\s|[?<>≤≥≠:]|\b(?:with|using|where|for|if|when|and|or|taking|as|at|because|since|but|not|mit|med|avec)\b",
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


class Bare(NamedTuple):
    """An answer without talk: its text, how many signs stood before it, and the sides before its last equals sign."""

    text: str
    skipped: int
    sides: tuple[str, ...]


def answer_in(normalized: str, *, in_letters: bool = False) -> Bare:
    """Return the answer itself in a text translated by TO_ASCII (of bounded length).

    `in_letters`: it is a formula, behind which `!` is a factorial and never talk.
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
        skipped, found_sides = _skipped(text)
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


def _skipped(text: str) -> tuple[int, list[str]]:
    """How much of the text leads up to the answer, 0 when nothing does; and the sides in it."""
    blank = len(text) - len(text.lstrip())
    if 0 < blank < len(text):
        return blank, []
    if MINUS.match(text):
        return 0, []
    for lead in LEADING:
        if (found := lead.match(text)) and found.end() < len(text):
            return found.end(), []
    for name in LEFT_NAMES:
        if (found := name.match(text)) and found.end() < len(text):
            return found.end(), [found["side"]]
    return _last_side(text)


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
