"""Words that one slip of the keyboard makes of each other."""

from __future__ import annotations


def one_apart(left: str, right: str) -> bool:
    """Whether one letter put in, left out or exchanged, or two that changed places, make them equal."""
    short, long = sorted((left, right), key=len)
    if len(long) - len(short) > 1:
        return False
    same = next((place for place, (a, b) in enumerate(zip(short, long, strict=False)) if a != b), len(short))
    if (
        len(short) == len(long)
        and short[same:] == long[same + 1 : same + 2] + long[same : same + 1] + long[same + 2 :]
    ):
        return True
    return short[same + (len(short) == len(long)) :] == long[same + 1 :]
