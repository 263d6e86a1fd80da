"""Words that an author may write, with a line of each to begin with, from the tables that the readers go by."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from inspect import signature
from typing import Any

from corollary.answers.registry import answer_type, known
from corollary.derive.formula_text import callables
from corollary.derive.item_clauses import ALLOWED, BELOW, CLAIMS
from corollary.derive.item_examples import HEADINGS, ITEMS, ITEMS_BELOW, OPTIONS
from corollary.problem.field_examples import ATTRIBUTES, FIELDS, GIVEN, HOLES
from corollary.problem.parts_markdown import KNOWN
from corollary.problem.schema import schema
from corollary.render.preview_page import AuthorWord, AuthorWords

EXAMPLE = re.compile(r": `(\w+\([^`]*\))`")


def author_words() -> tuple[AuthorWords, ...]:
    """Words of both texts, in the order in which one writes them. What has no example yet is not among them."""
    fields: dict[str, Any] = schema()["properties"]
    given: dict[str, Any] = fields["given"]["additionalProperties"]["properties"]
    items = dict.fromkeys((*(word for words in ALLOWED.values() for word in words), *CLAIMS))
    below = dict.fromkeys(word for words in BELOW.values() for word in words)
    return (
        AuthorWords("Front matter", "problem", _described(fields, FIELDS)),
        AuthorWords("Givens", "problem", _described(given, GIVEN)),
        AuthorWords("Holes", "problem", tuple(AuthorWord(*each) for each in HOLES), inline=True),
        AuthorWords("Kinds of answer", "problem", tuple(map(_kind, known()))),
        AuthorWords(
            "Attributes of a part", "problem", _explained(sorted(KNOWN), ATTRIBUTES, "{}="), inline=True
        ),
        AuthorWords("Headings", "solution", tuple(AuthorWord(*each) for each in HEADINGS)),
        AuthorWords("Items", "solution", _explained(items, ITEMS, "{}:")),
        AuthorWords("Options", "solution", tuple(AuthorWord(*each) for each in OPTIONS)),
        AuthorWords("Items below an item", "solution", _explained(below, ITEMS_BELOW, "{}:")),
        AuthorWords("Laws and mistakes to call", "solution", tuple(_called())),
    )


def _described(fields: Mapping[str, Any], examples: Mapping[str, str]) -> tuple[AuthorWord, ...]:
    return tuple(
        AuthorWord(f"{name}:", str(field.get("description", "")), examples[name])
        for name, field in fields.items()
        if name in examples
    )


def _explained(
    words: Iterable[str], examples: Mapping[str, tuple[str, str]], form: str
) -> tuple[AuthorWord, ...]:
    return tuple(AuthorWord(form.format(word), *examples[word]) for word in words if word in examples)


def _kind(name: str) -> AuthorWord:
    """A heading with what this kind of answer needs."""
    its = answer_type(name)
    needs = {"rows", "components"} & its.needs | {"function", "slope"} & its.accepts
    attributes = " ".join(ATTRIBUTES[each][1] for each in sorted(needs))
    unit = ' unit="m/s"' if its.found_in == "variable" and its.stated_by == "step" and name != "count" else ""
    heading = f"## Title {{#a .{name}{unit}{' ' if attributes else ''}{attributes} points=1}}"
    options = "\n\n- (A) one\n- (B) another" if "options" in its.needs else ""
    return AuthorWord(f".{name}", its.word, heading + options)


def _called() -> Iterator[AuthorWord]:
    """The common misconceptions with the example in their docstring, and the laws of the library with their arguments."""
    for name, function in sorted(
        callables().items(), key=lambda each: not EXAMPLE.search(each[1].__doc__ or "")
    ):
        first, _, _ = (function.__doc__ or "").strip().partition("\n")
        if found := EXAMPLE.search(first):
            yield AuthorWord(name, first[: found.start()].rstrip(": "), f"- mistake: `{found[1]}`")
        else:
            wanted = (each for each in signature(function).parameters.values() if each.default is each.empty)
            yield AuthorWord(name, first, f"- law: `{name}({', '.join(each.name for each in wanted)})`")
