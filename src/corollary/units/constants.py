"""Constants of nature by name: value, standard uncertainty and unit, as CODATA recommends them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from corollary.units.unit import Unit, show, unit

EDITION = "CODATA 2022"  # Mohr, Newell, Taylor, Tiesinga, Rev. Mod. Phys. 97 (2025) 025002


@dataclass(frozen=True, slots=True)
class Constant:
    """`uncertainty` is 0 where the value is exact by definition (or follows from such values, and is rounded)."""

    symbol: str
    name: str
    value: Fraction
    uncertainty: Fraction
    unit: Unit

    @property
    def source(self) -> str:
        """Where the value is from, as a worked solution says it."""
        return f"{EDITION}, {'exact' if not self.uncertainty else f'± {float(self.uncertainty):.2g} {show(self.unit)}'}"


TABLE = """
c         | speed of light in vacuum          | 299792458          | 0       | m/s
h         | Planck constant                   | 6.62607015e-34     | 0       | J s
hbar      | reduced Planck constant           | 1.054571817e-34    | 0       | J s
q_e       | elementary charge                 | 1.602176634e-19    | 0       | C
k_B       | Boltzmann constant                | 1.380649e-23       | 0       | J/K
N_A       | Avogadro constant                 | 6.02214076e23      | 0       | 1/mol
R         | molar gas constant                | 8.314462618        | 0       | J/(mol K)
F_A       | Faraday constant                  | 96485.33212        | 0       | C/mol
sigma     | Stefan-Boltzmann constant         | 5.670374419e-8     | 0       | W/(m^2 K^4)
b_W       | Wien displacement constant        | 2.897771955e-3     | 0       | m K
g_n       | standard acceleration of gravity  | 9.80665            | 0       | m/s^2
atm_n     | standard atmosphere               | 101325             | 0       | Pa
G         | Newtonian constant of gravitation | 6.67430e-11        | 1.5e-15 | m^3/(kg s^2)
epsilon_0 | vacuum electric permittivity      | 8.8541878188e-12   | 1.4e-21 | F/m
mu_0      | vacuum magnetic permeability      | 1.25663706127e-6   | 2.0e-16 | N/A^2
m_e       | electron mass                     | 9.1093837139e-31   | 2.8e-40 | kg
m_p       | proton mass                       | 1.67262192595e-27  | 5.2e-37 | kg
m_n       | neutron mass                      | 1.67492750056e-27  | 8.5e-37 | kg
u         | atomic mass constant              | 1.66053906892e-27  | 5.2e-37 | kg
a_0       | Bohr radius                       | 5.29177210544e-11  | 8.2e-21 | m
R_inf     | Rydberg constant                  | 10973731.568157    | 1.2e-5  | 1/m
alpha_f   | fine-structure constant           | 7.2973525643e-3    | 1.1e-12 | 1
"""
CONSTANTS = {
    symbol: Constant(symbol, name, Fraction(value), Fraction(uncertainty), unit(its_unit))
    for row in TABLE.strip().splitlines()
    for symbol, name, value, uncertainty, its_unit in [[cell.strip() for cell in row.split("|")]]
}
