"""The heading of a step: the parts that it answers, and the letters that it finds."""

from __future__ import annotations

import re
from dataclasses import dataclass

from corollary.derive.markdown_items import MarkdownError, Section

TITLE = re.compile(
    r"(?:\((?P<parts>\w+(?:\s*,\s*\w+)*)\)\s*)?(?P<letters>[^:;()]*?)(?::\s*(?P<meaning>.*))?$"
)
FUNCTION = re.compile(r"\b([A-Za-z]\w*)\(([A-Za-z]\w*)\)")
LETTERS = re.compile(r"[A-Za-z]\w*(?:\s*,\s*[A-Za-z]\w*)*$")
CASE = re.compile(r"[Cc]ase:?\s+(?P<text>.*?),?\s+(?:if|when)\s+`(?P<condition>[^`]+)`$")
CHECKS = "Checks"


@dataclass(frozen=True, slots=True)
class StepHeading:
    """`answers` are the letters that answer each part, where one step answers several; `part` is the only one otherwise. `functions`
    are those of the letters that stand with what they depend on, U(t), each with that."""

    part: str = ""
    letters: tuple[str, ...] = ()
    meaning: str = ""
    answers: tuple[tuple[str, tuple[str, ...]], ...] = ()
    functions: tuple[tuple[str, str], ...] = ()


def step_heading(section: Section) -> StepHeading:
    """`(a) v`, `v: speed`, `(a, b) F_1, F_2`, `(a) v_x, v_y; (b) T; N`, `(a) U(t)`. Raises MarkdownError."""
    if CASE.match(section.title) or section.title == CHECKS:
        return StepHeading()
    before, colon, meaning = section.title.partition(":")
    functions = tuple(FUNCTION.findall(before))
    pieces = FUNCTION.sub(r"\1", before).split(";")
    whole = TITLE.match(pieces[-1].strip() + colon + meaning)
    found = [*map(TITLE.match, map(str.strip, pieces[:-1])), whole]
    answers: list[tuple[str, tuple[str, ...]]] = []
    for each in found:
        text = each["letters"].strip().replace("`", "") if each else ""
        odd = each is None or (text and not LETTERS.match(text)) or text.casefold() in ("case", "check")
        if odd or each is None or ((each["meaning"] or len(found) > 1) and not text):
            raise MarkdownError(
                section.line,
                f"a heading is a part in brackets and the unknowns that are found, such as (a) v, (a, b) v_A, v_B or "
                f"(a) v_x, v_y; (b) T; a case, such as Case: it rests, if `F <= mu*N`; or {CHECKS}; this is {section.title!r}",
            )
        letters = tuple(one.strip() for one in text.split(",") if one)
        parts = [one.strip() for one in (each["parts"] or "").split(",")]
        if len(parts) == 1:
            answers.append((parts[0], letters))
        elif len(parts) == len(letters):
            answers += [(part, (letter,)) for part, letter in zip(parts, letters, strict=True)]
        else:
            raise MarkdownError(
                section.line,
                f"{len(parts)} parts are answered, and {len(letters)} letters are found: name one for each, as in (a, b) F_1, F_2, "
                "or part them by semicolons, as in (a) v_x, v_y; (b) T",
            )
    every = tuple(letter for _part, letters in answers for letter in letters)
    meaning = (whole["meaning"] if whole else "") or ""
    if len(answers) == 1:
        return StepHeading(answers[0][0], every, meaning, functions=functions)
    return StepHeading("", every, meaning, tuple(each for each in answers if each[0]), functions)
