"""Words that change the number beside them, take it back, or leave open which one is meant, in English, German and Norwegian."""

from __future__ import annotations

import re

from corollary.answers.number_words import NUMBERS
from corollary.answers.sign_words import SIGNS

WORD = re.compile(r"[^\W\d_]+")
NEGATIONS: str = "not no never neither nor none non hardly barely scarcely nicht kein keine keiner keines nie niemals keineswegs keinesfalls ikke ingen intet inga aldri"
CHANGES = (
    "minus plus times half third quarter twice double doubled triple thrice negative negativ negatives not no wrong false incorrect without except "
    "opposite reverse reversed inverse reciprocal root square squared cube cubed sine cosine tangent logarithm divided multiplied over "
    "halb halbe halbes doppelt doppelte dreifache nicht kein falsch mal ohne quadrat wurzel kehrwert "
    "halv halve halvparten dobbel dobbelt dobbelte tredobbelt ikke feil galt ganger uten kvadratet roten"
)
OF_CHANGE = frozenset(CHANGES.split())
RATIO_WORDS: str = "half third quarter twice double doubled triple thrice halb halbe doppelt doppelte halv halve dobbel dobbelt times much"
# What makes another value of the number behind it, or leaves open which one is meant.
TURNING: str = (
    "nobody nothing anybody instead rather unlike contrary exceed exceeds exceeding beyond within besides short shy cannot doubt lacks lacking missing complement supplement "
    "hardly barely scarcely kaum knapt if unless except but either both per each every and or oder eller und og between than least most more less minimum maximum above below "
    "over under until from error uncertainty before initial initially previous previously earlier first old vorher før wenn hvis pro "
    "second third other another last next each lost lose loses losing gained gain gains increases increased decreases decreased reduced toward towards away against"
)
OF_DIRECTION = frozenset(["toward", "towards", "away", "against", "opposite", "lost", "loses", *SIGNS])
CHANGING = (
    (OF_CHANGE - set(RATIO_WORDS.split())) | set(TURNING.split()) | SIGNS.keys() | (NUMBERS.keys() - {"one"})
)
# What takes the number back, or makes it another one: `one and a half`.
DENIED = re.compile(
    r"\b(?:not|no|never|none|nicht|kein|keine|ikke|or|oder|eller|half|quarter|third|dozen|hundred|thousand|million"
    r"|halb\w*|halv\w*)\b|n['’]t\b",
    re.IGNORECASE,
)
# The other side of what is asked for: `in front of the mirror`, where it is asked how far behind.
ANOTHER_SIDE: str = (
    "front opposite other against wrong below above under less more lost gained before half twice each per left down back too "
    "short missing lacking almost nearly not but anything everything downstream upstream inwards outwards inward outward inside outside behind "
    "off clockwise counterclockwise anticlockwise"
)
CONTRARY = frozenset(ANOTHER_SIDE.split())


def words_of(text: str) -> set[str]:
    """The words of a text, in small letters."""
    return set(WORD.findall(text.lower()))
