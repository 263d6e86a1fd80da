"""Words beside a number that neither the question nor a list of harmless ones has, for a person to read."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

from corollary.answers.answer import Answer, Numbers, Unclear
from corollary.answers.changing_words import NEGATIONS, words_of
from corollary.answers.components import are_axes
from corollary.answers.direction import LEFT_OVER, axes_of, directed
from corollary.answers.name import GREEK_WORDS, VOWEL
from corollary.answers.number_words import BELOW, COUNTED, NUMBERS, POWERS, RATIOS
from corollary.answers.preamble import ABOUT, TALK
from corollary.answers.question import Question
from corollary.answers.remark import HARMLESS
from corollary.answers.sign_words import SIGNS
from corollary.answers.unit_meant import unit_meant
from corollary.formula.abbreviations import calculator_words
from corollary.formula.value import Items, Text, Value
from corollary.units.unit import ONE, Dimension, Unit, unit

LONGEST = 400
WORD = re.compile(r"[^\W\d_²³]{3,}")
# Commands of TeX that set a formula, calls of numpy, `as before`.
COMMAND = re.compile(
    r"\\(?:begin|end)\{\w+\}|\\(?:[dt]?frac|text(?:rm|bf|it)?|math\w+|rm|bf|it|left|right|[cl]?dots?|times|sqrt|vec|hat|bar|tilde|overline|underline|boxed"
    r"|approx|simeq|sim|equiv|quad|qquad|circ|degree|displaystyle|big[lr]?|Big[lr]?|operatorname|si|SI|unit|qty|num|therefore|implies|Rightarrow|rightarrow|to"
    r"|[ij]math|langle|rangle|lvert|rvert|perp|parallel|pm|ohm|micro|percent)(?![A-Za-z])"
    r"|\b(?:arc)?(?:sin|cos|tan)(?=[^\W\d_a-z])|\bper cent\b|\b(?:at|in the|in der|i) (?:last|end|summe)\b|\bas asked\b"
    r"|\bout (?=of )|\b(?:as|than) (?:\w+ )?before\b|\beach other\b"
    r"|\b(?:math|numpy|np)\.\w+|\b(?:array|float)\b|\b(?:ball|block|body|car|glider|disc|Block|Kugel|kloss) (?=[A-Z]\b)"
)
# Verbs, and small words beside a result, that leave it as it is.
PASSED_OVER: str = (
    "has have had were does did can must will would should could need needs take takes took lasts get gets got give gives given gave "
    "come comes came coming go goes went going move moves moved moving fly flies flew travel travels run runs ride flow flows leave leaves left "
    "stand stands stop stops start starts hang hangs hanging feel feels act acts acting push pushes pushed pull pulls pulled drive drives driving pass passes "
    "rest remain remains stay stays make makes made reach reaches show shows find found calculated point points catch catches sit pivot yet met turns turned "
    "there all only just also very because which whose who what you your they them their here now again once since both own full top side about exactly nothing "
    "therefore hence per pro approx delta direction way sign factor number solution component components motion along other off into head vertical horizontal "
    "angular root vector magnitude big great large long cubic system end ends whole experiences exerts exerted become becomes till each bounces bounce rebounds slide slides "
    "recoil recoils slowing further cools warms converted pointing directed stopped stationary significant figures coefficient matrix roll rolls taking taken "
    "horizontally vertically waagerecht senkrecht arc arcus sinus cosinus tangens doesn isn "
    "hat haben hatte hatten muss müssen kann geht gehen kommt fliegt fällt dauert braucht bewegt folgt gilt sie sein seine ihre nur auch daher und von bis "
    "damit also weil richtung faktor verhältnis anteil doppelt mal groß viel hoch weit rechter winkel nichts "
    "genau bei ich mich sich weicht gerundet endtemperatur mischungstemperatur bleibt stehen steht ruht ruhe rollt prallt springt "
    "auf zum zur zusammen wirkt wirken liegt liegen drückt wirkungsgrad komponente achse fahrtrichtung gegen "
    "har hadde må kan går gikk kommer flyr faller tar varer trenger beveger blir sin sitt bare også fordi derfor retning retningen forhold andel stor mye høy og fra til "
    "altså nøyaktig jeg meg seg bevege avrundet sluttemperatur vinkelfarten virkningsgraden stort sammen stopper ligger får står stille spretter ruller komponent aksen "
    "fartsretningen kjøreretningen "
    "mot against towards toward away"
)
# What may be a sign: of them and of open words a person reads where the number would be right with the other one.
TURNING_WORDS: str = (
    "fall falls fell falling sink sinks sank drop drops dropped down back backward backwards back return returns returned takes away heat negative opposite "
    "lost loss loses losing lose decrease decreases decreased gain gains gained increase increases increased rise rises dissipated reduced brakes "
    "verlust verliert verloren sinkt abnahme zurück negativ tap tapt taper mister synker avtar tilbake mot gegen entgegen against towards toward left right "
    "less weniger mindre weaker than"
)
# Words of arithmetic that a number is read with; any other word that changes a number takes it back.
RECKONED: str = (
    "minus plus times half third quarter twice double doubled triple thrice negative negativ root square squared cube cubed sine cosine tangent divided "
    "multiplied over opposite reversed halb halbe halbes doppelt doppelte dreifache mal quadrat wurzel halv halve halvparten dobbel dobbelt dobbelte ganger roten"
)
# Words that may name another value than is asked for, where the question does not say them.
OF_ANOTHER: str = (
    "relative higher lower larger smaller bigger greater before initial initially vorher vor før weight gravity gewicht vekt mass "
    "change changes changed ändert änderung endring endringen endret difference first second third last than"
)
# Bodies and extremes, of which the one that is asked for stands in the question.
BODIES: str = (
    "friction floor ground wall bullet ball block car book body object person sphere rocket chain atom club racket track table "
    "maximum minimum maxima minima max min"
)
MULTIPLES: str = "larger bigger greater higher faster longer more"  # beside a ratio
OF_A_CHANGE = re.compile(r"[Δδ∆]|\b(?:chang|impuls|los[st]|gain|differ|änder|endr|verl|tap)", re.IGNORECASE)
OF_CHANGE = frozenset(word for word in OF_ANOTHER.split() if OF_A_CHANGE.match(word))
WITH_ITS_WEIGHT = re.compile(
    r"\b(?:incl\w*|excl\w*|with|without|due to|because of|by|against|mit|ohne|med|uten)\.? (?:the |its |his |her )?(?:weight|gravity|gewicht|vekt)\b",
    re.IGNORECASE,
)
NAMED: dict[str, str] = {
    "kg": "mass masse massen",
    "N": "force kraft kraften weight",
    "kg*m/s": "momentum impulse impuls impulsen bewegelsesmengde bewegelsesmengden kraftstoß",
    "m/s": "velocity speed geschwindigkeit fart farten hastighet hastigheten tempo",
    "m/s^2": "acceleration beschleunigung akselerasjon akselerasjonen",
    "J": "heat energy work energie energien arbeit arbeid arbeidet",
    "W": "power leistung effekt",
    "s": "time zeit tid tiden",
    "m": "height distance length höhe strecke høyde høyden avstand avstanden",
    "rad": "angle winkel vinkel vinkelen",
    "A": "current strom strøm",
    "V": "voltage spannung spenning",
    "ohm": "resistance widerstand motstand",
    "Pa": "pressure druck trykk",
}
# Words of arithmetic: `the impulse divided by the time` names no result.
# `part of 86 N`, `the mean of 2 s and 5 s`, `is its square`: a value made of this one.
MADE_OF_IT = re.compile(
    rf"\b(?P<word>{'|'.join((*RATIOS, 'part', 'parts', 'share', 'maximum', 'minimum', 'multiple', 'multiples'))})"
    r" (?:of|von|av|de) (?:the |about )?(?=[-+−]?[0-9(])|(?P<before>\b(?:excluding|including|except|since|until|unter|über)) (?=[-+−]?[0-9])"
    r"|\bis (?P<made>(?:its|the) (?:square|root|inverse|half|double)|twice|half|double)\b",
    re.IGNORECASE,
)
# `2 s, and 5 s after that`
OF_SEVERAL = re.compile(
    r"\b(?:sum|mean|average|difference|product|ratio|larger|smaller|mittelwert|summe) (?:of|von|av)\b|\b(?:after that|later|danach|später|senere)\b",
    re.IGNORECASE,
)
# `cooled by 45 °C`: a change, where none is asked for.
BY = re.compile(r"(?<!given )\b(?:by|um)\s+(?=[-+−]?[0-9])", re.IGNORECASE)
ASKED_BY = re.compile(r"\b(?:by|um|much|far|chang\w*|factor|wie viel|hvor mye)\b", re.IGNORECASE)
COMPARED = re.compile(
    r"\b(?:as|than|that) (?:(?:that|those|the|of|from|for) )+(?P<what>[^0-9,;]+)$", re.IGNORECASE
)
RECKONING = re.compile(r"\b(?:divided|over|times|per|geteilt|durch|mal|delt|ganger)\b", re.IGNORECASE)
PREFIXES = frozenset(
    ["kilo", "mega", "giga", "milli", "micro", "nano", "centi", "deci"]
)  # alone they are no unit
LEFT = re.compile(r"(?:^|[=;,]\s*)(?P<name>[^\W\d]\w*)\s*[=≈]\s*(?=[-+−]?[0-9.,])")
OF_SPACE_AND_TIME = frozenset(unit(text).dimension for text in ("m", "s", "1"))  # `Δt` is a time
SIDE = re.compile(r"\s*(?P<side>[^=,;\[(]*[\^/*²³][^=,;]*)=")  # `ω^2 = 6.32, 8`
HEIGHT = re.compile(r"\b(?:height|high)\b", re.IGNORECASE)
FORCE = unit("N").dimension
PER_SECOND = unit("1/s")


def with_open_words(answer: Answer, value: Value, question: Question) -> Answer:
    """The answer with the words of its text that may make it the value of something else."""
    if not isinstance(answer, Numbers | Unclear):
        return answer
    items = value.items if isinstance(value, Items) else (value,)
    text = "; ".join(item.text for item in items if isinstance(item, Text))
    if len(text) > LONGEST:
        return answer
    words = open_words(text, question)
    if isinstance(answer, Numbers) and not all(answer.values):  # of nothing, no word makes anything else
        words = tuple(word for word in words if any(answer.values) and word.lower() not in NEGATIONS.split())
    signs = words_of(text) & _turning()
    if signs and axes_of(text, question.components).words:
        signs = set[str]()
    if LEFT_OVER.search(text):
        signs -= {"left"}
    if isinstance(answer, Unclear):
        return replace(answer, sign_alone=answer.sign_alone and not words)
    if answer.in_words:  # the sign stands in them, and was read
        signs = set[str]()
        words = tuple(word for word in words if word.lower() not in _turning())
    else:
        signs |= {word.lower() for word in words}
        if directed(question) or answer.values[0] < 0:
            words = tuple(word for word in words if word.lower() not in _turning())
    return replace(answer, open_words=", ".join(words), turning_words=", ".join(sorted(signs)))


def open_words(text: str, question: Question) -> tuple[str, ...]:
    """The words of a text of bounded length that may make its number the value of something else."""
    asked = f"{question.title} {question.text}"
    made = MADE_OF_IT.search(text)
    others = (
        *((made[made.lastgroup or 0].strip(),) if made else ()),
        *(OF_SEVERAL.findall(text) if "list" in question.types else ()),
        *(("by",) if BY.search(text) and not ASKED_BY.search(asked) else ()),
        *_other_names(text, question, asked),
        *_other_units(text, question, asked),
    )
    if not WORD.search(text):
        return others
    own = {
        _stem(word)
        for word in words_of(" ".join((asked, *question.components, *question.rows, *question.columns)))
    }
    if OF_A_CHANGE.search(asked):
        own |= {
            _stem(word)
            for word in (*OF_CHANGE, "before", "initial", "vorher", "før", "more", "less", "mehr", "mer")
        }
    text = WITH_ITS_WEIGHT.sub(" ", COMMAND.sub(" ", re.sub("[Δ∆]", " ", text)))
    named = [
        (word, word.lower())
        for word in dict.fromkeys(WORD.findall(text))
        if word not in question.symbol_names
    ]
    others += tuple(_other_quantities([small for _, small in named], own, question, text))
    if question.unit.is_pure:  # which of two is the larger one, the words beside a ratio say
        own = {_stem(word) for word in words_of(" ".join((question.title, *question.components)))}
        own |= _compared(text, asked)
        accepted = _harmless() | {*MULTIPLES.split(), *(word for each in RATIOS for word in each.split())}
        accepted |= {"fold", "twofold", "threefold", "fourfold", *(f"{word}s" for word in BELOW)}
        accepted |= {form for word in COUNTED.lower().split() for form in (word, f"{word}s")}
    else:
        same = {word for word, measured in _measured().items() if measured == question.unit.dimension} - set(
            OF_ANOTHER.split()
        )
        accepted = _harmless() | same | _part_ratios()
    if HEIGHT.search(asked):
        accepted |= {"higher", "than"}
    if question.extreme:
        accepted |= {"least", "most", "minimum", "maximum", "max", "min"}
    if "interval" in question.types:
        accepted |= {"between", "zwischen", "mellom"}
    if are_axes(question.components):
        accepted |= {"below", "unter", "under"}
    if question.unit.is_angle:
        accepted |= {"über", "unter", "over", "below"}
    letters = set("".join(question.symbol_names))
    found = (
        word
        for word, small in named
        if small not in accepted
        and _stem(small) not in own
        and not set(word) <= letters
        and not _is_unit(word, text, question.unit)
    )
    return tuple(dict.fromkeys((*others, *found)))


def _compared(text: str, asked: str) -> set[str]:
    """The words behind `as that of the` or `than the`, where the question compares with that, too."""
    found = COMPARED.search(text)
    behind = re.split(r"\b(?:as|than|to)\b", asked)[-1]
    words = words_of(found["what"]) if found else set[str]()
    return (
        {_stem(word) for word in words}
        if words & words_of(behind) - _harmless() and words <= words_of(asked)
        else set()
    )


def _is_unit(word: str, text: str, expected: Unit) -> bool:
    """True for a unit; for one made of several letters run together behind a number only."""
    if word.lower() in PREFIXES and re.search(rf"\b{word}\s", text):
        return False
    if re.search(rf"[0-9)\]]\s?{word}", text) and VOWEL.search(word) is None:
        return True  # `8.6 kgms^-1`
    found = unit_meant(word, expected)
    return isinstance(found, Unit) and (
        "*" not in found.text or re.search(rf"[0-9)\]]\s?{word}", text) is not None
    )


def _other_quantities(names: list[str], own: set[str], question: Question, text: str) -> list[str]:
    """The names of quantities of another dimension, where none of the dimension asked for is named."""
    measured = _measured()
    if RECKONING.search(text) or any(measured.get(word) == question.unit.dimension for word in names):
        return []
    return [
        word
        for word in names
        if word in measured and _stem(word) not in own and question.unit.dimension != ONE
    ]


def _other_names(text: str, question: Question, asked: str) -> tuple[str, ...]:
    """The letter before the number, where it is that of a given with an index, or of a change that is not asked for."""
    if "list" in question.types and (reckoned := SIDE.match(text)):
        return (reckoned["side"].strip(),)
    names = [found["name"] for found in LEFT.finditer(text)]
    names = names if len(names) == 1 and text.count("=") == 1 else []
    given = set(question.symbol_names) - set(question.components)
    dimensions = question.dimensions
    changes = question.unit.dimension not in OF_SPACE_AND_TIME and not OF_A_CHANGE.search(asked)
    return tuple(
        name
        for name in names
        if (re.search(r"\d$", name) and {name, name.replace("_", "")} & given)
        or (changes and name[0] in "Δ∆")
        or dimensions.get(name, question.unit.dimension) != question.unit.dimension
        or (
            question.unit.dimension == FORCE
            and re.search(r"_[gGN]$", name)
            and not re.search("weight|grav|normal", asked)
        )
    )


def _other_units(text: str, question: Question, asked: str) -> tuple[str, ...]:
    """Radians beside a plain number; radians a second where turns are asked for, and hertz where angles are."""
    if question.unit.is_pure:
        return tuple(re.findall(r"(?<=\d)\s?(?:rad|°|deg)\b", text)[:1])
    if question.unit.dimension != PER_SECOND.dimension or "rad" in question.unit.text:
        return ()
    if re.search(r"\b(?:angular|winkel|vinkel)|ω", asked, re.IGNORECASE):
        return tuple(re.findall(r"\bHz\b", text)[:1])
    turns = re.search(r"\b(?:turn|revol|frequen|umdreh|omdr)", asked, re.IGNORECASE)
    return tuple(re.findall(r"\brad(?=\s?(?:/|s\b|per))", text)[:1]) if turns else ()


@cache
def _turning() -> frozenset[str]:
    return frozenset(TURNING_WORDS.split())


@cache
def _measured() -> dict[str, Dimension]:
    return {word: unit(text).dimension for text, words in NAMED.items() for word in words.split()}


@cache
def _part_ratios() -> frozenset[str]:
    """Words for a part or a multiple that an answer may repeat beside its number: `twice as much: 172 N`."""
    return frozenset(word for each in RATIOS for word in each.split() if not word.endswith("th"))


@cache
def _harmless() -> frozenset[str]:
    lists = f"{TALK} {ABOUT} {PASSED_OVER} {RECKONED} {COUNTED}".lower().split()
    names = (word.lower() for each in GREEK_WORDS for word in (each, f"var{each}"))
    return frozenset({*HARMLESS, *lists, *SIGNS, *NUMBERS, *POWERS, *names, *calculator_words()}) - set(
        f"{OF_ANOTHER} {BODIES}".split()
    )


def _stem(word: str) -> str:
    """A word without the ending of a plural, a participle or a case."""
    return next(
        (
            word[: -len(end)]
            for end in ("ing", "ed", "es", "en", "s", "n", "e")
            if word.endswith(end) and len(word) > len(end) + 3
        ),
        word,
    )
