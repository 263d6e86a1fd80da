"""Newton's second law step by step: the second way in which ready scenes are confirmed, and how it is handed back."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from corollary.scenes.run import STEPS, Model, Observable, Observed, Run, by_relative_errors, components
from corollary.scenes.scene import Body, Force, Scene

ONE_BY_ONE = "momentum at every collision, one after the other"


def followed(
    scene: Scene, observe: Collection[Observable], tolerance: float, times: Sequence[float] = ()
) -> Run:
    from corollary.scenes.measure import measured  # here, since it brings scipy

    return measured(scene, observe, tolerance, STEPS, times)


def state_after(
    bodies: Sequence[Body], forces: Sequence[Force], until: float, tolerance: float
) -> tuple[tuple[float, ...], tuple[float, ...], float]:
    """Velocities and places at a time, and the relative error of the worse."""
    seen = {Observable.VELOCITIES, Observable.TRAJECTORY}
    run = followed(Scene(tuple(bodies), tuple(forces), until=until), seen, tolerance, (until,))
    velocities, places = (components(run.observed[name]) for name in ("velocities", "trajectory"))
    return velocities, places, max(run.relative_error("velocities"), run.relative_error("trajectory"))


def second_run(
    observed: Mapping[str, Observed],
    error: float,
    why: str = STEPS,
    model: Model = "integration",
    scales: Mapping[str, float] | None = None,
) -> Run:
    """A run whose values have one relative error, of their size or of `scales` (SI) where these are larger."""
    return by_relative_errors(observed, dict.fromkeys(observed, error), model, why, 0, "released", scales)
