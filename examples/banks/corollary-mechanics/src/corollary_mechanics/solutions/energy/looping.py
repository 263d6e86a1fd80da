"""A looping: energy gives the speed, the circle asks for a force."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(m, R, h, g):
    v, N, w, H = unknowns("v N w H", w="least speed at the top")
    return derivation(
        step(
            v,
            "The top of the loop lies 2R above its lowest point.",
            law("Conservation of energy", "m*g*h = m*v^2/2 + 2*m*g*R"),
            where=v > 0,
            answers="a",
            mistakes=[
                mistake(
                    "That is the speed at the lowest point. At the top some of the energy is spent on height "
                    "again.",
                    wrong("m*g*h = m*v^2/2"),
                    where=v > 0,
                ),
                mistake(
                    "How high is the top of a loop with the radius R?",
                    wrong("m*g*h = m*v^2/2 + m*g*R"),
                    where=v > 0,
                ),
            ],
        ),
        step(
            N,
            "At the top the weight and the track both push downwards, to the middle of the circle.",
            law("Newton's second law", "N + m*g = m*v^2/R"),
            answers="b",
            mistakes=[
                mistake(
                    "The weight helps at the top: it points to the middle of the circle.",
                    wrong("N - m*g = m*v^2/R"),
                ),
                mistake(
                    "That is the force that the circle asks for; the weight gives some of it.",
                    wrong("N = m*v^2/R"),
                ),
                mistake("The car is not in equilibrium there.", wrong("N = m*g")),
            ],
            check="It vanishes for the lowest start that is possible.",
        ),
        step(
            w,
            "At the slowest the weight alone is what the circle asks for.",
            law("Newton's second law", "m*g = m*w^2/R", w=w),
            where=w > 0,
        ),
        step(
            H,
            "That speed must be left at the top.",
            law("Conservation of energy", "m*g*H = m*w^2/2 + 2*m*g*R", w=w),
            answers="c",
            mistakes=[
                mistake(
                    "From there it would be at rest at the top; it would fall off long before.",
                    wrong("m*g*H = 2*m*g*R"),
                ),
                mistake("How high is the top of the loop?", wrong("m*g*H = m*w^2/2 + m*g*R", w=w)),
            ],
            check="Two and a half radii, whatever the mass.",
        ),
    )


def scene(m, R, h, g, answer):
    """On a rod instead of a rail, from the bottom with the energy of the start: the energy at any moment is that of the top."""
    nail = Body(float("inf"), (0.0, 0.0), (0.0, 0.0))
    car = Body(m, (0.0, R), (answer["a"], 0.0))
    swing = Scene((nail, car), (Rod((0, 1)), Weight(g)), until=R / answer["a"])
    return [simulate(swing, energy=m * g * (h - R))]
