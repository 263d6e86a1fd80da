"""Formulas as students and authors write them, read into trees; what has two readings is asked about, never guessed."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import partial

from corollary.formula.abbreviations import function_words
from corollary.formula.ast import Expr
from corollary.formula.by_hand import by_hand
from corollary.formula.degrees import in_degrees
from corollary.formula.errors import ParseError, ambiguous, refused, sentence
from corollary.formula.lexer import LONGEST, MOST_TOKENS, tokens
from corollary.formula.line import Lean
from corollary.formula.numerals import TO_ASCII
from corollary.formula.parser import formula
from corollary.formula.symbols import APART, LETTER, RUN, Letters, Piece, letters, read_run
from corollary.messages import catalogue

_ = catalogue(__name__)

INDEXED = re.compile(
    rf"(?<![A-Za-z0-9_])([{LETTER}]+)\[([0-9]{{1,2}}|[A-Za-z]|[0-9A-Za-z]{{1,2}},[0-9A-Za-z]{{1,2}})\]"
)
JOINED = re.compile(
    rf"(?<![{LETTER}0-9_])(?P<head>[{LETTER}]+_[{LETTER}0-9]{{1,3}}),(?P<index>[{LETTER}0-9]{{1,2}})(?![{LETTER}0-9_.(])"
)
LEFT = re.compile(rf"\s*({RUN.pattern})\s*(?:\(\s*t\s*\)\s*)?=(?!=)")


def parse(
    text: str, names: Iterable[str], *, degrees: bool = False, left: str | None = None, lean: Lean = "ask"
) -> Expr | ParseError:
    """A student's formula in the letters `names`; `lean` says what becomes of places that have two readings.

    A left side (`p = m v`) may be repeated: any one letter, or only `left` when it is given. With `degrees`, a bare number
    inside sin, cos or tan is in degrees; letters stand for angles themselves.
    """
    if len(text) > LONGEST:
        return refused(_("this is longer than {most} characters", most=LONGEST), LONGEST)
    if (typed := by_hand(text)) != text:
        tree = parse(typed, names, degrees=degrees, left=left, lean=lean)
        return tree.without_place() if isinstance(tree, ParseError) else tree
    found = LEFT.match(text.translate(TO_ASCII))
    start = 0
    if found:
        start = found.end()
        if left is not None and isinstance(read_run(found[1], 0, letters(frozenset({left}))), ParseError):
            return refused(
                _("{found} stands on the left, but {left} is asked for", found=found[1], left=left),
                found.start(1),
                _("begin with {left} =", left=left),
            )
    known = letters(frozenset(names))
    # Blanks stand for what was skipped, so that a place found is a place in what was typed.
    line = " " * start + (text[start:] if "Delta" in known.names else APART.sub(r"\2\1", text[start:]))
    line = _with_indices(line, known)
    if isinstance(line, ParseError):
        return line
    read = tokens(line, partial(read_run, known=known))
    if isinstance(read, ParseError):
        return read
    for token in read:
        power = next((letter for letter in "eE" if token.kind == "number" and letter in token.text), "")
        if power and power in known.names:
            base, _mark, exponent = token.text.partition(power)
            return ambiguous(
                _("{text} can be a power of ten or hold the letter {letter}", text=token.text, letter=power),
                token.at,
                f"{base}*10^{exponent.lstrip('+')}",
                f"{base}*{power}{exponent if exponent[0] in '+-' else '*' + exponent}",
            )
    tree = formula(read, student=True, lean=lean)
    return in_degrees(tree) if degrees and not isinstance(tree, ParseError) else tree


def _with_indices(line: str, known: Letters) -> str | ParseError:
    """`v[0]` as v_0 and `v_A,0` as v_A0, where there is such a letter; asked about where a letter stands before a bracket with digits alone."""
    for found in JOINED.finditer(line) if "," in line else ():
        name = f"{found['head']}{found['index']}"
        if name.replace("_", "") in known.exact:
            line = line.replace(found[0], name.ljust(len(found[0])), 1)
    for found in INDEXED.finditer(line):
        name = f"{found[1]}_{found[2]}"
        if (
            not isinstance(read_run(found[1] + found[2], 0, known), ParseError)
            and name.replace("_", "") in known.exact
        ):
            line = line.replace(found[0], f"{name}".ljust(len(found[0])), 1)
        elif found[2].isdigit() or "," in found[2]:
            return ambiguous(
                _("{text} can be an index or a product", text=found[0]),
                found.start(),
                f"{found[1]}_{found[2]}",
                f"{found[1]}*({found[2]})",
            )
    return line


def author_formula(text: str, names: Iterable[str] | None = None, *, operators: bool = False) -> Expr:
    """A formula, a law or a condition of an author: every product written with `*`, letters exactly as declared.

    With `operators`, a letter with a bracket right behind it is called, as in `v(0)` or `int(F, t, 0, T)`. Raises ValueError
    with a sentence that quotes the text.
    """
    declared = None if names is None else frozenset(names)
    typed = text.replace("∞", "oo") if operators else text
    read = tokens(typed, partial(_author_run, declared=declared), longest=20 * LONGEST, most=20 * MOST_TOKENS)
    if operators and not isinstance(read, ParseError):
        behind = [*read[1:], read[-1]]
        read = [
            replace(each, kind="function")
            if each.kind == "name" and following.kind == "open" and following.tight
            else each
            for each, following in zip(read, behind, strict=True)
        ]
    tree = read if isinstance(read, ParseError) else formula(read, student=False)
    if isinstance(tree, ParseError):
        raise ValueError(f"formula {text!r}, {sentence(tree)}")
    return tree


def _author_run(run: str, at: int, declared: frozenset[str] | None) -> list[Piece] | ParseError:
    if declared is not None and run in declared:
        return [Piece("name", run, at)]
    if run in (known := function_words()):
        return [Piece("function", known[run], at)]
    if declared is None or run == "pi":
        return [Piece("name", run, at)]
    return refused(
        _("{run} is not among the letters here ({letters})", run=run, letters=", ".join(sorted(declared))), at
    )
