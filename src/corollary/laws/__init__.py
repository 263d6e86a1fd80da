"""Physics as equations: what the textbook says, and what its letters mean here."""

from corollary.laws.collision import (
    after_elastic,
    half_oscillation,
    in_the_limit,
    reduced_mass,
    restitution,
    seen_from,
)
from corollary.laws.damped import damped_frequency, damped_rebound, damping_rate
from corollary.laws.energy import (
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
from corollary.laws.force import distance, ionic, on_a_circle, overlap, sphere_contact, towards_circle, within
from corollary.laws.general import level_floor, same
from corollary.laws.geometry import angle_between, line_of_centres, rope_height
from corollary.laws.impulse import (
    direction,
    force_on_standing,
    impulse_momentum,
    impulse_of,
    impulse_of_constant_force,
    mean_force,
    third_law,
)
from corollary.laws.law import Law, law
from corollary.laws.momentum import (
    change_of_momentum,
    conservation_of_momentum,
    external_impulse,
    magnitude,
    momentum,
    sticking,
    total_momentum,
)
from corollary.laws.potential import (
    angular_momentum,
    depth_of_well,
    energy_between,
    far_turning_point,
    oscillation,
    small_excess,
    turning_points,
)
from corollary.laws.rotation import elastic_on_hinge, hit_on_hinge
from corollary.laws.variable_mass import (
    burnt,
    change_in_absorption,
    growing,
    impulse_of_growing_weight,
    rocket_equation,
    thrust,
)

__all__ = [
    "Law", "after_elastic", "angle_between", "angular_momentum", "burnt", "change_in_absorption", "change_of_kinetic_energy",
    "change_of_kinetic_energy_in_plane", "change_of_momentum", "conservation_of_momentum", "damped_frequency",
    "damped_rebound", "damping_rate", "depth_of_well", "direction", "distance", "elastic", "elastic_on_hinge",
    "energy_at_heights", "energy_between", "external_impulse", "falling", "far_turning_point", "force_on_standing", "growing",
    "half_oscillation", "hit_on_hinge", "impulse_momentum", "impulse_of", "impulse_of_constant_force",
    "impulse_of_growing_weight", "in_the_limit", "ionic", "kinetic_energy", "law", "level_floor", "line_of_centres",
    "magnitude", "mean_force", "momentum", "on_a_circle", "oscillation", "overlap", "reduced_mass", "restitution",
    "rocket_equation", "rope_height", "same", "seen_from", "sliding_to_rest", "small_excess", "sphere_contact",
    "spring_at_rest", "sticking", "third_law", "thrust", "total_momentum", "towards_circle", "turning_points", "within",
    "work_of_net_force",
]  # fmt: skip
