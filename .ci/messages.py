"""Extracts the texts that students read: one template for each room, `src/corollary/ROOM/locale/corollary.ROOM.pot`."""

from __future__ import annotations

import io
from pathlib import Path

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_file
from babel.messages.pofile import write_po

PACKAGE = Path(__file__).parents[1] / "src" / "corollary"
KEYWORDS = {"_": None, "N_": None, "plural": (1, 2)}


def templates() -> dict[Path, str]:
    """The text of each room's template by its place; a room that says nothing to students has none."""
    found: dict[Path, str] = {}
    for room in sorted(path.parent for path in PACKAGE.glob("*/__init__.py")):
        domain = f"corollary.{room.name}"
        # Neither dates nor line numbers: a template changes only when a text does.
        catalogue = Catalog(project=domain, version="", header_comment="# Texts of PROJECT.", charset="utf-8")
        for path in sorted(room.rglob("*.py")):
            text = path.read_text(encoding="utf-8")
            if "catalogue" not in text and "N_" not in text:
                continue
            for _, message, comments, context in extract_from_file("python", path, keywords=KEYWORDS):
                place = path.relative_to(PACKAGE).as_posix()
                catalogue.add(message, locations=[(place, 0)], auto_comments=comments, context=context)
        if len(catalogue):
            out = io.BytesIO()
            write_po(out, catalogue, include_lineno=False, omit_header=True, sort_output=True, width=110)
            header = f'msgid ""\nmsgstr ""\n"Project-Id-Version: {domain}\\n"\n"Content-Type: text/plain; charset=utf-8\\n"\n\n'
            found[room / "locale" / f"{domain}.pot"] = header + out.getvalue().decode()
    return found


if __name__ == "__main__":
    for place, text in templates().items():
        place.parent.mkdir(exist_ok=True)
        place.write_text(text, encoding="utf-8")
        print(f"{place.relative_to(PACKAGE)}: {text.count('msgid ') - 1} texts")
