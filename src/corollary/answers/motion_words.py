"""Rest and motion in words, for one body or several: `A stops, B moves at 4 m/s`, `he is at rest`."""

from __future__ import annotations

import re

from corollary.answers.sign_words import SIGNS

NO: str = "not never neither nobody longer nicht kein nie ikke aldri ingen"
DENIED = "".join(rf"(?<!\b{word} )" for word in NO.split()) + r"(?<!n['’]t )"
DENIAL = re.compile(rf"\b(?:{'|'.join(NO.split())})\b|n['’]t\b", re.IGNORECASE)
VERB = r"\b(?:is|are|was|be|stays?|remains?|keeps|comes? to|came to|comes|lies|has|gets|ist|sind|bleibt|bleiben|kommt|liegt|hat|er|blir|kommer|ligger|har)\s+"
ZERO_AGAIN = re.compile(
    r"= 0\s*[,(]\s*0\s*[^\s,;()0-9]*\)?(?=\s*[,;]|\s+and\b)"
)  # `A is at rest, 0 m/s, and …`
NOTHING = re.compile(  # `nothing along x`, `no force in y`
    r"(?<![^\W_])(?:nothing|none|zero|no (?:force|momentum|velocity|impulse|component|motion|change)) (?P<where>(?:along|in) (?:the )?[xyz]\b)",
    re.IGNORECASE,
)
STILL = (  # in English, German and Norwegian
    "at rest|to rest|stationary|motionless|zero velocity|no velocity|zero speed|stopped|in Ruhe|zur Ruhe|stehen|liegen|i ro|til ro|stille"
)
HALTS = "stops|stops dead|stands? still|does(?: not|n['’]t) move|(?:is )?not moving|isn['’]t moving|no motion|steht still|steht|ruht|ruhen|bewegt sich nicht"
HALTS_NB = "stopper|står stille|står i ro|ligger stille|beveger seg ikke|er ikke i bevegelse"
REST = re.compile(
    rf"{DENIED}(?:(?:{VERB})(?:(?:still|immer noch|fortsatt)\s+)?)?\b(?:{HALTS}|{HALTS_NB}|{STILL})(?![^\W\d_])(?:\s+(?:yet|still))?",
    re.IGNORECASE,
)
SUBJECT = re.compile(
    r"\s*(?!not\b|no\b|never\b|both\b|all\b|neither\b)[^\W\d_]{1,12}(?: (?!not\b|never\b)[^\W\d_]{1,12})?\s+0\s*[.!]?\s*",
    re.IGNORECASE,
)
GOES = (
    "moves?|starts|goes|go|travels?|flies|runs?|rolls?|slides?|swings?|leaves|continues|bewegt sich|fliegt|rollt|läuft|fährt|gleitet|geht"
    "|beveger seg|går|fortsetter|ruller|glir|flyr"
)
ON = r"(?:\s+(?:on|off|away|weiter|videre))?"
SPEED = r"(?:\s+(?:a |the )?(?:velocity|speed) of)?"
BOUNCES = "bounces?|rebounds?|recoils?|prallt|prellt|springt|spretter"
WAY = (
    rf"(?:(?:to|towards|in|nach|til|mot|i) )?(?:the |der |den )?(?:{'|'.join(sorted(SIGNS, key=len, reverse=True))})"
    r"(?:[ -][xyz])?(?:[ -](?:direction|richtung|retning))?"
)
NUMBER = (
    r"(?>[-+−–]?\s*(?:[0-9]+(?:[.,][0-9]+)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?)(?!\s*(?:°|º|deg|rad|%|[0-9]))"
)
UNIT = r"(?:\s*(?!and\b|und\b|og\b|but\b|while\b)[^\W\d_][^\s,;().]*(?:\s*/\s*[^\W\d_][^\s,;().]*)?)?"
WENT = re.compile(
    rf"(?:^|\s+){DENIED}(?:(?:(?:{GOES}|(?P<bounces>{BOUNCES})){ON}(?:\s+(?P<way>{WAY}))?(?:\s+(?:at|with|by|mit|med))?)"
    rf"|(?P<bare>{WAY})\s+(?:at|with|mit|med)){SPEED}\s+(?P<much>{NUMBER}{UNIT})(?![^\W_])(?(bounces)(?:\s+(?:back|zurück|tilbake)\b)?)",
    re.IGNORECASE,
)
MOVES = re.compile(
    rf"(?:^|\s+){DENIED}(?:(?:{GOES}){ON}(?:\s+(?:at|with|by|mit|med))?{SPEED}|(?:rises|reaches|climbs|steigt)(?: up)?(?:\s+(?:to|auf))?(?:\s+(?:a |the )?height of)?"
    r"|(?:has|gets|keeps|hat|bekommt|behält|har|får)(?:\s+(?:a |the )?(?:velocity|speed)(?: of)?)?)\s+(?=[-+]?\s*[0-9.,])",
    re.IGNORECASE,
)


def motion_in_numbers(text: str) -> str:
    """The components of several bodies: `A stops, B moves at 4 m/s` as `A 0, B = 4 m/s`."""
    return MOVES.sub(
        " = ", way_behind(ZERO_AGAIN.sub("= 0", REST.sub(_zero, NOTHING.sub("0 \\g<where>", text))))
    )


def way_behind(text: str) -> str:
    """The way of a motion put behind its speed: `A goes back at 4 m/s` as `A = 4 m/s back`. What bounces goes back."""
    return text if DENIAL.search(text) else WENT.sub(_turned_round, text)


def _turned_round(found: re.Match[str]) -> str:
    way = found["way"] or found["bare"] or ("back" if found["bounces"] else "")
    return f" = {found['much']} {way}" if way else found[0]


def _zero(found: re.Match[str]) -> str:
    """`A stops` as `A = 0`, so that the name is seen to be one wherever it stands."""
    return "= 0" if found.string[: found.start()].rstrip()[-1:].isalpha() else "0"


def motion_in_number(text: str) -> str:
    """One number: `at rest`, `he does not move` as `0`, `the ball moves at 4 m/s` as `the ball = 4 m/s`."""
    zero = REST.sub("0", text)
    return "0" if zero != text and SUBJECT.fullmatch(zero) else MOVES.sub(" = ", zero)
