"""Non-central elastic collision: what the conservation laws say alone, and what the line of centres adds."""

import sympy

from corollary.author import derivation, mistake, proof, reject, simulate, step, unknown, unknowns, vector
from corollary.laws import (
    Law,
    angle_between,
    conservation_of_momentum,
    elastic,
    law,
    line_of_centres,
    magnitude,
    wrong,
)


def plane_energy(m, v0, A, B) -> Law:
    """Kinetic energy is kept; A (v_A) and B (v_B), of equal masses, move in a plane."""
    return law(
        "Conservation of mechanical energy",
        "m*v_0^2/2 = m*(v_Ax^2 + v_Ay^2)/2 + m*(v_Bx^2 + v_By^2)/2",
        source="(12.113)",
        holds="the collision is elastic",
        m=m,
        v_0=v0,
        v_Ax=A[0],
        v_Ay=A[1],
        v_Bx=B[0],
        v_By=B[1],
    )


def derive(v0, theta, s, D, mA, mB):
    w, b, speeds, psi = (
        unknown("w", "speed of A after the collision"),
        vector("b", meaning="velocity of B after the collision"),
        vector("v", "A B"),
        unknown("psi"),
    )
    a = (w * sympy.cos(theta), w * sympy.sin(theta))
    n, A, B, V = vector("n"), vector("A"), vector("B"), vector("V")
    w_A, w_B, u_A, u_B, many, equations = unknowns(
        "w_A w_B u_A u_B N_unknown N_equations",
        w_A="component of A's velocity along n afterwards",
        w_B="that of B",
        u_A="component of A's velocity along n, with the unequal masses",
        u_B="that of B",
    )
    momentum_ab = conservation_of_momentum(before=[(mA, (v0, 0)), (mA, (0, 0))], after=[(mA, a), (mA, b)])
    energy_ab = plane_energy(mA, v0, a, b)
    momentum_AB = conservation_of_momentum(before=[(mA, (v0, 0)), (mA, (0, 0))], after=[(mA, A), (mA, B)])
    along, along_after = [(mA, v0 * n[0]), (mA, 0)], [(mA, w_A), (mA, w_B)]
    uneven, uneven_after = [(mA, v0 * n[0]), (mB, 0)], [(mA, u_A), (mB, u_B)]
    not_met = "the velocities would be those from before: nothing has happened"
    return derivation(
        step(
            (w, *b),
            "Momentum is kept along x and along y, kinetic energy too; A moves off with a speed w at the "
            "angle θ. The masses are equal: call both m_A.",
            momentum_ab,
            energy_ab,
            reject=[
                reject(
                    "A would stand still and have no direction: that is the central hit", w=0, b_x=v0, b_y=0
                )
            ],
        ),
        step(
            speeds,
            "The speeds are the lengths of the two velocities.",
            magnitude(speeds, ((a[0], b[0]), (a[1], b[1]))),
            answers="a",
            mistakes=[
                mistake(
                    "Sine and cosine have changed places: a slightly deflected A keeps nearly all of its "
                    "speed.",
                    wrong("v = c", v=speeds, c=(v0 * sympy.sin(theta), v0 * sympy.cos(theta))),
                ),
                mistake(
                    "Speeds do not add up to v₀: momentum is a vector. Momentum along y must vanish too.",
                    wrong("v = c", v=speeds, c=(v0 * sympy.cos(theta), v0 * (1 - sympy.cos(theta)))),
                ),
                mistake(
                    "You let A keep its speed and only turn; then there is no energy left for B.",
                    wrong("v = c", v=speeds, c=(v0, v0 * sympy.sin(theta))),
                ),
                mistake(
                    "The two do not share the energy in equal halves; momentum must be kept along y as well.",
                    wrong("v = c", v=speeds, c=(v0 / sympy.sqrt(2), v0 / sympy.sqrt(2))),
                ),
            ],
            check=(
                "Their squares add up to v₀²: the kinetic energy is kept. θ → 0: A misses, and B stays at "
                "rest."
            ),
        ),
        step(
            psi,
            "The scalar product of the two velocities tells the angle between them.",
            angle_between(psi, a=a, b=b, lengths=speeds),
            answers="b",
            where=psi <= sympy.pi,
            mistakes=[
                mistake(
                    "B does not move off at the same angle on the other side, unless θ is 45°.",
                    wrong("psi = 2*theta", psi=psi),
                ),
                mistake(
                    "That is the angle of B's velocity with +x; asked is the angle between the velocities "
                    "of A and B.",
                    wrong("psi = pi/2 - theta", psi=psi),
                ),
            ],
            check="It does not depend on θ, nor on v₀.",
        ),
        step(
            n,
            "When they touch, the centres are D apart, and s of it across the motion: this fixes the unit "
            "vector n from A's centre to B's.",
            *line_of_centres(n, s=s, D=D),
            mistakes=[
                mistake(
                    "Sine and cosine have changed places: s is the side *across* the motion, along y.",
                    wrong("n_y = sqrt(D^2 - s^2)/D", n_y=n[1]),
                ),
            ],
        ),
        step(
            w_B,
            "Smooth spheres push each other along n only. Along n it is a collision on a line: A comes with "
            "the component v₀ n_x of its velocity, B is at rest.",
            conservation_of_momentum(before=along, after=along_after),
            elastic(before=along, after=along_after),
            also=[w_A],
            reject=[reject(not_met, w_A=v0 * n[0], w_B=0)],
            mistakes=[
                mistake(
                    "Only the component of A's velocity along the line of centres takes part in the "
                    "collision.",
                    law("Whole velocity", "w_B = v_0", v_0=v0),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "Along the line of centres the spheres do not stick together.",
                    law("Perfectly inelastic", "w_A = w_B"),
                    instead="Conservation of mechanical energy",
                ),
            ],
        ),
        step(
            (*B, *A),
            "B was at rest and is pushed along n only, so it moves along n; what is left of the momentum is "
            "A's.",
            law("Velocity along n", "v = w*n", v=B, w=w_B, n=n),
            momentum_AB,
            answers="c",
            mistakes=[
                mistake(
                    "You treated it as a head-on collision; B moves along the line of centres, not along x.",
                    wrong("v = v_limit", v=B, v_limit=(v0, 0)),
                ),
                mistake(
                    "B lies at +s: it is pushed towards +y, and A towards -y.",
                    wrong("v = w*n", v=B, w=w_B, n=(n[0], -n[1])),
                ),
            ],
            check=(
                "s = 0: A stops and B goes on at v₀. s = D: they only touch, and nothing changes. The two "
                "velocities are at right angles."
            ),
        ),
        step(
            u_B,
            "The same along n, with the masses as they are.",
            conservation_of_momentum(before=uneven, after=uneven_after),
            elastic(before=uneven, after=uneven_after),
            also=[u_A],
            reject=[reject(not_met, u_A=v0 * n[0], u_B=0)],
            mistakes=[
                mistake(
                    "That would be right for equal masses.",
                    law("Equal masses", "u_B = v_0*n_x", v_0=v0, n_x=n[0]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "Only the component of A's velocity along the line of centres takes part in the "
                    "collision.",
                    law("Whole velocity", "u_B = 2*m_A/(m_A + m_B)*v_0", m_A=mA, m_B=mB, v_0=v0),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "Along the line of centres the spheres do not stick together.",
                    law("Perfectly inelastic", "u_A = u_B"),
                    instead="Conservation of mechanical energy",
                ),
            ],
        ),
        step(
            V,
            "B was at rest and is pushed along n only.",
            law("Velocity along n", "v = w*n", v=V, w=u_B, n=n),
            answers="d",
            mistakes=[
                mistake(
                    "B moves along the line of centres, not along x.",
                    wrong("v = c", v=V, c=(u_B, 0)),
                ),
                mistake(
                    "B lies at +s: it is pushed towards +y.",
                    wrong("v = w*n", v=V, w=u_B, n=(n[0], -n[1])),
                ),
            ],
            check="With equal masses this is (c); a light B moves off at up to 2v₀ n_x.",
        ),
        step(
            (many, equations),
            "Two velocities with two components each are unknown. Momentum is a vector law, an equation for "
            "each component; energy is one more.",
            law("Count", "N_u = b*d", N_u=many, b=2, d=2),
            law(
                "Count of equations",
                "N_e = p + e",
                N_e=equations,
                p=momentum_ab.components,
                e=energy_ab.components,
            ),
            answers="e",
            mistakes=[
                mistake(
                    "Momentum is a vector: in a plane its conservation is two equations, not one.",
                    law("Count of equations", "N_e = 1 + e", N_e=equations, e=energy_ab.components),
                    instead="Count of equations",
                ),
                mistake(
                    "In a plane each of the two velocities has two components.",
                    law("Count", "N_u = 2", N_u=many),
                    instead="Count",
                ),
                mistake(
                    "The kinetic energy is a single number: its conservation is one equation.",
                    law("Count of equations", "N_e = p + 2", N_e=equations, p=momentum_ab.components),
                    instead="Count of equations",
                ),
            ],
            check="One more piece of information is needed, such as an angle or how the spheres meet.",
        ),
        proof(
            "f",
            "Squaring the conservation of momentum gives the conservation of energy, but for twice the "
            "scalar product; so this must vanish.",
            momentum_AB,
            plane_energy(mA, v0, A, B),
            target=law("Orthogonal", "A_x*B_x + A_y*B_y = 0", A_x=A[0], A_y=A[1], B_x=B[0], B_y=B[1]),
            given=[law("Equal masses", "m_B = m_A", m_B=mB, m_A=mA)],
            lines=[
                "mA*v0 = mA*A_x + mA*B_x",
                "0 = mA*A_y + mA*B_y",
                "v0 = A_x + B_x",
                "0 = A_y + B_y",
                "v0^2 = (A_x + B_x)^2 + (A_y + B_y)^2",
                "mA*v0^2/2 = mA*(A_x^2 + A_y^2)/2 + mA*(B_x^2 + B_y^2)/2",
                "v0^2 = A_x^2 + A_y^2 + B_x^2 + B_y^2",
                "(A_x + B_x)^2 + (A_y + B_y)^2 = A_x^2 + A_y^2 + B_x^2 + B_y^2",
                "2*A_x*B_x + 2*A_y*B_y = 0",
                "A_x*B_x + A_y*B_y = 0",
            ],
            mistakes=[
                mistake(
                    "Before squaring: the speeds do not add up to v₀, only the velocities do, as vectors.",
                    wrong(
                        "v_0 = sqrt(A_x^2 + A_y^2) + sqrt(B_x^2 + B_y^2)",
                        v_0=v0,
                        A_x=A[0],
                        A_y=A[1],
                        B_x=B[0],
                        B_y=B[1],
                    ),
                ),
                mistake(
                    "Momentum along y is zero before, so the two components along y are opposite, not equal.",
                    wrong("A_y = B_y", A_y=A[1], B_y=B[1]),
                ),
            ],
        ),
    )


def scene(v0, theta, s, D, mA, mB, answer):
    """Two smooth elastic spheres, so stiff that they are nearly hard, from Newton's second law."""
    k = 1e14
    flat = (max(mA, mB) * v0**2 / k) ** (2 / 5) / D  # how far they are pressed in, in diameters (q = 3/2)
    hard = {"R": D / 2, "k": k, "eta": 0.0, "dx": 2 * D, "dy": s, "vA": (v0, 0.0), "vB": (0.0, 0.0)}
    bx, by, ax, ay = answer["c"]
    vx, vy = answer["d"]
    ax_d, ay_d = v0 - mB / mA * vx, -mB / mA * vy
    return [
        simulate(
            "spheres",
            hard | {"mA": mA, "mB": mA},
            animated=True,
            neglected=10 * flat,
            velocities=(ax, ay, bx, by),
        ),
        simulate(
            "spheres", hard | {"mA": mA, "mB": mB}, neglected=10 * flat, velocities=(ax_d, ay_d, vx, vy)
        ),
    ]
