"""Errors that two runs agree about by chance: the motion of what is tied together is held against scipy's at a much finer tolerance."""

from __future__ import annotations

import math

from scipy.integrate import solve_ivp

from corollary.scenes.body import Body
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.plan import play
from corollary.scenes.run import Observable, components
from corollary.scenes.scene import Scene

G = 9.81


def test_what_is_off_in_one_body_is_off_in_the_one_it_pulls():
    m, c, k, wind, until = (
        (0.39287333439465305, 1.0740804660514471),
        0.3034237549097778,
        192.1553966817749,
        -2.0663043404936063,
        2.739151684221378,
    )

    def slope(_, y):
        apart = y[2:4] - y[:2]
        r = math.hypot(*apart)
        pull, air = k * (r - 1.0) * apart / r, y[4:6] - (wind, 0.0)
        down = (0.0, -G)
        return [*y[4:], *((pull - c * math.hypot(*air) * air) / m[0] + down), *(-pull / m[1] + down)]

    truth = solve_ivp(slope, (0.0, until), (0.0, 1.0) + (0.0,) * 6, "DOP853", rtol=3e-14, atol=1e-15).y[
        4:, -1
    ]
    bodies = Body(m[0], (0.0, 1.0), (0.0, 0.0)), Body(m[1], (0.0, 0.0), (0.0, 0.0))
    forces = Spring((0, 1), k, 1.0), Weight(G), Drag(0, quadratic=c, wind=(wind, 0.0))
    found = play(Scene(bodies, forces, until=until), {Observable.VELOCITIES}).measured["velocities"]
    errors = components(found.error)
    assert all(abs(v - t) < e < 1e-9 for v, e, t in zip(components(found.value), errors, truth, strict=True))
