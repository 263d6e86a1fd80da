"""A JSON schema of a problem's front matter, for editors: from the patterns and names that the reader holds it to."""

from __future__ import annotations

from typing import Any

from corollary.problem.givens import RESERVED, SYMBOL
from corollary.problem.reader import CODE, DIFFICULTIES
from corollary.problem.row_tables import MOST_ROWS
from corollary.units.constants import CONSTANTS

NUMBER = {
    "type": ["number", "string"],
    "pattern": r"^\s*[-+\u2212]?(\d+/[1-9]\d*|(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,3})?)\s*$",
}
WORDS = {"type": ["string", "number"], "minLength": 1}


def _variable() -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {
            "is": {**WORDS, "description": "What the letter means."},
            "from": {
                **NUMBER,
                "description": "Where its domain begins; left out: above 0, without 0 itself.",
            },
            "to": {**NUMBER, "description": "Where its domain ends."},
            "unit": {
                "type": ["string", "number"],
                "description": "As s; a plain number when left out.",
            },
        },
        "required": ["is", "to"],
        "additionalProperties": False,
    }


def schema() -> dict[str, Any]:
    """The schema as a JSON document (draft 2020-12). What it takes, the reader may still refuse: units, conditions, holes."""
    relation = {"type": "string", "pattern": r"<|>|!=|\u2264|\u2265|\u2260"}
    relations = {"anyOf": [relation, {"type": "array", "items": relation}]}
    constant = {"enum": sorted(CONSTANTS)}
    texts = {"anyOf": [WORDS, {"type": "array", "items": WORDS}]}
    given = {
        "type": "object",
        "properties": {
            "is": {**WORDS, "description": "What the letter means."},
            "value": {**NUMBER, "description": "The problem's own number, in the unit."},
            "from": {
                **NUMBER,
                "description": "The first value of the grid that students' numbers are drawn from.",
            },
            "to": {**NUMBER, "description": "The last value of the grid, reached in whole steps."},
            "step": {**NUMBER, "description": "Between two values of the grid."},
            "in": {
                "type": "array",
                "items": WORDS,
                "minItems": 2,
                "uniqueItems": True,
                "description": "The values that students' numbers are drawn from, or words; the first is the problem's own.",
            },
            "unit": {
                "type": ["string", "number"],
                "description": "As kg*m/s^2; a plain number when left out.",
            },
        },
        "required": ["is"],
        "not": {"required": ["value", "in"]},
        "dependentRequired": {name: ["from", "to", "step", "value"] for name in ("from", "to", "step")},
        "dependentSchemas": {"in": {"not": {"required": ["from"]}}},
        "additionalProperties": False,
    }
    cell = {**WORDS, "description": "A number in the unit of the column, or words."}
    row = {
        "type": "object",
        "propertyNames": {"pattern": f"^{SYMBOL.pattern}", "not": {"enum": sorted(RESERVED)}},
        "additionalProperties": cell,
        "minProperties": 1,
    }
    rows = {"type": "array", "items": row, "minItems": 2, "maxItems": MOST_ROWS}
    alone = {"anyOf": [{"required": ["value"]}, {"required": ["in"]}]}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Front matter of a problem",
        "type": "object",
        "properties": {
            "code": {
                "type": "string",
                "pattern": f"^{CODE.pattern}",
                "description": "As X12.5; one of its own in the bank.",
            },
            "title": {**WORDS, "description": "What stands above the problem; without numbers."},
            "source": {"type": ["string", "number"], "description": "Where it is from."},
            "given": {
                "type": "object",
                "propertyNames": {"pattern": f"^{SYMBOL.pattern}", "not": {"enum": sorted(RESERVED)}},
                "additionalProperties": given,
                "description": "The givens by their letter.",
            },
            "variables": {
                "type": "object",
                "propertyNames": {"pattern": f"^{SYMBOL.pattern}", "not": {"enum": sorted(RESERVED)}},
                "additionalProperties": _variable(),
                "description": "The letters that formulas are asked of, such as the time in U(t), each with its domain.",
            },
            "rows": {
                "anyOf": [rows, {"type": "object", "additionalProperties": rows, "minProperties": 1}],
                "description": "A table of which each student has one row, the first as printed; or several tables by name.",
            },
            "constants": {
                "anyOf": [constant, {"type": "array", "items": constant}],
                "description": "Constants of nature that the laws need, by their letter.",
            },
            "require": {
                **relations,
                "description": "Where the physics holds: values against it are refused anywhere.",
            },
            "where": {**relations, "description": "What may be drawn."},
            "figure": {
                "type": "string",
                "description": "A line for each thing in it; or SVG, with holes such as {{m}}.",
            },
            "alt": {"type": "string", "description": "The figure in words."},
            "shown": {
                "type": "object",
                "additionalProperties": {"type": "string"},
                "description": "How letters of givens and unknowns are printed: pH, Δv, pK_a, or TeX.",
            },
            "meant": {
                **texts,
                "description": "Numbers in the words that are the same for everybody, as they stand there.",
            },
            "difficulty": {
                "enum": [*map(int, DIFFICULTIES), *DIFFICULTIES],
                "description": "From 1 (easiest) to 5.",
            },
            "tags": {**texts, "description": "Words to find it by."},
            "author": {"type": "string", "description": "Who wrote it."},
            "licence": {"type": "string", "description": "Under which terms others may use it."},
            "version": {
                "type": ["string", "number"],
                "description": "The author's own count of its editions.",
            },
        },
        "required": ["code", "title"],
        "if": {"properties": {"figure": {"pattern": r"^\s*<"}}, "required": ["figure"]},
        "then": {"required": ["alt"]},
        "anyOf": [
            {"required": ["rows"]},
            {"properties": {"given": {"additionalProperties": alone}}},
        ],
        "additionalProperties": False,
    }
