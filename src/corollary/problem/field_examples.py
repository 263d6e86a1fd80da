"""An example for each line of the front matter, each word of a given and each attribute of a part's heading."""

from __future__ import annotations

from collections.abc import Mapping

FIELDS: Mapping[str, str] = {
    "code": "code: Q1",
    "title": "title: A bike and a car",
    "source": "source: Exercise 12.4",
    "given": "given:",
    "constants": "constants: [g_n]",
    "rows": "rows: [{body: a hoop, k: 1}, {body: a ball, k: 0.4}]",
    "variables": "variables: {t: {is: time since the start, from: 0, to: 10, unit: s}}",
    "require": "require: m > 0",
    "where": "where: abs(v - w) > v/5",
    "figure": "figure: |",
    "alt": "alt: A box on the floor.",
    "shown": "shown: {pH: pH, dv: Δv}",
    "meant": "meant: [50 km/h]",
    "difficulty": "difficulty: 2",
    "tags": "tags: [momentum, collision]",
    "author": "author: Ada",
    "licence": "licence: CC BY 4.0",
    "version": "version: 1",
}
GIVEN: Mapping[str, str] = {
    "is": "  m: {is: mass of the ball, value: 0.43, unit: kg}",
    "value": "  m: {is: mass of the ball, value: 0.43, unit: kg}",
    "from": "  m: {is: mass of the ball, value: 0.43, from: 0.3, to: 0.6, step: 0.01, unit: kg}",
    "to": "  m: {is: mass of the ball, value: 0.43, from: 0.3, to: 0.6, step: 0.01, unit: kg}",
    "step": "  m: {is: mass of the ball, value: 0.43, from: 0.3, to: 0.6, step: 0.01, unit: kg}",
    "in": "  m: {is: mass of the ball, in: [1, 2, 5], unit: kg}",
    "unit": "  m: {is: mass of the ball, value: 430, unit: g}",
}
ATTRIBUTES: Mapping[str, tuple[str, str]] = {
    "unit": ("a bare number of a student is in this unit", 'unit="m/s"'),
    "points": ("what the part is worth", "points=1"),
    "letter": ("the letter students see, where ids leave gaps", 'letter="e"'),
    "tolerance": ("a share of the answer that it may be off, with its because", 'tolerance="5 %" because="it is read off a diagram"'),
    "because": ("why the tolerance is larger", 'tolerance="5 %" because="it is read off a diagram"'),
    "given": ("equations that the question of a derivation states", 'given="w^2 = k/m"'),
    "hint": ("the first hint", 'hint="Draw the ball before and after."'),
    "plausible": ("answers that make sense, in the part's unit", 'plausible="0.1 to 30"'),
    "expected": ("your own estimate, which no student sees", 'expected="about 40 s"'),
    "components": ("the names of several numbers", 'components="x y"'),
    "rows": ("the rows of a table", 'rows="before, after" columns="momentum, energy"'),
    "columns": ("the columns of a table", 'rows="before, after" columns="momentum, energy"'),
    "function": ("the function that a program defines", 'function="fall(m, dt)"'),
    "of": ("the variables that a formula is of; each is declared under variables:", 'of="t"'),
    "slope": ("the angle of a slope, for directions along it", 'slope="alpha"'),
}  # fmt: skip
HOLES: tuple[tuple[str, str, str], ...] = (
    ("{{m}}", "a given with its unit", "{{m}}"),
    ("{{m|number}}", "the number alone", "{{m|number}}"),
    ("{{m in g}}", "in another unit", "{{m in g}}"),
    ("{{m*v|3}}", "a calculation, with three figures", "{{m*v|3}}"),
)
