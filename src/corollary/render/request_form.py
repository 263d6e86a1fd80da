"""The form in which a student asks for regrading, and its address in the feedback page."""

from __future__ import annotations

from collections.abc import Iterable
from urllib.parse import quote

from corollary.messages import catalogue
from corollary.records.regrade_requests import file_name

_ = catalogue(__name__)


def request_form(set_name: str, title: str, parts: Iterable[tuple[str, str, str]]) -> str:
    """The text of the form; `parts` are code, letter and title."""
    heading = _("Request for regrading: {title}", title=title)
    what = _("Write below a part what your teacher is to look at, for example: I went by p = 2mv.")
    how = _(
        "Leave the other parts empty. Hand this file in where you handed in your notebook, under the name {name}.",
        name=file_name(set_name),
    )
    lines = [f"# {heading}", "", what, how, ""]
    for code, letter, words in parts:
        lines += [f"## {code} ({letter}) {words}".rstrip(), "", ""]
    return "\n".join(lines)


def form_address(text: str) -> str:
    """A data URI by which a page holds the form: nothing has to lie beside it."""
    return f"data:text/markdown;charset=utf-8,{quote(text)}"
