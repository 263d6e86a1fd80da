"""Pictures in the text of a problem or a set: files beside it, packed into the text, which so carries all that it shows."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from corollary.figure.picture import KINDS, NotAPicture, address, checked
from corollary.problem.diagnostic import Diagnostic
from corollary.problem.parts_markdown import EXPECTED, without_expected

PICTURE = re.compile(
    r"!\[(?P<alt>[^\]\n]*)\]\s?(?:\((?P<target>[^)\n]*)\)|\[(?P<label>[^\]\n]*)\])|<(?P<tag>img|svg)\b",
    re.IGNORECASE,
)
CODE = re.compile(r"(`+)[^`\n]+?\1|^(```|~~~).*?^\2", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"\w[\w.-]*(?:/\w[\w.-]*)*")
LONGEST = 60  # letters of a target that is named: a data URI has thousands
HOW = "write ![what is to be seen](name.png), with a file that lies beside this one"


def packed(path: Path, text: str, line: int, complaints: list[Diagnostic]) -> str:
    """Markdown of the file at `path`, which begins there on this line, with its pictures inside: data URIs for names of files.

    What cannot be packed is left as it is, and complained of. Pictures in code are words.
    """
    pieces: list[str] = []
    end = 0
    for found in _found(text):
        at = line + text.count("\n", 0, found.start())
        try:
            its = _address(path.parent, found)
        except NotAPicture as error:
            complaints.append(Diagnostic(path, at, f"the picture {_named(found)} {error}"))
            continue
        pieces += [text[end : found.start("target")], its]
        end = found.end("target")
    return "".join([*pieces, text[end:]])


def pictures_of(path: Path) -> list[Path]:
    """The files that the text of a problem, a translation or a set shows, as far as they are there."""
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError:  # who reads it complains
        return []
    targets = (found["target"] for found in _found(text))
    files = (path.parent / each for each in targets if each and FILE.fullmatch(each))
    return [each for each in dict.fromkeys(files) if each.is_file()]


def packed_file(path: Path) -> bytes:
    """A file with its pictures inside, and without the answers that its author expects: what is kept of a problem that was handed
    out. The very bytes where it has neither."""
    raw = path.read_bytes()
    if EXPECTED.encode() in raw:
        raw = without_expected(raw.decode("utf-8")).encode()
    return packed(path, raw.decode("utf-8"), 1, []).encode() if pictures_of(path) else raw


def unused(path: Path) -> list[Path]:
    """The pictures that no problem of this one's topic shows, in any language, and that are this one's to name: by the
    beginning of their name, or because it is the first of the topic."""
    texts = sorted(each for each in path.parent.rglob("*.md") if each.is_file())
    used = {each.resolve() for text in texts for each in pictures_of(text)}
    stems = [text.stem for text in texts if "." not in text.stem]
    there = (each for each in sorted(path.parent.rglob("*")) if each.suffix.lower() in KINDS)
    return [each for each in there if each.resolve() not in used and _whose(each, stems) == path.stem]


def _whose(picture: Path, stems: list[str]) -> str:
    return max((stem for stem in stems if picture.stem.startswith(stem)), key=len, default=stems[0])


def count(text: str) -> int:
    """How many pictures a text shows."""
    return sum(1 for _ in _found(text))


def _found(text: str) -> Iterator[re.Match[str]]:
    return PICTURE.finditer(CODE.sub(lambda code: re.sub(r"[^\n]", " ", code[0]), text))


def _address(folder: Path, found: re.Match[str]) -> str:
    """The data URI of what is to be shown. Raises NotAPicture."""
    target = found["target"]
    if target is None:
        raise NotAPicture(f"would not come along; {HOW}")
    if not found["alt"].strip():
        raise NotAPicture("has no words; say in the brackets what is to be seen, for those who cannot see it")
    if target.startswith("data:"):
        return checked(target)
    if not FILE.fullmatch(target):
        raise NotAPicture(f"is not a file's name, or leads elsewhere; {HOW}")
    file = folder / target
    if not file.is_file():
        raise NotAPicture(f"is not there: {file} is missing")
    if file.resolve() != folder.resolve() / target:
        raise NotAPicture("is a link to another place; put the file itself beside this one")
    return address(file)


def _named(found: re.Match[str]) -> str:
    name = found["target"] or found["label"] or (f"<{found['tag']}>" if found["tag"] else "without a name")
    return name if len(name) <= LONGEST else name[:LONGEST] + "…"
