"""The message catalogues use the words of the glossary."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from babel.messages.pofile import read_po

TOP = Path(__file__).parents[2]
GLOSSARY = TOP / "docs" / "reference" / "glossary.md"
ROWS = re.findall(
    r"^\| ([a-z ]+) \| [^|]+ \| ([^|]+) \| ([^|]+) \|$", GLOSSARY.read_text(encoding="utf-8"), re.MULTILINE
)[1:]
# Inflected, or said by another word of the same meaning.
ALSO = {
    ("angle", "de"): ["bogenmaß"], ("equation", "de"): ["gleichheitszeichen"], ("equation", "nb"): ["likhetstegn"],
    ("force", "de"): ["kräft"], ("force", "nb"): ["kreft"], ("formula", "nb"): ["formler"], ("impulse", "de"): ["kraftstöße"],
    ("momentum", "nb"): ["spinn"], ("points", "de"): ["punkt"], ("significant figures", "de"): ["geltende"],
    ("points", "nb"): ["punkt"], ("worked solution", "nb"): ["løsning"],
}  # fmt: skip
# Other meanings: letters that are characters, signs of a product, a force that points, decimal points, friction by its name.
OTHERWISE = re.compile(
    r"chapter \*Momentum|of \{what\} letters|product sign|force points|commas or points|friction is the only"
)


def messages(language: str) -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    for path in sorted((TOP / "src" / "corollary").glob(f"*/locale/{language}/LC_MESSAGES/*.po")):
        with path.open("rb") as file:
            found += [
                (each.id, each.string) for each in read_po(file) if isinstance(each.id, str) and each.id
            ]
    return found


@pytest.mark.parametrize("language", ["de", "nb"])
def test_catalogues_use_the_words_of_the_glossary(language: str) -> None:
    assert len(ROWS) > 30
    catalogue = messages(language)
    assert len(catalogue) > 500
    wrong = [
        f"{term}: {original} | {translated}"
        for term, german, norwegian in ROWS
        for original, translated in catalogue
        if re.search(rf"\b{term}s?\b", re.sub(r"\{\w*\}|`[^`]*`", "", original), re.IGNORECASE)
        and not OTHERWISE.search(original)
        and not any(
            word.lower().rstrip("e") in translated.lower()
            for word in [german if language == "de" else norwegian, *ALSO.get((term, language), [])]
        )
    ]
    assert wrong == []
