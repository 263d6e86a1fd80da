"""The texts of a problem that a student reads, with the place of each in its file."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from corollary.answers.registry import UnknownAnswerType, answer_type
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.figure import is_svg
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.statement import HOLE
from corollary.problem.translation import LABEL, ProblemTranslation

UNREAD = re.compile(
    r"```.*?```|~~~.*?~~~|`[^`\n]+`|!\[[^\]\n]*\]\([^)\n]*\)|\]\([^)\n]*\)|https?://\S+|<[A-Za-z/!][^<>\n]*>",
    re.DOTALL,
)
"""Code, pictures, addresses and tags."""
BLANK = "\N{WHITE SQUARE}"
INLINE = "\N{WORD JOINER}"
"""Before what TeX sets upright: in a formula a unit, where letters alone would be a product."""
SIUNITX = re.compile(r"\\(?:SI|qty)\s*(?:\[[^\]]*\])?\{([^{}]*)\}\{([^{}]*)\}")
UPRIGHT = re.compile(
    r"\\(?:mathrm|text|textrm|mathsf|mathup|rm|operatorname|unit|si|num|ang)\s*\{((?:[^{}]|\{[^{}]*\})*)\}"
)
UPRIGHT_LETTER = re.compile(r"\\mathrm\s+([A-Za-z])(?![A-Za-z])")
FRACTION = re.compile(rf"\\[dt]?frac\{{{INLINE}([^{{}}]+)\}}\{{{INLINE}([^{{}}]+)\}}")
"""Of units, as in N over m."""
SPACES = re.compile(r"\\[,;:! ]|~|\\quad|\\thinspace|[\N{NO-BREAK SPACE}\u2009\u202f\u2007]")
SIGNS = (
    (re.compile(r"\{([,.])\}"), r"\1"),
    (re.compile(r"\\(?:cdot|times)(?![A-Za-z])"), "·"),
    (re.compile(r"\^? ?\{? ?\\circ ?\}?"), "°"),
    (re.compile(r"\{\}°"), "°"),
    (re.compile(r"\\%"), "%"),
    (re.compile(r"\^\{([-+\N{MINUS SIGN}]?\d+)\}"), r"^\1"),
    (re.compile(r"\N{MINUS SIGN}"), "-"),
    (re.compile(r"\\mu(?=\s*[A-Za-z]*\s*\})"), "µ"),
)


@dataclass(frozen=True)
class AuthorText:
    """One text: `what` names it in a sentence, `line` is where it begins; `part` is the part it belongs to."""

    path: Path
    what: str
    text: str
    line: int
    language: str = "en"
    part: Part | None = None
    kind: str = "text"

    @cached_property
    def without_tex(self) -> str:
        """The text line by line with TeX in plain signs; holes, code and addresses are blank."""
        text = UNREAD.sub(_blank, self.text)
        text = HOLE.sub(lambda found: BLANK + "\n" * found[0].count("\n"), text)
        return tex_replaced(text)

    def where(self, place: int, source: str = "") -> str:
        """`file:line` of a place in `source` (the plain text, or the text itself)."""
        row = (source or self.without_tex).count("\n", 0, place)
        rows = self.text.splitlines()
        wanted = rows[row].strip() if row < len(rows) else ""
        lines = lines_of(self.path, self.path.stat().st_mtime_ns)
        if wanted and "data:image" not in wanted:
            for number in (*range(self.line, len(lines) + 1), *range(1, self.line)):
                if wanted in lines[number - 1]:
                    return f"{name_in_bank(self.path)}:{number}"
        return f"{name_in_bank(self.path)}:{self.line}"


_LINES: dict[tuple[Path, int], list[str]] = {}


def lines_of(path: Path, state: int) -> list[str]:
    """The lines of a file, read once for each state of it."""
    if (path, state) not in _LINES:
        if len(_LINES) > 64:
            _LINES.clear()
        _LINES[path, state] = path.read_text(encoding="utf-8", errors="replace").splitlines()
    return _LINES[path, state]


def tex_replaced(text: str) -> str:
    """TeX in plain signs, line by line; dollars stay, and before what is upright in them stands a word joiner."""
    text = SIUNITX.sub(rf"\1 {INLINE}\2", text)
    text = SPACES.sub(" ", text)
    for sign, by in SIGNS:
        text = sign.sub(by, text)
    text = UPRIGHT_LETTER.sub(rf"{INLINE}\1", text)
    for _ in range(2):
        text = UPRIGHT.sub(rf"{INLINE}\1", text)
    return FRACTION.sub(rf"{INLINE}\1/\2", text)


def stated_by(part: Part) -> str:
    """The word of a solution that states the answer: step, choice, explain; "" for a type of answers that is not known."""
    try:
        return answer_type(part.answer_type).stated_by
    except UnknownAnswerType:
        return ""


def asks_for_numbers(part: Part) -> bool:
    """True for quantities; not for formulas, choices, words and programs."""
    return stated_by(part) == "step" and not answer_type(part.answer_type).in_symbols


def _blank(found: re.Match[str]) -> str:
    return " " + "\n" * found[0].count("\n")


def texts_of_problem(problem: Problem) -> Iterator[AuthorText]:
    """The texts of the original, in the order of the file."""
    path = problem.path

    def text(
        what: str, words: str, line: int = 1, part: Part | None = None, kind: str = "text"
    ) -> AuthorText:
        return AuthorText(path, what, words, line, part=part, kind=kind)

    yield text("the title", problem.title)
    for given in problem.givens:
        if not given.source:
            yield text(f"the meaning of {given.symbol}", given.meaning, given.line, kind="meaning")
    if not is_svg(problem.figure):
        for label in LABEL.findall(problem.figure):
            yield text("a label of the figure", label, problem.figure_line, kind="label")
    yield text("the alt text", problem.figure_alt, kind="alt")
    first = problem.parts[0].line if problem.parts else 1
    lines = lines_of(path, path.stat().st_mtime_ns)
    fences = [number for number, line in enumerate(lines, 1) if line.strip() == "---"]
    body = fences[1] + 1 if len(fences) > 1 and fences[1] < first else 1
    yield text("the statement", problem.statement, body, kind="statement")
    yield from _of_parts(path, problem.parts, "en")
    for part in problem.parts:
        if part.hint:
            yield text(f"the hint of part {part.id}", part.hint, part.line, part, kind="hint")


def texts_of_translation(problem: Problem, found: ProblemTranslation, language: str) -> Iterator[AuthorText]:
    """The texts of a translation; those below # Texts are of the figure, of hints and of the solution."""
    path = found.path

    def text(what: str, words: str, line: int = 1, kind: str = "text") -> AuthorText:
        return AuthorText(path, what, words, line, language, kind=kind)

    yield text("the title", found.title)
    yield text("the alt text", found.alt, kind="alt")
    yield text("the statement", found.statement, kind="statement")
    parts = {part.id: part for part in problem.parts}
    for each in found.parts.values():
        own = parts.get(each.id)
        if own is not None:
            yield from _of_parts(path, (each,), language, own)
    for original, words in found.texts.items():
        line = found.lines.get(original, 1)
        yield text(f"the translation of {original[:40]!r}", words, line, kind="listed")


def _of_parts(
    path: Path, parts: tuple[Part, ...], language: str, own: Part | None = None
) -> Iterator[AuthorText]:
    for part in parts:
        its = own or part
        yield AuthorText(
            path, f"the title of part {part.id}", part.title, part.line, language, its, "part title"
        )
        yield AuthorText(path, f"part {part.id}", part.text, part.line, language, its, "part")
        for option in part.options:
            what = f"option {option.letter} of part {part.id}"
            yield AuthorText(path, what, option.text, part.line, language, its, "option")


def texts_of_solution(path: Path, texts: Mapping[str, int] | list[str]) -> Iterator[AuthorText]:
    """The sentences of a solution: reasons, checks, mistakes, rubrics."""
    for each in texts:
        yield AuthorText(path, "the solution's text", each, 1, kind="solution")
