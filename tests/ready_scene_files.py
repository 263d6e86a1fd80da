"""The files of the chapter's ready-made scenes, as they are loaded when these are played."""

from __future__ import annotations

import inspect
from typing import Any

from corollary.derive.ready_scenes import ready_scenes


def names_in(scene: str) -> dict[str, Any]:
    """Everything by its name that the file of a scene defines or imports; what is put there is what it plays with."""
    return inspect.unwrap(ready_scenes()[scene].play).__globals__
