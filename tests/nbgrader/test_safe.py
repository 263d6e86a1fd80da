"""What a student wrote must not act on whoever looks at it."""

from __future__ import annotations

import base64
from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st
from nbconvert.filters.markdown_mistune import markdown2html_mistune as rendered
from nbformat import validate
from nbformat.v4 import new_code_cell, new_notebook

from corollary.nbgrader.safe import MOST_LETTERS, safe_attachments, safe_markdown, safe_outputs

PNG = base64.b64encode(b"\x89PNG\r\n\x1a\n" + bytes(20)).decode()
HARMLESS = {
    "p",
    "em",
    "strong",
    "code",
    "pre",
    "ul",
    "ol",
    "li",
    "a",
    "br",
    "hr",
    "blockquote",
    "del",
    "div",
    "span",
}
HARMLESS |= {"h1", "h2", "h3", "h4", "h5", "h6", "table", "thead", "tbody", "tr", "td", "th", "sup", "sub"}


class Seen(HTMLParser):
    """What a browser would meet on the page: its tags, and the addresses it fetches or would go to at a click.

    An address of the web, in plain sight, may be clicked.
    """

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.attributes: set[str] = set()
        self.addresses: list[str] = []
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        for name, value in attrs:
            self.attributes.add(name)
            if name == "src" or (
                name == "href" and not (value or "").startswith(("#", "https://", "http://"))
            ):
                self.addresses.append(value or "")

    def handle_comment(self, data: str) -> None:
        self.tags.add("!--")


def harmless(page: str) -> bool:
    seen = Seen(page)
    return (
        seen.tags <= HARMLESS
        and not seen.addresses
        and not any(name.startswith("on") for name in seen.attributes)
    )


ATTACKS = [
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "<ScRiPt src=//evil>",
    "<!-- --><iframe src=x>",
    "<svg/onload=alert(1)>",
    "a <b onmouseover=x> c",
    "<javascript:alert(1)>",
    "[x](javascript:alert(1))",
    "[x]( java\tscript:alert(1))",
    "[x][y]\n\n[y]: javascript:alert(1)",
    "![x](https://evil.example/pixel.png)",
    "![x](data:text/html;base64,PHNjcmlwdD4=)",
    "`` ` `` <script>",
    "$<script>$",
    "- <script>\n\n> <script>",
    "```\n</code></pre><script>\n```",
]


def test_the_attacks_work_without_protection():
    assert sum(not harmless(rendered(text)) for text in ATTACKS) > len(ATTACKS) / 2


@pytest.mark.parametrize("text", ATTACKS)
def test_nothing_runs_and_nothing_is_fetched(text: str):
    assert harmless(rendered(safe_markdown(text)))


@given(st.text(alphabet="<>/![]():abjsx \n`\"'=&;#-$", max_size=60))
def test_no_combination_of_marks_makes_a_tag_or_an_address(text: str):
    assert harmless(rendered(safe_markdown(text)))


@pytest.mark.parametrize(
    "text",
    [
        "Because **impulse** is kept.",
        "$a \\le b$ and $p = m v$",
        "1 < 2 and 3 > 2",
        "![a photo](attachment:work.png)",
    ],
)
def test_an_honest_answer_is_left_as_it_is(text: str):
    assert safe_markdown(text) == text


def test_a_formula_gets_a_blank_at_most():
    assert safe_markdown("$a<b$") == "$a< b$"


def test_pasted_pictures_stay_and_other_attachments_go():
    cell = {
        "attachments": {
            "a.png": {"image/png": PNG, "text/html": "<script>"},
            "b": {"image/svg+xml": "<svg/>"},
            "c": 3,
        }
    }
    assert safe_attachments(cell) == {"a.png": {"image/png": PNG}}
    assert safe_attachments({"attachments": []}) == {}


def test_outputs_keep_text_and_pictures_only():
    shown = safe_outputs(
        [
            {"output_type": "stream", "name": "stdout", "text": ["a\n", "b"]},
            {
                "output_type": "display_data",
                "data": {"image/png": PNG, "text/html": "<b>", "application/javascript": "x"},
            },
            {
                "output_type": "execute_result",
                "data": {"text/plain": "8.6"},
                "metadata": {"width": '"><script>'},
            },
            {"output_type": "display_data", "data": {"text/html": "<script>"}},
            {"output_type": "error", "ename": "NameError", "evalue": "x", "traceback": ["line"] * 1000},
            {"output_type": "comm"},
            {},
        ]
    )
    assert [each.output_type for each in shown] == ["stream", "display_data", "display_data", "error"]
    assert shown[0].text == "a\nb"
    assert shown[1].data == {"image/png": PNG}
    assert shown[2] == {"output_type": "display_data", "data": {"text/plain": "8.6"}, "metadata": {}}
    assert len(shown[3].traceback) == 50
    validate(new_notebook(cells=[new_code_cell("x", outputs=shown)]))


@pytest.mark.parametrize(
    "content", ['"><script>alert(1)</script>', "", "aGVsbG8=", 3, None, base64.b64encode(b"<svg>").decode()]
)
def test_what_is_no_picture_is_not_shown_as_one(content: object):
    assert safe_outputs([{"output_type": "display_data", "data": {"image/png": content}}]) == []


def test_endless_text_ends():
    (shown,) = safe_outputs([{"output_type": "stream", "name": "stdout", "text": "x" * 10**6}])
    assert len(shown.text) < MOST_LETTERS + 100
    assert "more letters are left out" in shown.text
