"""A contact with a damped spring: how fast its swing goes, how fast it dies away, what is left when it ends."""

from __future__ import annotations

from corollary.law.law import Law, law


def damping_rate(gamma: object, m: object, c: object) -> Law:
    """How fast a swing with the drag c v dies away, from m x'' = -k x - c x'."""
    return law("Damped oscillation", "gamma = c/(2*m)", holds="the contact pushes with k x + c v", gamma=gamma, m=m, c=c)


def damped_frequency(omega: object, m: object, k: object, gamma: object) -> Law:
    """The angular frequency of a damped swing, from m x'' = -k x - c x'.

    From gamma² = k/m on, the overlap creeps back and never ends: nothing rebounds. The second number says so without a case of
    its own: it keeps omega so small there that exp(-pi gamma/omega) is below 10^-400, which is 0 among the doubles.
    """
    return law("Damped oscillation", "omega = sqrt(max(k/m - gamma^2, gamma^2/100000))",
               holds="the first number counts for a swing; without one the second makes the rebound vanish",
               omega=omega, m=m, k=k, gamma=gamma)  # fmt: skip


def damped_rebound(r: object, gamma: object, T: object) -> Law:
    """The relative velocity shrinks as exp(-gamma t), and half a swing turns it round."""
    return law("Damped oscillation", "r = exp(-gamma*T)", holds="the contact ends when the overlap is zero again",
               r=r, gamma=gamma, T=T)  # fmt: skip
