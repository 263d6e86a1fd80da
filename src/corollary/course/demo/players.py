"""The class of the demonstration: fifteen students, what each writes, and the verdicts that this deserves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from corollary.answers.evaluation import number
from corollary.answers.option_names import option_named
from corollary.derive.statements import Code, Explain, Plot
from corollary.formula.numerals import decimal_text
from corollary.formula.plain_text import text
from corollary.grading.forces_on_body import as_answered, free_body
from corollary.grading.key import Key, named
from corollary.grading.replay import WhatIf, replay
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.roster import Student
from corollary.units.unit import Unit, canonical, show, unit

Sources = dict[str, str]


@dataclass(frozen=True, slots=True)
class Hand:
    """What a student hands in: new sources of cells by their name, and the verdict each part deserves (where not right).

    `raw` replaces the whole file; `late` is in hours.
    """

    sources: Sources
    deserves: Mapping[str, str] = field(default_factory=dict[str, str])
    raw: bytes | None = None
    late: float = 0.0
    nothing: str = ""


@dataclass(frozen=True, slots=True)
class Player:
    student: Student
    plays: str
    hand: Callable[[Worksheet, Mapping[str, Key]], Hand]


def right_sources(
    sheet: Worksheet, keys: Mapping[str, Key], write: Callable[[Prompt, tuple[float, ...]], str] | None = None
) -> Sources:
    """A cell for every part with the right answer, as `write` puts it; programs, figures and texts are the solution's examples."""
    sources: Sources = {}
    for prompt in sheet.prompts:
        key = keys[prompt.problem.code]
        if prompt.part.id in key.truths:
            sources[f"{prompt.key}_answer"] = (
                f"{prompt.name} = {(write or plainly)(prompt, key.truths[prompt.part.id].values)}"
            )
        elif prompt.part.id in key.choices:
            option = option_named(prompt.part, key.choices[prompt.part.id]).strip("()")
            sources[f"{prompt.key}_answer"] = f"{prompt.name} = {option!r}"
        elif prompt.part.id in key.solution.examples:
            sources[f"{prompt.key}_answer"] = f"{prompt.name} = {instance(key, prompt.part.id)!r}"
        elif prompt.part.id in key.solution.forces:
            body = free_body(key.solution.forces[prompt.part.id], key.variant)
            sources[f"{prompt.key}_answer"] = f"{prompt.name} = {as_answered(body, prompt.part)!r}"
        else:
            sources |= _examples(prompt, key)
    return sources


def plainly(prompt: Prompt, values: tuple[float, ...]) -> str:
    """Machine numbers."""
    return repr(list(values)) if prompt.part.components else repr(values[0])


def instance(key: Key, part: str) -> list[float]:
    """One good example of an example part, as numbers."""
    trees = key.solution.examples[part].instance
    assert trees is not None
    known = key.variant.exact | named(key.solution, list(key.values))
    return [number(tree, known) for tree in trees]


def _examples(prompt: Prompt, key: Key) -> Sources:
    """Programs, figures and explanations from the solution."""
    sources: Sources = {}
    for entry in key.solution.entries:
        match entry:
            case Code() if entry.statement.part == prompt.part.id:
                sources[f"{prompt.key}_answer"] = f"import numpy as np\n{entry.example_for(key.variant.si)}"
            case Plot() if entry.statement.part == prompt.part.id:
                body = entry.example_for(key.variant.si)
                sources[f"{prompt.key}_plot"] = f"import numpy as np\nimport matplotlib.pyplot as plt\n{body}"
            case Explain() if entry.statement.part == prompt.part.id:
                sources[prompt.key] = entry.answer
            case _:
                continue
    return sources


Keys = Mapping[str, Key]
OTHER_UNITS = {
    "kg*m/s": "g*m/s",
    "N": "kN",
    "m/s": "km/h",
    "J": "kJ",
    "s": "ms",
    "m": "cm",
    "rad": "deg",
    "N*s": "N*ms",
}


def in_unit(values: tuple[float, ...], of: Unit, mark: str = ".") -> list[str]:
    """Numbers as typed, with a unit: about four figures, but never three decimals, which after a comma could be thousands."""
    size = of.si
    numbers: list[str] = []
    for value in values:
        tries = (decimal_text(value / size, figures) if value else "0" for figures in (4, 5))
        number = next(text for text in tries if len(text.partition(".")[2]) != 3)
        numbers.append(number.replace(".", mark) + (f" {show(of)}" if show(of) else ""))
    return numbers


def listed(prompt: Prompt, texts: list[str]) -> str:
    return repr(texts) if prompt.part.components else repr(texts[0])


def all_right(sheet: Worksheet, keys: Keys) -> Hand:
    return Hand(right_sources(sheet, keys))


def rounding(sheet: Worksheet, keys: Keys) -> Hand:
    """Every step rounded to three figures, and the next step done with the rounded number."""
    rounded = {
        code: replay(key.solution, key.variant.exact, WhatIf(rounding=lambda x: float(f"{x:.3g}")))
        for code, key in keys.items()
    }

    def write(prompt: Prompt, values: tuple[float, ...]) -> str:
        place = keys[prompt.problem.code].truths[prompt.part.id].place
        return listed(
            prompt,
            [
                f"{value:.3g} {canonical(prompt.part.unit)}".replace(" 1", "")
                for value in rounded[prompt.problem.code][place]
            ],
        )

    return Hand(right_sources(sheet, keys, write))


def other_units(sheet: Worksheet, keys: Keys) -> Hand:
    def write(prompt: Prompt, values: tuple[float, ...]) -> str:
        return listed(prompt, in_unit(values, unit(OTHER_UNITS[canonical(prompt.part.unit)])))

    return Hand(right_sources(sheet, keys, write))


def decimal_comma(sheet: Worksheet, keys: Keys) -> Hand:
    return Hand(
        right_sources(
            sheet, keys, lambda prompt, values: listed(prompt, in_unit(values, prompt.part.unit, ","))
        )
    )


def formulas(sheet: Worksheet, keys: Keys) -> Hand:
    """Formulas instead of numbers, wherever one exists; numpy numbers elsewhere, and warnings on stderr, which cost nothing."""

    def write(prompt: Prompt, values: tuple[float, ...]) -> str:
        in_givens = keys[prompt.problem.code].find(keys[prompt.problem.code].truths[prompt.part.id]).in_givens
        if in_givens is not None and len(in_givens) == 1 and text(in_givens[0])[0] not in "0123456789p":
            return repr(text(in_givens[0]))
        numbers = repr(list(values)) if prompt.part.components else repr(values[0])
        return (
            f"__import__('numpy').array({numbers})"
            if prompt.part.components
            else f"__import__('numpy').float64({numbers})"
        )

    sources = right_sources(sheet, keys, write)
    sources["X12_5_a_answer"] = (
        "import sys, warnings\nprint('thinking', file=sys.stderr)\nwarnings.warn('careful')\n"
        + sources["X12_5_a_answer"]
    )
    return Hand(sources)


def misconception(sheet: Worksheet, keys: Keys) -> Hand:
    """Momentum without direction in one part: the speeds are subtracted."""
    si = keys["X12.5"].variant.si
    sources = right_sources(sheet, keys)
    sources["X12_5_d_answer"] = f"X12_5_d = {si['m'] * (si['v'] - si['w']) / si['dt']!r}"
    return Hand(sources, {"X12_5_d": "mistaken"})


def carried(sheet: Worksheet, keys: Keys) -> Hand:
    """A wrong speed of the bullet, and everything after it done rightly with that speed."""
    key = keys["X12.10"]
    si = key.variant.si
    wrong = 1.17 * key.truths["a"].values[0]
    u = si["m"] * wrong / (si["m"] + si["M"])
    change = (si["m"] + si["M"]) * u * u / 2 - si["m"] * wrong * wrong / 2
    sources = right_sources(sheet, keys)
    sources["X12_10_a_answer"] = f"X12_10_a = {wrong!r}"
    sources["X12_10_b_answer"] = f"X12_10_b = '{change:.5g} J'"
    return Hand(sources, {"X12_10_a": "wrong", "X12_10_b": "follows"})


def sign(sheet: Worksheet, keys: Keys) -> Hand:
    sources = right_sources(sheet, keys)
    sources["X12_10_b_answer"] = f"X12_10_b = {-keys['X12.10'].truths['b'].values[0]!r}"
    return Hand(sources, {"X12_10_b": "slip"})


def euler(sheet: Worksheet, keys: Keys) -> Hand:
    """A program that steps the position with the old velocity."""
    sources = right_sources(sheet, keys)
    source = sources["P12_14_h_answer"]
    swapped = source.replace(
        "        v = v + a * dt\n        shift = shift + v * dt\n",
        "        shift = shift + v * dt\n        v = v + a * dt\n",
    )
    assert swapped != source, "the example program has changed; change this player with it"
    sources["P12_14_h_answer"] = swapped
    return Hand(sources, {"P12_14_h": "mistaken"})


def blank(sheet: Worksheet, keys: Keys) -> Hand:
    return Hand({}, {prompt.key: "unread" for prompt in sheet.prompts})


def endless(sheet: Worksheet, keys: Keys) -> Hand:
    sources = right_sources(sheet, keys)
    sources["X12_8_b_answer"] = "while True:\n    pass"
    return Hand(sources, {"X12_8_b": "unread"})


def crash(sheet: Worksheet, keys: Keys) -> Hand:
    """The process ends itself in exercise 12.10: that answer is lost, and none of those around it."""
    sources = right_sources(sheet, keys)
    sources["X12_10_a_answer"] = "import os\nos._exit(3)"
    return Hand(sources, {"X12_10_a": "unread"})


def forged(sheet: Worksheet, keys: Keys) -> Hand:
    """No answers, but checks rewritten to claim full marks, and code that goes looking for the key and the gradebook."""
    sources = {
        "setup": "def check(*names):\n    print('right: full points')",
        "X12_5_a": "check('X12_5_a')  # score: 1/1",
        "X12_5_a_answer": (
            "import glob\ntry:\n    import corollary\n    found = 'corollary'\nexcept ImportError:\n    found = None\n"
            "files = glob.glob('/**/gradebook.db', recursive=True) + glob.glob('/**/solutions/**/*.py', recursive=True)\n"
            "X12_5_a = None if not found and not files else 'found: ' + str(found) + str(files[:3])"
        ),
    }
    return Hand(sources, {prompt.key: "unread" for prompt in sheet.prompts})


def no_notebook(sheet: Worksheet, keys: Keys) -> Hand:
    return Hand(
        {}, {prompt.key: "unread" for prompt in sheet.prompts}, raw=b'{"cells": [{"cell_type": "code", "sour'
    )


def late(sheet: Worksheet, keys: Keys) -> Hand:
    return replace(all_right(sheet, keys), late=30.0)


def _player(name: str, first: str, last: str, plays: str, hand: Callable[[Worksheet, Keys], Hand]) -> Player:
    return Player(Student(name, first, last, f"{name}@example.org"), plays, hand)


PLAYERS = (
    _player("ada", "Ada", "Lund", "everything right", all_right),
    _player("ben", "Ben", "Okafor", "right, each step rounded to three figures", rounding),
    _player("chen", "Chen", "Li", "right, in other units", other_units),
    _player("dora", "Dora", "Weiss", "right, with decimal commas", decimal_comma),
    _player("elif", "Elif", "Kaya", "right, as formulas and numpy numbers, with warnings", formulas),
    _player("finn", "Finn", "Berg", "one misconception: momentum without direction", misconception),
    _player("gia", "Gia", "Rossi", "one wrong answer, carried forward", carried),
    _player("hugo", "Hugo", "Silva", "a sign slip", sign),
    _player("ines", "Inés", "Vega", "a program with forward Euler", euler),
    _player("jon", "Jón", "Arnason", "handed in blank", blank),
    _player("kim", "Kim", "Park", "an endless loop in one cell", endless),
    _player("lou", "Lou", "Martin", "a crash half-way", crash),
    _player("mallory", "Mallory", "Crane", "forged checks, and a search for the key", forged),
    _player("nils", "Nils", "Holm", "a file that is not a notebook", no_notebook),
    _player("omar", "Omar", "Haddad", "everything right, 30 hours late", late),
)
