"""A share of the draws of benchmarks/calibration.py: bounds hold always, estimates as often as is published, none is far off."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))

from calibration import FAMILIES, calibrated


@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.name)
def test_stated_errors_hold(family):
    found = calibrated(family, 15 if family.digits <= 50 else 3)  # references with more digits take seconds
    assert found.values > found.refused
    assert found.worst <= (1.0 + 1e-9 if found.bounds == found.runs else 3.0), found.settings
