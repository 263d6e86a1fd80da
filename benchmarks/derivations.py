"""Derivations by other students: right ones varied, an error planted in a line, only what holds where a law does not.

Numbers of a point at which the laws hold come from formulas written here, and tell whether a changed line is false.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from corollary.answers.answer import Equation
from corollary.answers.proof.argument import Standing
from corollary.formula.ast import names
from corollary.formula.plain_text import text

SWAPS = {
    "X12.13": "mu/R L/y v0/y m/mu g/v0",
    "S12.5nc": "A_x/B_x A_y/B_y A_x/A_y v0/A_x B_x/B_y",
    "S12.5two": "mA/mB vA/vB v_A1/v_B1 vA/v_A1 vB/v_B1",
}
SPELLED = {
    "mA": "m_A",
    "mB": "m_B",
    "vA": "v_A",
    "vB": "v_B",
    "v_A1": "v_{A1}",
    "v_B1": "vB1",
    "dK": "ΔK",
    "mu": "μ",
    "v0": "v_0",
    "A_x": "Ax",
}
REASONS = (
    "",
    "",
    " (momentum)",
    " [energy]",
    ", by the line above",
    " (insert)",
    " (2)",
    " by conservation of momentum",
    " # simplify",
)
OWN = (
    "Q",
    "W_1",
    "E2",
    "T",
    "P_0",
    "N",
    "S",
    "X",
    "Z_a",
    "H",
    "k1",
    "k2",
    "q",
    "w_r",
    "j",
    "h_0",
    "U",
    "D2",
    "c1",
    "c2",
)


def lawful(code: str, dice: random.Random) -> dict[str, float]:
    """Numbers at which the laws hold, each by its formula."""
    draw = dice.uniform
    if code == "X12.13":
        m, L, v0, y, g = draw(0.5, 3), draw(1, 4), draw(1, 5), draw(0.1, 0.9), 9.81
        force = m / L * (v0**2 + g * y)
        return {"m": m, "L": L, "v0": v0, "y": y, "g": g, "mu": m * y / L, "R": m * v0 / L, "F": force}
    if code == "S12.5nc":
        v0, m, angle = draw(0.5, 5), draw(0.05, 0.5), draw(0.2, 1.3)
        c, s = math.cos(angle), math.sin(angle)
        after = {"B_x": v0 * c * c, "B_y": v0 * c * s, "A_x": v0 * s * s, "A_y": -v0 * c * s}
        return after | {"v0": v0, "mA": m, "mB": m}
    mA, mB, vA, vB, r = draw(0.5, 9), draw(0.5, 9), draw(2, 9), draw(-6, 1.5), draw(0.2, 0.9)
    V, w, reduced = (mA * vA + mB * vB) / (mA + mB), vA - vB, mA * mB / (mA + mB)
    after = {"v_A1": V - reduced / mA * r * w, "v_B1": V + reduced / mB * r * w}
    return after | {"mA": mA, "mB": mB, "vA": vA, "vB": vB, "r": r, "dK": -reduced / 2 * (1 - r * r) * w * w}


@dataclass(frozen=True, slots=True)
class Written:
    """A derivation by hand: as typed, equation by equation as it was read, and what each equation is."""

    code: str
    part: str
    way: str
    lines: tuple[str, ...]
    equations: tuple[Equation, ...]
    standings: tuple[Standing, ...]
    movable: frozenset[str]

    @property
    def texts(self) -> list[str]:
        return [text(each.relation) for each in self.equations]

    @property
    def definitions(self) -> set[str]:
        return {text(each.relation) for each in self.equations if each.defines}

    @property
    def own(self) -> list[str]:
        return [each.defines for each in self.equations if each.defines]


def varied(written: Written, dice: random.Random) -> list[str]:
    """The same derivation by another student: lines left out, laws and definitions earlier, letters renamed, sides turned, reasons behind."""
    lines = list(zip(written.texts, written.standings, strict=True))
    skipped = dice.random()
    lines = [
        each for each in lines if each[1].kind != "follows" or each[1].claims or dice.random() > 0.5 * skipped
    ]
    for place, each in enumerate(lines):
        if place and each[0] in written.movable and dice.random() < 0.4:
            lines.insert(dice.randrange(place), lines.pop(place))
    found = [_turned(line, line in written.definitions, dice) for line, _standing in lines]
    new = dice.sample(OWN, len(OWN)) if dice.random() < 0.5 else []
    taken = {name for each in written.equations for name in names(each.relation)}
    renaming = dict(zip(written.own, [each for each in new if each not in taken], strict=False))
    if dice.random() < 0.4:
        renaming |= {name: SPELLED[name] for name in SPELLED if name not in written.own}
    equals, power = dice.choice(("=", "=", "==")), dice.choice(("^", "^", "**"))
    found = [_renamed(line, renaming).replace(" = ", f" {equals} ").replace("^", power) for line in found]
    found = [line + dice.choice(REASONS) for line in found]
    return [f"{number}) {line}" for number, line in enumerate(found, 1)] if dice.random() < 0.2 else found


def _turned(line: str, defines: bool, dice: random.Random) -> str:
    left, right = line.split(" = ")
    if defines:
        return f"{right} = {left}" if dice.random() < 0.15 else line
    match dice.randrange(8):
        case 0:
            return f"{right} = {left}"
        case 1:
            return f"{left} - ({right}) = 0"
        case 2:
            return f"2*({left}) = 2*({right})"
        case _:
            return line


def _renamed(line: str, renaming: dict[str, str]) -> str:
    return re.sub(r"[A-Za-z]\w*", lambda found: renaming.get(found[0], found[0]), line)


def with_error(written: Written, dice: random.Random) -> tuple[list[str], int] | None:
    """One line changed so that it, or the first line that uses what it defines, is false; and the number of that line."""
    lines = written.texts
    for _attempt in range(60):
        place = dice.randrange(len(lines))
        changed = [*lines[:place], _mutated(lines[place], written.code, dice), *lines[place + 1 :]]
        if changed[place] == lines[place]:
            continue
        false = first_false(changed, written, dice)
        if false is not None and (false == place or written.equations[place].defines):
            return changed, false + 1
    return None


def _mutated(line: str, code: str, dice: random.Random) -> str:
    one, other = dice.choice(SWAPS[code].split()).split("/")
    changes: tuple[tuple[str, str], ...] = (
        (r" \+ ", " - "),
        (r" - ", " + "),
        (r"\^2", ""),
        (r"(?<=[/*(])2(?!\d)", "3"),
        (r"/2(?!\d)", ""),
        (rf"\b{one}\b", other),
        (rf"\b{other}\b", one),
        (rf"\b{one}\*", ""),
        (r" = ", " = 2*"),
        (r" = ", " = -"),
        (r"\b1 - r", "1 + r"),
    )
    pattern, replacement = dice.choice(changes)
    places = list(re.finditer(pattern, line))
    if not places:
        return line
    found = dice.choice(places)
    if " = " in replacement and re.match(r"[^+-]* [+-] ", line[found.end() :]):
        return line[: found.start()] + replacement + "(" + line[found.end() :] + ")"
    return line[: found.start()] + replacement + line[found.end() :]


def first_false(lines: Sequence[str], written: Written, dice: random.Random) -> int | None:
    """The place of the first line that is false at several points, with letters of the student's own as these lines define them."""
    places: set[int | None] = set()
    for _again in range(3):
        values: dict[str, Any] = lawful(written.code, dice) | {"sqrt": math.sqrt}
        waiting = [
            (each.defines, line) for each, line in zip(written.equations, lines, strict=True) if each.defines
        ]
        for _pass in range(len(waiting)):
            for name, line in waiting:
                left, _, right = line.partition(" = ")
                with suppress(NameError):  # it is made of one that comes later
                    values[_python(name)] = _value(right if left == name else left, values)
        try:
            places.add(next((place for place, line in enumerate(lines) if not _holds(line, values)), None))
        except NameError:
            return None
    return places.pop() if len(places) == 1 else None


def _define(lines: Sequence[str], written: Written, values: dict[str, Any]) -> None:
    """Gives values to the letters of the student's own."""
    waiting = [
        (each.defines, line) for each, line in zip(written.equations, lines, strict=True) if each.defines
    ]
    for _pass in waiting:
        for name, line in waiting:
            left, _, right = line.partition(" = ")
            with suppress(NameError):  # it is made of one that comes later
                values[_python(name)] = _value(right if left == name else left, values)


def _python(formula: str) -> str:
    return re.sub(r"\blambda\b", "lambda_", formula.replace("^", "**"))


def _value(formula: str, values: dict[str, Any]) -> float:
    return eval(_python(formula), {"__builtins__": {}}, values)


def _holds(line: str, values: dict[str, Any]) -> bool:
    left, right = (_value(side, values) for side in line.split(" = "))
    return abs(left - right) <= 1e-7 * (1 + abs(left) + abs(right))


def without_a_law(written: Written, dice: random.Random) -> list[str] | None:
    """Only those lines that hold in a world where one law does not, and the claim, which does not hold there: no proof."""
    world = dice.choice(otherwise(written.code, dice))
    values: dict[str, Any] = world | {"sqrt": math.sqrt}
    _define(written.texts, written, values)
    lines = [
        line
        for line, each in zip(written.texts, written.equations, strict=True)
        if each.defines or _holds(line, values)
    ]
    false = not _holds(written.texts[-1], values)
    return [*lines, written.texts[-1]] if set(lines) - written.definitions and false else None


def otherwise(code: str, dice: random.Random) -> list[dict[str, float]]:
    """Numbers at which one law is broken, and the others hold."""
    v, draw = lawful(code, dice), dice.uniform
    if code == "X12.13":
        heavy, fast = 1.3 * v["mu"], 1.4 * v["R"]
        return [
            v | {"F": 1.2 * v["F"]},
            v | {"mu": heavy, "F": heavy * v["g"] + v["R"] * v["v0"]},
            v | {"R": fast, "F": v["mu"] * v["g"] + fast * v["v0"]},
        ]
    if code == "S12.5nc":
        angle, share = draw(0.2, 1.3), draw(0.3, 0.8)
        lost = v | {"A_x": share * v["v0"], "B_x": (1 - share) * v["v0"], "A_y": 0.3, "B_y": -0.3}
        turned = v | {"B_x": v["v0"] * share * math.cos(angle), "B_y": v["v0"] * share * math.sin(angle)}
        slow = math.sqrt(1 - share**2) * v["v0"]
        along_x = turned | {"A_y": 0.0, "A_x": v["v0"] - turned["B_x"]}
        along_x["B_y"] = math.sqrt(v["v0"] ** 2 - along_x["A_x"] ** 2 - along_x["B_x"] ** 2)
        along_y = turned | {"A_y": -turned["B_y"]}
        along_y["A_x"] = math.sqrt(max(slow**2 - along_y["A_y"] ** 2, 0.0))
        ways = [lost, along_x]
        return [*ways, along_y] if slow**2 > along_y["A_y"] ** 2 else ways
    mA, mB, vA, vB, r, w = (*(v[name] for name in ("mA", "mB", "vA", "vB", "r")), v["vA"] - v["vB"])
    jumped = v | {"v_A1": v["v_A1"] + 0.7, "v_B1": v["v_A1"] + 0.7 + r * w}
    sticky = v | {"v_A1": v["v_A1"] + 0.7, "v_B1": v["v_B1"] - 0.7 * mA / mB}
    for each in (jumped, sticky):
        each["dK"] = (mA * (each["v_A1"] ** 2 - vA**2) + mB * (each["v_B1"] ** 2 - vB**2)) / 2
    return [jumped, sticky, v | {"dK": 0.8 * v["dK"]}]
