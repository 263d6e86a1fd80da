"""Two gliders on three springs: coupled equations of motion, and the modes in which they swing."""

from math import cos, pi

from corollary.author import (
    along,
    choice,
    confirm,
    derivation,
    force,
    forces,
    function,
    mistake,
    simulate,
    step,
    unknowns,
    variable,
)
from corollary.laws import balance, law, second_law, wrong
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.scene import Body, Scene


def derive(m, k, c, A, t1, g_n):
    t = variable("t")
    x, y, v, w = (function(name, t) for name in "xyvw")
    for acceleration in "fg":  # of the left glider and of the right one; laws know them by name
        function(acceleration, t)
    N, a, slow, fast, s, low, high = unknowns(
        "N a slow fast s low high", N="normal force", a="acceleration of the left glider"
    )
    pulls, K = unknowns("P Q R S"), unknowns("K11 K12 K21 K22")
    return derivation(
        step(N, "Nothing moves up or down.", balance(N, m * g_n)),
        step(
            pulls,
            "Each spring pulls as far as it is stretched or pressed: the middle one by what its ends differ.",
            law("Hooke's law, left", "P = -k*A", A=A),
            law("Hooke's law, between", "Q = -c*A", A=A),
            law("At rest", "R = 0"),
            law("Action and reaction", "S = -Q", S=pulls[3]),
            answers="b",
            mistakes=[
                mistake(
                    "The middle spring is pressed: it pushes the two apart.",
                    law("Hooke's law, between", "Q = c*A", A=A),
                    instead="Hooke's law, between",
                ),
                mistake(
                    "The spring constant of the middle spring is another.",
                    law("Hooke's law, between", "Q = -k*A", A=A),
                    instead="Hooke's law, between",
                ),
            ],
        ),
        step(
            a,
            "Both springs push the left glider back.",
            second_law(pulls[0] + pulls[1], m=m, a=a),
        ),
        forces(
            "a",
            "The Earth pulls, the track carries, and both springs act to the left: one is stretched, the other pressed.",
            force("a", m * g_n, "down"),
            force("b", N, "up"),
            force("c", k * A, "left"),
            force("d", c * A, "left"),
            laws=[
                along("right", second_law(-k * A - c * A, m=m, a=a)),
                along("up", balance(N, m * g_n)),
            ],
            mistakes={"e": "On an air track nothing rubs."},
        ),
        step(
            K,
            "What pulls a glider back when it alone is moved stands on the diagonal; what it does to the other beside it.",
            law("Left, moved", "K11 = k + c", K11=K[0]),
            law("Right, moved", "K12 = -c", K12=K[1]),
            law("Action and reaction", "K21 = K12", K21=K[2], K12=K[1]),
            law("Symmetry", "K22 = K11", K22=K[3], K11=K[0]),
            answers="c",
            mistakes=[
                mistake(
                    "A glider that moves stretches the middle spring, too.",
                    law("Left, moved", "K11 = k", K11=K[0]),
                    instead="Left, moved",
                ),
                mistake(
                    "When the right one moves to the right, the left one is pulled to the right: mind the sign.",
                    law("Right, moved", "K12 = c", K12=K[1]),
                    instead="Right, moved",
                ),
            ],
        ),
        step(
            (slow, fast),
            "In step, the middle spring plays no part; against one another, it is pressed from both sides.",
            law("In step", "m*slow^2 = k", slow=slow),
            law("Against one another", "m*fast^2 = k + 2*c", fast=fast),
            where=(slow > 0) & (fast > 0),
            answers="d",
            mistakes=[
                mistake(
                    "The middle spring is pressed from both sides, twice as far.",
                    law("Against one another", "m*fast^2 = k + c", fast=fast),
                    instead="Against one another",
                ),
                mistake(
                    "In step the middle spring keeps its length.",
                    law("In step", "m*slow^2 = k + c", slow=slow),
                    instead="In step",
                ),
            ],
        ),
        step(
            s,
            "Both equations of motion hold together; their sum and their difference swing by themselves.",
            law("Newton's second law, left", "m*d2x/dt2 = -k*x - c*(x - y)"),
            law("Newton's second law, right", "m*d2y/dt2 = -k*y - c*(y - x)"),
            law("Pulled", "x(0) = A", A=A),
            law("Held", "y(0) = 0"),
            law("Velocity, left", "v = dx/dt"),
            law("Velocity, right", "w = dy/dt"),
            law("Let go, left", "v(0) = 0"),
            law("Let go, right", "w(0) = 0"),
            law("Acceleration, left", "f = dv/dt"),
            law("Acceleration, right", "g = dw/dt"),
            law("Place asked for", "s = y(t1)"),
            answers="e",
            mistakes=[
                mistake(
                    "The two are coupled: neither swings by itself.",
                    wrong("s = A*(1 - cos(slow*t1))/2", A=A),
                    instead="Place asked for",
                ),
                mistake("That is the left one.", wrong("s = x(t1)"), instead="Place asked for"),
            ],
        ),
        step(
            (low, high),
            "In step both swing as a single glider on its outer spring does, as far to one side as to the other.",
            law("One turning point", "high = A", A=A),
            law("The other", "low = -high"),
            answers="f",
            mistakes=[
                mistake(
                    "It swings through to the other side.", law("The other", "low = 0"), instead="The other"
                ),
                mistake(
                    "The middle spring keeps its length, and nothing of the energy goes into it.",
                    law("One turning point", "high = A/2", A=A),
                    instead="One turning point",
                ),
            ],
        ),
        choice(
            "g",
            "The middle spring is then pressed and stretched from both sides, which makes the motion stiffer.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "Then the middle spring keeps its length: is that the stiffer motion?",
                "c": "In a mode both swing with one frequency, and pass their places of rest at once.",
            },
        ),
        confirm(
            "The motion that was found begins with the pulls that were stated, and with the acceleration.",
            law("Newton's second law, left, at first", "m*f(0) = P + Q"),
            law("Newton's second law, right, at first", "m*g(0) = R + S", S=pulls[3]),
            law("Acceleration at first", "f(0) = a"),
        ),
        confirm(
            "At any time the matrix gives the forces that the motion needs.",
            law("Left glider", "m*f(t1) = -K11*x(t1) - K12*y(t1)", K11=K[0], K12=K[1]),
            law("Right glider", "m*g(t1) = -K21*x(t1) - K22*y(t1)", K21=K[2], K22=K[3]),
        ),
        confirm(
            "The energy of the start is there at any time.",
            law(
                "Conservation of energy",
                "k*A^2 + c*A^2 = m*v(t1)^2 + m*w(t1)^2 + k*x(t1)^2 + k*y(t1)^2 + c*(x(t1) - y(t1))^2",
                A=A,
                x=x,
                y=y,
                v=v,
                w=w,
            ),
        ),
    )


def scene(m, k, c, A, t1, g_n, answer):
    """The same gliders between two walls that never move, followed for the time asked for; and both pulled alike, for half a swing."""
    wall = float("inf")
    bodies = (
        Body(wall, (0.0,), (0.0,)),
        Body(m, (1.0 + A,), (0.0,)),
        Body(m, (2.0,), (0.0,)),
        Body(wall, (3.0,), (0.0,)),
    )
    springs = tuple(Spring((n, n + 1), each, length=1.0) for n, each in enumerate((k, c, k)))
    slow, fast = sorted(answer["d"])
    left = A / 2 * (cos(slow * t1) + cos(fast * t1))
    ends = (0.0, 1.0 + left, 2.0 + answer["e"], 3.0)
    low, high = sorted(answer["f"])
    both = (bodies[0], Body(m, (1.0 + high,), (0.0,)), Body(m, (2.0 + high,), (0.0,)), bodies[3])
    turned = (0.0, 1.0 + low, 2.0 + low, 3.0)
    return [
        simulate(Scene(bodies, springs, until=t1), trajectory=ends),
        simulate(Scene(both, springs, until=pi / slow), trajectory=turned),
    ]
