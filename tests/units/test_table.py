"""A unit is one row, also that of somebody else's package."""

from __future__ import annotations

import importlib
import sys

import pytest

from corollary.answers.quantity import Reading, read_quantity
from corollary.formula.errors import ParseError
from corollary.units import register
from corollary.units.unit import _READ, read_unit, show, unit
from corollary.units.unit_table import ENGLISH, ROWS, UNITS, WITH_PREFIXES, rows_of_others


@pytest.fixture
def table_restored():
    """All that registering a unit changes is for the whole process: other tests carry what others registered into notebooks."""
    before = dict(UNITS), dict(WITH_PREFIXES), set(ENGLISH), list(ROWS)
    yield
    for kept, content in zip((UNITS, WITH_PREFIXES, ENGLISH), before[:3], strict=True):
        kept.clear()
        kept.update(content)
    ROWS[:] = before[3]
    _READ.clear()


def test_a_module_brings_a_unit(tmp_path, monkeypatch, table_restored):
    """As a plug-in's answer type or bank does: the module is imported, and from then on the unit is read."""
    tmp_path.joinpath("drams_and_barrels.py").write_text(
        "from corollary.units import register\n"
        "register('bbl', 'm^3', '0.158987294928', 'k M', 'barrel')\n"
        "register('D', 'A s m', '3.33564e-30', words='debye')\n"
    )
    assert isinstance(read_unit("bbl"), ParseError)
    monkeypatch.syspath_prepend(tmp_path)
    importlib.import_module("drams_and_barrels")
    monkeypatch.delitem(sys.modules, "drams_and_barrels")
    found = read_quantity("2 kilobarrels/h", unit("m^3/s"))
    assert isinstance(found, Reading)
    assert (found.fit, found.as_read) == ("fits", "2 kbbl/h")
    assert unit("kbbl").si == pytest.approx(158.987294928)
    assert show(unit("D*bbl^2")) == "D bbl²"
    assert [row[0] for row in rows_of_others()] == ["bbl", "D"]


def test_another_test_s_units_are_gone():
    """Whichever of the two ran first."""
    assert rows_of_others() == []
    assert isinstance(read_unit("bbl"), ParseError)


@pytest.mark.parametrize(
    ("row", "words"),
    [
        (("T", "kg"), "the unit T: T means T already"),
        (("q", "kg", "1", "", "newton"), "the unit q: newton means N already"),
        (("q", "kg V"), "not a product of base units"),
    ],
)
def test_a_row_that_will_not_do_changes_nothing(row, words, table_restored):
    before = dict(UNITS)
    with pytest.raises(ValueError, match=words):
        register(*row)
    assert before == UNITS


def test_no_two_rows_may_be_typed_alike():
    """Each symbol with each of its prefixes is one unit: registering the table did not overwrite anything."""
    assert UNITS["min"].si == 60
    assert UNITS["cd"].dimension.powers() == {"cd": 1}
    assert UNITS["Pa"].dimension.powers() == {"kg": 1, "m": -1, "s": -2}
    assert {UNITS[each].text for each in ("kg", "Kg", "kilograms", "Kilogramm".lower())} == {"kg"}
    assert {UNITS[each].text for each in ("us", "µs", "μs", "microseconds")} == {"us"}
    assert {UNITS[each].text for each in ("ohm", "Ω", "Ω", "ohms")} == {"ohm"}
