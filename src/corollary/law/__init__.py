"""Physics as equations: what the textbook says, and what its letters mean here."""

from corollary.law.collision import half_oscillation, reduced_mass, restitution
from corollary.law.energy import (
    change_of_kinetic_energy,
    change_of_kinetic_energy_in_plane,
    elastic,
    energy_at_heights,
    falling,
    kinetic_energy,
    sliding_to_rest,
    spring_at_rest,
    work_of_net_force,
)
from corollary.law.general import level_floor, same
from corollary.law.impulse import (
    direction,
    force_on_standing,
    impulse_momentum,
    impulse_of,
    impulse_of_constant_force,
    mean_force,
    third_law,
)
from corollary.law.law import Law, law
from corollary.law.momentum import (
    change_of_momentum,
    conservation_of_momentum,
    external_impulse,
    magnitude,
    momentum,
    sticking,
    total_momentum,
)

__all__ = [
    "Law", "change_of_kinetic_energy", "change_of_kinetic_energy_in_plane", "change_of_momentum", "conservation_of_momentum",
    "direction", "elastic", "energy_at_heights", "external_impulse", "falling", "force_on_standing", "half_oscillation",
    "impulse_momentum", "impulse_of", "impulse_of_constant_force", "kinetic_energy", "law", "level_floor", "magnitude",
    "mean_force", "momentum", "reduced_mass", "restitution", "same", "sliding_to_rest", "spring_at_rest", "sticking", "third_law",
    "total_momentum", "work_of_net_force",
]  # fmt: skip
