"""Physics as equations: what the textbook says, and what its letters mean here."""

from corollary.law.collision import half_oscillation, reduced_mass, restitution
from corollary.law.energy import (
    change_of_kinetic_energy,
    elastic,
    falling,
    kinetic_energy,
    sliding_to_rest,
    spring_at_rest,
)
from corollary.law.general import level_floor, same
from corollary.law.impulse import impulse_momentum, mean_force, third_law
from corollary.law.law import Law, law
from corollary.law.momentum import change_of_momentum, conservation_of_momentum, momentum, sticking

__all__ = [
    "Law", "change_of_kinetic_energy", "change_of_momentum", "conservation_of_momentum", "elastic", "falling", "half_oscillation",
    "impulse_momentum", "kinetic_energy", "law", "level_floor", "mean_force", "momentum", "reduced_mass", "restitution", "same",
    "sliding_to_rest", "spring_at_rest", "sticking", "third_law",
]  # fmt: skip
