"""Answers in the text of a cell that binds no answer: without quotes, in a comment, under another name, as Markdown."""

from __future__ import annotations

import ast
import builtins
import re
from collections.abc import Collection

REMARK = re.compile(r"#.*")
LEADS_NOWHERE = re.compile(r"\s*(?:import\b|from\s+\S+\s+import\b|%|check\s*\()")
BEFORE_VALUE = re.compile(r"(?:[#\s:=]|->|→|is\b)+")
LONGEST = 80
NO_ANSWER = re.compile(r"\bNone\b|\W|_")  # what may stand in a cell without being an answer


def text_found(source: str, blank: str, name: str, runs: str | None = None) -> str:
    """What a student wrote into an answer cell that was handed out as `blank`: without the lines of the blank, imports, and an
    assignment of nothing to `name`; empty where nothing is left, and where the cell computes the value of `runs` (of `name` when
    left out, of nothing when empty)."""
    runs = name if runs is None else runs
    if runs and _computes(source, runs) and not unquoted(runs, source):
        return ""
    handed_out = {line.strip() for line in blank.splitlines()}
    remarks = [found[0].strip() for line in handed_out if (found := REMARK.search(line))]
    left: list[str] = []
    for line in map(str.strip, source.splitlines()):
        if line in handed_out or LEADS_NOWHERE.match(line):
            continue
        for remark in remarks:
            line = line.replace(remark, "").strip()
        if NO_ANSWER.sub("", re.sub(rf"^{re.escape(name)}\s*=", "", line)):
            left.append(line)
    return "\n".join(left)


def assigned(source: str, name: str) -> str:
    """The last line of a text that gives `name` a value, in capital or small letters; empty where none does."""
    lines = re.findall(rf"^[^\w\n]*({re.escape(name)}\s*[=:](?!=).*)$", source, re.MULTILINE | re.IGNORECASE)
    return next((line.strip() for line in reversed(lines) if _value_in(line)), "")


def unquoted(name: str, source: str, known: Collection[str] = ()) -> str:
    """`8.6 N s` where a cell gives it to `name` without quotes, so that Python cannot take it: it is no Python, or has names that
    are neither `known` nor made in the cell. Empty where Python takes it."""
    found = re.findall(
        rf"^[ \t]*{re.escape(name)}[ \t]*=(?!=)[ \t]*([^\"'#\n]*?)[ \t]*(?:#.*)?$", source, re.MULTILINE
    )
    text = found[-1] if found else ""
    if not NO_ANSWER.sub("", text):
        return ""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return "" if _is_python(text) or text[-1] in "([{,\\" else text
    made, used = _names(tree), {node.id for node in ast.walk(_parsed(text)) if isinstance(node, ast.Name)}
    return text if made is not None and used - made - {*known, *dir(builtins)} else ""


def value_without_name(text: str, name: str) -> tuple[str, str]:
    """The value in the one line that was found for `name` and not given to it, and that line without the name.

    `X12_5_a == 8.6`, `8.6` and `# 8.6` have 8.6; several lines, and what is no value, have none.
    """
    if "\n" in text.strip() or not text.strip():
        return "", ""
    line = re.sub(rf"^[#\s]*{re.escape(name)}\b\s*", "", text.strip(), flags=re.IGNORECASE)
    if re.match(r"[^\w\s:=]+=", line):  # `+= 8.6` changes a value that is not there
        return "", ""
    start = BEFORE_VALUE.match(line)
    value = line[start.end() if start else 0 :].strip()
    if value[:1] in ("'", '"') and value[:1] == value[-1:]:
        value = value[1:-1]
    return value, line


def binds(source: str, name: str) -> bool:
    """True if a statement of a cell gives `name` a value: an assignment, a loop, a definition, an import."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return False
    made = _names(tree)
    return made is None or name in made


def one_line(text: str) -> str:
    """A text as it may be quoted in a sentence: printable, and cut short where it is long."""
    words = " ".join("".join(sign if sign.isprintable() else " " for sign in text).split())
    return words if len(words) <= LONGEST else words[: LONGEST - 1] + "…"


def _value_in(line: str) -> str:
    return NO_ANSWER.sub("", REMARK.sub("", re.split("[=:]", line, maxsplit=1)[1]))


def _is_python(text: str) -> bool:
    try:
        ast.parse(text, mode="eval")
    except (SyntaxError, ValueError):
        return False
    return True


def _parsed(text: str) -> ast.AST:
    """The tree of an expression; an empty one for the first line of a longer one."""
    return ast.parse(text, mode="eval") if _is_python(text) else ast.Module([], [])


def _computes(source: str, name: str) -> bool:
    """True if a cell gives `name` something else than a plain None, whatever comes of it."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return False
    for node in ast.walk(tree):
        match node:
            case ast.Assign(targets=targets, value=value):
                names = {
                    each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)
                }
            case (
                ast.AnnAssign(target=ast.Name(id=own), value=value)
                | ast.NamedExpr(target=ast.Name(id=own), value=value)
            ):
                names = {own}
            case _:
                continue
        if name in names and not (value is None or (isinstance(value, ast.Constant) and value.value is None)):
            return True
    return False


def _names(tree: ast.Module) -> set[str] | None:
    """The names that a cell makes; None where it may make any."""
    found = set[str]()
    declared = {
        id(node.target) for node in ast.walk(tree) if isinstance(node, ast.AnnAssign) and not node.value
    }
    for node in ast.walk(tree):
        if id(node) in declared:  # `x: 3` declares and makes nothing
            continue
        match node:
            case ast.Name(id=name, ctx=ast.Store()) | ast.arg(arg=name):
                found.add(name)
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                found.add(name)
            case ast.alias(name="*"):
                return None
            case ast.alias(name=name, asname=other):
                found.add(other or name.partition(".")[0])
            case _:
                continue
    return found
