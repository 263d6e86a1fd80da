"""A rocket burns its fuel: the last kilogram gives more speed than the first."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import burnt, wrong


def derive(m0, m1, vrel, v0, dv):
    v, m_2 = unknowns("v m_2")
    return derivation(
        step(
            v,
            "No external force: $m\\,dv/dt = -v_{rel}\\,dm/dt$. Divide by $m$ and integrate from the first "
            "mass to the last: $v - v_0 = -v_{rel}\\int_{m_0}^{m_1} dm/m$.",
            burnt(v_0=v0, v_1=v, v_rel=vrel, m_0=m0, m_1=m1),
            answers="a",
            mistakes=[
                mistake(
                    "That throws out all the fuel in one go, with this speed as seen from the ground. The "
                    "rocket burns it bit by bit, and every bit leaves a rocket that moves already.",
                    wrong(
                        "m_1*(v - v_0) = (m_0 - m_1)*v_rel",
                        m_1=m1,
                        v_0=v0,
                        m_0=m0,
                        v_rel=vrel,
                    ),
                ),
                mistake(
                    "You kept the mass at its starting value; the same push gives a lighter rocket more.",
                    wrong(
                        "m_0*(v - v_0) = (m_0 - m_1)*v_rel",
                        m_1=m1,
                        v_0=v0,
                        m_0=m0,
                        v_rel=vrel,
                    ),
                ),
                mistake(
                    "The logarithm has its fraction upside down: the rocket would fly backwards.",
                    burnt(v_0=v0, v_1=v, v_rel=vrel, m_0=m1, m_1=m0),
                ),
                mistake(
                    "You used the decimal logarithm; the integral of 1/m is the natural one.",
                    wrong(
                        "v_1 = v_0 + v_rel*log10(m_0/m_1)",
                        v_1=v,
                        v_0=v0,
                        v_rel=vrel,
                        m_0=m0,
                        m_1=m1,
                    ),
                ),
            ],
            check=(
                "It is more than with the starting mass all the time and less than with the final mass, "
                "and does not depend on how fast the fuel is burnt."
            ),
        ),
        step(
            m_2,
            "The same law, read the other way: the gain is known, the final mass is not.",
            burnt(v_0=0, v_1=dv, v_rel=vrel, m_0=m0, m_1=m_2),
            answers="b",
            mistakes=[
                mistake(
                    "That is the fuel it burns; asked is the mass that is left.",
                    wrong("m_1 = m_0*(1 - exp(-dv/v_rel))", m_1=m_2, m_0=m0, v_rel=vrel),
                ),
                mistake(
                    "The rocket gets lighter: the exponent must be negative.",
                    burnt(v_0=0, v_1=-dv, v_rel=vrel, m_0=m0, m_1=m_2),
                ),
                mistake(
                    "That is $1 - \\Delta v/v_{rel}$, good only for gains much smaller than the speed of "
                    "the exhaust.",
                    wrong("m_1 = m_0*(1 - dv/v_rel)", m_1=m_2, m_0=m0, v_rel=vrel),
                ),
            ],
            check="Each gain of $v_{rel}$ costs a factor e = 2.72 in mass.",
        ),
    )


def scene(m0, m1, vrel, v0, dv, answer):
    """Ten thousand small puffs, with momentum kept at every one."""
    burn = {"v_rel": vrel, "m0": m0, "v0": v0, "N": 10000}
    return [
        simulate("rocket", burn | {"m1": m1}, velocities=answer["a"]),
        simulate("rocket", burn | {"m1": answer["b"]}, velocities=v0 + dv),
    ]
