"""Words behind a quantity that are none of it: `86 N on average`, `20.8 m/s (speed of the bullet)`."""

from __future__ import annotations

import re
from dataclasses import dataclass

from corollary.answers.changing_words import DENIED

WORDS = r"[^0-9=<>≤≥]"
BECAUSE = "because|since|due to|weil|fordi"  # lead the reason of any answer
LEADS = (
    "is was ist er on in at when while just right before after including incl excluding without with because since due for from by which that and so as "
    "above over below "
    "behind away upstream downstream under beneath inside outside later deep wide apart towards to along across between "
    "higher im bei beim mit ohne nach vor als wenn gegen i med uten etter før mot når"
)
REMARK = re.compile(
    rf"(?<=[^\W_]|[²³)°%½])(?:\s*\((?P<bracketed>(?!or\b){WORDS}{{3,80}})\)|\s*(?:[,;]|\.(?=\s))\s*(?P<apart>(?!or\b)[A-Za-z]{WORDS}{{2,80}})"
    rf"|\s+(?P<led>(?:{'|'.join(LEADS.split())})\b[^0-9=<>≤≥,;]{{2,80}}|total|altogether|insgesamt|totalt|high|hoch|høyt|away|later|upstream|downstream|deep|wide|apart|inwards|outwards|inward|outward))\.?\s*$",
    re.IGNORECASE,
)
# Words that change neither the number nor its sign. Whatever else is said, a person reads.
NEUTRAL: str = (
    "a an the this that it its he she his her my of on in at by with from for to as is was are and we i.e so e.g "
    "average avg mean magnitude total altogether size value force speed velocity momentum impulse energy kinetic weight gravity mass "
    "height time including incl included without excluding just right shortly immediately before after during while when where "
    "collision impact hit hits hitting reaching reaches ground floor landing lands contact kick jump "
    "bullet ball block car book wall body object person sphere rocket chain atom club racket track "
    "twice double much large same answer part result approximately approximation decimal rounded si unit units "
    "above over high hoch høyt higher than lowest point starting position table first second third bounce "
    "perpendicular orthogonal later molecules particles deep wide apart ray makes angle angles "
    "straight change axis direction x x-axis x-direction horizontal counterclockwise counter-clockwise anticlockwise measured relative "
    "im mittel mittelwert durchschnitt betrag insgesamt mit ohne gewicht vor nach dem der die das beim stoß aufprall kurz gerundet "
    "kugel klotz "
    "i snitt gjennomsnitt totalt med uten vekt før etter støtet rett ballen kula kloss"
)
HARMLESS = frozenset(NEUTRAL.split())


# What denies a motion and not the number, of which nothing but a zero is passed over.
NOT_MOVING = re.compile(
    r"(?:\w+ ){0,3}(?:has|have|had|is|was|are|were|does|do|did)(?: not|n['’]t)(?: yet)? (?:mov|start|begun?|left)\w*(?: moving| yet)*",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class WordsBehind:
    """A text without the words behind it, the words, and whether they can change nothing."""

    text: str
    words: str
    harmless: bool


def remark_in(text: str) -> WordsBehind | None:
    """The remark behind a quantity in a text of bounded length, if there is one."""
    found = REMARK.search(text)
    if found is None:
        return None
    words = (found["bracketed"] or found["apart"] or found["led"]).strip(" .")
    denied = DENIED.search(words) and not NOT_MOVING.fullmatch(words)
    return None if denied else WordsBehind(text[: found.start()], words, _are_harmless(words))


def _are_harmless(words: str) -> bool:
    """A capital alone is a body's name, and may be another one's."""
    each = [re.sub(r"['’]s$", "", word.strip(".()'’")) for word in re.split(r"[\s,;:/]+", words)]
    return any(len(word) > 2 for word in each) and all(
        not word or (word.lower() in HARMLESS and word != "A") or re.fullmatch("[a-h]", word) for word in each
    )
