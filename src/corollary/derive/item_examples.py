"""A meaning and an example for each heading and each item of a solution in text."""

from __future__ import annotations

from collections.abc import Mapping

HEADINGS: tuple[tuple[str, str, str], ...] = (
    ("step", "a step: the part that it answers in brackets, and what it finds", "## (a) t"),
    ("step on the way", "what nobody asks for, with its meaning", "## p: momentum of the car"),
    (
        "case",
        "what holds under a condition; its steps have ### headings",
        "## Case: it rests, if `F <= mu*N`",
    ),
    ("checks", "claims that no step has to find", "## Checks"),
)
OPTIONS: tuple[tuple[str, str, str], ...] = (
    ("is right", "the right option of a `.choice` part", "- (b) is right"),
    ("is wrong", "what choosing it overlooks", "- (a) is wrong: The way is longer, and so is the time."),
    ("is right if", "an option that is right under a condition", "- (c) is right if `F > mu*N`"),
)
ITEMS: Mapping[str, tuple[str, str]] = {
    "law": ("a law by its name and formula, or a law of the library", "- law: Speed, `v = d/t`"),
    "each": ("a list with an entry for each whole number", "- each: `m` from `1` to `floor(d/lam)`"),
    "also": ("unknowns in the laws that nobody asks for", "- also: `T, N`"),
    "where": ("which of several roots is meant", "- where: `t > 0`"),
    "reject": ("a refused root, on record", "- reject: nothing has happened yet `t = 0`"),
    "mistake": ("a sentence, then what the misconception makes of the law", "- mistake: You divided the speed by the way. `t = v/d`"),
    "route": ("other laws that lead to the same result, below it", "- route: By energy."),
    "check": ("a sanity check in the worked solution", "- check: Twice the speed takes half the time."),
    "scale": ("for an answer that is zero, what to compare it with", "- scale: `d/v`"),
    "letter": ("an unknown that a later step finds", "- letter: `T` tension of the rope"),
    "function": ("a function of time, above the first step", "- function: `x(y)` place of the ball"),
    "variable": ("a variable without a value, above the first step", "- variable: `y` time"),
    "supposed": ("a value for what is neglected, above the first step", "- supposed: `tau = 1 ms` hard things touch no longer"),
    "optimum": ("where something is largest or smallest", "- optimum: `R` is largest for `theta` from `0` to `pi/2`"),
    "simulated": ("an answer measured in a ready-made scene", "- simulated: `cradle`, `velocities`"),
    "example": ("numbers of the student's own, and how many are free", "- example: 1 free"),
    "apart": ("numbers that are no example, and why", "- apart: `0, 0` nothing moves"),
    "neglected": ("what the answer leaves out, with a law for its bound", "- neglected: the weight of the ball"),
    "supposing": ("values that are supposed above", "- supposing: `tau`"),
    "proof": ("what a derivation must show", "- proof: To show, `F = m*v/dt`"),
    "line": ("a line of one good derivation", "- line: `F*dt = m*v`"),
    "given": ("what the question of a derivation states", "- given: Equal masses, `m_B = m_A`"),
    "rate": ("the derivative by time of a letter that changes", "- rate: `mu = R`"),
    "force": ("a force that acts: option, magnitude, direction", "- force: (a) `m*g` down"),
    "along": ("a direction, and the law of the components along it", "- along: up, `N = m*g`"),
    "code": ("the file of a program's judge", "- code: `braking/judge_braking.py`"),
    "plot": ("the file of a figure's judge", "- plot: `braking/judge_braking.py`"),
    "returns": ("what a function of the student must return", "- returns: `place(v, a, t) = v*t - a*t^2/2`"),
    "drawn": ("between which values an argument is drawn", "- drawn: `t` from `0.5 s` to `12 s`"),
    "corner": ("a special case that is called, too", "- corner: `t = 0 s`"),
    "curve": ("a curve that the figure must have", "- curve: `v - a*t` against `t` from `0` to `v/a`"),
    "axes": ("the labels of the axes, with units", "- axes: `t [s]`, `v [m/s]`"),
    "fit": ("the line through the student's points", "- fit: slope `2*a`, intercept `0`"),
    "within": ("how far a program or a line may be off", "- within: 2 %"),
    "rubric": ("a line of the rubric by which a person marks", "- rubric: names the law of action and reaction"),
    "at": ("a special case: givens are set, and what is found is claimed", "- at: `v = w, u = v`"),
    "limit": ("what an answer comes to", "- limit: The way back takes no time. `u -> 2*v` as `w -> oo`"),
    "always": ("what holds for every variant", "- always: the mean is below twice the first speed `u < 2*v`"),
    "confirm": ("laws, below it, that must hold, too", "- confirm: The energies agree."),
    "printed": ("what the source prints for its numbers", "- printed: (a) `2880 s` in (12.31)"),
}  # fmt: skip
ITEMS_BELOW: Mapping[str, tuple[str, str]] = {
    "law": ("a law below a mistake, a route or a confirm", "  - law: Left loop, `E = i*(R + T)`"),
    "each": ("a mistake in a list of entries", "  - each: `m` from `0` to `floor(d/lam)`"),
    "with": ("letters of the law by those of the problem", "  - with: `m = m1 + m2`"),
    "holds": ("when the law holds", "  - holds: without friction"),
    "source": ("where the law is from", "  - source: (12.31)"),
    "where": ("which root a mistake leads to", "  - where: `v > 0`"),
    "instead of": ("the law that a mistake replaces", '  - instead of: "Speed"'),
    "named": ("the misconception's name, the same in every problem", '  - named: "factor 1/2 left out"'),
    "erratum": ("why a printed value is wrong", "  - erratum: a slip of the unit"),
    "inputs": ("the function that lists the inputs of a program", "  - inputs: `inputs`"),
    "judge": ("the function that judges", "  - judge: `judge`"),
    "example": ("the file of an example that is right", "  - example: `braking/place.py`"),
    "with calls": ("whether the judge of a figure calls the program, too", "  - with calls: yes"),
}
