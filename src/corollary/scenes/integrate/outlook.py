"""Expected time to follow a collision in a row, from a rough run by velocity Verlet at a tenth of the kernel's cost."""

from __future__ import annotations

import math

import numpy as np

from corollary.scenes.row import RowOfBodies

# A step as a share of the shortest swing between neighbours, that into a contact as a share of the step that is due in it.
SHARE, INTO = 0.5, 0.1
# Slower, nothing counts as moving.
STILL = 1e-14


def rough_steps(line: RowOfBodies, most: int) -> int:
    """How many rough steps a line in natural units takes until its bodies fly apart, `most` if it takes more; weight and damping are left out.

    A swing takes some fifteen of them, however many the followed run takes: 0.1 to 0.45 times as many as that takes at 1e-13.
    Masses that are alike leave next to nothing of their motion behind, and what rounding makes of it here is counted, too.
    """
    inverse = np.array([1.0 / m for m in line.masses])
    k, q = np.array([c.k for c in line.contacts]), np.array([c.q for c in line.contacts])
    velocities, overlaps = np.array(line.velocities), -np.array(line.gaps)
    pair = inverse[:-1] + inverse[1:]
    # Of two bodies that meet with a speed s: the angular frequency where they are squeezed most goes with s^((q - 1)/(q + 1)).
    power = 0.5 * (1.0 - q) / (q + 1.0)
    share = SHARE / np.sqrt(pair * k * q) * (0.5 * (q + 1.0) / (k * pair)) ** power
    stored = 2.0 * pair / (q + 1.0)
    pushes = np.zeros(len(inverse) + 1)
    half, stride = 0.5 * inverse, 0.0
    with np.errstate(all="ignore"):  # what leaves the range of a computer goes on until the end
        for step in range(most):
            deep = np.maximum(overlaps, 0.0)
            pushes[1:-1] = force = k * deep**q
            gained = half * (pushes[:-1] - pushes[1:])
            velocities += stride * gained
            closing = velocities[:-1] - velocities[1:]
            squared = closing * closing + stored * force * deep
            swing = share * squared**power
            change = np.maximum(-overlaps / closing, INTO * swing)  # into a contact, or out of it
            strides = np.where(closing < 0.0, np.minimum(swing, change), swing)
            np.copyto(strides, change, where=overlaps < 0.0)
            strides[(overlaps <= 0.0) & (closing <= STILL) | (squared < STILL * STILL)] = math.inf
            stride = strides.min()
            if stride == math.inf:
                return step
            velocities += stride * gained
            overlaps += stride * (velocities[:-1] - velocities[1:])
    return most
