"""Rails in summer: length goes with the change of temperature."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(L, alpha, T, S, W, E):
    x, y, p = unknowns("x y p")
    return derivation(
        step(
            x,
            "The bridge grows in proportion to its length and to the change of temperature.",
            law("Linear expansion", "x = alpha*L*(S - T)", x=x, S=S, T=T),
            answers="a",
            mistakes=[
                mistake(
                    "Only the change of temperature counts, from the day on which it was built.",
                    wrong("x = alpha*L*(S - T_0)", x=x, S=S, T_0=273.15),
                ),
                mistake(
                    "It was not built in the coldest winter.", wrong("x = alpha*L*(S - W)", x=x, S=S, W=W)
                ),
            ],
        ),
        step(
            y,
            "From the hottest day, with closed gaps, to the coldest one.",
            law("Linear expansion", "y = alpha*L*(S - W)", y=y, S=S, W=W),
            answers="b",
            mistakes=[
                mistake(
                    "The gaps were open already when it was built.",
                    wrong("y = alpha*L*(T - W)", y=y, T=T, W=W),
                ),
                mistake(
                    "When it gets colder the gaps become wider, not narrower.",
                    wrong("y = x - alpha*L*(T - W)", x=x, y=y, T=T, W=W),
                ),
            ],
        ),
        step(
            p,
            "The steel is pressed together by as much as it would have grown: Hooke's law, per area.",
            law("Hooke's law", "p = E*x/L", p=p, E=E, x=x),
            answers="c",
            mistakes=[
                mistake(
                    "In summer it is pressed by what it has grown since it was built, not since winter.",
                    wrong("p = E*y/L", p=p, E=E, y=y),
                ),
                mistake(
                    "Is it pressed from each side by half? The pressure is the same all along.",
                    wrong("p = E*x/(2*L)", p=p, E=E, x=x),
                ),
            ],
            check="The length of the bridge does not matter.",
        ),
    )
