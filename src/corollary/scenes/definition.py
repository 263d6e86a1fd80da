"""A ready-made scene: what it lets one set, what it refuses, and how it is played."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from numbers import Real
from typing import TYPE_CHECKING, Any

from corollary.messages import did_you_mean
from corollary.scenes.run import BadSetting, Observed, Run
from corollary.scenes.validation import short_text

if TYPE_CHECKING:
    from corollary.scenes.film import Film

Settings = Mapping[str, Observed]
"""By name, in SI."""


@dataclass(frozen=True, slots=True)
class Setting:
    """One number (or, with `many`, a row of them), in SI, with the value it takes when nothing is said.

    `above` and `below` are open ends, `least` and `most` closed ones; `below_that` and `most_that` are other settings it is held against.
    """

    name: str
    meaning: str
    unit: str
    value: Observed
    above: float = -math.inf
    least: float = -math.inf
    below: float = math.inf
    most: float = math.inf
    whole: bool = False
    many: bool = False
    below_that: str = ""
    most_that: str = ""

    @property
    def takes(self) -> str:
        """What it must be, in words: `more than 0`, `1 to 10, a whole number`, `at least 0; one number, or a row`; nothing where any number will do."""
        from_to = math.isfinite(self.least) and math.isfinite(self.most)
        words = [
            f"{self.least:g} to {self.most:g}" * from_to,
            f"more than {self.above:g}" * math.isfinite(self.above),
            f"at least {self.least:g}" * (math.isfinite(self.least) and not from_to),
            f"less than {self.below:g}" * math.isfinite(self.below),
            f"at most {self.most:g}" * (math.isfinite(self.most) and not from_to),
            f"less than {self.below_that}" * bool(self.below_that),
            f"at most {self.most_that}" * bool(self.most_that),
            "a whole number" * self.whole,
        ]
        row = ["one number, or a row"] * self.many
        return "; ".join(filter(None, (", ".join(filter(None, words)), *row)))


@dataclass(frozen=True, slots=True)
class SceneDefinition:
    """`meaning` is one line for a list of scenes; `play` takes all settings and a tolerance relative to the scene's natural scale.

    `second_way` plays it by formulas that it does not share with `play`, and gives none where there is no such way for these settings;
    `film` pictures the motion, and gives none where nothing moves.
    """

    meaning: str
    settings: tuple[Setting, ...]
    play: Callable[[Settings, float], Run]
    second_way: Callable[[Settings, float], Run | None] | None = None
    film: Callable[[Settings], Film | None] | None = None


def settle(scene: str, known: Iterable[Setting], given: Mapping[str, object]) -> dict[str, Observed]:
    """All settings of a scene: the given ones checked, the others at their own value. Raises BadSetting."""
    settings = {setting.name: setting for setting in known}
    for name in given:
        if name not in settings:
            hint = did_you_mean(name, settings)
            raise BadSetting(f"{scene}: {name!r} is not among its settings ({', '.join(settings)}){hint}.")
    settled = {
        name: _checked(scene, s, given[name]) if name in given else s.value for name, s in settings.items()
    }
    for setting in settings.values():
        _refuse_misfit(scene, setting, settled)
    return settled


def _refuse_misfit(scene: str, setting: Setting, settled: Settings) -> None:
    """Raises BadSetting for a number that does not go with that of another setting."""
    for other, rule in ((setting.below_that, "less than"), (setting.most_that, "at most")):
        if not other:
            continue
        value, limit = one(settled, setting.name), one(settled, other)
        if value > limit or (value == limit and other == setting.below_that):
            value_text, limit_text = _in_digits(value, limit)
            rule = f"{rule} {other} = {limit_text}{_unit(setting)}"
            raise BadSetting(_broken(scene, setting, value_text, rule))


def _checked(scene: str, setting: Setting, value: Any) -> Observed:
    several = value
    if isinstance(value, (list, tuple)):
        if not setting.many:
            raise BadSetting(f"{scene}: {setting.name} is one number, not a row of {len(several)}.")
        return tuple(_number(scene, setting, each) for each in several)
    return _number(scene, setting, value)


def _number(scene: str, setting: Setting, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, Real):
        raise BadSetting(
            f"{scene}: {setting.name} = {short_text(value)} is not a number ({setting.meaning})."
        )
    try:
        number = float(value)
    except OverflowError:
        raise BadSetting(
            f"{scene}: {setting.name} = {short_text(value)} is beyond the numbers of a computer."
        ) from None
    if not math.isfinite(number):
        raise BadSetting(f"{scene}: {setting.name} = {number} is not finite.")
    if setting.whole and number != round(number):
        raise BadSetting(_broken(scene, setting, f"{number:g}", "a whole number"))
    for holds, rule, limit in (
        (number > setting.above, "more than", setting.above),
        (number >= setting.least, "at least", setting.least),
        (number < setting.below, "less than", setting.below),
        (number <= setting.most, "at most", setting.most),
    ):
        if not holds:
            number_text, limit_text = _in_digits(number, limit)
            raise BadSetting(_broken(scene, setting, number_text, f"{rule} {limit_text}{_unit(setting)}"))
    return number


def _in_digits(number: float, limit: float) -> tuple[str, str]:
    """Both as text, with the digits that it takes to tell them apart; all of them where they are the same."""
    texts = [(f"{number:.{digits}g}", f"{limit:.{digits}g}") for digits in range(6, 18)]
    return next((a, b) for a, b in texts if a != b or (float(a), float(b)) == (number, limit))


def _unit(setting: Setting) -> str:
    return "" if setting.unit == "1" else f" {setting.unit}"


def _broken(scene: str, setting: Setting, number: str, rule: str) -> str:
    """`kick: m = 0 kg must be more than 0 kg (mass of the body).`"""
    return f"{scene}: {setting.name} = {number}{_unit(setting)} must be {rule} ({setting.meaning})."


def one(settings: Settings, name: str) -> float:
    """A setting that is a single number."""
    value = settings[name]
    if isinstance(value, tuple):
        raise BadSetting(f"{name} is one number, not a row of {len(value)}.")
    return value


def numbers(settings: Settings, *names: str) -> list[float]:
    """Settings that are single numbers, in this order."""
    return [one(settings, name) for name in names]


def row(settings: Settings, name: str, count: int, what: str) -> tuple[float, ...]:
    """A setting for each of `count` things; a single number serves them all."""
    value = settings[name]
    if not isinstance(value, tuple):
        return (value,) * count
    if len(value) != count:
        numbers = "1 number" if len(value) == 1 else f"{len(value)} numbers"
        raise BadSetting(f"{name} has {numbers}, but there are {count} {what}.")
    return value


def vector(settings: Settings, name: str) -> tuple[float, float]:
    """A setting (x, y)."""
    x, y = row(settings, name, 2, "components")
    return x, y
