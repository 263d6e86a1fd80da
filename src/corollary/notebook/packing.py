"""The modules that read answers, gathered for a notebook to carry: by their dotted names, and none but Python itself beside."""

from __future__ import annotations

import ast
import sys
from base64 import b64encode
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib.abc import InspectLoader
from importlib.util import find_spec, resolve_name

from corollary.answers.registry import folder
from corollary.messages import catalogue, compiled, spoken

CHECK = "corollary.notebook.check"


class NotCarried(ValueError):
    """An answer type cannot be read in a student's notebook; one sentence says which, and why."""


@cache
def modules(types: tuple[str, ...]) -> Mapping[str, str]:
    """The text of everything that `check` needs for these answer types, by module, in the order of the imports.

    Packages on the way are carried with their first sentence only. Raises NotCarried for a module that needs more than
    Python's standard library.
    """
    found: dict[str, str] = {}
    _follow(CHECK, "check", found)
    for name in types:
        _follow(f"{folder(name)}.reading", f"the answer type {name}", found)
    return found


def texts_of(wanted: Iterable[str], stand_ins: Mapping[str, str]) -> Mapping[str, str]:
    """The text of these modules and of everything they need, as `modules` has it; in the place of a library, by its name, a module of
    ours that stands in for it. Raises NotCarried."""
    found = {library: f"from {ours} import *\n" for library, ours in stand_ins.items()}
    for name in (*stand_ins.values(), *wanted):
        _follow(name, name, found)
    return found


def catalogues(names: Iterable[str]) -> Mapping[str, str]:
    """The compiled catalogues, in base64, of the rooms these modules belong to, in the language now spoken.

    A room that has none is there with an empty text, so that a notebook looks for no folder; in English, none is needed.
    """
    if spoken() == "en":
        return {}
    domains = dict.fromkeys(catalogue(name).domain for name in names)
    return {domain: b64encode(compiled(domain, spoken())).decode() for domain in domains}


def _follow(name: str, wanted_by: str, found: dict[str, str]) -> None:
    if name in found:
        return
    package = name.partition(".")[0]
    text, is_package = _text(name)
    tree = ast.parse(text)
    for other in _imports(tree, name if is_package else name.rpartition(".")[0]):
        root = other.partition(".")[0]
        if root in ("corollary", package):
            _follow(other, wanted_by, found)
        elif root not in sys.stdlib_module_names and root not in found:
            raise NotCarried(
                f"{wanted_by} of {package} cannot be read in a notebook: {name} imports {root}, which a student's computer "
                "may not have; what reading.py imports must be in Python's standard library"
            )
    for place, sign in enumerate(name):
        if sign == ".":
            found.setdefault(name[:place], _first_sentence(name[:place]))
    found[name] = _without_docstrings(text, tree)


def _without_docstrings(text: str, tree: ast.Module) -> str:
    """A module without the docstrings of its functions and classes, an eighth of what a notebook would carry."""
    lines = text.split("\n")
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.FunctionDef | ast.ClassDef)
            and len(node.body) > 1
            and ast.get_docstring(node)
        ):
            words = node.body[0]
            lines[words.lineno - 1 : words.end_lineno] = [""] * (
                (words.end_lineno or words.lineno) - words.lineno + 1
            )
    return "\n".join(lines)


def _text(name: str) -> tuple[str, bool]:
    """The text of a module, and whether it is a package."""
    spec = find_spec(name)
    if spec is None or not isinstance(spec.loader, InspectLoader):
        raise NotCarried(f"there is no module {name} whose text a notebook could carry")
    return spec.loader.get_source(name) or "", spec.submodule_search_locations is not None


def _first_sentence(package: str) -> str:
    words = ast.get_docstring(ast.parse(_text(package)[0])) or ""
    return f"{words!r}\n"


def _imports(tree: ast.Module, package: str) -> Iterator[str]:
    """The modules a text imports. Of ours, what a function imports when it is called is not needed to read (tests see to it);
    in a plug-in's every import counts, for nobody has tried it in a notebook.
    """
    ours = package.partition(".")[0] == "corollary"
    for node in tree.body if ours else _run(tree):
        match node:
            case ast.ImportFrom(module=module, names=names, level=level):
                source = resolve_name("." * level + (module or ""), package) if level else module or ""
                inside = [f"{source}.{alias.name}" for alias in names]
                yield from {each if _is_module(each) else source: None for each in inside}
            case ast.Import(names=names):
                yield from (alias.name for alias in names)
            case _:
                continue


def _run(tree: ast.AST) -> Iterator[ast.AST]:
    """Every node but those that only a type checker sees."""
    for node in ast.iter_child_nodes(tree):
        if not (isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)):
            yield node
            yield from _run(node)


def _is_module(name: str) -> bool:
    """Whether a dotted name of ours or of a plug-in is a module, and not what is in one."""
    package = name.rpartition(".")[0]
    if name.partition(".")[0] in sys.stdlib_module_names:
        return False
    spec = find_spec(package)
    return spec is not None and spec.submodule_search_locations is not None and find_spec(name) is not None
