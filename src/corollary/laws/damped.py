"""A contact with a damped spring: how fast its swing goes, how fast it dies away, what is left when it ends."""

from __future__ import annotations

from corollary.laws.law import Law, law


def damping_rate(beta: object, m: object, c: object) -> Law:
    """How fast a swing with the drag c v dies away, from m x'' = -k x - c x'.

    `beta = c/(2*m)`
    """
    return law(
        "Damped oscillation", "beta = c/(2*m)", holds="the contact pushes with k x + c v", beta=beta, m=m, c=c
    )


def damped_frequency(omega: object, m: object, k: object, beta: object) -> Law:
    """The angular frequency of a damped swing, from m x'' = -k x - c x'.

    From beta² = k/m on, the overlap creeps back and never ends: nothing rebounds. The second number says so without a case of
    its own: it keeps omega so small there that exp(-pi beta/omega) is below 10^-400, which is 0 among the doubles.

    `omega = sqrt(max(k/m - beta^2, beta^2/100000))`
    """
    return law(
        "Damped oscillation",
        "omega = sqrt(max(k/m - beta^2, beta^2/100000))",
        holds="the first number counts for a swing; without one the second makes the rebound vanish",
        omega=omega,
        m=m,
        k=k,
        beta=beta,
    )


def damped_rebound(r: object, beta: object, T: object) -> Law:
    """The relative velocity shrinks as exp(-beta t), and half a swing turns it round.

    `r = exp(-beta*T)`
    """
    return law(
        "Damped oscillation",
        "r = exp(-beta*T)",
        holds="the contact ends when the overlap is zero again",
        r=r,
        beta=beta,
        T=T,
    )
