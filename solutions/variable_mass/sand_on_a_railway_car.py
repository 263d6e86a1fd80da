"""Sand on a railway car: a force is needed to keep a velocity, when there is ever more to move."""

from corollary.author import simulate


def scene(v, R, ux, m0, t, answer):
    """The sand comes in a thousand shovels, each caught by the car; once falling straight down, once with its own velocity."""
    still = {"v": v, "R": R, "t": t}
    return [
        simulate(
            "railway_car",
            still | {"ux": 0.0},
            mean_force=answer["a"],
            work=answer["b"] * t,
            energy_lost=answer["d"] * t,
        ),
        simulate("railway_car", still | {"ux": ux}, mean_force=answer["c"]),
    ]
