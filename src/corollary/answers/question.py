"""A question as a reader of answers sees it: what is asked for, in which unit and which symbols; nothing of what is right."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from corollary.units.unit import Dimension, Unit, unit

Extreme = Literal["", "least", "greatest"]


@dataclass(frozen=True, slots=True)
class Symbol:
    """A letter that a formula may be written in."""

    name: str
    unit: Unit
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class Question:
    """`name` is the variable that takes the answer; `types` its answer type, or `code` and `plot` together.

    `components` name the members of a list, in order; `options` are the letters of a choice, `option_texts` what
    stands beside them; `signature` is that of a
    function, `force(t, dt)`; `symbols` are the givens of the problem; `slope` is the angle that directions along a slope turn by;
    `rows` and `columns` are the labels of a table, `column_units` the units of its columns, where they are not all `unit`;
    `extreme` tells that a least or a greatest value is asked for;
    `variables` are those of the symbols that its formula is asked of, each with the ends of its domain in SI;
    `positive` is the positive direction in the problem's words, `reference` is from what it counts an angle; `text` is
    that of the part.
    """

    part: str
    name: str
    types: tuple[str, ...]
    unit: Unit
    title: str = ""
    components: tuple[str, ...] = ()
    options: tuple[str, ...] = ()
    option_texts: tuple[str, ...] = ()
    signature: str = ""
    symbols: tuple[Symbol, ...] = ()
    slope: str = ""
    rows: tuple[str, ...] = ()
    columns: tuple[str, ...] = ()
    column_units: tuple[Unit, ...] = ()
    positive: str = ""
    reference: str = ""
    extreme: Extreme = ""
    text: str = ""
    variables: tuple[tuple[str, float, float], ...] = ()

    @property
    def function(self) -> str:
        """The name that the function must have."""
        return self.signature.partition("(")[0].strip()

    @property
    def arguments(self) -> tuple[str, ...]:
        """The names of the function's arguments."""
        inside = self.signature.partition("(")[2].rpartition(")")[0]
        return tuple(name.strip() for name in inside.split(",") if name.strip())

    @property
    def ratio(self) -> str:
        """The text that says what is asked over what, where a plain number is asked for."""
        return self.text if self.types == ("value",) and self.unit.bare else ""

    @property
    def symbol_names(self) -> list[str]:
        return [symbol.name for symbol in self.symbols]

    @property
    def dimensions(self) -> dict[str, Dimension]:
        """What each symbol measures."""
        return {symbol.name: symbol.unit.dimension for symbol in self.symbols}

    def as_data(self) -> dict[str, Any]:
        """The question as JSON can hold it, for a notebook to carry; `from_data` reads it again."""
        return {
            "part": self.part,
            "name": self.name,
            "types": self.types,
            "unit": self.unit.text,
            "title": self.title,
            "components": self.components,
            "options": self.options,
            "option_texts": self.option_texts,
            "signature": self.signature,
            "slope": self.slope,
            "rows": self.rows,
            "columns": self.columns,
            "column_units": [each.text for each in self.column_units],
            "positive": self.positive,
            "reference": self.reference,
            "extreme": self.extreme,
            "text": self.text,
            "variables": self.variables,
            "symbols": [(symbol.name, symbol.unit.text, symbol.meaning) for symbol in self.symbols],
        }

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Question:
        """The question that `as_data` wrote."""
        symbols: Sequence[Sequence[str]] = data["symbols"]
        return cls(
            data["part"],
            data["name"],
            tuple(data["types"]),
            unit(data["unit"]),
            data["title"],
            tuple(data["components"]),
            tuple(data["options"]),
            tuple(data["option_texts"]),
            data["signature"],
            tuple(Symbol(name, unit(its_unit), meaning) for name, its_unit, meaning in symbols),
            data["slope"],
            tuple(data["rows"]),
            tuple(data["columns"]),
            tuple(map(unit, data["column_units"])),
            data["positive"],
            data["reference"],
            data["extreme"],
            data["text"],
            tuple((name, low, high) for name, low, high in data["variables"]),
        )
