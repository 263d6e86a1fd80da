"""What other packages add is found by name, and what cannot be used is said in a sentence that names the package."""

from __future__ import annotations

import pytest

from corollary.answers.registry import UnknownAnswerType, answer_type, judging
from corollary.plug_ins import PlugInFault, load, plug_ins, state

GROUP = "corollary.exports"


def test_found_by_name(installed):
    installed("rollcall", {GROUP: ["roll = rollcall:ROLL"]}, {"rollcall.py": "ROLL = 7"})
    installed(
        "choir", {GROUP: ["song = choir:SONG"], "corollary.laws": ["song = choir"]}, {"choir.py": "SONG = 8"}
    )
    assert {name: load(entry, "the export") for name, entry in plug_ins(GROUP).items()} == {
        "roll": 7,
        "song": 8,
    }


def test_one_name_of_two_packages_is_refused_with_both(installed):
    installed("rollcall", {GROUP: ["roll = rollcall:ROLL"]}, {"rollcall.py": "ROLL = 7"})
    installed("bakery", {GROUP: ["roll = bakery:ROLL"]}, {"bakery.py": "ROLL = 8"})
    with pytest.raises(PlugInFault) as found:
        plug_ins(GROUP)
    for word in ("rollcall", "bakery", "both bring roll", "uninstall"):
        assert word in str(found.value)


def test_a_name_that_is_ours_is_refused_too(installed):
    installed("prices", {"corollary.answers": ["value = prices"]}, {"prices.py": ""})
    with pytest.raises(
        PlugInFault, match="corollary-physics and prices are both installed and both bring value"
    ):
        answer_type("ratio")
    assert answer_type("value").word == "number"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("import nothing_of_this_name", "ModuleNotFoundError: No module named 'nothing_of_this_name'"),
        ("1/0", "ZeroDivisionError: division by zero"),
        ("raise SystemError('no such machine')", "SystemError: no such machine"),
        ("", "AttributeError: module 'rollcall' has no attribute 'ROLL'"),
        ("def", "SyntaxError: invalid syntax"),
    ],
)
def test_what_cannot_be_loaded(installed, text, why):
    installed("rollcall", {GROUP: ["roll = rollcall:ROLL"]}, {"rollcall.py": text})
    with pytest.raises(
        PlugInFault, match="the export roll of rollcall cannot be used: rollcall:ROLL: "
    ) as found:
        load(plug_ins(GROUP)["roll"], "the export")
    assert why in str(found.value)
    assert str(found.value).endswith("update that package or uninstall it")


def test_an_answer_type_without_its_halves(installed):
    points = {"corollary.answers": ["shade = shades", "tint = tints"]}
    installed(
        "painting",
        points,
        {"shades/__init__.py": "", "shades/reading.py": "TYPE = 1", "tints/__init__.py": ""},
    )
    with pytest.raises(
        PlugInFault, match=r"the answer type shade of painting cannot .* No module named 'shades.judging'"
    ):
        judging("shade")
    with pytest.raises(
        PlugInFault, match=r"the answer type tint of painting cannot .* No module named 'tints.reading'"
    ):
        answer_type("tint")
    with pytest.raises(
        UnknownAnswerType, match=r"there is no answer type hue; choose one of value, .*shade, tint"
    ):
        answer_type("hue")


def test_an_answer_type_whose_reading_holds_none(installed):
    installed(
        "painting", {"corollary.answers": ["glow = glows"]}, {"glows/__init__.py": "", "glows/reading.py": ""}
    )
    with pytest.raises(PlugInFault, match=r"the answer type glow of painting .* its reading\.py has no TYPE"):
        answer_type("glow")


def test_their_programs_are_told_apart(installed):
    groups = ("corollary.laws", "corollary.banks")
    bare = state(groups)
    place = installed(
        "heat", {"corollary.laws": ["heat = heated"]}, {"heated/__init__.py": "", "heated/more.py": ""}
    )
    first = state(groups)
    assert first != bare
    assert str(place / "heated" / "more.py") in first
    (place / "heated" / "more.py").write_text("x = 1")
    state.cache_clear()
    assert state(groups) != first
