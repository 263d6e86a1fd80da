"""Students' output made harmless for a page: text stays readable, pictures stay, nothing runs and nothing is fetched."""

# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false

from __future__ import annotations

import re
from base64 import b64decode, b64encode
from collections.abc import Iterable, Mapping

from nbformat import NotebookNode, from_dict

MOST_LETTERS = 20_000  # some ten printed pages: more is never read, and makes formgrader crawl
MOST_PICTURE = 4 << 20  # bytes; a figure of matplotlib has some 50 kB
PICTURES = {"image/png": b"\x89PNG\r\n\x1a\n", "image/jpeg": b"\xff\xd8\xff"}

HTML = re.compile(r"<(?=[A-Za-z/!?])")
LINK = re.compile(r"\](?=\((?!attachment:)|:)")


def safe_markdown(text: str) -> str:
    """Markdown without HTML and without links; pictures that were pasted in stay. A blank is put where they would begin, so
    that formulas ($a < b$) and everything else read as before."""
    return LINK.sub("] ", HTML.sub("< ", _short(text)))


def safe_attachments(cell: Mapping[str, object]) -> dict[str, dict[str, str]]:
    """The pictures pasted into a cell that are pictures."""
    found: dict[str, dict[str, str]] = {}
    attached = cell.get("attachments")
    for name, kinds in attached.items() if isinstance(attached, Mapping) else ():
        data = _pictures(kinds)
        if data:
            found[str(name)] = data
    return found


def safe_outputs(outputs: Iterable[Mapping[str, object]]) -> list[NotebookNode]:
    """Outputs as text and pictures: no HTML, no scripts, no widgets, nothing of endless length."""
    return [safe for output in outputs if (safe := _output(output)) is not None]


def _output(output: Mapping[str, object]) -> NotebookNode | None:
    match output.get("output_type"):
        case "stream":
            name = "stderr" if output.get("name") == "stderr" else "stdout"
            return _made("stream", name=name, text=_short(_text(output.get("text"))))
        case "error":
            traceback = output.get("traceback")
            lines = (
                [_short(str(line)) for line in traceback[:50]] if isinstance(traceback, (list, tuple)) else []
            )
            name, value = (_short(str(output.get(key))) for key in ("ename", "evalue"))
            return _made("error", ename=name, evalue=value, traceback=lines)
        case "display_data" | "execute_result":
            content = output.get("data")
            data = _pictures(content)
            if (text := dict(_pairs(content)).get("text/plain")) is not None:
                data["text/plain"] = _short(_text(text))
            return _made("display_data", data=data, metadata={}) if data else None
        case _:
            return None


def _made(kind: str, **content: object) -> NotebookNode:
    """Not by nbformat's new_output, which checks each against the schema: that takes longer than all the rest of a notebook."""
    return NotebookNode(from_dict({"output_type": kind, **content}))


def _pairs(kinds: object) -> Iterable[tuple[str, object]]:
    return [(str(mime), content) for mime, content in kinds.items()] if isinstance(kinds, Mapping) else []


def _pictures(content: object) -> dict[str, str]:
    """The pictures among the representations of one thing."""
    return {mime: data for mime, each in _pairs(content) if (data := _picture(mime, each))}


def _picture(mime: str, content: object) -> str:
    """The picture in base64, or nothing when it is none: what is put into a page's `src` must be base64 and no more."""
    if mime not in PICTURES:
        return ""
    try:
        raw = b64decode("".join(_text(content).split()), validate=True)
    except ValueError:  # what is no base64
        return ""
    return b64encode(raw).decode() if raw.startswith(PICTURES[mime]) and len(raw) <= MOST_PICTURE else ""


def _text(content: object) -> str:
    """nbformat keeps a text as one string or as a list of lines."""
    return "".join(map(str, content)) if isinstance(content, (list, tuple)) else str(content)


def _short(text: str) -> str:
    over = len(text) - MOST_LETTERS
    return text if over <= 0 else f"{text[:MOST_LETTERS]}\n[{over} more letters are left out here]"
