"""Our constants of nature are scipy's: values, uncertainties and units of the same edition."""

from __future__ import annotations

import pytest
import scipy.constants as scipy_constants

from corollary.units.constants import CONSTANTS, EDITION
from corollary.units.unit import unit

IN_SCIPY = {
    "q_e": "elementary charge",
    "F_A": "Faraday constant",
    "b_W": "Wien wavelength displacement law constant",
    "epsilon_0": "vacuum electric permittivity",
    "mu_0": "vacuum mag. permeability",
    "atm_n": "standard atmosphere",
    "alpha_f": "fine-structure constant",
}


@pytest.mark.parametrize("symbol", CONSTANTS)
def test_a_constant_is_what_scipy_has(symbol):
    ours = CONSTANTS[symbol]
    value, its_unit, uncertainty = scipy_constants.physical_constants[IN_SCIPY.get(symbol, ours.name)]
    assert float(ours.value) == pytest.approx(value, rel=1e-9)
    assert float(ours.uncertainty) == pytest.approx(uncertainty, rel=1e-6)
    written = unit(its_unit.replace("E_h", "J") or "1")
    assert (ours.unit.dimension, ours.unit.factor) == (written.dimension, written.factor)


def test_the_edition_is_scipys():
    """It names its tables by the year; the newest is the one it uses."""
    from scipy.constants import _codata

    assert EDITION.split()[1] == max(
        name[-4:] for name in vars(_codata) if name.startswith("_physical_constants_20")
    )
