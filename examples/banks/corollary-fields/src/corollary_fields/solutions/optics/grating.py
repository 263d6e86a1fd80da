"""A grating: paths that differ by whole wavelengths."""

from corollary.author import HALF_PI, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(N, lam, L):
    theta, phi, x = unknowns("theta phi x")
    return derivation(
        step(
            theta,
            "From line to line, at the distance 1/N, the paths differ by one wavelength.",
            law("Grating", "sin(theta)/N = lam", N=N),
            where=(theta > 0) & (theta < HALF_PI),
            answers="a",
            mistakes=[
                mistake(
                    "At half a wavelength the light from neighbouring lines cancels.",
                    wrong("sin(theta)/N = lam/2", N=N),
                    where=(theta > 0) & (theta < HALF_PI),
                ),
                mistake(
                    "That is the second order.",
                    wrong("sin(theta)/N = 2*lam", N=N),
                    where=(theta > 0) & (theta < HALF_PI),
                ),
            ],
        ),
        step(
            phi,
            "Two wavelengths.",
            law("Grating", "sin(phi)/N = 2*lam", N=N),
            where=(phi > 0) & (phi < HALF_PI),
            answers="b",
            mistakes=[
                mistake("The sine doubles, not the angle.", wrong("phi = 2*theta")),
                mistake(
                    "Counted from the middle, the second order has two wavelengths, not three.",
                    wrong("sin(phi)/N = 3*lam/2", N=N),
                    where=(phi > 0) & (phi < HALF_PI),
                ),
            ],
        ),
        step(
            x,
            "One on each side of the middle.",
            law("Triangle", "x = 2*L*tan(theta)"),
            answers="c",
            mistakes=[
                mistake("There is one on each side.", wrong("x = L*tan(theta)")),
                mistake(
                    "The distance to the screen is the short side of the triangle, not the way of the light.",
                    wrong("x = 2*L*sin(theta)"),
                ),
            ],
        ),
    )
