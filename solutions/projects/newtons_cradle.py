"""Newton's cradle: what the conservation laws fix, what they leave open, and what the contact decides."""

from corollary.author import (
    code,
    derivation,
    example,
    explain,
    file,
    mistake,
    module,
    neglected,
    plot,
    simulate,
    simulated,
    step,
    supposed,
    unknowns,
    vector,
)
from corollary.laws import (
    conservation_of_momentum,
    elastic,
    falling,
    half_oscillation,
    law,
    reduced_mass,
    restitution,
    same,
    spring_at_rest,
    sticking,
    wrong,
)

ROW = module("newtons_cradle/judge_cradle.py")
FIGURE = module("newtons_cradle/judge_velocity_plot.py")


def derive(m, h0, r, k, v0, g):
    u_0, V, h_1, h_in, mu, T, x = unknowns("u_0 V h_1 h_in mu T x", V="velocity of the two balls together")
    t, x_a, a_p, eps = unknowns("t x_a a_p epsilon")
    _ell, thread = supposed("ell", "0.5 m", "the threads are at least so long, for the ball was lifted far")
    v, w = vector("v", "A B"), vector("w", "A B")
    f, s, e, n = vector("f", "A B C"), vector("s", "A B C"), vector("e", "A B C"), vector("n", "A B C")
    return derivation(
        step(
            u_0,
            "On its way down only gravity does work on the ball; the thread pulls at right angles to the "
            "motion.",
            falling(u_0, g, h0),
            answers="a",
            where=u_0 >= 0,
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h0, v=u_0),
                ),
                mistake(
                    "Energy goes with the square of the speed: $2gh$ is $v^2$, so the speed is "
                    "$\\sqrt{2gh}$ and not $\\sqrt{gh/2}$.",
                    wrong("g*h = 2*v^2", h=h0, v=u_0),
                ),
            ],
            check=(
                "A lift of h₀ gives the speed of a fall through h₀; the length of the thread does not matter."
            ),
        ),
        step(
            v,
            "Momentum and kinetic energy are both kept; the masses are equal.",
            conservation_of_momentum(before=[(m, u_0), (m, 0)], after=[(m, v[0]), (m, v[1])]),
            elastic(before=[(m, u_0), (m, 0)], after=[(m, v[0]), (m, v[1])]),
            answers="b",
            where=v[1] >= v[0],
            mistakes=[
                mistake(
                    "You let them move on together: that is a perfectly inelastic collision. An elastic one "
                    "keeps the kinetic energy.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=v[0], v_B=v[1]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "That is the motion as if they had never met: A cannot pass through B.",
                    law("No collision", "v_A = u", v_A=v[0], u=u_0),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check="Equal masses exchange their velocities.",
        ),
        step(
            h_1,
            "On its way up only gravity works on B.",
            falling(v[1], g, h_1),
            answers="c",
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h_1, v=v[1]),
                ),
                mistake(
                    "The energy of A is not shared between the balls: A stays behind at rest.",
                    wrong("g*h = v^2/4", h=h_1, v=v[1]),
                ),
            ],
            check="B rises as high as A was lifted: nothing is lost.",
        ),
        step(
            V,
            "They stick: momentum is kept, kinetic energy is not.",
            sticking(before=[(m, u_0), (m, 0)], together=V),
            mistakes=[
                mistake(
                    "Kinetic energy is not kept when things stick together; momentum is.",
                    wrong("V = u/sqrt(2)", u=u_0),
                ),
            ],
        ),
        step(
            h_in,
            "Both rise with this common velocity; the mass does not matter.",
            falling(V, g, h_in),
            answers="d",
            mistakes=[
                mistake(
                    "Half the speed is a quarter of the height, not half of it: the height goes with the "
                    "square of the speed.",
                    wrong("h = h_0*V/u", h=h_in, h_0=h0, u=u_0),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h_in, v=V),
                ),
            ],
            check="Half of the kinetic energy is lost, and what is left lifts twice the mass.",
        ),
        step(
            w,
            "Momentum is kept; the relative velocity is turned round and shrinks by r.",
            conservation_of_momentum(before=[(m, u_0), (m, 0)], after=[(m, w[0]), (m, w[1])]),
            restitution(r, A=(u_0, w[0]), B=(0, w[1])),
            answers="e",
            mistakes=[
                mistake(
                    "The coefficient of restitution compares *relative* velocities, not the speeds of A "
                    "before and B after.",
                    law("Coefficient of restitution", "v_B1 = r*v_A0", v_B1=w[1], v_A0=u_0),
                ),
                mistake(
                    "You let A run ahead of B: after the collision B must be the faster one.",
                    law(
                        "Coefficient of restitution",
                        "v_A1 - v_B1 = r*v_A0",
                        v_A1=w[0],
                        v_B1=w[1],
                        v_A0=u_0,
                    ),
                ),
            ],
            check="r = 1 gives part (b), r = 0 the common velocity of part (d).",
        ),
        step(
            f,
            "A and B are equal masses in an elastic collision; C has not been touched.",
            conservation_of_momentum(before=[(m, v0), (m, 0)], after=[(m, f[0]), (m, f[1])]),
            elastic(before=[(m, v0), (m, 0)], after=[(m, f[0]), (m, f[1])]),
            law("Newton's first law", "v_C = 0", v_C=f[2], holds="nothing has touched C"),
            answers="f1",
            where=f[1] >= f[0],
            mistakes=[
                mistake(
                    "The collision is elastic: A and B do not move on together.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=f[0], v_B=f[1]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "Momentum is not shared by all three at once: there is a gap, and C has not been "
                    "touched yet.",
                    law("All together", "v_C = v_0/3", v_C=f[2], v_0=v0),
                    instead="Newton's first law",
                ),
            ],
            check="A stops; B carries on.",
        ),
        step(
            s,
            "Now B meets C, which is still at rest: again equal masses in an elastic collision; A is not touched.",
            conservation_of_momentum(before=[(m, f[1]), (m, f[2])], after=[(m, s[1]), (m, s[2])]),
            elastic(before=[(m, f[1]), (m, f[2])], after=[(m, s[1]), (m, s[2])]),
            same(s[0], f[0], "A is not touched any more"),
            answers="f2",
            where=s[2] >= s[1],
            mistakes=[
                mistake(
                    "The collision is elastic: B and C do not move on together.",
                    law("Perfectly inelastic", "v_B = v_C", v_B=s[1], v_C=s[2]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "B meets C and hands on its velocity; it does not pass through it.",
                    law("No collision", "v_B = f", v_B=s[1], f=f[1]),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check="One ball in, one ball out.",
        ),
        example(
            "g",
            n,
            "Momentum and kinetic energy are two equations for three unknown velocities; one stays free.",
            conservation_of_momentum(
                before=[(m, v0), (m, 0), (m, 0)], after=[(m, n[0]), (m, n[1]), (m, n[2])]
            ),
            elastic(before=[(m, v0), (m, 0), (m, 0)], after=[(m, n[0]), (m, n[1]), (m, n[2])]),
            apart=[
                ((0, 0, v0), "that is the set the question excludes: only C moves"),
                ((v0, 0, 0), "that is the set the question excludes: nothing happened"),
                ((0, v0, 0), "that is a set the question excludes: B would have to pass through C"),
            ],
            free=1,
            scale=v0,
        ),
        step(
            mu,
            "Two balls that push each other apart move against each other like one ball of the reduced mass.",
            reduced_mass(mu, m, m),
        ),
        step(
            T,
            "With q = 1 the overlap swings like a mass on a spring: from zero to zero is half a period.",
            half_oscillation(T, mu, k),
            answers="h1",
            mistakes=[
                mistake(
                    "Both balls move: the mass that swings is the reduced mass, m/2.",
                    half_oscillation(T, m, k),
                ),
                mistake(
                    "That is a whole period; the balls part after half of one.",
                    wrong("T = 2*pi*sqrt(m/k)", m=mu),
                ),
                mistake(
                    "That is a quarter of a period, up to the largest overlap; they still have to part.",
                    wrong("T = pi/2*sqrt(m/k)", m=mu),
                ),
            ],
            check="It does not depend on the speed: for q = 1, fast and slow balls touch equally long.",
        ),
        step(
            x,
            "At the largest overlap the balls do not move against each other: the kinetic energy of their "
            "relative motion sits in the contact.",
            spring_at_rest(m=mu, v=v0, k=k, x=x),
            answers="h2",
            where=x * v0 >= 0,
            mistakes=[
                mistake(
                    "Not all of A's kinetic energy is stored: the pair moves on. Use the reduced mass m/2.",
                    spring_at_rest(m=m, v=v0, k=k, x=x),
                ),
                mistake(
                    "A force balance gives the place of no force, not of rest; use energy.",
                    wrong("k*x = m*v/T", m=mu, v=v0),
                ),
            ],
            check="Stiffer balls overlap less.",
        ),
        code(
            "h",
            "Newton's second law for each ball, stepped forward: velocities first, then positions with the "
            "new velocities.",
            inputs=ROW.cradle_inputs,
            judge=ROW.judge_cradle,
            example=file("newtons_cradle/cradle.py"),
        ),
        plot(
            "h",
            "The velocities cross at half the time of contact and end exchanged.",
            judge=lambda given, axes: FIGURE.judge_velocity_plot(given, axes, balls=2),
            example=file("newtons_cradle/two_balls_plot.py"),
        ),
        simulated(
            e,
            "Momentum and energy leave one velocity free; the law of the contact decides. With q = 1 the "
            "three balls are masses on springs, and part one after the other.",
            scene="cradle",
            settings={"N": 3, "q": 1, "m": m, "k": k, "v0": v0},
            observe="velocities",
            answers="i",
            mistakes=[
                mistake(
                    "That is what a toy seems to do, and what separate collisions give. Touching balls with "
                    "q = 1 do something else: run the program.",
                    *(law("Separate collisions", "v = s", v=e[i], s=s[i]) for i in range(3)),
                ),
                mistake(
                    "That is an equal share of the momentum; the balls do not stick together.",
                    *(law("Together", "v = v_0/3", v=e[i], v_0=v0) for i in range(3)),
                ),
            ],
            check="A bounces back a little, and B follows C slowly: not what the toy shows.",
        ),
        neglected(
            "i",
            "the swing of the balls while they touch",
            eps,
            "Three balls touch for less than 1.6 times T. The places of all three, which begin at 0, add up "
            "to $v_0t$ as long as their momentum is kept; on their threads they are pulled back "
            "in proportion to that, on the average with half of what it is in the end.",
            law("Time", "t = 8*T/5"),
            law("Places together", "x = v_0*t", x=x_a, v_0=v0),
            law("Pull of the threads", "a = g*x/ell/2", a=a_p, x=x_a),
            law("Change of the velocities", "epsilon = a*t", epsilon=eps, a=a_p),
            also=[t, x_a, a_p],
            supposing=[thread],
        ),
        code(
            "j",
            "The steeper the force (the larger q), the more the contacts come one after the other; k only "
            "sets the time.",
            inputs=lambda given, draw: [{}],
            judge=ROW.judge_contact,
            example=file("newtons_cradle/contact.py"),
        ),
        plot(
            "j",
            "Three curves: A falls to nearly zero, B rises and falls back to nearly zero, C takes it all.",
            judge=lambda given, axes, called: FIGURE.judge_velocity_plot(given, axes, balls=3, called=called),
            with_calls=True,
            example=file("newtons_cradle/three_balls_plot.py"),
        ),
        explain(
            "k",
            "Says that momentum and energy are two equations for three (or more) unknown velocities, so "
            "they alone cannot decide.",
            "Says that the law of the contact decides, and that a linear contact (q = 1) sets all the balls "
            "in motion.",
            "Says that real steel balls touch with a steeper law (Hertz, q = 3/2) and tiny gaps, so the "
            "collisions come one after the other, each handing on the velocity.",
            answer="The two conservation laws leave a whole family of outcomes. Which one occurs depends "
            "on how the balls push each other. If the force sets in softly (q = 1), all three contacts "
            "act at once and every ball moves. The harder it sets in, or if there are small gaps, the more "
            "the collisions happen one after the other, and each is an exchange of velocities "
            "between equal masses: the ball at the end takes it all.",
        ),
    )


def scene(m, h0, r, k, v0, g, answer):
    """Two balls from Newton's second law, at the height's speed and at v0; three with gaps for the separate collisions."""
    gap = 100 * v0 * answer["h1"]
    return [
        simulate("cradle", {"N": 2, "q": 1, "m": m, "k": k, "v0": answer["a"]}, velocities=answer["b"]),
        simulate(
            "cradle",
            {"N": 2, "q": 1, "m": m, "k": k, "v0": v0},
            duration=answer["h1"],
            largest_overlap=answer["h2"],
        ),
        simulate(
            "cradle",
            {"N": 3, "q": 1, "m": m, "k": k, "v0": v0, "gaps": (0.0, gap)},
            animated=True,
            velocities=answer["f2"],
        ),
    ]
