"""The Markdown below the front matter: the statement, then one heading with attributes for each part."""

from __future__ import annotations

import re
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic
from corollary.problem.part import KIND_NAMES, KindName, Option, Part
from corollary.units.unit import Unit, unit

HEADING = re.compile(r"""##\s+(?P<title>.*?)\s*(?:\{(?P<attributes>(?:[^{}"]|"[^"]*")*)\})?\s*$""")
ATTRIBUTE = re.compile(
    r"""\#(?P<id>[\w-]+)|\.(?P<kind>\w+)|(?P<name>\w+)=(?:"(?P<quoted>[^"]*)"|(?P<bare>[^\s"]+))"""
)
OPTION = re.compile(r"-\s+\((?P<letter>[a-z])\)\s+(?P<text>.+)")
ID = re.compile(r"[a-z][a-z0-9_]*$")
KNOWN = {"unit", "points", "components", "function"}


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
    return "\n".join(chunks[0][2]).strip(), tuple(parts)


def _part(path: Path, line: int, heading: str, lines: list[str], complaints: list[Diagnostic]) -> Part | None:
    def complain(sentence: str, at: int = line) -> None:
        complaints.append(Diagnostic(path, at, sentence))

    match = HEADING.match(heading)
    if match is None or match["attributes"] is None:
        complain('a part needs attributes: ## Title {#a .value unit="kg m/s" points=1}')
        return None
    ids, kinds, settings = [], [], {}
    for attribute in ATTRIBUTE.finditer(match["attributes"]):
        if attribute["id"]:
            ids.append(attribute["id"])
        elif attribute["kind"]:
            kinds.append(attribute["kind"])
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
    known: list[KindName] = [kind for kind in KIND_NAMES if kind in kinds]
    if len(known) != len(kinds) or not known or (len(known) > 1 and known != ["code", "plot"]):
        complain(
            f"part {ids[0]} needs one kind of {', '.join('.' + kind for kind in KIND_NAMES)} (or .code .plot together)"
        )
        return None
    measured_in = _unit(settings.get("unit", "1"), ids[0], complain)
    points = _points(settings.get("points", "1"), ids[0], complain)
    components = tuple(settings.get("components", "").split())
    if components and known[0] not in {"vector", "example", "expression", "proof"}:
        complain(f"part {ids[0]}: only .vector, .example, .expression and .proof parts have components")
    if not components and known[0] == "vector":
        complain(f'part {ids[0]} is a vector; name its components: components="x y"')
    signature = settings.get("function", "")
    if ("code" in known) != bool(signature) or (
        signature and not re.match(r"[A-Za-z_]\w*\([\w\s,]*\)$", signature)
    ):
        complain(f'part {ids[0]}: a .code part, and only that, has a function="name(arguments)"')
    options, text = _options(lines)
    if len(options) < 2 if "choice" in known else options:
        complain(f"part {ids[0]}: a .choice part, and only that, lists options, each as: - (a) text")
    if len({option.letter for option in options}) != len(options):
        complain(f"part {ids[0]} lists an option letter twice")
    return Part(
        ids[0], match["title"], text, tuple(known), measured_in, points, components, options, signature, line
    )


def _options(lines: list[str]) -> tuple[tuple[Option, ...], str]:
    options, rest = [], []
    for line in lines:
        if match := OPTION.match(line.strip()):
            options.append(Option(match["letter"], match["text"]))
        else:
            rest.append(line)
    return tuple(options), "\n".join(rest).strip()


def _unit(text: str, part: str, complain) -> Unit:
    try:
        return unit(text)
    except ValueError as error:
        complain(f"unit of part {part}: {error}")
        return unit("1")


def _points(text: str, part: str, complain) -> float:
    try:
        points = float(text)
    except ValueError:
        points = -1.0
    if not 0 <= points <= 1000:
        complain(f"part {part} has points={text}; give a number from 0 to 1000")
        return 0.0
    return points
