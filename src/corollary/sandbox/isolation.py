"""The level of isolation on this machine, by what was found to hold, and a sentence for whoever grades."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

LAYERS = ("namespaces", "Landlock", "seccomp")
GUARANTEES = {
    "reads": "files outside its own folder cannot be read",
    "writes": "files outside its own folder cannot be changed",
    "signals": "no signal reaches another process",
    "network": "nothing is sent or received",
}
_DISK = "a disk of its own: the folder's size is watched, not bounded"


@dataclass(frozen=True, slots=True)
class Isolation:
    """What a notebook cannot do here, as found by trying it in a worker that was confined like every other.

    Level 0: it may read, change, signal or send something outside of its own folder, and is not fit for strangers' work.
    Level 1: none of these four (GUARANTEES), but it may start processes, which no memory limit binds together.
    Level 2: nor that. Level 3: and namespaces, Landlock and seccomp are all in force, so that each of the four is held
    twice. `line` names the layers in force and what is not guaranteed; `missing` says which layer is absent and why.
    """

    level: int
    line: str
    missing: tuple[str, ...]
    guaranteed: tuple[str, ...] = ()


UNKNOWN = Isolation(0, "nothing has run yet", ())


class WeakIsolation(RuntimeError):
    """This machine cannot isolate notebooks as well as was required."""

    def __init__(self, found: Isolation, required: int) -> None:
        why = "; ".join(found.missing)
        super().__init__(
            f"Isolation level {required} is required, but here only level {found.level} holds ({found.line}): {why}."
        )
        self.isolation, self.required = found, required

    def __reduce__(self) -> tuple[type[WeakIsolation], tuple[Any, ...]]:
        """So that it can be raised in one process and shown in another."""
        return WeakIsolation, (self.isolation, self.required)


def isolation_of(held: Mapping[str, bool], reasons: Mapping[str, str]) -> Isolation:
    """The level from what a probe found to hold; `reasons` say why a layer could not be had."""
    layers = [layer for layer in LAYERS if held.get(layer, False)]
    guaranteed = tuple(name for name in GUARANTEES if held.get(name, False))
    lacking = [name for name in GUARANTEES if name not in guaranteed]
    if lacking:
        level = 0
    elif not held.get("processes", False):
        level = 1
    else:
        level = 3 if len(layers) == len(LAYERS) else 2
    missing = [
        f"{layer}: {reasons.get(layer, 'did not hold when tried')}" for layer in LAYERS if layer not in layers
    ]
    missing += [f"{name}: {why}" for name, why in reasons.items() if name not in LAYERS]
    if not held.get("disk", False):
        missing.append(_DISK)
    line = " + ".join((*layers, *(["rlimits"] if held.get("rlimits", False) else []))) or "nothing holds"
    if lacking:
        line += f"; not guaranteed: {', '.join(lacking)}: do not grade strangers' work"
    return Isolation(level, line, tuple(missing), guaranteed)
