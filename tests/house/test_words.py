"""The words of the code: the field's own, so that one who searches for the usual term finds the place."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

VAGUE = {"plain", "said", "kept", "shown", "told", "heard", "taken", "closed", "close"}
OF_THE_FIELD = {"ClosedForms", "closed_forms", "get_close_matches"}  # mathematics, and Python's difflib
CHARMING = re.compile(r"\b(came to grief|nought|stands by|lest|passed over)\b")


def test_no_name_is_a_word_that_could_mean_anything(modules):
    """`kept` was a cache, a condition that holds and a conserved quantity; `plain` six other things. Each has a term.

    Handlers of files and sockets have a method `close` and a flag `closed`: Python's protocol, not a name of ours.
    """
    wrong = [
        f"{module.path.name}:{line} {name}"
        for module in modules
        for name, line in _names(module.tree)
        if name not in OF_THE_FIELD and _words(name) & VAGUE
    ]
    assert not wrong


def test_what_is_ours_has_one_name(modules):
    """A class or constant that goes by another name where it is imported is not found by a search for its own."""
    wrong = [
        f"{module.path.name}:{node.lineno} {alias.name} as {alias.asname}"
        for module in modules
        for node in module.nodes(ast.ImportFrom)
        if (node.module or "").startswith("corollary")
        for alias in node.names
        if alias.asname and alias.name[0].isupper() and alias.asname != alias.name
    ]
    assert not wrong


def test_sentences_say_what_happens(modules):
    """In docstrings and messages: a figure of speech is neither understood by every reader nor found by a search."""
    wrong = [
        f"{module.path.name}:{node.lineno} {found[0]}"
        for module in modules
        for node in module.nodes(ast.Constant)
        if isinstance(node.value, str) and (found := CHARMING.search(node.value))
    ]
    assert not wrong


def _words(name: str) -> set[str]:
    return set(re.sub(r"([a-z])([A-Z])", r"\1_\2", name).lower().split("_"))


def _names(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Every name that is bound, and every attribute but those of Python's files."""
    for node in ast.walk(tree):
        match node:
            case ast.Name(name, ast.Store()) | ast.arg(name):
                if name != "closed" or "OutputStream" not in {
                    each.name for each in _classes_around(tree, node)
                }:
                    yield name, node.lineno
            case ast.FunctionDef(name) | ast.ClassDef(name):
                if name != "close":
                    yield name, node.lineno
            case ast.Attribute(_, name):
                if name != "close":
                    yield name, node.lineno
            case ast.keyword(str(name)):
                yield name, node.value.lineno
            case ast.MatchAs(_, str(name)) | ast.MatchStar(str(name)) | ast.ExceptHandler(_, str(name)):
                yield name, node.lineno
            case _:
                pass


def _classes_around(tree: ast.Module, node: ast.AST) -> list[ast.ClassDef]:
    return [each for each in ast.walk(tree) if isinstance(each, ast.ClassDef) and node in set(ast.walk(each))]
