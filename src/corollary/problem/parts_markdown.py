"""The Markdown below the front matter: the statement, then one heading with attributes for each part."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

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
KNOWN = {"unit", "points", "components", "function", "letter", "slope"}


def read_parts(
    path: Path, body: str, first_line: int, complaints: list[Diagnostic]
) -> tuple[str, tuple[Part, ...]]:
    """The statement and the parts; what is wrong is added to the complaints."""
    chunks: list[tuple[int, str, list[str]]] = [(first_line, "", [])]
    fenced = False
    for line, text in enumerate(body.splitlines(), first_line):
        fenced ^= text.lstrip().startswith("```")
        if text.startswith("## ") and not fenced:
            chunks.append((line, text, []))
        else:
            chunks[-1][2].append(text)
    parts: list[Part] = []
    for line, heading, lines in chunks[1:]:
        part = _part(path, line, heading, lines, complaints)
        if part is None:
            continue
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
    return "\n".join(chunks[0][2]).strip(), tuple(parts)


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
        complain(f"part {ids[0]} has an unknown attribute {name}; known are {', '.join(sorted(KNOWN))}")
    measured_in = _unit(settings.get("unit", "1"), ids[0], complain)
    points = _points(settings.get("points", "1"), ids[0], complain)
    options, text = _options(lines)
    if len({option.letter for option in options}) != len(options):
        complain(f"part {ids[0]} lists an option letter twice")
    return Part(
        ids[0],
        match["title"],
        text,
        tuple(sorted(answer_types)),  # `.plot .code` is `.code .plot`
        measured_in,
        points,
        tuple(settings.get("components", "").split()),
        options,
        settings.get("function", ""),
        line,
        lettered=settings.get("letter", ""),
        slope=settings.get("slope", ""),
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


def _unit(text: str, part: str, complain: Complain) -> Unit:
    try:
        return unit(text)
    except ValueError as error:
        complain(f"unit of part {part}: {error}")
        return unit("1")


def _points(text: str, part: str, complain: Complain) -> float:
    try:
        points = float(text)
    except ValueError:
        points = -1.0
    if not 0 <= points <= 1000:
        complain(f"part {part} has points={text}; give a number from 0 to 1000")
        return 0.0
    return points
