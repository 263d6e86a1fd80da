"""Bounds typed for a value: `v ≥ 7.18 m/s`, `at least 7.18 m/s`, `7.18 m/s or more`."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import lru_cache

from corollary.answers.answer import Answer, Formulas, Numbers, Unclear
from corollary.answers.name import NAME
from corollary.answers.question import Extreme, Question
from corollary.formula.by_hand import by_hand
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST = 200
LEAST_ASKED = re.compile(
    r"\b(?:least|smallest|slowest|shortest|lowest|minim\w*|mindestens|kleinst\w*|geringst\w*|minst\w*|lavest\w*)\b(?! (?:order|point))",
    re.IGNORECASE,
)
GREATEST_ASKED = re.compile(
    r"\b(?:at most|the most|largest|greatest|biggest|fastest|highest|longest|maxim\w*|höchstens|größt\w*|höchst\w*|størst\w*|høyest\w*|høyst\w*)\b(?! point)",
    re.IGNORECASE,
)
QUESTIONS = re.compile(r"[^.!?]*\?")
# `For which angle is the force largest?` asks for no extreme; `At what smallest speed …?` does.
PLACE_ASKED = re.compile(
    r"\s*(?:for|at|bei|für|ved) (?:which|what|welche\w*|hvilke\w*) (?!\w*(?:least|small|slow|short|low|larg|great|fast|high|max|min|klein|gr[öo]ß|minst|størst))",
    re.IGNORECASE,
)
# In `from one moment when the distance is smallest` the extreme tells when, and is not what is asked for.
ASIDE = re.compile(
    r"\b(?:when|where|while|whose|(?:at|for|in|from|to|during|after|before|with|between) which|wenn|wo|während|sobald|bei de[mr]|für de[nr]|når|mens|der hvor)\b[^,;.?!]*",
    re.IGNORECASE,
)
MORE = (
    "at least|no less than|not less than|no fewer than|more than|greater than|larger than|bigger than|faster than|higher than|above|over|"
    "minimum(?: of)?|minimal|min\\.|mindestens|mehr als|größer als|minst|mer enn|større enn"
)
LESS = (
    "at most|no more than|not more than|less than|fewer than|smaller than|slower than|lower than|below|under|up to|"
    "maximum(?: of)?|maximal|max\\.|höchstens|weniger als|kleiner als|høyst|mindre enn"
)
LEADS = r"\s*(?:(?:it|he|she|we|A|B|v) |(?:the )?[a-z]{3,12} (?:is|are|goes|has|must be|can be) )?(?:(?:must|has to|have to|needs to|should) be )?"
NUMBER = r"(?=[-+−]?\s*[0-9.,√(]|sqrt)"
IN_WORDS = re.compile(rf"{LEADS}(?:(?P<least>{MORE})|(?P<greatest>{LESS}))\s+{NUMBER}", re.IGNORECASE)
IN_SIGNS = re.compile(  # `=> 3 N` begins with an arrow
    rf"(?:{NAME.pattern}(?P<turned>=>|=<)|(?:{NAME.pattern})?\s*(?P<sign>>=|<=|[<>≤≥⩾⩽≧≦]))\s*(?=[^\s<>≤≥=])"
)
BEHIND = re.compile(
    r"[\s,(]+(?:(?P<least>(?:or|and) (?:more|greater|larger|faster|higher|above|over|up)|at least|minimum|oder mehr|mindestens|eller mer)"
    r"|(?P<greatest>(?:or|and) (?:less|smaller|slower|lower|below|under)|at most|maximum|oder weniger|höchstens|eller mindre))\)?\s*",
    re.IGNORECASE,
)
SIGN_BEHIND = re.compile(rf"\s*(?P<sign><=|=<|>=|=>|[<>≤≥⩾⩽≧≦])\s*(?:{NAME.pattern})")
ANOTHER = re.compile(r"[<>≤≥⩾⩽≧≦]|\b(?:and|or|but|und|oder|aber|og|eller|men)\b|[;]", re.IGNORECASE)
HINT = re.compile(
    r"[<>≤≥⩾⩽≧≦\\]|least|most|min|max|more|less|than|als|enn|above|below|over|under|up|øyst|öchst|mehr|mer|great",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class TypedBound:
    """The value of a bound, from which side it bounds, and the words or signs that say so."""

    text: str
    extreme: Extreme
    words: str


@lru_cache(maxsize=512)  # of a part, each time that an answer to it is read
def extreme_asked(title: str, text: str) -> Extreme:
    """`least` or `greatest`, where the title of a part or the questions in its text speak of one of the two alone."""
    asked = (each for each in QUESTIONS.findall(text) if PLACE_ASKED.match(each) is None)
    asking = f"{title}. {' '.join(ASIDE.sub('', each) for each in asked)}"
    least, greatest = (pattern.search(asking) is not None for pattern in (LEAST_ASKED, GREATEST_ASKED))
    return "" if least == greatest else "least" if least else "greatest"


def bound_in(text: str) -> TypedBound | None:
    """The bound that a text is; None for a value, and for an interval with two of them."""
    if len(text) > LONGEST or HINT.search(text) is None:
        return None
    typed = by_hand(text)
    leads = IN_WORDS.match(typed) or IN_SIGNS.match(typed)
    found = leads or _last(SIGN_BEHIND, typed) or _last(BEHIND, typed)
    if found is None:
        return None
    rest = typed[found.end() :] if leads else typed[: found.start()]
    if not rest.strip() or ANOTHER.search(rest):
        return None
    return TypedBound(rest.strip(), _side(found, behind=not leads), found[0].strip(" ,()"))


def bounded(bound: TypedBound, found: Answer, question: Question) -> Answer:
    """The answer of a bound's value, where the question asks for that extreme; elsewhere the bound is asked about."""
    match found:
        case Numbers() | Formulas() if bound.extreme == question.extreme:
            return replace(found, as_read=f"{found.as_read} ({bound.words})")
        case Numbers() | Formulas():
            return Unclear(of_a_bound(bound), found.as_read, (found,))
        case _:
            return found


def of_a_bound(bound: TypedBound) -> str:
    """What is said of a bound where a value is asked for."""
    return _("\u201c{words}\u201d gives a bound, not a value; write the value alone", words=bound.words)


def _last(pattern: re.Pattern[str], text: str) -> re.Match[str] | None:
    """A match that ends the text and does not begin it."""
    return next(
        (found for found in pattern.finditer(text) if found.start() and found.end() == len(text)), None
    )


def _side(found: re.Match[str], *, behind: bool) -> Extreme:
    groups = found.groupdict()
    if sign := groups.get("sign") or groups.get("turned"):
        return "least" if (sign[0] in ">≥⩾≧" or sign == "=>") != behind else "greatest"
    return "least" if groups["least"] else "greatest"
