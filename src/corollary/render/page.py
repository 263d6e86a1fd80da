"""A page: one HTML file with its style, its font and its pictures inside, to be read anywhere, offline."""

from __future__ import annotations

import base64
import hashlib
import re
from functools import lru_cache
from html import unescape
from importlib.resources import files

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from corollary.figure.svg import alone, on_paper, safe_svg
from corollary.messages import catalogue
from corollary.notebook.worksheet import Exercise
from corollary.render.markdown import html, inline
from corollary.render.wording import earned, percent, points, points_earned

_ = catalogue(__name__)
CONTROLS = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f-\x9f]")  # no page of HTML may hold them, as an answer may


def page(
    template: str,
    *,
    title: str,
    lang: str = "en",
    script: str | tuple[str, ...] = (),
    sends: bool = False,
    loads: bool = False,
    style: str | tuple[str, ...] = (),
    formulas: bool = False,
    **facts: object,
) -> str:
    """The page a template of `templates/` makes of the facts; what is no Markup among them is escaped.

    `script` and `style` name a file of `templates/`, or several; `page.css` is there in any case. Nothing else runs, and nothing is
    fetched: the page's own policy forbids both, but that a page which `sends` may answer the server that it came from, and one that
    `loads` may run the files beside it and Python in WebAssembly. With `formulas` it brings the font for those that come later.
    """
    body = CONTROLS.sub("\ufffd", environment().get_template(template).render(**facts))
    sheet = _style(font_file(body, formulas)) + _texts(style)
    program = _texts(script)
    whole = (
        environment()
        .get_template("page.html")
        .render(
            title=CONTROLS.sub("\ufffd", title),
            lang=lang,
            body=Markup(body),
            policy=_policy(sheet, program, loads) + ("; connect-src 'self'" if sends else ""),
            style=Markup(sheet),
            script=Markup(program),
        )
    )
    # Half a surrogate pair in a student's text could not be written to a file.
    return whole.encode("utf-8", "replace").decode()


# The letters of `mathematics_usual.woff2`, which `docs/mathematics_font.py` makes: half of a page without its figures is its font.
USUAL = re.compile("[\\n\\u00a0 -~α-ωΔ°·±×ℎ\u2061…′→∂∑−√∞∫˙⃗¨≈≠≤≥≪≫⋅]*")
FORMULA, TAG = re.compile(r"<math\b.*?</math>", re.DOTALL), re.compile("<[^>]*>")


def font_file(body: str, formulas: bool) -> str:
    """The font that the formulas of a page need, or those that come later (`formulas`); none without any."""
    if formulas:
        return "mathematics.woff2"
    if "<math" not in body:
        return ""
    letters = unescape(TAG.sub("", "".join(FORMULA.findall(body))))
    return "mathematics_usual.woff2" if USUAL.fullmatch(letters) else "mathematics.woff2"


@lru_cache(maxsize=4)
def _style(file: str) -> str:
    """The style sheet, with the font that formulas need."""
    face = '@font-face { font-family: "Corollary Mathematics"; src: url(data:font/woff2;base64,%s) format("woff2"); }\n'
    return (face % font(file) if file else "") + _text("page.css")


@lru_cache(maxsize=4)
def _policy(style: str, script: str, loads: bool) -> str:
    """What the browser may do: apply this style, run this script, show pictures that stand in the page."""
    allowed = _fingerprint(script) if script else "'none'"
    if loads:
        allowed += " 'self' file: 'wasm-unsafe-eval'"
    return (
        f"default-src 'none'; style-src {_fingerprint(style)}; style-src-attr 'unsafe-inline'; script-src {allowed}; "
        "img-src data:; font-src data:; base-uri 'none'; form-action 'none'"
    )


def _fingerprint(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


@lru_cache(maxsize=1)
def environment() -> Environment:
    """The templates, with Markdown, points, percentages and the message catalogue at hand."""
    templates = PackageLoader("corollary.render")
    found = Environment(
        loader=templates, autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    found.filters |= {
        "markdown": _markdown,
        "inline": _inline,
        "points": points,
        "earned": earned,
        "percent": _unbroken_percent,
    }
    found.globals |= {"_": _, "plural": _.plural, "points_of": points_earned}  # pyright: ignore[reportAttributeAccessIssue]
    return found


def _unbroken_percent(share: float) -> str:
    return percent(share).replace(" ", "\N{NO-BREAK SPACE}")


def _markdown(text: str) -> Markup:
    return Markup(html(text))


def _inline(text: str) -> Markup:
    return Markup(inline(text))


def drawing(exercise: Exercise) -> Markup:
    """The exercise's figure as inline SVG that runs and fetches nothing, or nothing when it has none. Raises NotADrawing."""
    if not exercise.figure:
        return Markup()
    return Markup(safe_svg(exercise.figure, prefix=exercise.problem.prefix + "-", label=exercise.figure_alt))


def drawing_file(exercise: Exercise) -> bytes:
    """The exercise's figure as a file, readable on any background. Raises NotADrawing."""
    return on_paper(alone(str(drawing(exercise)))).encode()


def drawing_address(exercise: Exercise) -> str:
    """The exercise's figure as a data URI, readable on any background. Raises NotADrawing."""
    return "data:image/svg+xml;base64," + base64.b64encode(drawing_file(exercise)).decode()


@lru_cache(maxsize=2)
def font(file: str) -> str:
    """A mathematics font as base64: only a font made for formulas has roots and brackets that grow."""
    return base64.b64encode(files("corollary.render").joinpath("templates", file).read_bytes()).decode()


def _texts(names: str | tuple[str, ...]) -> str:
    return "".join(map(_text, (names,) if isinstance(names, str) else names))


@lru_cache(maxsize=8)
def _text(name: str) -> str:
    return files("corollary.render").joinpath("templates", name).read_text(encoding="utf-8")
