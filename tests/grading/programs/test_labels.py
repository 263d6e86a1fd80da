"""Labels of axes as people write them: the unit in brackets, below a slash, behind a word, or at the end."""

import pytest

from corollary.grading.programs.panels import read_label
from corollary.units.unit import unit


@pytest.mark.parametrize(
    ("label", "name", "size"),
    [
        ("F [N]", "f", "N"),
        ("p (kg m/s)", "p", "N s"),
        ("t / ms", "t", "ms"),
        ("time in ms", "time in ms", "ms"),
        ("Zeit, s", "zeit s", "s"),
        ("momentum kg m/s", "momentum kg m", "kg*m/s"),
        ("time s", "time s", "s"),
        (r"$p_x$ [$\mathrm{N\,s}$]", "p x", "N s"),
        (r"$\frac{F}{\mathrm{kN}}$", "f", "kN"),
    ],
)
def test_a_label_is_read(label, name, size):
    found = read_label(label)
    wanted = unit(size)
    assert found.unit(wanted.dimension) is not None, found
    assert found.unit(wanted.dimension).si == wanted.si
    if "frac" not in label:
        assert found.name == name


@pytest.mark.parametrize("label", ["", "force", "F [furlongs]"])
def test_a_label_without_a_unit_has_none(label):
    assert read_label(label).unit(unit("kg").dimension) is None
