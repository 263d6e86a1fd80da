"""The sign that the words of a part ask for: a magnitude, a distance, a loss, or a value with its sign."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

from corollary.grading.key import Key
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.translation import translation, translations
from corollary.units.unit import show
from corollary.verify.words.author_text import asks_for_numbers

MAGNITUDE = {
    "en": r"\bhow (?:large|big|great|strong|fast|quickly|far|high|long|deep|heavy|wide|steep|much time)\b|\bmagnitude\b|\babsolute value\b|"
    r"\b(?:what|which|find|calculate|determine|with what|at what|at which|give)\b[^.?!\n]{0,30}?\b(?:speed|distance|length|size)\b(?! of (?:light|sound)\b)",
    "de": r"\bwie (?:schnell|weit|hoch|lange|stark|tief|schwer|groß ist der betrag)\b|\bbetrag\b|"
    r"\b(?:welche[rn]?|wie groß ist (?:der|die)) (?:abstand|entfernung|strecke|länge)\b",
    "nb": r"\bhvor (?:fort|raskt|langt|høyt|lenge|sterk|dypt|tung)\b|\babsoluttverdi\w*|\b(?:hvilken|hva er) (?:avstand|lengde)\w*",
}
SPEEDS = r"\b(?:speeds|magnitudes|distances|lengths|beträge|abstände|avstandene?)\b"
LOSS = {
    "en": r"\bhow much\b[^.?!\n]{0,50}?\b(?:lost|loses?|losing|given (?:off|away)|released|decreases?|dissipated)\b|\bwhat (?:is|energy is) (?:the )?(?:loss|lost)\b",
    "de": r"\bwie viel\b[^.?!\n]{0,50}?\b(?:verloren|verliert|abgegeben|abgibt)\b",
    "nb": r"\bhvor m(?:ye|ange)\b[^.?!\n]{0,50}?\b(?:tapt|tapes|taper|avgitt|går tapt)\b",
}
SIGNED = re.compile(
    r"\bsigns?\b|negativ|\bminus\b|\bvorzeichen\b|\bfortegn\w*|\bcomponent\b|\bkomponente\b|\brelative to the positive|\bdirection\b|\brichtung\b|\bretning",
    re.IGNORECASE,
)


SIGNS = re.compile(
    r"\bsigns\b|\bmind the sign\b|\bwith (?:its|their|the) signs?\b|\bvorzeichen\b|\bfortegn\w*",
    re.IGNORECASE,
)


def asks_for_magnitude(text: str, language: str = "en") -> str:
    """The words by which a question asks for what has no sign (a magnitude, a distance, a loss); "" where there are none, or where
    it says how a sign is meant."""
    if SIGNED.search(text):
        return ""
    for words in (MAGNITUDE, LOSS):
        found = _pattern(words.get(language, r"(?!)")).search(text)
        if found is not None:
            return " ".join(found[0].split())
    return ""


@lru_cache(maxsize=16)
def _pattern(words: str) -> re.Pattern[str]:
    return re.compile(words, re.IGNORECASE)


def magnitudes_asked(problem: Problem) -> dict[str, str]:
    """For each part of numbers that the words ask a magnitude of: the words, and the file and line where they stand.

    None where the text above the parts says that signs count.
    """
    found: dict[str, str] = {}
    if SIGNS.search(problem.statement):
        return found
    others = {code: translation(problem, code) for code in translations(problem.path)}
    for part in problem.parts:
        if not asks_for_numbers(part):
            continue
        if words := _words(part, f"{part.title}\n{part.text}", "en"):
            found[part.id] = f"{problem.path.name}:{part.line}: part {part.id} asks {words!r}"
            continue
        for code, other in others.items():
            theirs = other.parts.get(part.id) if other is not None else None
            if theirs and other and (words := _words(part, f"{theirs.title}\n{theirs.text}", code)):
                found[part.id] = f"{other.path.name}:{theirs.line}: part {part.id} asks {words!r}"
    return found


def _words(part: Part, text: str, language: str) -> str:
    if len(part.units) == 1:
        title, _, rest = text.partition("\n")
        if SIGNED.search(title):
            return ""
        return asks_for_magnitude(rest, language)
    several = re.search(SPEEDS, text, re.IGNORECASE)
    return several[0] if several and not SIGNED.search(text) else ""


def negative_magnitudes(asked: Mapping[str, str], key: Key) -> Iterator[tuple[str, str]]:
    """The parts of `asked` whose answer is negative for these numbers, each with a sentence."""
    for part_id, words in list(asked.items()):
        truth = key.truths.get(part_id)
        part = key.variant.problem.part(part_id)
        if truth is None:
            continue
        numbers = [
            unit.from_si(value)
            for unit, value in zip(part.units_for(len(truth.values)), truth.values, strict=True)
        ]
        low = min(numbers)
        if low < 0 and abs(low) > 1e-9 * max(map(abs, numbers)):
            answer = f"{low:.3g} {show(part.unit)}".rstrip().replace("-", "\N{MINUS SIGN}")
            yield (
                part_id,
                f"{words}, which has no sign, and the answer is negative for some numbers ({answer} on {key.variant.label}): "
                "ask for the value with its sign, say which direction is positive, or let the step find the magnitude",
            )
