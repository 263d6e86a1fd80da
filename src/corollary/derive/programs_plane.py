"""Students' programs for two bodies in a plane: colliding spheres, and ions that repel each other."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from corollary.derive.said import Said
from corollary.scene.catalogue import run

TOLERANCE = 0.005  # of the relative speed: three times what the book's method errs at most at the steps asked for
FINEST = 1 << 17
Given = Mapping[str, float]
Force = Callable[[float, float, float, float], tuple[float, float]]  # on A, from r_B - r_A and v_B - v_A
Draw = Callable[[float, float], float]


def sphere_force(R: float, k: float, eta: float, *, spring: float = -1.0, drag: float = 1.0, q: float = 1.5) -> Force:
    """On A: k overlap^q along the line of centres and eta times the relative velocity, while the spheres overlap."""

    def force(x: float, y: float, u: float, w: float) -> tuple[float, float]:
        r = math.hypot(x, y)
        if r >= 2 * R:
            return 0.0, 0.0
        push = spring * k * (2 * R - r) ** q / r
        return push * x + drag * eta * u, push * y + drag * eta * w

    return force


def ion_force(C: float, *, sign: float = -1.0, power: float = 3.0) -> Force:
    """On A: C over the square of the distance, away from B."""
    return lambda x, y, u, w: (sign * C * x / math.hypot(x, y) ** power, sign * C * y / math.hypot(x, y) ** power)


def stepped(
    inputs: Mapping[str, Any], force: Force, *, steps: int = 0, both: bool = True, euler: bool = False
) -> tuple[float, ...]:  # fmt: skip
    """Velocities (A x, A y, B x, B y) at the time T by Euler-Cromer's method, in `steps` or in steps of dt; inf when lost."""
    count = steps or max(1, round(inputs["T"] / inputs["dt"]))
    dt = inputs["T"] / count
    (ax, ay), (bx, by), (au, aw), (bu, bw) = inputs["rA"], inputs["rB"], inputs["vA"], inputs["vB"]
    to_a, to_b = dt / inputs["mA"], (dt / inputs["mB"] if both else 0.0)
    for _ in range(count):
        fx, fy = force(bx - ax, by - ay, bu - au, bw - aw)
        if not math.isfinite(fx + fy) or abs(fx) + abs(fy) > 1e12:
            return (math.inf,) * 4
        if euler:
            ax, ay, bx, by = ax + au * dt, ay + aw * dt, bx + bu * dt, by + bw * dt
        au, aw, bu, bw = au + fx * to_a, aw + fy * to_a, bu - fx * to_b, bw - fy * to_b
        if not euler:
            ax, ay, bx, by = ax + au * dt, ay + aw * dt, bx + bu * dt, by + bw * dt
    return au, aw, bu, bw


def converged(inputs: Mapping[str, Any], force: Force, tolerance: float) -> tuple[float, ...]:
    """The same with steps halved and the first order of the error taken out, until it changes by less than the tolerance.

    Raises ArithmeticError when that does not come about.
    """
    steps = max(256, round(inputs["T"] / inputs["dt"]))
    coarse, before = stepped(inputs, force, steps=steps), None
    while steps < FINEST:
        steps *= 2
        fine = stepped(inputs, force, steps=steps)
        better = tuple(2 * one - other for one, other in zip(fine, coarse, strict=True))
        if before is not None and math.dist(better, before) <= tolerance:
            return better
        coarse, before = fine, better
    raise ArithmeticError("the reference motion of the two bodies does not settle")


def sphere_inputs(given: Given, draw: Draw) -> list[dict[str, Any]]:
    """A head-on hit, an oblique one, an oblique one with damping; until the spheres have parted, 200 steps a contact."""
    inputs = []
    for eta, aside in ((0.0, 0.0), (0.0, 0.8), (1.0, 0.6)):
        mA, mB, R = (round(draw(low, high), 4) for low, high in ((0.05, 0.3), (0.05, 0.3), (0.015, 0.03)))
        k, eta = round(draw(1e4, 4e4)), round(eta * draw(0.5, 1.5), 2)
        case = {"mA": mA, "mB": mB, "R": R, "k": k, "eta": eta, "rA": (0.0, 0.0), "rB": (2.2 * R, round(aside * R, 5)),
                "vA": (round(draw(0.6, 1.4), 2), 0.0), "vB": (0.0, round(draw(-0.2, 0.2), 2))}  # fmt: skip
        time = _played(case).observed["duration"]
        assert isinstance(time, float)
        case["T"] = (0.2 * R + 2 * R * (1 - math.sqrt(1 - (aside / 2) ** 2)) + 0.3 * R) / case["vA"][0] + 1.5 * time
        inputs.append(case | {"dt": time / 200})
    return inputs


def judge_spheres(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """Against the scene; then against what the usual wrong programs return, and by the total momentum."""
    reference = _played(inputs).observed["velocities"]
    assert isinstance(reference, tuple)
    R, k, eta = inputs["R"], inputs["k"], inputs["eta"]
    usual = {
        "the spheres pull each other together while they overlap. The spring pushes A away from B, against "
        "$\\Delta\\vec r$.": sphere_force(R, k, eta, spring=1.0),
        "the damping drives the spheres instead of braking them. The force on A must pull its velocity towards that "
        "of B: $+\\eta\\,\\Delta\\vec v$.": sphere_force(R, k, eta, drag=-1.0),
        "the spring force grows linearly with the overlap. Its power is 3/2.": sphere_force(R, k, eta, q=1.0),
        "there is no damping. Add the term with $\\eta$.": sphere_force(R, k, 0.0),
    }
    return _judged(inputs, returned, reference, usual, sphere_force(R, k, eta), f"With eta = {eta:g} kg/s")


def ion_inputs(given: Given, draw: Draw) -> list[dict[str, Any]]:
    """Head-on, oblique, and B moving too; until well after the closest approach, in 1500 steps."""
    inputs = []
    for aside, v_b in ((0.0, 0.0), (0.3, 0.0), (0.5, -0.4)):
        C, mA, mB = round(draw(4e-4, 4e-3), 5), round(draw(0.05, 0.3), 3), round(draw(0.05, 0.3), 3)
        r0, v = round(draw(0.06, 0.15), 3), round(draw(0.6, 1.6), 2)
        T = round(2.5 * r0 / (v - v_b), 4)
        case = {"C": C, "mA": mA, "mB": mB, "rA": (0.0, 0.0), "vA": (v, 0.0), "rB": (r0, round(aside * r0, 4)), "vB": (v_b, 0.0)}
        inputs.append(case | {"T": T, "dt": T / 1500})
    return inputs


def judge_ions(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """Against steps made ever smaller; then against what the usual wrong programs return, and by the total momentum."""
    C = inputs["C"]
    usual = {
        "the ions attract. $\\Delta\\vec r$ leads from A to B, so the force on A needs a minus.": ion_force(C, sign=1.0),
        "the force falls off as $1/\\Delta r$: a unit vector takes one more division.": ion_force(C, power=2.0),
    }
    reference = converged(inputs, ion_force(C), 1e-6 * _speed(inputs))
    return _judged(inputs, returned, reference, usual, ion_force(C), f"With C = {C:g} N m²")


def _judged(
    inputs: Mapping[str, Any], returned: Sequence[float], reference: Sequence[float], usual: Mapping[str, Force], right: Force,
    case: str,
) -> Said | None:  # fmt: skip
    if len(returned) != 4:
        return Said(f"It returns {len(returned)} numbers; return the four velocities v_Ax, v_Ay, v_Bx, v_By.")
    allowed = TOLERANCE * _speed(inputs)
    if math.dist(returned, reference) <= allowed:
        return None
    for sentence, force in usual.items():
        if math.dist(returned, stepped(inputs, force)) <= allowed:
            return Said(f"{case} {sentence}", known=True)
    if math.dist(returned, stepped(inputs, right, euler=True)) <= allowed:
        return Said(f"{case} this is forward Euler: the position is stepped with the old velocity. Step the velocity "
                    f"first, then the position with the new one.", known=True)
    if math.dist(returned, stepped(inputs, right, both=False)) <= allowed:
        return Said(f"{case} only A feels a force. What B does to A, A does to B, the other way.", known=True)
    if math.dist(returned, (*inputs["vA"], *inputs["vB"])) <= allowed:
        return Said(f"{case} nothing has happened to the velocities. Step forward until the time T.")
    mA, mB = inputs["mA"], inputs["mB"]
    lost = [mA * (returned[i] - inputs["vA"][i]) + mB * (returned[i + 2] - inputs["vB"][i]) for i in (0, 1)]
    if math.hypot(*lost) > 0.01 * mA * _speed(inputs):
        return Said(f"{case} the total momentum is not kept. The force on B is that on A, the other way, and each has "
                    f"its own mass.", known=True)
    return Said(f"{case} the total momentum is kept, but the velocities after the time T are not right. Check the "
                f"force law, and that you reach T.")


def _played(inputs: Mapping[str, Any]):
    (ax, ay), (bx, by) = inputs["rA"], inputs["rB"]
    settings = {name: inputs[name] for name in ("mA", "mB", "R", "k", "eta", "vA", "vB")}
    return run("spheres", {**settings, "q": 1.5, "dx": bx - ax, "dy": by - ay}, tolerance=1e-9)


def _speed(inputs: Mapping[str, Any]) -> float:
    return math.dist(inputs["vA"], inputs["vB"])
