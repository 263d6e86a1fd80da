"""The Markdown below the front matter: the statement, then one heading with attributes for each part."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path

from corollary.messages import did_you_mean
from corollary.problem.diagnostic import Diagnostic
from corollary.problem.part import Option, Part
from corollary.units.unit import Unit, unit

HEADING = re.compile(r"""##\s+(?P<title>.*?)\s*(?:\{(?P<attributes>(?:[^{}"]|"[^"]*")*)\})?\s*$""")
ATTRIBUTE = re.compile(
    r"""\#(?P<id>[\w-]+)|\.(?P<type>\w+)|(?P<name>\w+)=(?:"(?P<quoted>[^"]*)"|(?P<bare>[^\s"]+))"""
)
OPTION = re.compile(r"-\s+\((?P<letter>[a-zA-Z])\)\s+(?P<text>.+)")
ID = re.compile(r"[a-z][a-z0-9_]*$")
Complain = Callable[[str], None]
EXPECTED = "expected"  # of all attributes the one that no student may read
KNOWN = {
    "unit", "points", "components", "function", "letter", "slope", "rows", "columns", "tolerance", "because", "plausible", "hint", "given", "of",
    EXPECTED,
}  # fmt: skip
SHARE = re.compile(r"\s*(\d+(?:\.\d+)?)\s*%\s*")
SMALLEST, LARGEST = 1, 20  # per cent, of a tolerance of a part's own
NUMBER = r"\s*([-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d{1,2})?)\s*"
RANGE = re.compile(f"{NUMBER}to{NUMBER}")
MOST_ENTRIES = 40  # of a table


def read_parts(
    path: Path, body: str, first_line: int, complaints: list[Diagnostic]
) -> tuple[str, tuple[Part, ...], tuple[tuple[str, str], ...]]:
    """The statement, the parts, and by part the answer that the author expects; what is wrong is added to the complaints."""
    chunks: list[tuple[int, str, list[str]]] = [(first_line, "", [])]
    fenced = False
    for line, text in enumerate(body.splitlines(), first_line):
        fenced ^= text.lstrip().startswith("```")
        if text.startswith("## ") and not fenced:
            chunks.append((line, text, []))
        else:
            chunks[-1][2].append(text)
    parts: list[Part] = []
    expected: dict[str, str] = {}
    for line, heading, lines in chunks[1:]:
        part = _part(path, line, heading, lines, complaints)
        if part is None:
            continue
        if (answer := _expected(heading)) is not None:
            expected[part.id] = answer
            if not answer.strip():
                sentence = f'part {part.id} has expected=""; say about what you expect: expected="about 40 s"'
                complaints.append(Diagnostic(path, line, sentence))
        if any(part.id == other.id for other in parts):
            complaints.append(
                Diagnostic(path, line, f"part {part.id} occurs twice; every part needs an id of its own")
            )
        parts.append(part)
    for part in parts:
        if part.lettered and any(
            part.heading_letter == other.heading_letter for other in parts if other is not part
        ):
            complaints.append(
                Diagnostic(
                    path,
                    part.line,
                    f"two parts are lettered {part.lettered}; their answers would have one name",
                )
            )
    return "\n".join(chunks[0][2]).strip(), tuple(parts), tuple(expected.items())


def _expected(heading: str) -> str | None:
    """The answer that the author expects, as it stands in a heading; None where it does not."""
    match = HEADING.match(heading)
    found = ATTRIBUTE.finditer((match["attributes"] if match else None) or "")
    texts = [
        each["quoted"] if each["quoted"] is not None else each["bare"]
        for each in found
        if each["name"] == EXPECTED
    ]
    return texts[-1] if texts else None


def without_expected(text: str) -> str:
    """The text of a problem's file without the answers that its author expects: what may be handed out."""
    return "".join(map(_without_expected, text.splitlines(keepends=True)))


def _without_expected(line: str) -> str:
    match = HEADING.match(line) if line.startswith("## ") else None
    if match is None or match["attributes"] is None:
        return line
    start, end = match.span("attributes")
    places = [each.span() for each in ATTRIBUTE.finditer(line, start, end) if each["name"] == EXPECTED]
    for first, last in reversed(places):
        before = line[:first].rstrip(" ") if line[last] in " }" else line[:first]
        line = before + line[last:]
    return line


def _part(path: Path, line: int, heading: str, lines: list[str], complaints: list[Diagnostic]) -> Part | None:
    def complain(sentence: str) -> None:
        complaints.append(Diagnostic(path, line, sentence))

    match = HEADING.match(heading)
    if match is None or match["attributes"] is None:
        complain('a part needs attributes: ## Title {#a .value unit="kg m/s" points=1}')
        return None
    ids: list[str] = []
    answer_types: list[str] = []
    settings: dict[str, str] = {}
    for attribute in ATTRIBUTE.finditer(match["attributes"]):
        if attribute["id"]:
            ids.append(attribute["id"])
        elif attribute["type"]:
            answer_types.append(attribute["type"])
        else:
            settings[attribute["name"]] = (
                attribute["quoted"] if attribute["quoted"] is not None else attribute["bare"]
            )
    if left := ATTRIBUTE.sub("", match["attributes"]).strip():
        complain(f'cannot read {left!r} among the attributes; use #id, .kind and name="value"')
    if len(ids) != 1 or not ID.match(ids[0]):
        complain("a part needs one id of small letters and digits, such as #a or #c2")
        return None
    for name in settings.keys() - KNOWN:
        hint, known = did_you_mean(name, KNOWN), ", ".join(sorted(KNOWN))
        complain(f"part {ids[0]} has an unknown attribute {name}{hint}; known are {known}")
    rows, columns = (_labels(settings.get(side, "")) for side in ("rows", "columns"))
    if bool(rows) != bool(columns) or len(rows) * len(columns) > MOST_ENTRIES:
        complain(f"part {ids[0]}: a table has rows= and columns=, and at most {MOST_ENTRIES} entries in all")
    if len({*rows}) != len(rows) or len({*columns}) != len(columns):
        complain(f"part {ids[0]}: two rows, or two columns, have one label")
    units = _units(settings.get("unit", "1"), columns, ids[0], complain)
    points = _points(settings.get("points", "1"), ids[0], complain)
    options, text = _options(lines)
    if len({option.letter for option in options}) != len(options):
        complain(f"part {ids[0]} lists an option letter twice")
    return Part(
        ids[0],
        match["title"],
        text,
        tuple(sorted(answer_types)),  # `.plot .code` is `.code .plot`
        units[0] if len(set(units)) == 1 else unit("1"),
        points,
        tuple(settings.get("components", "").split()) or entries(rows, columns),
        options,
        settings.get("function", ""),
        line,
        lettered=settings.get("letter", ""),
        slope=settings.get("slope", ""),
        rows=rows,
        columns=columns,
        column_units=units if len(set(units)) > 1 else (),
        tolerance=_tolerance(settings, ids[0], complain),
        because=settings.get("because", ""),
        plausible=_plausible(settings, ids[0], complain),
        hint=_hint(settings.get("hint", ""), ids[0], complain),
        given=settings.get("given", ""),
        of=tuple(settings.get("of", "").replace(",", " ").split()),
    )


def _options(lines: list[str]) -> tuple[tuple[Option, ...], str]:
    options: list[Option] = []
    rest: list[str] = []
    for line in lines:
        if match := OPTION.match(line.strip()):
            options.append(Option(match["letter"].lower(), match["text"]))
        else:
            rest.append(line)
    return tuple(options), "\n".join(rest).strip()


def entries(rows: tuple[str, ...], columns: tuple[str, ...]) -> tuple[str, ...]:
    """The names of a table's entries, row by row."""
    return tuple(f"{row}, {column}" for row in rows for column in columns)


def _labels(text: str) -> tuple[str, ...]:
    """The labels of rows or columns, parted by commas or else by spaces; of a number as many, counted from 1."""
    if text.strip().isdecimal():
        return tuple(str(place + 1) for place in range(min(int(text), MOST_ENTRIES + 1)))
    return tuple(label.strip() for label in (text.split(",") if "," in text else text.split()))


def _units(text: str, columns: tuple[str, ...], part: str, complain: Complain) -> tuple[Unit, ...]:
    """The unit of the part; of a table one for all of its columns, or one for each."""
    if not columns or "," not in text:
        return (_unit(text, part, complain),)
    found = tuple(_unit(each.strip() or "1", part, complain) for each in text.split(","))
    if len(found) != len(columns):
        complain(
            f"part {part} has {len(columns)} columns and {len(found)} units; give one for all of them, or one for each, parted by commas"
        )
        return found[:1]
    return found


def _unit(text: str, part: str, complain: Complain) -> Unit:
    try:
        return unit(text)
    except ValueError as error:
        complain(f"unit of part {part}: {error}")
        return unit("1")


def _tolerance(settings: Mapping[str, str], part: str, complain: Complain) -> float:
    """The share of an answer that it may be off for a reason of the author's; 0 where there is none."""
    text, because = settings.get("tolerance", ""), settings.get("because", "")
    if not text and not because:
        return 0.0
    share = SHARE.fullmatch(text)
    if share is None or not because or not SMALLEST <= float(share[1]) <= LARGEST:
        complain(
            f'part {part} has tolerance="{text}" and because="{because}"; say a share from {SMALLEST} % to {LARGEST} %, and why: '
            'tolerance="5 %" because="it is read off a diagram"'
        )
        return 0.0
    return float(share[1]) / 100


def _plausible(settings: Mapping[str, str], part: str, complain: Complain) -> tuple[float, ...]:
    """From where to where answers may lie, in the unit of the part; empty where that is left out."""
    if "plausible" not in settings:
        return ()
    ends = RANGE.fullmatch(settings["plausible"])
    if ends is None or not float(ends[1]) < float(ends[2]):
        complain(
            f'part {part} has plausible="{settings["plausible"]}"; say from where to where, in the unit of the part: plausible="0.1 to 30"'
        )
        return ()
    return float(ends[1]), float(ends[2])


def _hint(text: str, part: str, complain: Complain) -> str:
    if "{{" in text:
        complain(f"the hint of part {part} has a hole; a hint is the same for all numbers")
    return text


def _points(text: str, part: str, complain: Complain) -> float:
    try:
        points = float(text)
    except ValueError:
        points = -1.0
    if not 0 <= points <= 1000:
        complain(f"part {part} has points={text}; give a number from 0 to 1000")
        return 0.0
    return points
