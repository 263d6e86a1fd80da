"""Writes docs/first_page.svg, the README's picture: a problem, an answer that is wrong, what its student reads, and where the key is from.

`python .ci/first_page.py` writes it, `--check` says whether it is up to date (a test asks). It is 390 wide, as a phone is.
"""

from __future__ import annotations

import re
import sys
import textwrap
from html import escape

from reference_page import written

import corollary
from corollary.api import variant
from corollary.grading.key_record import key_record
from corollary.problem.figure import drawn

CODE, PART, TYPED = "X12.5", "d", "130 N"
GIVEN = {"m": "0.37 kg", "v": "24.5 m/s", "w": "13.0 m/s", "dt": "0.07 s"}
ASKED = (  # the statement and part (d), with the words that the numbers need
    "A football of mass {m} rolls towards you at {w}. You kick it straight back: your foot touches it for {dt}, "
    "and it leaves at {v}. What is the average force on the ball?"
)
WIDE, EDGE, SIZE, LEAD = 390, 20, 15, 21
COLUMNS = 44  # letters in a line of this size
NBSP = "\N{NO-BREAK SPACE}"
INK, PAPER = "#1b1f24", "#ffffff"
DARK = "<style>@media (prefers-color-scheme: dark) { svg:root { filter: invert(.9) hue-rotate(180deg) } }</style>"
BARS = {"asked": "#0969da", "typed": "#57606a", "read": "#bc4c00", "key": "#1a7f37"}


def figure(svg: str, top: float) -> tuple[str, float]:
    """The right panel of a drawing as wide as the picture allows, and its height."""
    (width, height) = map(float, re.findall(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg)[0])
    cut = float(re.findall(r'd="M([\d.]+) 4V', svg)[0]) + 1
    inside = re.sub(r"^<svg[^>]*>|</svg>$", "", svg)
    scale = min(1.0, (WIDE - 2 * EDGE) / (width - cut))
    tall = height * scale
    opening = (
        f'<svg x="{EDGE}" y="{top:g}" width="{(width - cut) * scale:.1f}" height="{tall:.1f}" '
        f'viewBox="{cut:g} 0 {width - cut:g} {height:g}" font-family="sans-serif" font-size="15">'
    )
    return f"{opening}{inside}</svg>", tall


def block(kind: str, title: str, text: str, top: float, *, typed: bool = False) -> tuple[list[str], float]:
    """A titled text with a bar beside it, and where it ends."""
    lines = textwrap.wrap(text, COLUMNS)
    end = top + LEAD * (len(lines) + 1) + 4
    family = ' font-family="monospace"' if typed else ""
    return [
        f'<path d="M{EDGE - 10} {top + 4:g}V{end:g}" stroke="{BARS[kind]}" stroke-width="4"/>',
        f'<text x="{EDGE}" y="{top + 16:g}" font-size="13" font-weight="bold" fill="{BARS[kind]}">{escape(title)}</text>',
        *(
            f'<text x="{EDGE}" y="{top + 16 + LEAD * number:g}"{family}>{escape(line)}</text>'
            for number, line in enumerate(lines, start=1)
        ),
    ], end


def picture() -> str:
    """Raises AssertionError where the package no longer says what the picture is about."""
    problem = corollary.load_bank()[CODE]
    grade = corollary.judge(problem, {PART: TYPED}, GIVEN)
    (part,) = (each for each in grade.parts if each.part.id == PART)
    key = corollary.key(problem, **GIVEN)
    found = key_record(key.solution, key.variant)["parts"][PART]
    assert found["certified"], found
    follows = (
        f"follows from the laws: F = {found['expression']} = {found['value']:.4g}{NBSP}N, certified".replace(
            "dt", "Δt"
        )
    )
    follows = follows.replace("*(", "(")
    assert 0 < part.points < part.out_of, part
    body, top = list[str](), 12.0
    lines, top = block(
        "asked",
        "THE PROBLEM, with numbers for each student",
        ASKED.format(**{name: value.replace(" ", NBSP) for name, value in GIVEN.items()}),
        top,
    )
    drawing, tall = figure(drawn(variant(problem, GIVEN)).svg, top + 8)
    body += [*lines, drawing]
    for kind, title, text in (
        ("typed", "A STUDENT TYPES", f'"{TYPED}"'),
        ("read", f"THE STUDENT READS, with {part.points:g} of {part.out_of:g} points", part.feedback),
        ("key", "THE KEY, which nobody typed in", follows),
    ):
        lines, top = block(
            kind, title, text, top + (tall + 20 if kind == "typed" else 14), typed=kind == "typed"
        )
        body += lines
    height = top + 14
    return "".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDE}" height="{height:g}" viewBox="0 0 {WIDE} {height:g}" '
            f'font-family="sans-serif" font-size="{SIZE}" fill="{INK}" role="img">\n',
            f"{DARK}\n",
            f'<rect x="0.5" y="0.5" width="{WIDE - 1}" height="{height - 1:g}" rx="8" fill="{PAPER}" stroke="#d0d7de"/>\n',
            *(f"{line}\n" for line in body),
            "</svg>\n",
        ]
    )


if __name__ == "__main__":
    sys.exit(written("first_page.svg", picture(), sys.argv[1:]))
