def swing(m, k, b, x, v, T, dt):
    for _ in range(round(T / dt)):
        v = v + (-k * x - b * v) / m * dt  # first the velocity, then the place with the new one
        x = x + v * dt
    return x, v
