import numpy as np


def cradle(N, m, k, q, v0, dt):
    v = np.zeros(N)
    v[0] = v0
    shift = np.zeros(N)
    touched = False
    for step in range(1_000_000):
        overlap = np.clip(shift[:-1] - shift[1:], 0, None)
        force = k * overlap**q
        if touched and not overlap.any():
            break
        touched = touched or bool(overlap.any())
        a = np.zeros(N)
        a[:-1] -= force / m
        a[1:] += force / m
        v = v + a * dt
        shift = shift + v * dt
    return list(v)
