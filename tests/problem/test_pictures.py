"""Pictures in the text of a problem or a set: files beside it come along inside the text, and what cannot is refused with its line."""

from __future__ import annotations

import base64
import struct
import zlib
from pathlib import Path

import pytest

from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.packed_pictures import packed_file, pictures_of, unused
from corollary.problem.problem_set import find_set
from corollary.problem.reader import read_problem
from corollary.problem.translation import digest, faults, in_language, translation

from .conftest import BODY, FRONT


def png(width: int = 3, height: int = 2) -> bytes:
    """A grey PNG, chunk by chunk as its specification has it."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = b"".join(b"\0" + b"\x80" * width for _ in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", head)
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )


SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><circle cx="4" cy="4" r="3"/></svg>'


@pytest.fixture
def beside(tmp_path):
    """Puts a file beside the problem."""

    def put(name: str, raw: bytes | str) -> Path:
        path = tmp_path / "problems" / "carts" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(raw.encode() if isinstance(raw, str) else raw)
        return path

    return put


def test_a_picture_comes_along_in_the_text(read, beside):
    beside("cart.png", png())
    beside("more/cart.jpg", b"\xff\xd8\xff\xd9")
    text = "One ![a cart](cart.png) and ![another](more/cart.jpg).\n" + BODY
    problem = read(FRONT, text.replace("How large", "![again](cart.png) How large"))
    address = "data:image/png;base64," + base64.b64encode(png()).decode()
    assert (
        problem.statement.splitlines()[0]
        == f"One ![a cart]({address}) and ![another](data:image/jpeg;base64,/9j/2Q==)."
    )
    assert problem.parts[0].text == f"![again]({address}) How large is its momentum?"
    assert [each.name for each in pictures_of(problem.path)] == ["cart.png", "cart.jpg"]


def test_an_svg_keeps_its_shapes_on_a_light_sheet(read, beside):
    beside("cart.svg", SVG.replace("<circle", '<metadata>x</metadata><circle id="unused"'))
    found = read(FRONT, f"![a cart](cart.svg)\n{BODY}").statement
    text = base64.b64decode(found.partition("base64,")[2].partition(")")[0]).decode()
    assert '<circle cx="4" cy="4" r="3">' in text
    assert 'fill="#fff"' in text
    assert "metadata" not in text


@pytest.mark.parametrize(
    ("text", "name", "why"),
    [
        ("![a cart](cat.png)", "cat.png", "is missing"),
        ("![](cart.png)", "cart.png", "has no words"),
        ("See ![a cart](https://example.org/cart.svg) here.", "https://example.org/cart.svg", "a file that"),
        ("![a cart](../carts/cart.png)", "../carts/cart.png", "leads elsewhere"),
        ("![a cart](/etc/cart.png)", "/etc/cart.png", "leads elsewhere"),
        ("![a cart](linked.png)", "linked.png", "is a link"),
        ("![a cart](away/cart.png)", "away/cart.png", "is a link"),
        ("![a cart][photo]", "photo", "would not come along"),
        ('<img src="cart.png">', "<img>", "would not come along"),
        ("<SVG></SVG>", "<SVG>", "would not come along"),
        ("![a cart](cart.gif)", "cart.gif", "is not a picture"),
        ("![a cart](false.png)", "false.png", "does not hold what its name says"),
        ("![a cart](large.png)", "large.png", "has 600 kB"),
        ("![a cart](script.svg)", "script.svg", "has <script>"),
        ("![a cart](click.svg)", "click.svg", "has onclick= of <circle>"),
        ("![a cart](photo.svg)", "photo.svg", "has <image>"),
        ("![a cart](fetched.svg)", "fetched.svg", 'has href="http://example.org/a.svg#b" of <use>'),
        ("![a cart](classes.svg)", "classes.svg", "has <style>"),
        ("![a cart](entity.svg)", "entity.svg", "declares entities"),
        ("![a cart](broken.svg)", "broken.svg", "not well-formed"),
        (f"![a cart](data:image/png;base64,{'A' * 500})", "data:image/png;base64,", "does not hold"),
        ("![a cart](data:text/html;base64,AAAA)", "data:text/html", "is an address"),
    ],
)
def test_what_cannot_come_along_is_refused_with_its_line(complaints, beside, tmp_path, text, name, why):
    beside("cart.png", png())
    beside("cart.gif", b"GIF89a")
    beside("false.png", b"GIF89a")
    beside("large.png", png() + bytes(600 * 1024))
    for named, harm in {
        "script": "<script>alert(1)</script>",
        "click": '<circle onclick="alert(1)"/>',
        "photo": '<image href="data:image/png;base64,AAAA"/>',
        "fetched": '<use href="http://example.org/a.svg#b"/>',
        "classes": '<style>.a {fill: red}</style><circle class="a"/>',
        "broken": "<g>",
    }.items():
        beside(f"{named}.svg", SVG.replace("<circle", harm + "<circle", 1))
    beside("entity.svg", '<!DOCTYPE svg [<!ENTITY a "b">]>' + SVG)
    away = tmp_path / "away"
    away.mkdir()
    (away / "cart.png").write_bytes(png())
    (tmp_path / "problems" / "carts" / "linked.png").symlink_to(away / "cart.png")
    (tmp_path / "problems" / "carts" / "away").symlink_to(away)
    ((line, sentence),) = complaints(FRONT, f"One.\n{text}\n{BODY}")
    assert line == 9
    assert sentence.startswith(f"the picture {name}")
    assert why in sentence
    assert len(sentence) < 300


def test_titles_and_words_to_choose_from_are_no_pictures(complaints, beside):
    beside("cart.png", png())
    body = BODY.replace("## Momentum", "## Momentum ![a cart](cart.png)")
    body += "\n## Kind {#b .word}\nWhich?\n- (A) ![a cart](cart.png)\n- (B) sledge\n"
    first, second = complaints(FRONT, body)
    assert first == (10, "a picture stands in the text below a title, not in it")
    assert second == (13, "part b lists words, of which none can be a picture")


def test_what_is_code_or_no_picture_is_left_alone(read):
    text = "Write `![](x.png)`, or n! [see](below).\n\n```\n<img src=1>\n![](y.png)\n```\n"
    assert read(FRONT, text + BODY).statement.startswith("Write")


def test_a_set_carries_its_pictures_too(write, tmp_path):
    write()
    sets = tmp_path / "problems" / "sets"
    sets.mkdir()
    (sets / "week.md").write_text("---\ntitle: W\nproblems: [X1.1]\n---\nHello.\n![road](x.png)\n")
    with pytest.raises(Malformed, match=r"week.md:6: the picture x.png is not there"):
        find_set(Bank(tmp_path), "week")
    (sets / "x.png").write_bytes(png())
    assert "![road](data:image/png" in find_set(Bank(tmp_path), "week").introduction


def test_what_is_kept_of_a_problem_reads_the_same_without_its_pictures(read, beside, tmp_path):
    """What was handed out is shown again for years; by then another picture may lie there, or none."""
    beside("cart.png", png())
    beside("cart.svg", SVG)
    problem = read(FRONT, f"![a cart](cart.png) ![a wheel](cart.svg)\n{BODY}")
    kept = tmp_path / "kept.md"
    kept.write_bytes(packed_file(problem.path))
    assert read_problem(kept).statement == problem.statement
    before = packed_file(problem.path)
    beside("cart.png", png(5))
    assert packed_file(problem.path) != before
    plain = read(name="plain")
    assert packed_file(plain.path) == plain.path.read_bytes()


def test_a_picture_that_nothing_shows_is_named_once(write, beside):
    cart, sledge = write(body=f"![a cart](cart.png)\n{BODY}"), write(name="sledge")
    for name in ("cart.png", "sledge_old.svg", "other.jpg"):
        beside(name, png())
    (sledge.parent / "sledge.de.md").write_text("---\ntitle: S\n---\n![x](sledge_de.png)\n")
    beside("sledge_de.png", png())
    assert [each.name for each in unused(cart)] == ["other.jpg"]
    assert [each.name for each in unused(sledge)] == ["sledge_old.svg"]


def test_a_translation_shows_as_many_pictures_as_the_original(read, beside):
    beside("cart.png", png())
    problem = read(FRONT, f"![a cart](cart.png)\n{BODY}")
    german = (
        f"---\ntitle: Ein Wagen\nof: {digest(problem)}\n---\nEin Wagen mit {{{{m}}}} und {{{{v}}}}.\n\n"
        "## Impuls {#a}\nWie groß?\n\n# Texts\n\n> mass\ndie Masse\n\n> speed\ndas Tempo\n"
    )
    beside("cart.de.md", german)
    (said,) = [str(each) for each in faults(problem, translation(problem, "de"))]
    assert said.endswith("the statement shows 0 pictures, the original 1")
    beside("cart_de.png", png(4))
    beside("cart.de.md", german.replace("Ein Wagen mit", "![ein Wagen](cart_de.png) Ein Wagen mit"))
    found = translation(problem, "de")
    assert not [*faults(problem, found)]
    from corollary.messages import language

    with language("de"):
        assert base64.b64encode(png(4)).decode() in in_language(problem).statement


def test_a_translation_stays_good_when_a_picture_is_drawn_better(read, beside):
    beside("cart.png", png())
    text = f"A cart ![a cart](cart.png).\n{BODY}"
    before = digest(read(FRONT, text))
    beside("cart.png", png(7, 5))
    assert digest(read(FRONT, text)) == before
    assert digest(read(FRONT, text.replace("![a cart]", "![a cart at rest]"))) != before
    assert digest(read(FRONT, text.replace("A cart", "The cart"))) != before


def test_a_damaged_picture_is_refused_with_its_line(complaints, beside):
    beside("cart.png", png()[:-20])
    ((_line, sentence),) = complaints(FRONT, f"A cart ![a cart](cart.png).\n{BODY}")
    assert sentence.startswith("the picture cart.png is damaged: it ends too early")
