"""What can be observed of a scene, each defined so exactly that two programs must agree on it."""

from __future__ import annotations

from enum import Enum


class Observable(Enum):
    """The value is the name under which a run reports it."""

    VELOCITIES = "velocities"
    DURATION = "duration"
    LARGEST_OVERLAP = "largest_overlap"
    PEAK_FORCE = "peak_force"
    ENERGY_RATIO = "energy_ratio"
    TURNING_POINTS = "turning_points"
    PERIOD = "period"
    IMPULSE = "impulse"
    MOMENTUM = "momentum"
    ENERGY = "energy"
    TRAJECTORY = "trajectory"


MEANING: dict[Observable, str] = {
    Observable.VELOCITIES: "of every body at the end: after the last opening, or at the time asked for (m/s)",
    Observable.DURATION: "from the moment of the first touch to that of the last opening (s), not counted in samples",
    Observable.LARGEST_OVERLAP: "the largest there is at any moment between any two bodies, none if they never touch (m)",
    Observable.PEAK_FORCE: "the largest contact force there is at any moment between any two bodies, drag included (N)",
    Observable.ENERGY_RATIO: "kinetic energy at the end over that at the start",
    Observable.TURNING_POINTS: "distances from the origin at which the first body turns back, smallest first (m)",
    Observable.PERIOD: "time between two returns of the first body's distance to its smallest value (s)",
    Observable.IMPULSE: "of all forces on each body that is no wall, from start to end: its change of momentum (kg m/s)",
    Observable.MOMENTUM: "of all bodies that are no walls together, at the end (kg m/s)",
    Observable.ENERGY: "kinetic energy, and potential energy of every force that has one, at the end (J); zero as each force defines it",
    Observable.TRAJECTORY: "places of all bodies, body after body, at each of the times asked for, time after time (m); looked up within "
    "the steps, not between samples. Without times: at 101 equally spaced ones, from 0 to the end that the scene names",
}
