import numpy as np


def catch(m, k, b, d, x, y, vx, vy, t1, T, dt):
    r, v = np.array([x, y], dtype=float), np.array([vx, vy], dtype=float)
    met = False
    for step in range(round(T / dt)):
        if not met and step >= round(t1 / dt):
            v, met = v / 2, True  # momentum is kept, B was at rest; mass and force both double from here on
        length = np.hypot(*r)
        F = -k * (length - b) * r / length if length < b + d else np.zeros(2)
        v = v + F / m * dt
        r = r + v * dt
    return r[0], r[1]
