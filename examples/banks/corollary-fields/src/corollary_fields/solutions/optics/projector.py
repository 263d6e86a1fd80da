"""A projector: the lens equation, and similar triangles."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(f, b, G):
    a, B = unknowns("a B")
    return derivation(
        step(
            a,
            "The lens equation.",
            law("Lens equation", "1/f = 1/a + 1/b"),
            answers="a",
            mistakes=[
                mistake(
                    "The slide is not in the focus, or the image would be infinitely far away.",
                    wrong("a = f"),
                ),
                mistake(
                    "Object and image lie on opposite sides of the lens, both at positive distances: mind "
                    "the sign.",
                    wrong("1/f = 1/a - 1/b"),
                ),
            ],
            check="Just beyond the focal length.",
        ),
        step(
            B,
            "The ray through the middle of the lens is not bent: similar triangles.",
            law("Magnification", "B/G = b/a", G=G, B=B),
            answers="b",
            mistakes=[
                mistake(
                    "The image is further away than the slide: it should be the larger one.",
                    wrong("B/G = a/b", G=G, B=B),
                ),
                mistake(
                    "The distances count from the lens, not from the focus.", wrong("B/G = b/f", G=G, B=B)
                ),
            ],
        ),
        choice(
            "c",
            "A smaller distance of the image needs a larger one of the slide.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "In the lens equation the sum of the two reciprocals stays the same.",
                "c": "Then the image would be sharp where the screen was.",
            },
        ),
    )
