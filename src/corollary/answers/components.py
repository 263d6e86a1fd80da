"""Vectors in words, taken apart: `(3, 4) m/s`, `3 i + 4 j`, `p_y = 4; p_x = 3`, `5 m/s at 30°`."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import pairwise

from corollary.answers.left_side import gives_what_is_asked
from corollary.answers.name import is_name, is_talk
from corollary.answers.preamble import Bare, answer_in
from corollary.answers.question import Question
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.numerals import scan_number
from corollary.messages import catalogue
from corollary.units.unit import Unit, read_unit, show

_ = catalogue(__name__)

DIRECTIONS = {
    "i": 0,
    "j": 1,
    "k": 2,
    "î": 0,
    "ĵ": 1,
    "k̂": 2,
    "x̂": 0,
    "ŷ": 1,
    "ẑ": 2,
    "ex": 0,
    "ey": 1,
    "ez": 2,
}
LETTERS = r"k̂|x̂|ŷ|ẑ|[îĵijk]|e_?[xyz](?![A-Za-z])"
ALONG = re.compile(rf"(?P<letter>{LETTERS})(?=\s*(?:[+\-)]|$))|(?<![A-Za-z(])(?P<last>{LETTERS})\s+(?=\D)")
BETWEEN_TERMS = re.compile(r"(?<=[\w.)°%²³])(?<![0-9][eE])\s*(?=[+-])")
TERM = re.compile(
    r"\s*(?P<sign>[+-]?)\s*\(?\s*(?P<own>[+-]?)\s*(?P<number>[0-9.,]+(?:[eE][+-]?[0-9]+)?)\s*\)?\s*\*?\s*(?P<unit>.*)"
)
BRACKETS = {"(": ")", "[": "]", "{": "}", "<": ">", "⟨": "⟩"}
APART = 20  # how much nearer the last of several numbers must come to the others by a unit of its own
MARKS = (
    r"\s*[;|]\s*",
    r",\s+(?:(?:and|und|og|et)\s+)?|\s+(?:and|und|og|et)\s+|\s*&\s*",
    r",",
    r"(?<=[0-9.])\s+(?=[+\-]?[0-9])",
    r"\s+(?=[^\W\d]\w{0,7}['*]?\s*[=≈]\s*[-+]?[0-9.,])",  # `K1=3 K2=4`
    r"\.\s+(?=[^\W\d])",  # `The sphere: 3 m/s. The block: 4 m/s.`
)
LED = re.compile(r"\s*[=≈~]\s*|\s*(?:[Δ∆]\s*)?[^\W\d][^\s=≈~()\[\],;:+*/-]{0,7}\s*[=≈~]\s*(?=[(\[<{⟨])")
LEFT = re.compile(r"\s*[(\[<{]([^()\[\]<>{}=≈]*)[)\]>}]\s*[=≈]\s*(?=[(\[<{⟨])")
GROUPS = re.compile(r"\s*\([^()]*\)(?:\s*(?:and|und|og|,|;|&)\s*\([^()]*\))+\s*")
OF = r"(?:for|in|along|of|für|entlang|langs|i)\s+(?:the |ball |block |body )*"
COMPONENT = r"(?:[- ](?:component|direction|axis|part|coordinate))?"
NAMED = re.compile(r"\s*(?P<name>[^\W\d][^\s=:]{0,11})\s*[=:≈]")
BULLET = re.compile(r"^\s*[-*•–]\s+(?=[^\W\d])")
LEVEL = re.compile(r"\b(?:horizontal(?:ly)?|waagerecht|horisontalt?)\b(?! (?:to|up|down))", re.IGNORECASE)
UPRIGHT = re.compile(r"\b(?:vertical(?:ly)?|senkrecht|vertikalt?)\b(?! (?:up|down))", re.IGNORECASE)
TRANSPOSED = re.compile(r"(?<=[)\]])\s*(?:\^\s*(?:T|\{T\}|\(T\))|ᵀ|\.T)(?=\s|$)")
FACTOR = re.compile(r"[-+]|[-+]?[0-9.]+(?:\s*[A-Za-z][^()=:,;]*)?\s*\*|[-+]?[0-9.]+")
UNIT_AND_NUMBER = re.compile(r"(?<=[A-Za-z²³°%])\s+(?=[-+]?[0-9.])")
NUMBER_AND_UNIT = re.compile(r"[-+]?[0-9]*[.,]?[0-9]+\s*(?P<unit>[A-Za-zµΩ°%][^\s,;]*)")
IN_SLASHES = re.compile(r"\s*([-+]?[0-9]+(?:[.,][0-9]+)?)\s*/\s*([-+]?[0-9]+(?:[.,][0-9]+)?)\s*")
BARE_AXES = re.compile(  # `7.5x - 10y`
    r"\s*(?P<first>[-+]?\s*[0-9.,]+)\s?\*?\s?x\s*(?P<second>[-+]\s*[0-9.,]+)\s?\*?\s?y(?P<third>\s*[-+]\s*[0-9.,]+\s?\*?\s?z)?\s*"
)
CHAIN = re.compile(
    r"(?P<before>[^=]+(?:=[^=]+)*)=\s*(?P<last>[(\[][^()\[\]=]*[)\]][^()\[\]=]*)"
)  # `p = 2*(3, 4) = (6, 8)`
SCALED = re.compile(
    r"(?P<factor>[-+]?[0-9.,]+)(?:\s*[A-Za-z][A-Za-z/^0-9]*)?\s*[*·]?\s*\((?P<inside>[^()]*)\)(?:\s*[A-Za-z][A-Za-z/^0-9 ]*)?"
)


def are_axes(names: Sequence[str]) -> bool:
    """Whether the components are those of one vector, along axes, and not of several bodies."""
    return all(name[-1:] in ("x", "y", "z") for name in names) and len({name[:-1] for name in names}) <= 1


def in_one_line(text: str, count: int) -> str:
    """Lines, where there is one for each component, parted by semicolons."""
    lines = [BULLET.sub("", line).strip().rstrip(",;") for line in text.splitlines() if line.strip()]
    whole = all(line.count("(") == line.count(")") and line.count("[") == line.count("]") for line in lines)
    return "; ".join(lines) if len(lines) == count > 1 and whole else text


def pieces_of(
    normalized: str,
    count: int,
    names: Sequence[str] = (),
    expected: Unit | None = None,
    question: Question | None = None,
) -> list[str] | ParseError:
    """One text for each component, in the order of `names` where the text names them; a unit behind all of them goes to each."""
    if names and (left := LEFT.match(normalized)):  # `(p_y, p_x) = (4, 3)`
        places = [place_named(f"{name} = ", names) for name in re.split(r"[,;]", left[1])]
        found = pieces_of(normalized[left.end() :], count, (), expected)
        if isinstance(found, ParseError) or sorted(map(str, places)) != sorted(map(str, range(count))):
            return found
        return [found[places.index(place)] for place in range(count)]
    if count > 1 and (alone := _each_in_brackets(normalized)) is not None and len(alone) == count:
        return _in_order([labelled(piece, names) for piece in alone], names, question)
    inside, unit, factor = _unwrapped(TRANSPOSED.sub("", normalized))
    if question is None or not {"x", "y"} & set(question.symbol_names):
        inside = _with_unit_vectors(inside)
    along = [found for found in ALONG.finditer(inside) if _axis(found) < count]
    if along and (not names or are_axes(names)):  # in a plane k is no direction, but may be a letter
        return _directed(inside, unit, count)
    if count == 2 and (slashed := _slashed(inside)) is not None:
        return slashed
    found = _listed(_each_with_its_unit(_parted(inside, names), count), unit, count, expected)
    if isinstance(found, ParseError):
        return found
    found = _in_order([labelled(piece, names) for piece in found], names, question)
    return (
        found
        if isinstance(found, ParseError) or not factor
        else [f"{f'{factor}1' if factor in ('-', '+') else factor}*({piece})" for piece in found]
    )


def _with_unit_vectors(inside: str) -> str:
    """`7.5x - 10y` as `7.5 i - 10 j`: letters of axes as unit vectors."""
    found = BARE_AXES.match(inside)
    if found is None:
        return inside
    third = (found["third"] or "").rstrip("z* ")
    written = f"{found['first']} i {found['second']} j{third}{' k' if third else ''}"
    return written + (f" {inside[found.end() :]}" if found.end() < len(inside) else "")


def _each_in_brackets(text: str) -> list[str] | None:
    """The components of `(1.66 m/s) and (7.84 m/s)`."""
    if GROUPS.fullmatch(text) is None:
        return None
    return re.findall(r"\(([^()]*)\)", text)


def _slashed(inside: str) -> list[str] | ParseError | None:
    """The components of `(1,5/2,5)`, `7.5/-10`; of `(0/1,6)` it is asked whether the slash or the comma parts them."""
    found = IN_SLASHES.fullmatch(inside)
    if found is None:
        return None
    if inside.count(",") != 1:
        return [found[1], found[2]]
    choices = f"({found[1]}; {found[2]})", f"({inside.strip().replace(',', '; ')})"
    return ambiguous(_("the slash or the comma can part the components"), 0, *choices)


def _parted(inside: str, names: Sequence[str]) -> str:
    """`x = 0 y = 1.6`, `A 0 B 4`, with a mark between the components, where the text begins with the name of one and names each."""
    name = "|".join(sorted(map(re.escape, names), key=len, reverse=True)) or "(?!)"
    label = rf"(?<![^\s;,])(?:[^\W\d]_?)?(?:{name})['*]?(?:\s*[=:]\s*|\s+)(?=[-+≈]?\s*[0-9.,(])"
    starts = [found.start() for found in re.finditer(label, inside)]
    if not starts or len(starts) != len(names) or inside[: starts[0]].strip():
        return inside
    pieces = [inside[start:end] for start, end in pairwise([*starts, len(inside)])]
    ends = (re.sub(r"[\s,;]+(?:and|und|og)?\s*$", "", piece) for piece in pieces)
    return "; ".join(ends)


def _each_with_its_unit(inside: str, count: int) -> str:
    """`-1.48 m/s 2.95 m/s`, with a mark between the components, where nothing but the same unit stands behind each."""
    pieces = UNIT_AND_NUMBER.split(inside.strip())
    found = [NUMBER_AND_UNIT.fullmatch(piece) for piece in pieces]
    units = {each["unit"] if each else "" for each in found}
    return "; ".join(pieces) if len(pieces) == count > 1 == len(units) and "" not in units else inside


def labelled(piece: str, names: Sequence[str]) -> str:
    """`sphere 3 m/s`, `x-component: 3`, `3 (x)` as `x = 3`."""
    if not all(name[:1].isalpha() for name in names) or not names:  # in `2 5 s` 2 is no name
        return piece
    if are_axes(names):
        for way, axis in zip((LEVEL, UPRIGHT), names, strict=False):
            piece = way.sub(lambda found, axis=axis: axis if not found.start() else f"in {axis}", piece)
    name = rf"(?:[A-Za-z]_?)?(?P<name>{'|'.join(sorted(map(re.escape, names), key=len, reverse=True))}){COMPONENT}"
    number = r"(?=[-+≈~]?\s*[0-9.,(])"
    before = re.match(
        rf"\s*(?:the |ball |block |body )*{name}(?:\s*(?:is|[=:≈])\s*|\s+){number}", piece, re.IGNORECASE
    )
    if before:
        return f"{before['name']} = {piece[before.end() :]}"
    long = "|".join(re.escape(each) for each in names if len(each) > 2) or "(?!)"
    ways = (
        rf"\s*\(\s*(?:{OF})?{name}\s*\)\s*$",
        rf"\s+{OF}{name}\s*$",
        rf"(?<=[^\W\d])\s+(?P<name>{long})\s*$",
    )
    behind = next(filter(None, (re.search(way, piece, re.IGNORECASE) for way in ways)), None)
    return f"{behind['name']} = {piece[: behind.start()]}" if behind else piece


def _unwrapped(normalized: str) -> tuple[str, str, str]:
    """What stands in the outer brackets, the unit behind them, and a factor before them; the whole text without brackets."""
    text = normalized.strip()
    start = next((place for place, sign in enumerate(text) if sign in BRACKETS), -1)
    if start < 0:
        return text, "", ""
    depth, end = 0, len(text)
    for place in range(start, len(text)):
        depth += (text[place] in BRACKETS) - (text[place] in BRACKETS.values())
        if depth == 0:
            end = place
            break
    inside, behind, before = text[start + 1 : end], text[end + 1 :].strip(), text[:start].strip()
    if (
        not (re.search(r"[;,|\s]", _masked(inside)) or ALONG.search(inside))
        or re.match(r"[0-9,;+\-]", behind)
        or re.search(r"[,;]", before)
    ):
        return text, "", ""
    scaled = FACTOR.fullmatch(before)
    if before and (
        (behind and not scaled)
        or re.search(r"[A-Za-z]{3}$|[=:]", before)
        or not re.search("[,;]", _masked(inside))
    ):
        return text, "", ""
    return inside, behind.lstrip("*").strip(), before.rstrip("* ")


def _masked(text: str) -> str:
    """The text with what stands in brackets made invisible to a comma's search."""
    depth, seen = 0, list[str]()
    for sign in text:
        depth += sign in "(["
        seen.append("_" if depth else sign)
        depth -= sign in ")]" and depth > 0
    return "".join(seen)


def _split(text: str, mark: str) -> list[str]:
    pieces, start = list[str](), 0
    for found in re.finditer(mark, _masked(text)):
        pieces.append(text[start : found.start()])
        start = found.end()
    return [*pieces, text[start:]]


def _listed(inside: str, unit: str, count: int, expected: Unit | None) -> list[str] | ParseError:
    tries = MARKS[:1] if re.search(r"[;|]", _masked(inside)) else MARKS[1:]
    splits = [_split(inside, mark) for mark in tries]
    pieces = next((pieces for pieces in splits if len(pieces) == count), None)
    commas = re.findall(r"[0-9],[0-9]", inside)
    if pieces is None and ";" not in inside and commas and any(len(each) == 2 * count for each in splits):
        return ambiguous(
            _("the commas can part the components or be decimal commas"), 0, "(1.5; 2.5)", "(1,5; 2,5)"
        )
    if pieces is None:
        return _other_count(max(map(len, splits)) if re.search("[0-9]", inside) else 0, count, expected)
    behind = re.fullmatch(
        r"[^A-Za-z°%]*?((?:(?<=\s)1\s*/\s*|(?<=[0-9])\s*/\s*)?[A-Za-z°%].*)", pieces[-1].strip()
    )
    alone = not re.search(r"[^\W\d_]|[°º%‰]", "".join(pieces[:-1]).replace("e", ""))
    # In `(0, m*v)` what stands behind is a formula, and belongs to its own component alone.
    if not unit and behind and alone and _is_unit(behind[1]):
        pieces[-1], unit = (
            pieces[-1].strip().removesuffix(behind[1]),
            behind[1],
        )  # `3; 4 m/s`: one unit for all
        if (doubt := _of_the_last_alone(pieces, unit, expected)) is not None:
            return doubt
    return [f"{piece.strip()} {unit}".strip() for piece in pieces]


def _other_count(given: int, count: int, expected: Unit | None) -> ParseError:
    """What is said of as many components as are given, where others are asked for; 0 where none is told."""
    unit = show(expected) if expected is not None else "m/s"
    numbers = "; ".join(str(place + 3) for place in range(count))
    why = (
        _("{count} components are expected, not {given}", count=count, given=given)
        if given not in (0, count)
        else _("{count} components are expected", count=count)
    )
    return refused(why, None, _("write them as {example}", example=f"({numbers}) {unit}".strip()))


def _of_the_last_alone(pieces: Sequence[str], unit: str, expected: Unit | None) -> ParseError | None:
    """What is asked about `0.894, 1306 mm` where metres are asked for: only with a unit of its own the last is of the others' size."""
    found = read_unit(unit)
    if expected is None or isinstance(found, ParseError) or found.dimension != expected.dimension:
        return None
    read = [scan_number(piece) for piece in pieces]
    sizes = [abs(float(each[0].value)) for each in read if not isinstance(each, ParseError) and each[0].value]
    if len(sizes) < 2 or len(sizes) < len(pieces) or found.si == expected.si:
        return None
    *others, last = sizes
    together = max(sizes) / min(sizes)
    last *= found.si / expected.si
    if max(*others, last) / min(*others, last) * APART > together:
        return None
    bare, asked = [piece.strip() for piece in pieces], show(expected)
    choices = tuple(
        f"({'; '.join(f'{piece} {each}' for piece in bare[:-1])}; {bare[-1]} {unit})"
        for each in (unit, asked)
    )
    why = _("{unit} stands behind the last number only", unit=unit)
    return ambiguous(why, None, *choices)


def _is_unit(text: str) -> bool:
    """Whether it is read as a unit, or may be one."""
    found = read_unit(text)
    return not isinstance(found, ParseError) or found.status == "asked"


def _in_order(pieces: list[str], names: Sequence[str], question: Question | None) -> list[str] | ParseError:
    """`p_y = 4, p_x = 3` in the order asked for; pieces that do not all name a component stay as they are."""
    placed: dict[int, str] = {}
    labels = [label["name"] for piece in pieces if (label := NAMED.match(piece))]
    for piece in pieces:
        place = place_named(piece, names)
        if place is None and placed and len(labels) == len(pieces):
            which = next(label for label in labels if place_named(f"{label} = ", names) is None)
            why = _("{component} is none of the components {names}", component=which, names=", ".join(names))
            return ParseError("asked", why, None, _("write them as (3; 4) m/s"))
        if place is None:
            return pieces
        if (
            (label := NAMED.match(piece))
            and label["name"] not in names
            and not is_name(label["name"], question)
        ):
            return _no_name(label["name"])
        if place in placed:
            return refused(_("{component} is given twice", component=names[place]))
        placed[place] = (
            NAMED.sub("", piece, count=1).strip() if NAMED.match(piece) else piece[: piece.rindex(" ")]
        )
    return [placed[place] for place in range(len(pieces))] if len(placed) == len(names) else pieces


def place_named(piece: str, names: Sequence[str]) -> int | None:
    """Which component a text says it is: `p_x = 3`, `x: 3`, `3 unknowns`; None when it does not say."""
    label = NAMED.match(piece)
    label_text = label["name"] if label else piece.rpartition(" ")[2]
    ascii_name = re.sub(r"[^A-Za-z0-9]", "", label_text)
    exact = [
        place
        for place, name in enumerate(names)
        if ascii_name.lower() == name.lower() and (label or len(name) > 2)
    ]
    near = [
        place
        for place, name in enumerate(names)
        if ascii_name.endswith(name) and 0 < len(ascii_name) - len(name) <= 2
    ]
    found = exact or (sorted(near, key=lambda place: -len(names[place])) if label else [])
    return found[0] if found else None


def _axis(found: re.Match[str]) -> int:
    return DIRECTIONS[(found["letter"] or found["last"]).replace("_", "")]


def _directed(inside: str, unit: str, count: int) -> list[str] | ParseError:
    """`3 i - 4 j` cut at its directions, each with a unit of its own behind it or none; a direction left out is 0."""
    if count == 2 and (doubt := _half_directed(inside, unit)) is not None:
        return doubt
    components, own = dict[int, str](), list[str]()
    at = 0
    for found in ALONG.finditer(inside):
        behind, piece = (
            _after_unit(inside[at : found.start()]) if components else ("", inside[at : found.start()])
        )
        own += [behind] if components else []
        piece = re.sub(r"^\s*([+-]?)\s*", r"\1", piece).strip().rstrip("*").strip()
        axis = _axis(found)
        if axis in components or axis >= count:
            return refused(
                _("{direction} does not belong here", direction=found[0].strip()),
                None,
                _("write one term for each direction, such as 3 i + 4 j"),
            )
        components[axis] = piece + "1" if piece in ("", "+", "-") else piece
        at = found.end()
    last = inside[at:].strip()
    if any(own):
        components = {
            axis: f"{piece} {behind}".strip()
            for (axis, piece), behind in zip(components.items(), (*own, last), strict=True)
        }
        last = ""
    unit = unit or last
    units = [re.sub(r"^[+-]?[0-9.,e ]*", "", piece) for piece in components.values()] if not unit else [unit]
    missing = f"0 {units[0]}".strip()
    return [f"{components[axis]} {unit}".strip() if axis in components else missing for axis in range(count)]


def _half_directed(inside: str, unit: str) -> ParseError | None:
    """What is asked about `3 + (-4) j`, `3 m/s - 4 j`, `-4 j + 3`: one of two terms has a direction."""
    places = list(BETWEEN_TERMS.finditer(_masked(inside)))
    if len(places) != 1:
        return None
    parts = inside[: places[0].start()], inside[places[0].end() :]
    along = [ALONG.search(part) for part in parts]
    terms = [
        TERM.fullmatch(part[: way.start()] + part[way.end() :] if way else part)
        for part, way in zip(parts, along, strict=True)
    ]
    (way,) = [found for found in along if found] if sum(map(bool, along)) == 1 else [None]
    if way is None or _axis(way) > 1 or not all(terms):
        return None
    written = [
        f"{'-' if (term['sign'] == '-') != (term['own'] == '-') else ''}{term['number']} {term['unit']}".strip()
        for term in terms
        if term
    ]
    shared = unit or next((term["unit"] for term in terms if term and term["unit"].strip()), "")
    whole = [
        each if term and term["unit"].strip() else f"{each} {shared}".strip()
        for each, term in zip(written, terms, strict=True)
    ]
    directed = 0 if along[0] else 1
    choice = f"({'; '.join(whole if directed == _axis(way) else whole[::-1])})"
    why = _("one term has a direction and another has none")
    return ambiguous(why, None, choice)


def _after_unit(text: str) -> tuple[str, str]:
    """The unit of the component before and the next one, with one sign: ` m/s + -4.7` between two directions."""
    for sign in reversed(list(re.finditer(r"(?<!\^)[+-]", text))):
        unit = text[: sign.start()].strip()
        if not unit or _is_unit(unit):
            rest = text[sign.end() :].strip()
            if rest[:1] in ("+", "-"):
                minus = (sign[0] == "-") != (rest[0] == "-")
                return unit, ("-" if minus else "") + rest[1:].strip()
            return unit, sign[0] + rest
    return "", text


def without_preamble(normalized: str) -> Bare:
    """A vector without what leads up to it, and its left sides; names of its components stay."""
    if (
        not LEFT.match(normalized)
        and (chain := CHAIN.fullmatch(normalized))
        and not re.search("[,;]", _masked(chain["before"]))
    ):
        sides = tuple(side.strip() for side in chain["before"].split("="))
        return Bare(chain["last"], chain.start("last"), sides)
    led = LED.match(normalized)
    if led and led.end() < len(normalized):
        rest = without_preamble(normalized[led.end() :])
        side = led[0].strip().rstrip("=≈~").strip()
        return Bare(rest.text, rest.skipped + led.end(), (side, *rest.sides) if side else rest.sides)
    return (
        Bare(normalized, 0, ())
        if re.search("[,;]", normalized.split("=")[0])
        or len(re.findall(r"[=:]", normalized)) > 1
        or _labels(normalized)
        else answer_in(normalized)
    )


def unread_side(
    sides: Sequence[str], names: Sequence[str], question: Question | None = None, last: str = ""
) -> ParseError | None:
    """What is asked about a left side of a vector that is no name of it: `-p = (3; 4)`, `|p| = (3; 4)`. A formula of the question's
    kind is none of those, nor a multiple of a vector that comes to the `last` side, as `2*(3, 4) = (6, 8)`."""
    for side in sides:
        if (
            _comes_to(side, last)
            or _names_in_order(side, names)
            or (question is not None and _is_formula(side, question))
        ):
            continue
        size = side.strip().startswith("|")
        named = is_name(side, question) or is_talk(side, question)
        if size or not (named or place_named(f"{side} = ", names) is not None):
            return _no_name(side.strip())
    return None


def _comes_to(side: str, last: str) -> bool:
    """True for a multiple of a vector in numbers whose components are those of the last side."""
    scaled = SCALED.fullmatch(side.strip())
    if scaled is None:
        return False
    factor = scan_number(scaled["factor"])
    inside = [scan_number(piece.strip()) for piece in re.split(r"[;,]", scaled["inside"])]
    behind = [scan_number(piece) for piece in re.findall(r"[-+]?[0-9.]*[0-9]", last)]
    if isinstance(factor, ParseError) or len(inside) != len(behind):
        return False
    return all(
        not isinstance(one, ParseError)
        and not isinstance(other, ParseError)
        and math.isclose(float(factor[0].value * one[0].value), float(other[0].value), rel_tol=0.01)
        for one, other in zip(inside, behind, strict=True)
    )


def _names_in_order(side: str, names: Sequence[str]) -> bool:
    """True for `(p_x, p_y)`, the components by name."""
    inside = re.fullmatch(r"\s*[(\[]([^()\[\]]*)[)\]]\s*", side)
    places = (
        [place_named(f"{name.strip()} = ", names) for name in re.split(r"[,;]", inside[1])] if inside else []
    )
    return bool(names) and places == list(range(len(names)))


def _is_formula(side: str, question: Question) -> bool:
    """True for a product or a quotient in customary letters of what is asked for: `p/m` where a velocity is."""
    return gives_what_is_asked(side, question.unit.dimension, question) is not False


def _no_name(side: str) -> ParseError:
    why = _("{side} stands on the left, not the answer alone", side=side)
    return ParseError("asked", why, None, _("write the components alone"))


def _labels(normalized: str) -> bool:
    return (
        len([piece for piece in re.split(r"[;,]|\b(?:and|und|og|et)\b", normalized) if NAMED.match(piece)])
        > 1
    )
