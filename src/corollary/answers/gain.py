"""Gain and loss in words: `85.3 J lost`, `loss: 85.3 J`, `an increase of 2 J`. The word is the sign."""

from __future__ import annotations

import re
from dataclasses import dataclass

from corollary.answers.question import Question

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
    rf"(?P<word>{WORDS})(?:\s+(?:{WHAT}|(?:to|as|into) (?:heat|friction|sound)))?\)?\.?\s*$",
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
    if ASKED_AS_LOSS.search(question.title):
        sign = -sign
    without = OF_ENERGY.sub("", text[: found.start()] + text[found.end() :])
    return Gain(
        without,
        sign,
        found[0].strip(" ,;().:=≈\t\n"),
        word in COMPARING.split() and not TIMES.search(without),
    )
