"""A file of WeBWorK taken apart in one pass: its program without texts and comments, and its answers in their order."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass

from corollary.audit.readers.straight_line import MOST_ANSWERS, NotRead, arguments_at

BLOCK_MARK = re.compile(r"(BEGIN|END)_(\w+)")
HEREDOC = re.compile(r"<<\s*([\"']?)([A-Za-z_]\w*)\1")
DOCUMENTATION = re.compile(r"(?ms)^=[A-Za-z].*?(?:^=cut\b[^\n]*$|\Z)")
CODE_IN_TEXT = re.compile(r"\\\{|\[@")
CODE_ENDS = re.compile(r"[}@]")
ASSIGNMENT = re.compile(r"[$@%]\w+\s*(?:[-+*/.|&]|\*\*)?=(?![=~>])")
COMMENT = re.compile(r"(?m)^[^\S\n]*#.*$|(?<=;)[^\S\n]*#.*$")
QUOTED = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'")
PGML_BLANK = re.compile(r"\[_+\]\*?\{")
CONSTANT = re.compile(r"\$PI\b")
MARK = "\0"  # of a block that was taken out
END = "ENDDOCUMENT"
ANSWERED = re.compile(r"\b((?:(?:LABELED|NAMED|WEIGHTED|NAMED_WEIGHTED)_)?ANS)\s*\(")
SEVERAL = re.compile(r"@|\w_list\s*\(|\[")
TOGETHER = re.compile(r"\b(?:Radio)?MultiAnswer\s*\(")


@dataclass(frozen=True, slots=True)
class WebworkSource:
    """`statements` are those of the program, `text` is the whole of it; `answers` is what compares each answer, and behind which
    statement it is worked out, by its label if it has one and its place, from 1, if not."""

    text: str
    statements: tuple[str, ...]
    answers: dict[str, tuple[int, str]]


def webwork_source(source: str) -> WebworkSource:
    """Raises NotRead where a text assigns or answers something, and where the answers cannot be told apart."""
    if MARK in source:
        raise NotRead("it has a character that no text has")
    source = CONSTANT.sub("pi", DOCUMENTATION.sub("", source))
    source, blocks = _without_blocks(source)
    source, heredocs = _without_heredocs(source)
    texts = [*blocks, *heredocs]
    if any(map(_assigns, texts)):
        raise NotRead("its text assigns something")
    if any(map(ANSWERED.search, texts)):
        raise NotRead("its text answers something")
    source = COMMENT.sub("", source)
    source = QUOTED.sub(lambda found: found[0].replace(";", " "), source).partition(END)[0]
    if len(ANSWERED.findall(QUOTED.sub("''", source))) < len(ANSWERED.findall(source)):
        raise NotRead("a text within its program speaks of ANS")
    if any(map(PGML_BLANK.search, heredocs)):
        raise NotRead("it has answers in a text that is no block of PGML")
    statements = tuple(each.strip() for each in source.split(";"))
    answers: dict[str, tuple[int, str]] = {}
    kinds = set[str]()
    for place, statement in enumerate(statements):
        in_block = statement.startswith(MARK)
        listed = _blanks(blocks[int(statement[1:])]) if in_block else _answers(statement)
        for label, answer in listed:
            kinds.add("PGML" if in_block else "ANS")
            name = label or str(len(answers) + 1)
            if name in answers:
                raise NotRead(f"two of its answers are called {name!r}")
            if len(answers) >= MOST_ANSWERS:
                raise NotRead(f"it has more than {MOST_ANSWERS} answers")
            answers[name] = (place, answer)
    if len(kinds) > 1:
        raise NotRead("it has answers in PGML and others in ANS")
    several = any(SEVERAL.search(answer) for _, answer in answers.values()) or TOGETHER.search(source)
    if len(answers) > 1 and several:
        raise NotRead("one of its answers compares several, and which is which is not certain")
    return WebworkSource(source, statements, answers)


def _without_blocks(source: str) -> tuple[str, list[str]]:
    """A program with a mark and a number in place of BEGIN_TEXT … END_TEXT and the like, and these."""
    marks = list(BLOCK_MARK.finditer(source))
    last_end = {each[2]: each.start() for each in marks if each[1] == "END"}
    rest, blocks = list[str](), list[str]()
    at, begun = 0, None
    for mark in marks:
        if begun is None:
            if mark[1] == "BEGIN" and last_end.get(mark[2], -1) > mark.start():
                rest.append(source[at : mark.start()])
                begun = mark
        elif mark[1] == "END" and mark[2] == begun[2]:
            rest.append(f";{MARK}{len(blocks)};")
            blocks.append(source[begun.start() : mark.end()])
            at, begun = mark.end(), None
    return "".join([*rest, source[at:]]), blocks


def _without_heredocs(source: str) -> tuple[str, list[str]]:
    """The same for texts `<<'END'`, which begin on the next line and end with a line that is the word alone."""
    ends: dict[str, list[int]] = {}
    starts, start = list[int](), 0
    for line in source.split("\n"):
        starts.append(start)
        ends.setdefault(line.rstrip(" \t"), []).append(start)
        start += len(line) + 1
    rest, texts, at = list[str](), list[str](), 0
    for found in HEREDOC.finditer(source):
        if found.start() < at:
            continue
        line = bisect_left(starts, found.end())  # the next one
        closing = ends.get(found[2], [])
        place = bisect_left(closing, starts[line]) if line < len(starts) else len(closing)
        if place < len(closing):
            rest += [source[at : found.start()], "''", source[found.end() : starts[line]]]
            at = closing[place] + len(found[2])
            texts.append(source[starts[line] : closing[place]])
    return "".join([*rest, source[at:]]), texts


def _assigns(text: str) -> bool:
    """Whether code within a text, in `\\{ … \\}` or `[@ … @]`, gives a variable a value."""
    at = 0
    while (begins := CODE_IN_TEXT.search(text, at)) is not None:
        ends = CODE_ENDS.search(text, begins.end())
        at = ends.start() if ends is not None else len(text)
        if ASSIGNMENT.search(text[begins.end() : at]) or ASSIGNMENT.match(text, at):
            return True
    return False


def _blanks(text: str) -> Iterator[tuple[str, str]]:
    """The answers in `[____]{ … }`, which have no label. Raises NotRead."""
    at = 0
    while (blank := PGML_BLANK.search(text, at)) is not None:
        inside, at = arguments_at(text, blank.end())
        yield "", ", ".join(inside)


def _answers(program: str) -> Iterator[tuple[str, str]]:
    """Each answer with its label, "" for none. Raises NotRead."""
    at = 0
    while (answered := ANSWERED.search(program, at)) is not None:
        inside, at = arguments_at(program, answered.end())
        match answered[1]:
            case "ANS":
                pairs = [("", each) for each in inside]
            case "WEIGHTED_ANS":
                pairs = [("", each) for each in inside[::2]]
            case kind:
                flat = [each for one in inside for each in (one.split("=>", 1) if "=>" in one else [one])]
                step = 3 if kind == "NAMED_WEIGHTED_ANS" else 2
                if len(flat) % step:
                    raise NotRead(f"{kind} with {len(inside)} arguments is not read")
                pairs = [
                    (label.strip(" \n\"'"), each)
                    for label, each in zip(flat[::step], flat[1::step], strict=True)
                ]
        yield from pairs
