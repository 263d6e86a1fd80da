"""A page: one HTML file with its style, its font and its pictures inside, to be read anywhere, offline."""

from __future__ import annotations

import base64
from functools import lru_cache
from importlib.resources import files

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from corollary.render.markdown import html, inline


def page(template: str, *, title: str, lang: str = "en", **facts: object) -> str:
    """The page a template of `templates/` makes of the facts; what is no Markup among them is escaped."""
    body = environment().get_template(template).render(**facts)
    whole = (
        environment()
        .get_template("page.html")
        .render(
            title=title,
            lang=lang,
            body=Markup(body),
            style=Markup(_text("page.css")),
            font=font() if "<math" in body else "",
        )
    )
    return whole.encode(
        "utf-8", "replace"
    ).decode()  # half a surrogate pair in a student's text could not be written to a file


@lru_cache(maxsize=1)
def environment() -> Environment:
    """The templates, with Markdown, points and percentages at hand."""
    templates = PackageLoader("corollary.render")
    found = Environment(
        loader=templates, autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    found.filters |= {
        "markdown": lambda text: Markup(html(text)),
        "inline": lambda text: Markup(inline(text)),
        "points": points,
        "percent": lambda share: f"{100 * share:.0f} %",
    }
    return found


def points(value: float) -> str:
    """Points as people write them: at most two decimals, and none that are not needed."""
    return f"{round(value, 2) + 0.0:.2f}".rstrip("0").rstrip(".")


@lru_cache(maxsize=1)
def font() -> str:
    """The mathematics font as base64: only a font made for formulas has roots and brackets that grow."""
    return base64.b64encode(
        files("corollary.render").joinpath("templates", "mathematics.woff2").read_bytes()
    ).decode()


@lru_cache(maxsize=4)
def _text(name: str) -> str:
    return files("corollary.render").joinpath("templates", name).read_text(encoding="utf-8")
