"""Extracts the texts that students read: one template for each room, `src/corollary/ROOM/locale/corollary.ROOM.pot`, and one for
the judges of the chapter's bank, `solutions/locale/messages.pot`.

The translations beside it, `LANGUAGE/LC_MESSAGES/corollary.ROOM.po`, are brought up to date with it and compiled.
"""

from __future__ import annotations

import ast
import io
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_file
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "corollary"
BANK = ROOT / "solutions"
KEYWORDS = {"_": None, "N_": None, "plural": (1, 2)}
LAWS = "laws"
NEVER = datetime(2000, 1, 1, tzinfo=UTC)  # what is compiled changes only when a text does


def templates() -> dict[Path, str]:
    """The text of each template by its place; a room that says nothing to students has none."""
    found: dict[Path, str] = {}
    rooms = [(path.parent, f"corollary.{path.parent.name}") for path in sorted(PACKAGE.glob("*/__init__.py"))]
    for room, domain in (*rooms, (BANK, "messages")):
        # Neither dates nor line numbers: a template changes only when a text does.
        catalogue = Catalog(project=domain, version="", header_comment="# Texts of PROJECT.", charset="utf-8")
        for place, message, comments, context in _texts(room):
            catalogue.add(message, locations=[(place, 0)], auto_comments=comments, context=context)
        if len(catalogue):
            out = io.BytesIO()
            write_po(out, catalogue, include_lineno=False, omit_header=True, sort_output=True, width=110)
            header = f'msgid ""\nmsgstr ""\n"Project-Id-Version: {domain}\\n"\n"Content-Type: text/plain; charset=utf-8\\n"\n\n'
            found[room / "locale" / f"{domain}.pot"] = header + out.getvalue().decode()
    return found


def catalogues() -> dict[Path, bytes]:
    """The text of each translation by its place, as the template has it today, and beside it its compiled form."""
    found: dict[Path, bytes] = {}
    for place, text in templates().items():
        template = read_po(io.BytesIO(text.encode()), domain=place.stem)
        for path in sorted(place.parent.glob(f"*/LC_MESSAGES/{place.stem}.po")):
            language = path.parents[1].name
            catalogue = read_po(io.BytesIO(path.read_bytes()), locale=language, domain=place.stem)
            catalogue.update(template, no_fuzzy_matching=True)
            catalogue.obsolete.clear()
            catalogue.fuzzy = False
            source, compiled = io.BytesIO(), io.BytesIO()
            write_po(source, catalogue, include_lineno=False, omit_header=True, sort_output=True, width=110)
            header = (
                f'msgid ""\nmsgstr ""\n"Project-Id-Version: {place.stem}\\n"\n"Language: {language}\\n"\n'
                '"Content-Type: text/plain; charset=utf-8\\n"\n"Plural-Forms: nplurals=2; plural=(n != 1);\\n"\n\n'
            )
            found[path] = header.encode() + source.getvalue()
            ready = read_po(io.BytesIO(found[path]), locale=language, domain=place.stem)
            ready.creation_date = ready.revision_date = NEVER
            write_mo(compiled, ready)
            found[path.with_suffix(".mo")] = compiled.getvalue()
    return found


def _texts(room: Path) -> Iterator[tuple[str, str | tuple[str, ...], list[str], str | None]]:
    home = room if room == BANK else PACKAGE
    for path in sorted(room.rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        place = path.relative_to(home).as_posix()
        if room.name == LAWS:
            yield from ((place, message, [], None) for message in _names_and_conditions(text))
        if "catalogue" in text or "N_" in text:
            for _, message, comments, context in extract_from_file("python", path, keywords=KEYWORDS):
                yield place, message, comments, context
    for path in sorted(room.rglob("*.html")):
        place = path.relative_to(home).as_posix()
        options = {"trimmed": "true"}
        for _, message, comments, context in extract_from_file(
            "jinja2.ext:babel_extract", path, keywords=KEYWORDS, options=options
        ):
            yield place, message, comments, context


def _names_and_conditions(text: str) -> Iterator[str]:
    """The names of the laws stated in a module, and when they hold."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "law":
            conditions = [each.value for each in node.keywords if each.arg == "holds"]
            for value in (*node.args[:1], *conditions):
                if isinstance(value, ast.Constant) and isinstance(value.value, str) and value.value:
                    yield value.value


if __name__ == "__main__":
    for place, text in templates().items():
        place.parent.mkdir(exist_ok=True)
        place.write_text(text, encoding="utf-8")
        print(f"{place.relative_to(ROOT)}: {text.count('msgid ') - 1} texts")
    for place, content in catalogues().items():
        place.write_bytes(content)
