"""No sign that is not talk can be deleted from an accepted answer without changing what is read."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from corollary.answers.read_case import read_case
from corollary.formula.numerals import TO_ASCII
from corollary.problem.bank import chapter_bank

TYPED = Path(__file__).parents[1] / "grading" / "answers"
TALK = {"strip_preamble", "split_remark", "apply_direction", "solve_left_side"}
# What may be left out and says the same: signs of products, marks of TeX and Markdown, and the zero before a point.
IDLE = re.compile(
    r"[\u200b-\u200f\u2062\ufeff*·×⋅ \s\\${}_`'\"]|(?<![0-9])\+|(?<=[eE])\+|\+(?=\s*[0-9])|(?<![0-9.,])0+(?=[0-9.,․])|\((?=at rest)"
)


def accepted() -> list[tuple[str, str]]:
    """Texts of the collected answers to one number, and the unit asked for."""
    bank = chapter_bank()
    found = set[tuple[str, str]]()
    for name in ("honest", "wrong"):
        for questions in json.loads((TYPED / f"{name}.json").read_text(encoding="utf-8")).values():
            for question in questions:
                part = bank[question["code"]].part(question["part"])
                if part.answer_types == ("value",):
                    found |= {(text, part.unit.text) for text in question["answers"] if isinstance(text, str)}
    return sorted(found)


def read(text: str, unit: str):
    found = read_case({"text": text, "field": "quantity", "unit": unit}, explain=True)
    return found["status"], found["read"], found["value"], found["figures"], found["stages"]


def violations(text: str, unit: str) -> list[str]:
    """The texts with one sign less that are read as the whole is."""
    status, *reading, stages = read(text, unit)
    if status != "ok" or "\\" in text or "$" in text:
        return []
    talk = [each["took"] for each in stages if each["stage"] in TALK]
    spoken = set[int]()
    for words in talk:
        for piece in {words, *words.split()}:
            for place in re.finditer(re.escape(piece), text.translate(TO_ASCII)) if piece else ():
                spoken |= set(range(*place.span()))
    idle = {place for each in IDLE.finditer(text) for place in range(*each.span())}
    found: list[str] = []
    for place, sign in enumerate(text):
        if reading[1] == 0 and sign in "0.,":
            continue
        if place in spoken | idle or sign.isalpha() or sign.isspace():
            continue
        shorter = text[:place] + text[place + 1 :]
        other, *read_then, _stages = read(shorter, unit)
        if other == "ok" and read_then == reading and not same_spelling(text, shorter):
            found.append(f"{text!r} without {sign!r}")
    return found


def same_spelling(text: str, shorter: str) -> bool:
    """True where both are known spellings of one thing: `km/h` and `kmh`, `10^-3` and the `10-3` that lost its raising."""
    return any(
        re.sub(known, "", text) == re.sub(known, "", shorter)
        for known in (
            r"(?<=km)/(?=h)",
            r"-(?=fold)",
            r"1(?=/s)",
            r"0(?=\.)|(?<=[.,])0+(?=\s|\)|$)|(?<=\.[0-9])0+(?=\s|\)|$)|[.,](?=0)",  # zeros of a zero, and of a calculation
            r"(?<=10)\^(?=-)",
            r"(?<=[a-z])\^(?=-?[0-9])",
            r"(?<=[A-Za-z])[-.](?=[a-zA-Z])",
            r"/(?=s$)",
            r"(?<=0)0$|\.0?(?=$|\s)|(?<=[.,])0+",
        )
    )


@pytest.mark.parametrize("every", [8, pytest.param(1, marks=pytest.mark.whole)])
def test_each_sign_of_the_collected_answers_counts(every):
    texts = accepted()
    assert len(texts) > 900
    assert not [each for text, unit in texts[::every] for each in violations(text, unit)]


NUMBER = st.one_of(
    st.decimals(min_value="0.01", max_value="9999", places=2).map(str),
    st.integers(1, 9999).map(str),
    st.tuples(st.integers(1, 9), st.integers(1, 99), st.integers(2, 9)).map(
        lambda n: f"{n[0]}.{n[1]}e{n[2]}"
    ),
)
UNIT = st.sampled_from(["N", "kN", "kg m/s^2", "N*m/m", "J/m", "mN", "kg*m*s^-2"])
FACTOR = st.integers(2, 9999).filter(lambda number: number % 10 and set(str(number)) != {"1"}).map(str)
SUM = st.tuples(FACTOR, UNIT, st.sampled_from([" + ", " - ", "+"]), FACTOR, UNIT).map("".join)
QUANTITY = st.one_of(
    st.tuples(st.sampled_from(["", "-"]), NUMBER, st.just(" "), UNIT).map("".join),
    SUM,
    st.tuples(FACTOR, st.sampled_from(["*", "/"]), FACTOR, st.just(" "), UNIT).map("".join),
    st.tuples(
        st.sampled_from(["F", "2F", "-F", "F/2", "F*dt", "x + 2", "cos(F)"]),
        st.just(" = "),
        NUMBER,
        st.just(" N"),
    ).map("".join),
    st.tuples(st.integers(3, 9).map(str), st.sampled_from(["! N", "! * 2 N", "*3! N"])).map("".join),
)


@given(QUANTITY)
@example("5! N")
@example("11* N")
@example("F = 2 N")
def test_each_sign_of_a_composed_answer_counts(text):
    assert not violations(text, "N")
