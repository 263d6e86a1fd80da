def bounce(m, k, R, y0, v0, g, dt):
    y, v = y0, v0
    largest, steps = 0.0, 0
    while True:
        squeezed = max(R - y, 0.0)
        if squeezed > 0:
            steps += 1
        elif steps > 0:
            return [v, largest, steps * dt]
        F = k * squeezed**1.5 - m * g
        largest = max(largest, F)
        v = v + F / m * dt
        y = y + v * dt
