"""Over a pulley: one string, one acceleration, two equations."""

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import law, without_time, wrong
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(m, M, h, g):
    a, T, v = unknowns("a T v", T="tension of the string")
    return derivation(
        step(
            a,
            "Each block for itself; the string pulls both with the same force T, which drops out of the sum.",
            law("Newton's second law, heavier block", "M*g - T = M*a"),
            law("Newton's second law, lighter block", "T - m*g = m*a"),
            also=[T],
            answers="a",
            mistakes=[
                mistake(
                    "You let the string pull with all the weight of the heavier block; then that one would not "
                    "be accelerated.",
                    law("Tension", "T = M*g"),
                    instead="Newton's second law, heavier block",
                ),
                mistake(
                    "You let the string carry just the weight of the lighter block; then that one would not "
                    "be accelerated.",
                    law("Tension", "T = m*g"),
                    instead="Newton's second law, lighter block",
                ),
                mistake(
                    "The weights pull on opposite ends of the string: take their difference.",
                    law("Newton's second law, lighter block", "T + m*g = m*a"),
                    instead="Newton's second law, lighter block",
                ),
            ],
            check="With equal masses nothing would happen; with a very light one, the other falls freely.",
        ),
        step(
            T,
            "Back to one of the blocks, the lighter one.",
            law("Newton's second law", "T - m*g = m*a"),
            answers="b",
            routes=[route("Or the heavier one.", law("Newton's second law, heavier block", "M*g - T = M*a"))],
            mistakes=[
                mistake("That would hold the lighter block at rest.", wrong("T = m*g")),
                mistake("That would hold the heavier block at rest.", wrong("T = M*g")),
                mistake(
                    "The string pulls the lighter block upwards against its weight and accelerates it as "
                    "well: mind the sign.",
                    wrong("T = m*g - m*a"),
                ),
            ],
            check="It lies between the two weights.",
        ),
        step(
            v,
            "It comes down with constant acceleration.",
            without_time(v, v_0=0, a=a, s=h),
            where=v >= 0,
            answers="c",
            mistakes=[
                mistake(
                    "It does not fall freely; the other block holds it back.",
                    wrong("v^2 = 2*g*h"),
                    where=v >= 0,
                ),
                mistake("The factor 2 is missing.", wrong("v^2 = a*h"), where=v >= 0),
            ],
        ),
    )


def scene(m, M, h, g, answer):
    """The string laid out in a line: a rod between both blocks, each pulled outwards by its weight; and the heavier block alone."""
    v, t = answer["c"], answer["c"] / answer["a"]
    pulls = (ForceFunction(0, lambda t, x, v: (-m * g,)), ForceFunction(1, lambda t, x, v: (M * g,)))
    blocks = (Body(m, (0.0,), (0.0,)), Body(M, (1.0,), (0.0,)))
    net = ForceFunction(0, lambda t, x, v: (M * g - answer["b"],))
    return [
        simulate(Scene(blocks, (Rod((0, 1)), *pulls), until=t), velocities=(v, v), trajectory=(h, 1.0 + h)),
        simulate(Scene((Body(M, (0.0,), (0.0,)),), (net,), until=t), velocities=(v,)),
    ]
