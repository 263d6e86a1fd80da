"""What students write around an answer, and the answer between: `≈`, `ca.`, `Δp =`, `p = m v =`, quotation marks."""

from __future__ import annotations

import re

from corollary.answers.number_words import NUMBERS

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
    "gjennomsnittlig gjennomsnittskraften energien høyden vinkelen"
)
WORDS = "|".join(map(re.escape, sorted(f"{ABOUT} {TALK}".split(), key=len, reverse=True)))
LABEL = re.compile(r"[a-z][0-9]?\)\s+|\([a-z][0-9]?\)\s*(?=[-+≈=~]?\s*[0-9.,√])")
NAME = r"(?:(?:delta|Delta|[Δ∆])\s*)?[^\W\d][^\s=≈~+*/^();,:]{0,15}|[|<][^\W\d][^\s|=<>]{0,8}[|>]"
COUNTED = re.compile(
    r"(?:(?:an? |in |on )(?:average|mean|total|maximum|sum)(?: (?:of|is))?"
    r"|im (?:Mittel|Durchschnitt)|i (?:snitt|gjennomsnitt)|insgesamt|totalt)\s+(?=[-+]?[0-9.,])",
    re.IGNORECASE,
)
LEADING = (
    LABEL,
    COUNTED,
    re.compile(
        r"I (?:get|got|find|found|have) |(?:the )?same as (?:before|in \(?[a-z]\)?)[,:]\s*", re.IGNORECASE
    ),
    re.compile(rf"[=≈~:]\s*|(?:{WORDS})(?![A-Za-z0-9_^*/(]|\s+ganger)\s*", re.IGNORECASE),
    re.compile(rf"(?:{NAME})\s*(?:[=≈](?!=)|[:~](?=\s*[-+0-9.,√(]))\s*"),
)
MINUS = re.compile(
    rf"(?:minus|negative)\s+(?=[0-9.,]|(?:{'|'.join(NUMBERS)})\b)|\(-\)\s*(?=[0-9.,])", re.IGNORECASE
)
REMARK = (
    r"approx(?:\.|imately)?|about|roughly|circa|ca\.?|rounded|exactly|or so|(?:final )?answer|mean|average|impulse[^()0-9]*"
    r"|(?:to )?[0-9] ?(?:s\.? ?f\.?|sig\.? ?figs?\.?|significant figures|significant digits|figures)"
)
ENDING = re.compile(
    rf"[\s!?;,✅✓✔☑\U0001f300-\U0001faff]+$|(?<=[0-9])…$|\s#[^0-9]*[A-Za-z]{{4}}[^0-9]*$|(?<=[^0-9\s])\.$|(?<=[A-Za-z0-9²³)°%])[\s,;]+\(?(?:{REMARK})\)?$",
    re.IGNORECASE,
)
SIDES = re.compile(r"[=≈]+\s*|\s~\s+")
NO_SIDE = re.compile(  # in `3 m/s with g = 9.8` what stands behind the last sign is not the answer
    r"[,;]\s|[?<>≤≥≠:]|\b(?:with|using|where|for|if|when|and|or|taking|as|at|because|since|but|not|mit|med|avec)\b",
    re.IGNORECASE,
)
GRAVITY = re.compile(
    r"[\s,;]\s*\(?(?:(?:with|using|taking|for|if|when|where) )?g\s*[=≈]\s*(?:9[.,]8[0-9]?|10)\s*(?:m ?/ ?s ?(?:\^|\*\*)?[2²])?\s*\)?\s*$",
    re.IGNORECASE,
)


def answer_in(normalized: str) -> tuple[str, int]:
    """The answer itself, and how many signs stood before it, in a text translated by TO_ASCII (of bounded length)."""
    found = GRAVITY.search(normalized)
    text, before = (normalized[: found.start()] if found and found.start() else normalized), 0
    while True:
        shorter = ENDING.sub("", text)
        if shorter != text and shorter:
            text = shorter
            continue
        if len(text) > 2 and text[0] in QUOTES and text[-1] in QUOTES:
            text, before = text[1:-1], before + 1
            continue
        skipped = _skipped(text)
        if skipped == 0:
            return _with_minus(text), before
        text, before = text[skipped:], before + skipped


def _skipped(text: str) -> int:
    """How much of the text leads up to the answer; 0 when nothing does."""
    blank = len(text) - len(text.lstrip())
    if 0 < blank < len(text):
        return blank
    if found := MINUS.match(text):
        return 0
    for lead in LEADING:
        if (found := lead.match(text)) and found.end() < len(text):
            return found.end()
    return _last_side(text)


def _last_side(text: str) -> int:
    """Where the last side of `p = m v = 8.6` begins; 0 when there is but one, or what stands before is more than a side."""
    *_, last = [None, *SIDES.finditer(text)]
    if last is None or last.end() == len(text):
        return 0
    sides = text[: last.start()]
    return 0 if NO_SIDE.search(sides) or sides.count("(") != sides.count(")") else last.end()


def _with_minus(text: str) -> str:
    """A minus in words, or as a calculator writes it, as a sign."""
    found = MINUS.match(text)
    return "-".rjust(found.end()) + text[found.end() :] if found else text
