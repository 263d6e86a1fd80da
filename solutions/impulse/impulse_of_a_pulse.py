"""Impulse of a pulse: the area under the curve, and the rectangle of the same area."""

from corollary.author import simulate


def scene(F0, T, answer):
    """A body pushed by half a sine of this mean force: the run tells the peak and the impulse."""
    return [simulate("kick", {"F": answer["b"], "dt": T, "pulse": 1}, peak_force=F0, impulse=answer["a"])]
