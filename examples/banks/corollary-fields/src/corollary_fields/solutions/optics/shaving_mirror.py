"""A shaving mirror: a virtual image behind it, a real one before it."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(r, a, A):
    f, b, q, B = unknowns("f b q B")
    return derivation(
        step(
            f,
            "A hollow mirror gathers parallel rays at half of its radius.",
            law("Focal length", "f = r/2"),
            answers="a",
            mistakes=[
                mistake("The centre of the sphere is not the focus.", wrong("f = r")),
                mistake("Half of the radius, not twice.", wrong("f = 2*r")),
            ],
        ),
        step(
            b,
            "Within the focal length the image is virtual, behind the mirror.",
            law("Mirror equation", "1/f = 1/a - 1/b"),
            answers="b",
            mistakes=[
                mistake(
                    "The image is larger than your face: is it nearer to the mirror, or further away?",
                    wrong("1/b = 1/a + 1/f"),
                ),
                mistake("That is a flat mirror.", wrong("b = a")),
            ],
        ),
        step(
            q,
            "Image and object stand in the ratio of their distances.",
            law("Magnification", "q = b/a"),
            answers="c",
            mistakes=[
                mistake("You have turned the ratio round.", wrong("q = a/b")),
                mistake("The focal length is not the distance of the image.", wrong("q = f/a")),
            ],
        ),
        step(
            B,
            "Beyond the focal length the image is real.",
            law("Mirror equation", "1/f = 1/A + 1/B", A=A, B=B),
            answers="d",
            mistakes=[
                mistake(
                    "It arises in the focus only for something infinitely far away.", wrong("B = f", B=B)
                ),
                mistake(
                    "The lamp is beyond the focal length: its image is real, and the reciprocals add.",
                    wrong("1/B = 1/f + 1/A", A=A, B=B),
                ),
            ],
            check="Just beyond the focal length.",
        ),
    )
