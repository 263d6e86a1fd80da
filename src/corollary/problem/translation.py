"""A problem in another language: what `kicking_a_ball.de.md` beside `kicking_a_ball.md` says, text by text.

What it does not say, or says with a hole that the problem does not have, is read in the original.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from corollary.messages import spoken
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import Reader, split
from corollary.problem.given import Given
from corollary.problem.packed_pictures import count, packed
from corollary.problem.part import Part
from corollary.problem.parts_markdown import ATTRIBUTE, HEADING, entries, read_parts
from corollary.problem.problem import Problem
from corollary.problem.statement import holes

NAME = re.compile(r"(?P<original>.+)\.(?P<language>[a-z]{2,3})$")
TEXTS = "# Texts"
"""The heading below which texts of the figure and of the solution stand: each quoted, and its translation below it."""
PACKED = re.compile(r"\(data:image/[^)]*\)")
WORD = re.compile(r"[^\W\d_]{2,}")
NOTHING = "nothing stands below > {:.40}; translate it there"
SENTENCE = 6  # words from which on a text is not the same in two languages
LABEL = re.compile(r'"([^"\n]*)"')


@dataclass(frozen=True, slots=True)
class ProblemTranslation:
    """`parts` by their id; `texts` by the original's words. `of` is the digest of the original that it was made from."""

    path: Path
    title: str
    alt: str
    statement: str
    parts: Mapping[str, Part]
    texts: Mapping[str, str]
    lines: Mapping[str, int]
    of: str = ""


@dataclass(slots=True)
class TextList:
    """The quoted texts of a file and what stands below each, with its line."""

    texts: dict[str, str] = field(default_factory=dict[str, str])
    lines: dict[str, int] = field(default_factory=dict[str, int])


def translations(path: Path) -> dict[str, Path]:
    """The translations beside a problem or a set, by their language."""
    found = sorted(each for each in path.parent.glob(f"{path.stem}.*.md") if each.is_file())
    named = [(match, each) for each in found if (match := NAME.match(each.stem))]
    return {match["language"]: each for match, each in named if match["original"] == path.stem}


def digest(problem: Problem) -> str:
    """Tells the words of an original from those that it had before; a picture counts by its words, whatever its file holds."""
    parts = [[part.id, part.title, part.text, [each.text for each in part.options]] for part in problem.parts]
    words = json.dumps([problem.title, problem.figure_alt, problem.statement, parts])
    return hashlib.sha256(PACKED.sub("()", words).encode()).hexdigest()[:8]


def translation(problem: Problem, language: str = "") -> ProblemTranslation | None:
    """The problem in a language (left out: in the one spoken); None where nobody has translated it. Raises Malformed."""
    path = _beside(problem.path, language or spoken())
    return None if path is None else _read(path, path.stat().st_mtime_ns)


def in_language(problem: Problem) -> Problem:
    """The problem with its words in the spoken language, as far as they are translated. Raises Malformed."""
    found = translation(problem)
    if found is None:
        return problem
    known = frozenset(given.symbol for given in problem.givens)

    def chosen(theirs: str, original: str) -> str:
        return theirs if theirs and all(hole.letters <= known for hole in holes(theirs)) else original

    parts = tuple(
        replace(
            part,
            title=chosen(theirs.title, part.title),
            rows=(rows := tuple(found.texts.get(label, label) for label in part.rows)),
            columns=(columns := tuple(found.texts.get(label, label) for label in part.columns)),
            components=entries(rows, columns) or part.components,
            text=chosen(theirs.text, part.text),
            hint=found.texts.get(part.hint, part.hint),
            options=tuple(
                replace(option, text=chosen(texts.get(option.letter, ""), option.text))
                for texts in [{each.letter: each.text for each in theirs.options}]
                for option in part.options
            ),
        )
        if (theirs := found.parts.get(part.id)) is not None
        else part
        for part in problem.parts
    )
    givens = tuple(
        replace(
            given,
            meaning=found.texts.get(given.meaning, given.meaning),
            words=tuple(found.texts.get(word, word) for word in given.words),
        )
        for given in problem.givens
    )
    variables = tuple(
        replace(each, meaning=found.texts.get(each.meaning, each.meaning)) for each in problem.variables
    )
    figure = LABEL.sub(lambda label: f'"{chosen(found.texts.get(label[1], ""), label[1])}"', problem.figure)
    return replace(
        problem,
        title=chosen(found.title, problem.title),
        statement=chosen(found.statement, problem.statement),
        figure_alt=chosen(found.alt, problem.figure_alt),
        figure=problem.figure if problem.figure.lstrip().startswith("<") else figure,
        givens=givens,
        parts=parts,
        variables=variables,
    )


def text_in_language(problem: Problem, text: str) -> str:
    """A text of the problem's solution in the spoken language; as it is where it is not translated. Raises Malformed."""
    found = translation(problem)
    return text if found is None else found.texts.get(" ".join(text.split()), text)


def set_words(path: Path) -> tuple[str, str]:
    """Title and introduction of the set in a file, in the spoken language; empty where they are not translated. Raises Malformed."""
    beside = _beside(path, spoken())
    if beside is None:
        return "", ""
    complaints: list[Diagnostic] = []
    table, body, line = split(beside)
    front = Reader(beside, table, "the translation", complaints)
    title = front.text("title", "")
    front.finish()
    body = packed(beside, body, line, complaints)
    if complaints:
        raise Malformed(complaints)
    return title, body.strip()


def to_translate(problem: Problem) -> list[str]:
    """The texts of a problem that stand below `# Texts`, once each."""
    meanings = (each.meaning for each in problem.letters if not (isinstance(each, Given) and each.source))
    words = (word for given in problem.givens for word in given.words)
    hinted = (part.hint for part in problem.parts if part.hint)
    return list(dict.fromkeys((*labels(problem), *sides(problem), *meanings, *words, *hinted)))


def untranslated(problem: Problem, texts: Sequence[str]) -> str:
    """The file of a translation with everything that is to be translated: title, statement and parts as in the original, and each of
    the `texts`, quoted, with an empty line below. Raises Malformed."""
    _, body, _ = split(problem.path)
    lines: list[str] = []
    for line in body.strip("\n").split("\n"):
        heading = HEADING.match(line)
        part = (
            next((each for each in ATTRIBUTE.finditer(heading["attributes"] or "") if each["id"]), None)
            if heading
            else None
        )
        lines.append(f"## {heading['title']} {{#{part['id']}}}" if heading and part else line)
    front = [f"title: {json.dumps(problem.title, ensure_ascii=False)}"]
    if problem.figure_alt:
        front.append(f"alt: {json.dumps(problem.figure_alt, ensure_ascii=False)}")
    quoted = [f"> {' '.join(text.split())}\n" for text in texts if text]
    return "\n".join(["---", *front, f"of: {digest(problem)}", "---", *lines, "", TEXTS, "", *quoted])


def labels(problem: Problem) -> Iterator[str]:
    """The words that stand in a figure of primitives: labels in which there is more than letters of formulas and numbers."""
    if not problem.figure.lstrip().startswith("<"):
        for label in LABEL.findall(problem.figure):
            if re.search(r"[^\W\d_]{3,}", re.sub(r"\{\{.*?\}\}|theta|eta", "", label)):
                yield label


def sides(problem: Problem) -> Iterator[str]:
    """The labels of tables that are words, and not letters of formulas."""
    labelled = [label for part in problem.parts for label in (*part.rows, *part.columns)]
    yield from dict.fromkeys(label for label in labelled if re.search(r"[^\W\d_]{3,}", label))


def faults(problem: Problem, found: ProblemTranslation) -> Iterator[Diagnostic]:
    """What a translation lacks beside its original: parts, options, holes; and whether the original is another by now."""
    path, now = found.path, digest(problem)
    if found.of != now:
        why = f"the original has changed since `of: {found.of}`" if found.of else "has no `of`"
        yield Diagnostic(path, 2, f"{why}: compare the two, and write of: {now}")
    pairs = [(1, "the title", problem.title, found.title), (1, "the alt text", problem.figure_alt, found.alt)]
    pairs.append((1, "the statement", problem.statement, found.statement))
    for part in problem.parts:
        theirs = found.parts.get(part.id)
        if theirs is None:
            yield Diagnostic(
                path, 1, f"part {part.id} is missing: add ## {part.title} {{#{part.id}}}, translated"
            )
            continue
        pairs.append((theirs.line, f"the text of part {part.id}", part.text, theirs.text))
        texts = {each.letter: each.text for each in theirs.options}
        for option in part.options:
            what = f"option {option.letter} of part {part.id}"
            pairs.append((theirs.line, what, option.text, texts.get(option.letter, "")))
    for gone in found.parts.keys() - {part.id for part in problem.parts}:
        yield Diagnostic(path, found.parts[gone].line, f"the problem has no part {gone}; take it out")
    for each in to_translate(problem):
        pairs.append((found.lines.get(each, 1), f"the text {each!r}", each, found.texts.get(each, "")))
    for line, what, original, theirs in pairs:
        if original and not theirs and original in found.lines:
            yield Diagnostic(path, line, NOTHING.format(original))
        elif original and not theirs:
            yield Diagnostic(path, line, f"{what} is missing; it is read in the original's language")
        elif original == theirs and len(WORD.findall(original)) >= SENTENCE:
            yield Diagnostic(path, line, f"{what} is still that of the original; translate it")
        elif count(original) != count(theirs):
            yield Diagnostic(
                path, line, f"{what} shows {count(theirs)} pictures, the original {count(original)}"
            )
        elif differ := _holes(original) ^ _holes(theirs):
            yield Diagnostic(
                path, line, f"{what} differs from the original in the holes {', '.join(sorted(differ))}"
            )


def _holes(text: str) -> frozenset[str]:
    return frozenset(f"{{{{{hole.formula}}}}}" for hole in holes(text))


def _beside(path: Path, language: str) -> Path | None:
    found = path.with_name(f"{path.stem}.{language}.md")
    return found if language != "en" and found.is_file() else None


@lru_cache(maxsize=256)
def _read(path: Path, _state: int) -> ProblemTranslation:
    complaints: list[Diagnostic] = []
    table, body, line = split(path)
    front = Reader(path, table, "the translation", complaints)
    title, alt, of = (front.text(name, "") for name in ("title", "alt", "of"))
    front.finish()
    lines = packed(path, body, line, complaints).splitlines()
    end = next((at for at, each in enumerate(lines) if each.strip() == TEXTS), len(lines))
    statement, parts, _ = read_parts(path, "\n".join(lines[:end]), line, complaints)
    listed = _text_list(path, lines[end + 1 :], line + end + 1, complaints)
    if complaints:
        raise Malformed(complaints)
    by_id = {part.id: part for part in parts}
    return ProblemTranslation(path, title, alt, statement, by_id, listed.texts, listed.lines, of)


def _text_list(path: Path, lines: list[str], first: int, complaints: list[Diagnostic]) -> TextList:
    """`> The original.` and below it the translation, each over as many lines as it takes."""
    found, quoted, words, begun, parted = TextList(), list[str](), list[str](), first, False

    def close() -> None:
        original, theirs = " ".join(" ".join(quoted).split()), "\n".join(words).strip()
        if original and not theirs:
            found.lines[original] = begun  # not translated yet
        elif original in found.texts:
            complaints.append(
                Diagnostic(path, begun, f"> {original[:40]} stands here twice; keep one of them")
            )
        elif original:
            found.texts[original], found.lines[original] = theirs, begun
        elif theirs:
            complaints.append(
                Diagnostic(path, begun, "a translation stands below its original, quoted with >")
            )

    for at, line in enumerate(lines, first):
        if line.startswith(">"):
            if words or not quoted or parted:
                close()
                quoted, words, begun, parted = [], [], at, False
            quoted.append(line[1:])
        elif line.strip() or words:
            words.append(line)
        else:
            parted = True
    close()
    return found
