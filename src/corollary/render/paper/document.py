"""Typst's markup made a PDF: tagged, with its language and title, held to PDF/UA-1, and the same to the byte each time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from importlib import import_module
from importlib.resources import files
from typing import Any, Final

from corollary.extras import installing
from corollary.messages import spoken
from corollary.render.paper.typst_formula import literal

USUAL, LARGE = "11pt", "18pt"
STANDARD: Final = "ua-1"
"""With it Typst refuses to write a file in which a formula or a picture has no words."""

NO_LETTER: Final = "could not be displayed with font"


class CannotTypeset(RuntimeError):
    """There is no Typst here, or it refuses what was to be set; one sentence says which, and what to do."""


def typesetter(module: str) -> Any:
    """A module of the extra `pdf`. Raises CannotTypeset where it is not installed."""
    try:
        return import_module(module)
    except ImportError as error:
        raise CannotTypeset(
            f"PDF needs the Python package {module}; install it with: {installing('pdf')}"
        ) from error


def pdf(sheets: Sequence[str], title: str, *, large: bool = False) -> bytes:
    """One file with these sheets, each with its own count of pages. Raises CannotTypeset."""
    size, show = (LARGE if large else USUAL), literal(spoken())
    opening = f"#show: paper.with(lang: {show}, title: {literal(title)}, size: {size})\n\n"
    source = (_style() + opening + "\n\n".join(sheets)).encode("utf-8", "replace")
    typst = typesetter("typst")
    for others in (False, True):
        try:
            return _compiler(others).compile(input=source, format="pdf", pdf_standards=STANDARD)
        except typst.TypstError as error:
            refused = error
            if NO_LETTER not in error.message:
                break
    why = f"no font of this machine has what is to be set ({refused.message}); install one that has it"
    why = why if NO_LETTER in refused.message else refused.message
    raise CannotTypeset(f"{title} cannot be set on paper: {why}") from refused


@lru_cache(maxsize=2)
def _compiler(others: bool) -> Any:
    """One for all files of this process: fonts are loaded once, and what was laid out before is remembered. `others`: with the
    fonts of the machine too, for letters that Typst's own do not have."""
    typst = typesetter("typst")
    return typst.Compiler(font_paths=typst.Fonts(include_system_fonts=others))


@lru_cache(maxsize=1)
def _style() -> str:
    return files("corollary.render").joinpath("templates", "paper.typ").read_text(encoding="utf-8")
