"""Marks and words between units: `Newton seconds`, `meters per second`, `kg.m/s`, `N-s`, `kmph`."""

from __future__ import annotations

import re

from corollary.units.dimension import DIFFERENCE

SPEEDS = {
    "kph": "km/h", "kmph": "km/h", "kmh": "km/h", "mps": "m/s", "mph": "mi/h",
    "km/t": "km/h", "Stundenkilometer": "km/h",  # in Norwegian an hour is a time
    "U/min": "rpm", "omdr/min": "rpm",
}  # fmt: skip
SPEED = re.compile(rf"(?<![A-Za-z])(?:{'|'.join(SPEEDS)})(?![A-Za-z])")
PER = re.compile(r"(?<![A-Za-z])(?:per|pro|par)(?![A-Za-z])")
COMPOUND = re.compile(  # in German and Norwegian written as one word
    r"(?<![A-Za-z])((?:kilo)?(?:newton|watt|joule)|kilogramm?)(?=(?:sekund|meter|stund|timer?)[a-z]{0,2}(?![a-z]))",
    re.IGNORECASE,
)
JOINED = re.compile(
    r"(?<=[A-Za-z])-(?=[A-Za-z])|(?<=[A-Za-z0-9⁰¹²³⁴-⁹)])\.(?=\s?[A-Za-z(])"
)  # `N-s`, `kg.m/s`
RAISED_BEHIND = re.compile(r"\s+(squared|cubed)(?![A-Za-z])", re.IGNORECASE)
RAISED_BEFORE = re.compile(
    r"(?<![A-Za-z])(?:(?P<square>square|sq\.?|Quadrat-?|kvadrat-?)|(?:cubic|cu\.?|Kubik-?|kubikk-?))\s*(?P<unit>(?!d\b)[A-Za-zµ]+)(?![A-Za-z^])",
    re.IGNORECASE,
)
PREFIX_APART = re.compile(
    r"(?<![A-Za-z])(kilo|milli|centi|mega|giga|micro|nano)[ -]+(?=[a-z]{4,})", re.IGNORECASE
)
SHORTENED = re.compile(
    r"(?<![A-Za-z])((?i:micro|milli|nano|kilo))(?=(?:mol|m|g|s|N|J|W|V|A|Pa|Hz|eV|C|F)(?![A-Za-z]))"
)
MICRO = re.compile(
    r"(?<![A-Za-z])mu\s*(?=(?:m|g|s|A|V|C|F|N|J|W|H|T|Pa|mol|l|L)(?![A-Za-z]))"
)  # `\\mu m` without its backslash
OMEGA = re.compile(r"(?<![A-Za-z])([kMmGu]?)\s*Omega(?![A-Za-z])")
ALL = re.compile(r"\s*\[([^\[\]]*)\]\s*|\s*\(([^()]*)\)\s*")
# °C is no degree times a coulomb. A difference of temperatures is written with a delta: `Δ°C`, `delta K`.
DELTA = r"(?:delta(?:_| ?(?=[°ºdK]))|[Δ∆]\s?)"
DEGREES = r"(?:[°º]\s?|(?<![A-Za-z])deg(?:rees?)?\s?)(?:[CFK]|[Cc]elsius|[Ff]ahrenheit)"
TEMPERATURE = rf"(?:{DELTA}?{DEGREES}|{DELTA}K)(?![A-Za-z])"
PARTS = re.compile(rf"(?P<delta>{DELTA})?\s?(?P<degrees>[°ºd][^CFKcf]*)?(?P<scale>[CFKcf])\w*")
GROUP = re.compile(r"\(([^()^{}]+)\)(?!\s*[\^⁰¹²³⁴-⁹⁻*])")  # not raised


def in_signs(text: str) -> str:
    """The unit with a sign for every word and mark; a place in it stays a place in what was typed, but for whole brackets."""
    if whole := ALL.fullmatch(text):
        text = whole[1] or whole[2] or ""
    text = RAISED_BEHIND.sub(lambda found: f"^{2 if found[1].lower() == 'squared' else 3}", text)
    text = RAISED_BEFORE.sub(lambda found: f"{found['unit']}^{2 if found['square'] else 3}", text)
    text = PREFIX_APART.sub(r"\1", text.replace("electron volt", "electronvolt"))
    text = SHORTENED.sub(
        lambda found: {"micro": "u", "milli": "m", "nano": "n", "kilo": "k"}[found[1].lower()], text
    )
    text = OMEGA.sub(r"\1ohm", MICRO.sub("u", text))
    text = SPEED.sub(lambda found: SPEEDS[found[0]], text)
    text = COMPOUND.sub(r"\1 ", text)
    text = JOINED.sub("*", PER.sub(lambda found: "/".ljust(len(found[0])), text))
    for _ in range(3):
        text = GROUP.sub(_opened, text)
    return text


def _opened(group: re.Match[str]) -> str:
    """What stands in brackets, without them, unless it is below a slash or a power: they hold that together."""
    before = group.string[: group.start()].rstrip()
    return group[0] if before.endswith(("/", "^", "**")) else f" {group[1]} "


def temperature(symbol: str) -> str:
    """`Δ °C` and `degrees Celsius` as they are in the table, delta_degC and degC; any other symbol as it is."""
    if not re.fullmatch(TEMPERATURE, symbol):
        return symbol
    found = PARTS.fullmatch(symbol)
    assert found is not None  # a temperature has these parts
    scale = found["scale"].upper()
    return (DIFFERENCE if found["delta"] else "") + ("K" if scale == "K" else "deg" + scale)
