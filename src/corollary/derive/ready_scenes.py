"""Ready-made scenes of banks by name, and the one door through which they are run, filmed and judged by their condition."""

from __future__ import annotations

import ast
import math
import re
import time
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TypeVar

from corollary.derive.beside import LazyModule, importable
from corollary.derive.load import NotDerivable, authors_code, scene_folders
from corollary.messages import did_you_mean
from corollary.problem.bank import Bank
from corollary.scenes import condition
from corollary.scenes.definition import SceneDefinition, Settings, settle
from corollary.scenes.film import Film, film
from corollary.scenes.progress import part, with_bar
from corollary.scenes.run import BadSetting, GuardFailed, Run, components
from corollary.scenes.scene import Scene
from corollary.scenes.validation import refuse_tolerance

HOLDS_A_SCENE = re.compile(rb"^SCENE\b", re.MULTILINE)
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class ReadyScene:
    """A scene's definition and its file; `late` has a function that imports what lies beside the file."""

    definition: SceneDefinition
    path: Path
    late: bool

    def call(self, function: Callable[..., T], *given: object) -> T:
        """What a function of the scene gives. Raises BadSetting and GuardFailed as it does, NotDerivable for a fault of its code."""
        try:
            if self.late:
                with importable(self.path.parent):
                    return function(*given)
            return function(*given)
        except (BadSetting, GuardFailed, OverflowError, ZeroDivisionError, ValueError):
            raise
        except (Exception, SystemExit) as error:
            with authors_code(self.path, "the scene fails"):
                raise error


class ReadyScenes(Mapping[str, SceneDefinition]):
    """Each Python file that holds a SCENE in the folders is a scene of its name, the first folder's before the others'; it is loaded
    when it is asked for."""

    def __init__(self, folders: tuple[Path, ...]) -> None:
        self._paths = {
            path.stem: path
            for folder in reversed(folders)
            for path in folder.glob("*.py")
            if _holds_a_scene(path)
        }
        self._loaded: dict[str, ReadyScene] = {}

    def __contains__(self, name: object) -> bool:
        return name in self._paths

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(self._paths))

    def __len__(self) -> int:
        return len(self._paths)

    def __getitem__(self, name: str) -> SceneDefinition:
        """Raises NotDerivable for a file that cannot be loaded, or whose SCENE is none."""
        return self.loaded(name).definition

    def loaded(self, name: str) -> ReadyScene:
        """The scene with its file. Raises NotDerivable as above."""
        if name not in self._loaded:
            self._loaded[name] = _loaded(self._paths[name])
        return self._loaded[name]


def ready_scenes(bank: Bank | Path | None = None) -> ReadyScenes:
    """The ready-made scenes of a bank (or of that in a folder), and those of the chapter's that have no namesake in it."""
    return _in_folders(scene_folders(Bank(bank) if isinstance(bank, Path) else bank))


@cache
def _in_folders(folders: tuple[Path, ...]) -> ReadyScenes:
    return ReadyScenes(folders)


def forget() -> None:
    """Load scenes anew when they are next asked for: their files may have changed."""
    _in_folders.cache_clear()


def _holds_a_scene(path: Path) -> bool:
    try:
        return HOLDS_A_SCENE.search(path.read_bytes()) is not None
    except OSError:  # an editor's lock is a link that leads nowhere
        return False


def _loaded(path: Path) -> ReadyScene:
    with authors_code(path, "cannot be loaded"):
        found = LazyModule(path, path.parent).SCENE
        names = {each.stem for each in path.parent.glob("*.py")}
        late = any(
            name.partition(".")[0] in names
            for function in ast.walk(ast.parse(path.read_bytes()))
            if isinstance(function, ast.FunctionDef)
            for node in ast.walk(function)
            for name in _imported(node)
        )
    if not isinstance(found, SceneDefinition):
        raise NotDerivable(path, 0, "SCENE must be a SceneDefinition(…) of corollary.scenes.definition")
    return ReadyScene(found, path, late)


def _imported(node: ast.AST) -> tuple[str, ...]:
    match node:
        case ast.Import(names):
            return tuple(each.name for each in names)
        case ast.ImportFrom(module=str(module), level=0):
            return (module,)
        case _:
            return ()


def definition(name: str, bank: Bank | Path | None = None) -> SceneDefinition:
    """What a ready-made scene is and what it takes. Raises BadSetting where there is none of this name."""
    return _named(name, bank).definition


def _named(name: str, bank: Bank | Path | None) -> ReadyScene:
    scenes = ready_scenes(bank)
    if name not in scenes:
        raise BadSetting(
            f"There is no scene {name!r}{did_you_mean(name, scenes)}; choose one of {', '.join(scenes)}."
        )
    return scenes.loaded(name)


def run(
    name: str,
    settings: Mapping[str, object],
    tolerance: float = 1e-12,
    *,
    second_way: bool = False,
    bank: Bank | Path | None = None,
) -> Run:
    """Play a ready-made scene with the least model that answers; what confirms a formula asks for its `second_way`, which shares none.

    By the second way only those values are there that it gives; what is followed in steps in any case has none, and the same run is
    given.

    Settings are in SI; those not given take the scene's own values. `tolerance` is relative to the scene's natural scale. A value that
    no double holds, or that does not exist (how long a contact lasts that never ends), is left out, and a warning says so.
    Raises BadSetting when a setting is unknown or unphysical, GuardFailed when momentum or energy is not conserved, NotDerivable for
    a fault of the scene's code.
    """
    scene = _named(name, bank)
    known = scene.definition
    refuse_tolerance(name, tolerance)
    settled = settle(name, known.settings, settings)
    begin = time.perf_counter()
    with _in_range(name):
        found = None
        if second_way and known.second_way is not None:
            found = scene.call(known.second_way, settled, tolerance)
        if found is None:
            found = scene.call(known.play, settled, tolerance)
    if not isinstance(found, Run):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise NotDerivable(scene.path, 0, "play must give a Run, as play(…) of corollary.scenes.plan does")
    return replace(_finite(name, found), scene=name, settings=settled, seconds=time.perf_counter() - begin)


@contextmanager
def _in_range(name: str) -> Generator[None]:
    """Raise BadSetting where numbers leave the range of doubles."""
    try:
        yield
    except BadSetting:
        raise
    except (OverflowError, ZeroDivisionError, ValueError):
        raise BadSetting(
            f"{name}: with these settings numbers leave the range of a computer; choose milder ones."
        ) from None


def _finite(scene: str, found: Run) -> Run:
    """Without the values that are no numbers of a computer, and with a warning for each. Raises BadSetting when none is left."""
    lost = [
        name
        for name, each in found.measured.items()
        if not all(map(math.isfinite, (*components(each.value), *components(each.error))))
    ]
    if len(lost) == len(found.measured):
        raise BadSetting(
            f"{scene}: with these settings numbers leave the range of a computer; choose milder ones."
        )
    return found.without(lost) if lost else found


def play(
    name: str, settings: Mapping[str, object], tolerance: float = 1e-12, *, bank: Bank | Path | None = None
) -> Run:
    """A ready-made scene as `run` plays it, and its conditions; who waits for it at a terminal sees a bar. Raises as `run` does."""
    with with_bar(f"scene {name}"):
        with part(0.0, 0.5):
            found = run(name, settings, tolerance, bank=bank)
        with part(0.5, 1.0):
            return with_conditions(found, tolerance, bank=bank)


def with_conditions(found: Run, tolerance: float, *, bank: Bank | Path | None = None) -> Run:
    """The same run of a ready-made scene with the condition of each value, and warnings where it is large or another outcome is near."""

    def again(settings: Settings) -> Run:
        return run(found.scene, settings, tolerance, bank=bank)

    return condition.with_conditions(found, definition(found.scene, bank).settings, again)


def film_of(
    scene: str | Scene, settings: Mapping[str, object], bank: Bank | Path | None = None
) -> Film | None:
    """A run of a ready-made scene by its name, or of a composed one that names its end; none for what is no motion, or has no end.

    Raises BadSetting, GuardFailed and NotDerivable as playing it does.
    """
    if isinstance(scene, Scene):
        return film(scene.bodies, [(scene.forces, scene.until)]) if scene.until is not None else None
    ready = _named(scene, bank)
    if ready.definition.film is None:
        return None
    settled = settle(scene, ready.definition.settings, settings)
    # Who did not ask for friction does not see any.
    smooth = {"mu": 0.0} if "mu" in settled and "mu" not in settings else {}
    with _in_range(scene):
        return ready.call(ready.definition.film, {**settled, **smooth})
