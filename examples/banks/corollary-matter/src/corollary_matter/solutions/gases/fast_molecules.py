"""How fast molecules are: temperature is mean kinetic energy."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(T, M, V, p, k_B, N_A):
    E, v, N = unknowns("E v N")
    return derivation(
        step(
            E,
            "One half of $k_B T$ for each of three directions.",
            law("Mean kinetic energy", "E = 3*k_B*T/2", E=E, T=T),
            answers="a",
            mistakes=[
                mistake("That is one direction out of three.", wrong("E = k_B*T/2", E=E, T=T)),
                mistake(
                    "Temperatures count from absolute zero.",
                    wrong("E = 3*k_B*(T - T_0)/2", E=E, T=T, T_0=273.15),
                ),
            ],
        ),
        step(
            v,
            "The mass of one molecule is the molar mass divided by Avogadro's constant.",
            law("Kinetic energy", "E = (M/N_A)*v^2/2", E=E),
            where=v > 0,
            answers="b",
            mistakes=[
                mistake(
                    "The factor 1/2 of the kinetic energy is missing.",
                    wrong("E = (M/N_A)*v^2", E=E),
                    where=v > 0,
                ),
                mistake("That counts one direction only.", wrong("k_B*T = (M/N_A)*v^2", T=T), where=v > 0),
            ],
            check="Somewhat faster than sound.",
        ),
        step(
            N,
            "The ideal gas law for molecules.",
            law("Ideal gas", "p*V = N*k_B*T", p=p, V=V, N=N, T=T),
            answers="c",
            mistakes=[
                mistake(
                    "Temperatures count from absolute zero.",
                    wrong("p*V = N*k_B*(T - T_0)", p=p, V=V, N=N, T=T, T_0=273.15),
                ),
                mistake(
                    "The mean energy of a molecule has a factor 3/2 that the gas law has not.",
                    wrong("p*V = N*E", p=p, V=V, N=N, E=E),
                ),
            ],
        ),
    )
