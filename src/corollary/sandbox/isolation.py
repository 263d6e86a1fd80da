"""How well a notebook was shut in, as tried out at the start and told to whoever grades."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.sandbox.result import Isolation

_WALLS = ("namespaces", "Landlock", "seccomp")
UNKNOWN = Isolation(0, "nothing has run yet", ())


class WeakIsolation(RuntimeError):
    """This machine cannot shut notebooks in as well as was required."""

    def __init__(self, found: Isolation, required: int) -> None:
        why = "; ".join(found.missing)
        held = f"level {found.level} holds ({found.line})"
        super().__init__(f"Isolation level {required} is required, but here only {held}: {why}.")
        self.isolation, self.required = found, required

    def __reduce__(self):
        """So that it can be raised in one process and told in another."""
        return WeakIsolation, (self.isolation, self.required)


def isolation_of(held: Mapping[str, bool], reasons: Mapping[str, str]) -> Isolation:
    """The level from what held in the trial; `reasons` say why a wall could not be built.

    Seccomp counts more than the others: without it a notebook starts processes, and no memory limit binds them together.
    """
    standing = [wall for wall in _WALLS if held.get(wall, False)]
    if len(standing) == len(_WALLS):
        level = 3
    elif held.get("seccomp", False) and len(standing) == 2:
        level = 2
    else:
        level = min(1, len(standing))
    bounds = ["rlimits"] if held.get("rlimits", False) else []
    missing = [
        f"{wall}: {reasons.get(wall, 'did not hold when tried')}" for wall in _WALLS if wall not in standing
    ]
    missing += [f"{wall}: {why}" for wall, why in reasons.items() if wall not in _WALLS]
    if "namespaces" not in standing:
        missing.append("a disk of its own: the folder's size is watched, not bounded")
    line = " + ".join((*standing, *bounds)) or "nothing holds"
    return Isolation(level, line + (": do not grade strangers' work" if level == 0 else ""), tuple(missing))
