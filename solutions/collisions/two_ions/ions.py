import numpy as np


def ions(C, mA, mB, rA, vA, rB, vB, T, dt):
    rA, vA, rB, vB = (np.array(x, dtype=float) for x in (rA, vA, rB, vB))
    for step in range(round(T / dt)):
        Dr = rB - rA
        F = -C * Dr / np.linalg.norm(Dr) ** 3
        vA = vA + F / mA * dt
        vB = vB - F / mB * dt
        rA = rA + vA * dt
        rB = rB + vB * dt
    return [vA[0], vA[1], vB[0], vB[1]]
