"""What algebra sees to vanish: also where one root is written in two ways."""

from __future__ import annotations

import pytest
import sympy

from corollary.derive.assumptions import vanishes

V = sympy.symbols("vx vy vz", real=True)
B = sympy.symbols("Bx Bz", real=True)
ALONG, SPEED2, FIELD2 = B[0] * V[0] + B[1] * V[2], sum(each**2 for each in V), B[0] ** 2 + B[1] ** 2
ACROSS = sympy.sqrt(SPEED2 - ALONG**2 / FIELD2)


@pytest.mark.parametrize(
    ("residual", "expected"),
    [
        (ACROSS - sympy.sqrt(SPEED2) * sympy.sqrt(1 - ALONG**2 / (FIELD2 * SPEED2)), True),
        (ACROSS - sympy.sqrt(SPEED2) * sympy.sqrt(1 - ALONG**2 / (2 * FIELD2 * SPEED2)), False),
        (ACROSS + sympy.sqrt(SPEED2) * sympy.sqrt(1 - ALONG**2 / (FIELD2 * SPEED2)), False),
    ],
)
def test_the_component_of_a_velocity_across_a_field(residual, expected):
    assert vanishes(residual) is expected
