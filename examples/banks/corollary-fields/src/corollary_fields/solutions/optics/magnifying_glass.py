"""A magnifying glass: an object within the focal length."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(f, a, h):
    b, H = unknowns("b H")
    return derivation(
        step(
            b,
            "The rays leave the lens as if they came from behind the stamp: the image distance is negative "
            "in the lens equation.",
            law("Lens equation", "1/f = 1/a - 1/b"),
            answers="a",
            mistakes=[
                mistake(
                    "Within the focal length there is no real image: the reciprocals cannot add up to 1/f.",
                    wrong("1/f = 1/b - 1/a"),
                ),
                mistake("The distances do not subtract, their reciprocals do.", wrong("b = f - a")),
            ],
            check="The closer to the focus, the further away is the image.",
        ),
        step(
            H,
            "Similar triangles with their tips in the middle of the lens.",
            law("Magnification", "H/h = b/a", H=H),
            answers="b",
            mistakes=[
                mistake("It should appear larger.", wrong("H/h = a/b", H=H)),
                mistake(
                    "Compare the image with the stamp, not with the focal length.", wrong("H/h = f/a", H=H)
                ),
            ],
        ),
        choice(
            "c",
            "A virtual image, seen through the lens.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "Have you ever read a stamp upside down through a magnifying glass?",
                "c": "That is a real image, of something beyond the focal length.",
            },
        ),
    )
