"""A bucket on a drum: one falls, the other turns."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import angular_second_law, law, rolling, without_time, wrong
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def derive(M, m, R, h, g):
    I, a, T, alpha, v, w = unknowns(
        "I a T alpha v omega",
        T="tension of the rope",
        alpha="angular acceleration of the drum",
        v="speed of the bucket at the bottom",
    )
    return derivation(
        step(
            I, "A solid cylinder about its axis.", law("Moment of inertia of a cylinder", "I = M*R^2/2", I=I)
        ),
        step(
            a,
            "The rope slows the bucket down and turns the drum; the rope does not slip.",
            law("Newton's second law", "m*g - T = m*a"),
            angular_second_law(T * R, I=I, alpha=alpha),
            law("Unwinding", "a = alpha*R"),
            also=[T, alpha],
            answers="a",
            mistakes=[
                mistake(
                    "It does not fall freely: it must turn the drum.",
                    law("Free fall", "a = g"),
                    instead="Newton's second law",
                ),
                mistake(
                    "You let the rope pull with all the weight of the bucket; then that one would hang still.",
                    law("Tension", "T = m*g"),
                    instead="Newton's second law",
                ),
                mistake(
                    "All the mass of the drum would have to sit on its rim.",
                    law("Newton's second law for rotation", "T*R = M*R^2*alpha"),
                    instead="Newton's second law for rotation",
                ),
            ],
            check="The radius cancels; with a very light drum it is a free fall.",
        ),
        step(
            T,
            "Back to the bucket.",
            law("Newton's second law", "m*g - T = m*a"),
            answers="b",
            mistakes=[
                mistake("Then the bucket would not be accelerated.", wrong("T = m*g")),
                mistake(
                    "The bucket is accelerated downwards: is the rope's pull larger or smaller than the "
                    "weight?",
                    wrong("T - m*g = m*a"),
                ),
            ],
        ),
        step(v, "The bucket comes down steadily.", without_time(v, v_0=0, a=a, s=h), where=v > 0),
        step(
            w,
            "The rim of the drum is as fast as the rope.",
            rolling(v, omega=w, R=R),
            answers="c",
            mistakes=[
                mistake(
                    "That would be so after a free fall; but the bucket is held back.",
                    wrong("w*R = sqrt(2*g*h)", w=w),
                ),
                mistake(
                    "The rope runs over the radius of the drum, not over its diameter.",
                    wrong("v = 2*w*R", w=w),
                ),
            ],
        ),
    )


def scene(M, m, R, h, g, answer):
    """A roll with the bucket's mass and the drum's moment of inertia, which unrolls down a rough wall: what grips is the rope.

    And the bucket alone, under its weight and the tension.
    """
    w, v = answer["c"], answer["c"] * R
    falls = v / answer["a"]
    roll = Body(m, (R, 0.0), (0.0, 0.0), radius=R, inertia=M * R**2 / 2)
    wall = HardWall((1.0, 0.0), restitution=0.0, mu=1.0)
    pressed = ForceFunction(0, lambda t, place, velocity: (-2 * m * g, 0.0))
    net = ForceFunction(0, lambda t, place, velocity: (answer["b"] - m * g,))
    return [
        simulate(
            Scene((roll,), (Weight(g), wall, pressed), until=falls),
            velocities=(0.0, -v),
            spins=(-w,),
            trajectory=(R, -h),
        ),
        simulate(Scene((Body(m, (0.0,), (0.0,)),), (net,), until=falls), velocities=(-v,), trajectory=(-h,)),
    ]
