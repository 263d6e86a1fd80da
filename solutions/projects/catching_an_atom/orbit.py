import numpy as np


def orbit(m, k, b, d, x, y, vx, vy, T, dt):
    r, v = np.array([x, y], dtype=float), np.array([vx, vy], dtype=float)
    for step in range(round(T / dt)):
        length = np.hypot(*r)
        F = -k * (length - b) * r / length if length < b + d else np.zeros(2)
        v = v + F / m * dt
        r = r + v * dt
    return r[0], r[1]
