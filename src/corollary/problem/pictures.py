"""Pictures in the text of a problem: they would not come along to students, so they are refused."""

from __future__ import annotations

import re

PICTURE = re.compile(
    r"!\[[^\]\n]*\]\s?(?:\((?P<target>[^)\n]*)\)|\[(?P<label>[^\]\n]*)\])|<(?P<tag>img|svg)\b", re.IGNORECASE
)
CODE = re.compile(r"(`+)[^`\n]+?\1|^(```|~~~).*?^\2", re.MULTILINE | re.DOTALL)
LONGEST = 60  # letters of a target that is named: a data URI has thousands


def pictures(text: str) -> list[tuple[int, str]]:
    """Each picture of a text in Markdown, as the line it stands on (counted from 0) and a sentence; those in code are words."""
    words = CODE.sub(lambda code: re.sub(r"[^\n]", " ", code[0]), text)
    return [
        (
            words.count("\n", 0, found.start()),
            f"the picture {_named(found)} would not come along: notebooks and pages carry the figure of the front matter alone; "
            "draw it there (`figure:`, in lines or as SVG)",
        )
        for found in PICTURE.finditer(words)
    ]


def _named(found: re.Match[str]) -> str:
    name = found["target"] or found["label"] or (f"<{found['tag']}>" if found["tag"] else "without a name")
    return name if len(name) <= LONGEST else name[:LONGEST] + "…"
