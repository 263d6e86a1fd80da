"""The text of a PDF as a reader that did not write it finds it: pdfium, which Chromium shows PDFs with."""

from __future__ import annotations

from pypdfium2 import PdfDocument


def pages(pdf: bytes) -> list[str]:
    """The text of each page, line by line."""
    found = [page.get_textpage().get_text_bounded() for page in PdfDocument(pdf)]
    return [text.replace("\r\n", "\n").replace("\N{NO-BREAK SPACE}", " ") for text in found]


def text_of(pdf: bytes) -> str:
    """The text of all pages."""
    return "\n".join(pages(pdf))


def right_ends(pdf: bytes) -> list[float]:
    """How far from the left edge each character ends that shows, in points."""
    every = [page.get_textpage() for page in PdfDocument(pdf)]
    return [
        text.get_charbox(at)[2]
        for text in every
        for at in range(text.count_chars())
        if text.get_text_range(at, 1).strip()
    ]
