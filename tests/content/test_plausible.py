"""Numbers that can be met with: for every problem of the chapter what its draws give, held against limits from outside.

Each row is worked out from the givens alone, by a formula of this page, never by the problem's own solution or conditions.
"""

from __future__ import annotations

import math

import pytest

from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.syntax import author_formula
from corollary.problem.bank import files, open_bank
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem
from corollary.problem.sampling import sample

DRAWS, MANY = 60, 500
# Densities in kg/m^3: cork 120 to 240 (a hollow ball less), osmium 22 590. Speeds in m/s: thrown by hand 50, kicked 60, golf
# ball 108 (241.6 mph, a long drive), sound 343, a rifle's bullet 1000, Usain Bolt 12, cars on a motorway 40, escape from the
# Earth 11 186, meteors 72 000. Forces in N: a boxer's fist 5000, a racket's strings 5000. Decelerations in m/s^2: survived 450.
LIMITS = """
S12.1    | sqrt(vAx^2 + vAy^2)                     | 2000  | 72000  | a meteor on its way round the Sun
S12.1    | mB/mA                                   | 3     | 1000   | a planet, heavier than what hits it
S12.2    | m*sqrt(vx^2 + vy^2)                     | 0.1   | 2500   | a thing that is thrown or drives slowly
S12.3    | F0*T                                    | 0.01  | 200    | what a racket or a foot gives
S12.4    | abs(vBy) + vAy                          | 0     | 20     | what falls or is thrown up in a room
S12.4    | g*dt                                    | 0.01  | 1      | an impact is short
S12.4n   | sqrt(v1x^2 + v1y^2)                     | 0.5   | 20     | bodies on a table
S12.5el  | 2*mA*vA/(mA + mB)                       | 0.05  | 40     | blocks on a track
S12.5gen | abs(vA - vB)*2*mA/(mA + mB) + abs(vB)   | 0.1   | 60     | blocks on a track
S12.5nc  | mA/(4/3*pi*(D/2)^3)                     | 50    | 22590  | no ball is denser than osmium
S12.5nc  | mB/(4/3*pi*(D/2)^3)                     | 50    | 22590  | no ball is denser than osmium
S12.5nc  | D                                       | 0.01  | 0.3    | a ball to hold in a hand
S12.5pi  | abs(vA - vB)                            | 0.1   | 40     | blocks on a track
S12.5r   | h0*r^(2*n)                              | 0.01  | 5      | a bounce that can be seen
S12.5r   | r*v0                                    | 0.1   | 60     | a ball that is thrown
S12.5rr  | h1                                      | 0.01  | 4      | a bounce that can be seen
S12.5rr  | (vB1 - vA1)/(vA0 - vB0)                 | 0.1   | 1      | no collision gives energy
S12.5two | abs(vA - vB)*2*mA/(mA + mB) + abs(vB)   | 0.1   | 60     | blocks on a track
S12.5wall | abs(2*vB - vA)                         | 0.1   | 60     | a ball that is thrown
S12.6    | mA/(4/3*pi*R^3)                         | 50    | 22590  | no ball is denser than osmium
S12.6    | mB/(4/3*pi*R^3)                         | 50    | 22590  | no ball is denser than osmium
S12.6    | (2*R - sqrt(dx^2 + dy^2))/R             | 0.05  | 1      | balls that are pressed, and not through each other
S12.7    | dm/m                                    | 0.01  | 0.5    | a drop is lighter than what it falls into
S12.7    | abs(vrel)                               | 300   | 5000   | the exhaust of a rocket
T12.3    | h/s                                     | 1     | 25     | with more than 25 times the own weight nobody lands unhurt
T12.3    | sqrt(2*h/g)/dt                          | 1     | 25     | the same, by the time
T12.6    | v                                       | 0.1   | 10     | carts with magnets stand for ions
E12.3.1  | abs(v0)                                 | 0.1   | 50     | a ball that is dropped or thrown
E12.3.1  | 2*m*abs(v0)/dt                          | 1     | 30000  | a ball that stays whole
E12.3.1s | m/(4/3*pi*R^3)                          | 50    | 22590  | no ball is denser than osmium
E12.3.1s | sqrt(v0^2 + 2*g*(y0 - R))               | 0.1   | 20     | a ball that is dropped
E12.3.2  | m*(v0 + v1)/dt                          | 10    | 5000   | no strings bear more
E12.3.2  | m                                       | 0.03  | 0.1    | a tennis ball
E12.3.2  | v1                                      | 5     | 75     | the fastest serve had 73 m/s
E12.5.1  | (mA + mB)/mA*sqrt(2*g*h)                | 40    | 1000   | no bullet is faster, no air gun slower
E12.5.1  | h/L                                     | 0     | 1      | the string stays taut below its height
E12.5.2  | 9*h0                                    | 1     | 30     | a super-ball that can be found again
E12.7.1  | R*t/m0                                  | 0     | 3.6    | sand that a car can hold
E12.7.1  | v                                       | 0.5   | 40     | a railway car
E12.7.2  | m0/m1                                   | 1.05  | 25     | a rocket of one stage
E12.7.2  | vrel*ln(m0/m1)                          | 100   | 14000  | a rocket of one stage
X12.1    | v*(1 + r)*M/(M + m)                     | 10    | 108    | no golf ball has been faster
X12.2    | m1*v1/m2                                | 0.05  | 100    | slower than sound by far
X12.3    | v0                                      | 2     | 60     | cars
X12.4    | M*V/mb                                  | 20    | 171    | no bike is faster than with the printed numbers
X12.5    | v                                       | 3     | 60     | a football that is kicked
X12.5    | m*(v + w)/dt                            | 10    | 5000   | a foot that stays whole
X12.6    | v/td                                    | 5     | 450    | survived
X12.6    | v                                       | 3     | 40     | a car
X12.7    | 2*m*v0*sin(theta)/dt                    | 0.5   | 30000  | a ball that stays whole
X12.8    | m*v^2/2                                 | 5     | 425    | nobody throws harder
X12.8    | Ms                                      | 8     | 70     | the weight of a child
X12.9    | sqrt(3*I/M)                             | 0.05  | 0.51   | the height of a book
X12.9    | h/sqrt(3*I/M)                           | 0     | 1.001  | the ball hits the book
X12.10   | (m + M)/m*sqrt(2*mu*g*d)                | 11    | 1000   | a bullet
X12.11   | v0                                      | 0.5   | 60     | a ball
X12.12   | ((M - m)/(M + m))^2*L                   | 0.01  | 3      | a swing that can be seen
X12.13   | m/L                                     | 0.05  | 100    | the mass of a metre of chain
X12.13   | v0                                      | 0.1   | 6      | as fast as an arm lifts
P12.14   | h0/4                                    | 0.01  | 0.5    | a swing that can be seen
P12.14   | m                                       | 0.01  | 1      | the ball of a cradle
P12.15   | sqrt(k*b*d/m)                           | 0.5   | 50     | a model in metres and seconds
P12.15   | 2*m*v1^2/(k*b)                          | 0.004 | 0.33   | an excess over the circle that can be seen, and is small
"""
ROWS = [tuple(cell.strip() for cell in row.split("|")) for row in LIMITS.strip().splitlines()]
WITHOUT_NUMBERS = {"S12.0"}


def problems() -> dict[str, Problem]:
    found = (read_problem(path) for path in files(open_bank(None)))
    return {problem.code: problem for problem in found}


BANK = problems()


def implausible(code: str, draws: int) -> list[str]:
    """What lies outside of the limits, with the givens it came from; sampling alone, whatever mistakes might coincide."""
    found: list[str] = []
    letters = [given.symbol for given in BANK[code].givens]
    rows = [(*row, ready(author_formula(row[1], letters), DOUBLES)) for row in ROWS if row[0] == code]
    for variant in sample(BANK[code], draws, salt="plausible"):
        at = {name: float(each.ratio) * math.pi**each.pi for name, each in variant.exact.items()}
        for _, formula, low, high, why, worked in rows:
            if not float(low) <= worked(at) <= float(high):
                found.append(
                    f"{code} {variant.index}: {formula} = {worked(at):.3g}, not {low} to {high}: {why}; {at}"
                )
    return found


def test_every_problem_with_numbers_has_its_limits():
    assert {row[0] for row in ROWS} == set(BANK) - WITHOUT_NUMBERS
    assert len(BANK) == 40


@pytest.mark.parametrize("code", sorted(set(BANK) - WITHOUT_NUMBERS))
def test_draws_are_plausible(code):
    assert not implausible(code, DRAWS)


@pytest.mark.whole
@pytest.mark.parametrize("code", sorted(set(BANK) - WITHOUT_NUMBERS))
def test_many_draws_are_plausible(code):
    assert not implausible(code, MANY)
