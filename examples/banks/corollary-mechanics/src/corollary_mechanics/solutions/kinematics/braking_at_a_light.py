"""Braking at a traffic light: a way at constant speed, and one at constant deceleration."""

from corollary.author import simulate
from corollary.scenes.forces.contact import Friction
from corollary.scenes.scene import Body, Scene


def scene(v, t, b, answer):
    """A body that a rough table slows down by b."""
    sliding = Scene((Body(1.0, (answer["a"],), (v,)),), (Friction(0, b / 9.8),), until=2 * answer["b"])
    return [simulate(sliding, trajectory=(answer["c"],))]
