"""Numbers in words, and ratios: `twice as large`, `half`, `two thirds`, `2:1`, `a factor of 2`, `2 times`, `zero m/s`."""

from __future__ import annotations

import re

IN_ENGLISH = "zero one two three four five six seven eight nine ten eleven twelve"
IN_GERMAN = "null eins zwei drei vier fünf sechs sieben acht neun zehn elf zwölf"
NUMBERS = {word: number for words in (IN_ENGLISH, IN_GERMAN) for number, word in enumerate(words.split())}
# `to` is two in Norwegian, and no number where it stands before a direction.
TIMES_OVER = NUMBERS | {"to": 2, "tre": 3, "fire": 4, "fem": 5}
# As words that stand for a number on their own, in English, German, French and Nordic; with the fraction they are.
RATIOS = {
    "twice": "2", "double": "2", "doubled": "2", "doubles": "2", "thrice": "3", "triple": "3", "tripled": "3", "quadruple": "4",
    "half": "1/2", "halved": "1/2", "third": "1/3",
    "quarter": "1/4", "fourth": "1/4",
    "tenth": "1/10", "fifth": "1/5", "equal": "1",
    "doppelt": "2", "doppelte": "2", "zweimal": "2", "dreimal": "3", "halb": "1/2", "hälfte": "1/2", "le double": "2", "la moitié": "1/2",
    "dobbelt": "2", "dubbelt": "2", "halvparten": "1/2", "hälften": "1/2",
}  # fmt: skip
DIGITS = r"[0-9]+(?:[.,][0-9]+)?"
ABOUT = r"(?:(?:it|this|that|the|is|was|by|about|exactly|approximately|roughly|just|only|always|a|an|die|das|≈)\s+)*"
RATIO = re.compile(
    rf"\s*{ABOUT}(?:ratio\s*(?:of|is|=|:)?\s*)?({DIGITS})\s*(?::|\bto\b|\bzu\b|\bout of\b|\bvon\b|\bav\b)\s*({DIGITS})\s*",
    re.IGNORECASE,
)
FACTOR = re.compile(
    rf"\s*{ABOUT}(?:(?:fa[ck]tor|ratio)\s*(?:of|is|=|:)?|[x*])\s*({DIGITS}(?:/{DIGITS})?)\s*", re.IGNORECASE
)
LARGE = r"(?:as\s+)?(?:much|large|big|great|high|fast|strong|heavy|long|many|larger|bigger|greater|higher|faster|more)"
SMALL = r"(?![^0-9]*\b(?:small|less|slow|low|klein|wenig|langsam|kurz|liten|lite|mindre|sakte))"
BESIDE = rf"{SMALL}(?:\s+{LARGE}(?:\s+(?:as|than|for)\b[^0-9]{{0,60}})?|\s+(?:of|that of)\b[^0-9]{{0,60}}|\s+(?:the|that|its|so|så)\b[^0-9]{{0,60}})?"
TIMES = re.compile(
    rf"\s*{ABOUT}({DIGITS}(?:/{DIGITS})?)\s*(?:x|times|-?fold|mal|fois|ganger)(?:{BESIDE})\s*",
    re.IGNORECASE,
)
NUMBER_TIMES = re.compile(
    rf"\s*{ABOUT}({'|'.join(TIMES_OVER)})(?:\s+(?:times|mal|ganger)|[\s-]?fold){BESIDE}\s*", re.IGNORECASE
)
FACTOR_IN_WORDS = re.compile(
    rf"\s*{ABOUT}(?:factor|faktor)\s*(?:of|von|på)?\s*({'|'.join(NUMBERS)})\s*", re.IGNORECASE
)
WORD = re.compile(rf"\s*{ABOUT}({'|'.join(sorted(RATIOS, key=len, reverse=True))}){BESIDE}\s*", re.IGNORECASE)
PER_CENT = re.compile(r"\bper cent\b", re.IGNORECASE)
CROSS = re.compile(r"(?<=[0-9A-Za-z)²³] )[xX](?= [0-9A-Za-z(])|(?<=[0-9])[xX](?=[0-9])")
TWICE = re.compile(r"\b(twice|double|thrice|half|doppelt|dobbelt)\s+(?:of\s+)?(?=[^\W\d])", re.IGNORECASE)
OVER = re.compile(rf"\b({DIGITS}|{'|'.join(TIMES_OVER)})\s+(?:times|mal|ganger)\s+(?=[^\W\d])", re.IGNORECASE)
IN_MINUTES = re.compile(
    r"\b([0-9]{1,3})\s*[°º]\s*([0-9]{1,2})\s*'(?:\s*([0-9]{1,2}(?:[.,][0-9]+)?)\s*(?:\"|″|''|”))?(?=\s*$)"
)
CLOCK = re.compile(
    r"\s*(?P<large>[0-9]{1,4}):(?P<small>[0-5][0-9])\s*(?P<unit>min|minutes|h|hours)\.?\s*"
)  # `4:06 min`
MINUTES = re.compile(r"\s*([0-9]+)\s?(?:m|')\s?([0-9]+(?:[.,][0-9]+)?)\s?(?:s|''|\")\s*")  # `4m 6s`
SHARE = re.compile(
    r"(?<=%)\s+(?:of|von|der|des|av)(?: (?:it|its|the|A|seiner|ihrer|dens|den)['’]?s?)?(?: (?:kinetic|total|initial|original|whole|kinetischen|gesamten))*"
    r"(?: (?:energy|momentum|speed|Energie|energien))?\s*$",
    re.IGNORECASE,
)
FRACTION = re.compile(
    rf"\s*{ABOUT}(one|two|three|four|five|six|seven)[ -](half|halves|third|quarter|fourth|fifth|sixth|eighth|ninth|tenth)s?{BESIDE}\s*",
    re.IGNORECASE,
)
BELOW = {"half": 2, "halves": 2, "third": 3, "quarter": 4, "fourth": 4, "fifth": 5, "sixth": 6, "eighth": 8, "ninth": 9, "tenth": 10}  # fmt: skip
POWERS = {
    "thousand": 3,
    "tausend": 3,
    "tusen": 3,
    "million": 6,
    "millions": 6,
    "millionen": 6,
    "millioner": 6,
}
LARGE_NUMBER = re.compile(
    rf"(?<=[0-9])\s+({'|'.join(sorted(POWERS, key=len, reverse=True))})(?=\s+[A-Za-zµ°%]|\s*$)", re.IGNORECASE
)
FIRST = re.compile(rf"\s*([+-]?)\s*({'|'.join(NUMBERS)})(?=\s+[A-Za-zµ°%]|\s*$)", re.IGNORECASE)


def product_in_signs(formula: str, *, cross: bool) -> str:
    """`twice v`, `2 times v` as `2*v`; `2 x v` too, where the `cross` is no letter."""
    formula = TWICE.sub(lambda found: f"{RATIOS[found[1].lower()]}*", formula)
    formula = OVER.sub(lambda found: f"{TIMES_OVER.get(found[1].lower(), found[1])}*", formula)
    return CROSS.sub("*", formula) if cross else formula


COUNTED = (  # what is counted where a plain number is asked for
    "bounce collision hit impact kick step stage jump throw photon electron proton neutron atom molecule ion particle nucleus nuclei wave "
    "wavelength fringe maximum maxima minimum minima order slit line node antinode loop winding coil swing oscillation vibration period ball "
    "block car person people student resistor bulb cell battery time place way solution value day-old "
    "Stoß Stöße Photon Photonen Elektron Elektronen Welle Wellen Teilchen Atom Atome Schwingung Schwingungen Ordnung Ordnungen Kugel Kugeln "
    "støt elektroner fotoner bølger svingninger"
)
NOUN = re.compile(rf"(?<=[0-9])\s+\(?(?:{'|'.join(COUNTED.split())})(?:s|es)?\)?\s*$", re.IGNORECASE)


RIGHT_ANGLE = re.compile(
    rf"\s*{ABOUT}(?:(?:one|at|ein|einen|en)\s+)*(?:right angles?|rechter winkel|rechten winkel|rett vinkel)\s*[.!]?\s*",
    re.IGNORECASE,
)


def _in_degrees(found: re.Match[str]) -> str:
    """`19°6'` as `19.10°`, `19°6'30"` as `19.1083°`."""
    minutes, seconds = int(found[2]), float((found[3] or "0").replace(",", "."))
    return f"{int(found[1]) + minutes / 60 + seconds / 3600:.{4 if found[3] else 2}f}°"


def in_digits(normalized: str, *, pure: bool) -> str:
    """The number in digits; as it is where there is no word for one. Ratios are read where a `pure` number is asked for."""
    normalized = CROSS.sub("*", PER_CENT.sub("%", normalized))
    normalized = IN_MINUTES.sub(_in_degrees, normalized)
    if pure:
        if RIGHT_ANGLE.fullmatch(normalized):
            return "90°"
        normalized = NOUN.sub("", SHARE.sub("", normalized))
        text = normalized.strip().rstrip(".!")
        if found := RATIO.fullmatch(text):
            return f"{found[1]}/{found[2]}"
        if found := FACTOR.fullmatch(text) or TIMES.fullmatch(text):
            return found[1]
        if found := FRACTION.fullmatch(text):
            return f"{NUMBERS[found[1].lower()]}/{BELOW[found[2].lower()]}"
        if found := NUMBER_TIMES.fullmatch(text) or FACTOR_IN_WORDS.fullmatch(text):
            return str(TIMES_OVER[found[1].lower()])
        if found := WORD.fullmatch(text):
            return RATIOS[re.sub(r"\s+", " ", found[1].lower())]
    normalized = LARGE_NUMBER.sub(lambda found: f"*10^{POWERS[found[1].lower()]}", normalized)
    if found := FIRST.match(normalized):
        return found[1] + str(NUMBERS[found[2].lower()]) + normalized[found.end() :]
    return normalized


def clock_in_units(text: str) -> str:
    """`4:06 min` as `4 min 06 s`, `4m 6s` as `4 min 6 s`."""
    return CLOCK.sub(_of_a_clock, MINUTES.sub(r"\1 min \2 s", text))


def _of_a_clock(found: re.Match[str]) -> str:
    """`4:06 min` as `4 min 06 s`."""
    units = ("min", "s") if found["unit"].startswith("min") else ("h", "min")
    return f"{found['large']} {units[0]} {found['small']} {units[1]}"
