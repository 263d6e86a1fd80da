import numpy as np


def spheres(mA, mB, R, k, eta, rA, vA, rB, vB, T, dt):
    rA, vA, rB, vB = (np.array(x, dtype=float) for x in (rA, vA, rB, vB))
    for step in range(round(T / dt)):
        Dr, Dv = rB - rA, vB - vA
        r = np.linalg.norm(Dr)
        F = -k * (2 * R - r) ** 1.5 * Dr / r + eta * Dv if r < 2 * R else np.zeros(2)
        vA = vA + F / mA * dt
        vB = vB - F / mB * dt
        rA = rA + vA * dt
        rB = rB + vB * dt
    return [vA[0], vA[1], vB[0], vB[1]]
