"""The page on judging programs: its judge judges, its sentences are translated, and it names all that judges may import."""

from __future__ import annotations

import math
import random
import re
from pathlib import Path

import numpy as np
import pytest
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po

import corollary.programs
from corollary.derive.beside import LazyModule
from corollary.messages import language
from corollary.programs import Called, Fault

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "programs.md").read_text(encoding="utf-8")
FALL, TRANSLATED = re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


@pytest.fixture
def judge(tmp_path) -> LazyModule:
    path = tmp_path / "judge_fall.py"
    path.write_text(FALL, encoding="utf-8")
    return LazyModule(path, tmp_path)


def fallen(g, tau, T, dt, drag=1.0, order=2):
    """The way of a ball with drag, by steps of first order or of second."""
    x = v = 0.0
    for _ in range(round(T / dt)):
        half = v + (g - drag * v / tau) * dt / 2
        x, v = x + (half if order == 2 else v) * dt, v + (g - drag * half / tau) * dt
    return x


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("seed", range(3))
def test_its_judge_takes_any_method_that_converges(judge, order, seed):
    cases = judge.fall_inputs({}, random.Random(seed).uniform)
    assert not isinstance(
        judge.judge_fall({}, [Called(each, (fallen(**each, order=order),)) for each in cases]), Fault
    )


def test_its_judge_tells_what_is_wrong(judge):
    cases = judge.fall_inputs({}, random.Random(1).uniform)
    free = [Called(each, (fallen(**each, drag=0.0),)) for each in cases]
    assert judge.judge_fall({}, free) == Fault("The drag is missing.", known=True)
    late = [Called(each, (1.3 * fallen(**each),)) for each in cases]
    assert judge.judge_fall({}, late) == Fault("The way is not right.")
    none = [Called(each, (math.nan, 1.0)) for each in cases]
    assert judge.judge_fall({}, none) == Fault("It returns 2 numbers; return the way.")


def test_its_sentence_is_said_in_the_language_of_the_bank_s_catalogue(tmp_path):
    """Where the page puts it, compiled as Babel compiles it; in another language it is read as it stands."""
    german = tmp_path / "solutions" / "locale" / "de" / "LC_MESSAGES"
    path = tmp_path / "solutions" / "carts" / "ball" / "judge_ball.py"
    for each in (german, path.parent):
        each.mkdir(parents=True)
    path.write_text(TRANSLATED, encoding="utf-8")
    texts = 'msgid ""\nmsgstr "Content-Type: text/plain; charset=utf-8\\n"\n\n'
    texts += 'msgid "With {way} m the ball is too far."\nmsgstr "Mit {way} m ist der Ball zu weit."\n'
    (german / "messages.po").write_text(texts, encoding="utf-8")
    with (german / "messages.po").open("rb") as source, (german / "messages.mo").open("wb") as target:
        write_mo(target, read_po(source))
    ball = LazyModule(path, path.parents[1])
    said = {}
    for code in ("en", "de", "nb"):
        with language(code):
            said[code] = ball.fault(1.25).sentence
    assert said == {
        "en": "With 1.25 m the ball is too far.",
        "de": "Mit 1,25 m ist der Ball zu weit.",
        "nb": "With 1,25 m the ball is too far.",
    }


def test_it_names_all_that_judges_may_import():
    table = PAGE.partition("## What `corollary.programs` has")[2]
    named = set(
        re.findall(r"`(\w+)(?:\([^`]*\))?`", "\n".join(re.findall(r"^\| ([^|]*) \|", table, re.MULTILINE)))
    )
    assert named == set(corollary.programs.__all__)
    assert all(getattr(corollary.programs, name) is not None for name in named)
    assert np.isclose(corollary.programs.contact_time(0.05, 1e4, 1.0, 0.3), math.pi * math.sqrt(0.05 / 1e4))
