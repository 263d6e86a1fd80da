"""The only door to `solutions/`: a problem's derivation, its scene, and nothing else of the file."""

from __future__ import annotations

import ast
import importlib.util
import inspect
import re
import sys
import traceback
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager, redirect_stdout, suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from typing import Any, cast

from corollary.answers.questions import checked
from corollary.derive.beside import NAMES, compiled, files_beside, importable
from corollary.derive.derivation import Branch, Derivation
from corollary.derive.given_signs import symbol_of
from corollary.derive.markdown_items import MarkdownError
from corollary.derive.statements import SOLUTION
from corollary.derive.time_limit import TooLong, keyboard, no_way_out, time_limit
from corollary.guard import Overtime, failure_of
from corollary.problem.bank import Bank, UnknownCode, chapter_bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.front_matter import not_utf8
from corollary.problem.problem import Problem

AUTHOR_S, AUTHOR_WALL_S = 10.0, 30.0
"""Seconds of the processor, and on the wall, for a solution's own code to state what it derives, which takes it some milliseconds."""
LONGEST = 600  # letters of an exception's text that an author is shown
OF_NUMBERS = ("Cannot convert expression to float", "Cannot convert symbols to", "has no callable")
"""What Python says where a function of numbers is given a formula."""


class NotDerivable(Exception):
    """A solution that does not derive what it should; says where (file and line) and what to do."""

    def __init__(self, path: Path, line: int, sentence: str):
        self.path, self.line, self.sentence = path, line, sentence
        name = name_in_bank(path)
        super().__init__(f"{name}:{line}: {sentence}" if line else f"{name}: {sentence}")

    def __reduce__(self):
        """So that it can be raised in one process and caught in another."""
        return NotDerivable, (self.path, self.line, self.sentence)


@dataclass(frozen=True, slots=True)
class Loaded:
    """What a solution file says: the derivation (of its first case), the line where derive begins, what to simulate, and what
    letters stand for, where it says so. `bank` is the one whose ready-made scenes it names; `scene` loads the function."""

    path: Path
    bank: Bank
    derivation: Derivation
    line: int
    scene: Callable[[], Callable[..., Any]] | None
    branches: tuple[Branch, ...]
    meanings: Mapping[str, str] = field(default_factory=dict[str, str])


def load(bank: Bank, problem: Problem) -> Loaded:
    """The derivation of a problem. Raises NotDerivable when the file is missing, fails, or asks for givens that are not there.

    Raises Malformed when a part's heading does not fit its answer type.
    """
    checked(problem)
    path = bank.solution(problem)
    if not path.is_file():
        raise NotDerivable(path, 0, f"is missing; {problem.path.name} needs a solution there")
    home = bank.home_of(problem.path)
    if path.suffix == ".md":
        return _read(problem, path, home)
    with importable(path.parent), time_limit(AUTHOR_S, AUTHOR_WALL_S), redirect_stdout(sys.stderr):
        return _loaded(problem, path, home)


@contextmanager
def authors_code(
    path: Path, fails: str, line: int = 0, passing: tuple[type[Exception], ...] = ()
) -> Generator[None]:
    """Raise NotDerivable for whatever an author's own code raises, SystemExit and a KeyboardInterrupt of its own among it.

    What a person interrupts at the keyboard stops all the same.
    """
    with no_way_out(), keyboard() as pressed:
        try:
            yield
        except (NotDerivable, Overtime, *passing):
            raise
        except BaseException as error:
            if pressed():
                raise KeyboardInterrupt from error
            place, at = place_in(error, path)
            if isinstance(error, SyntaxError) and error.filename == str(place):
                raise NotDerivable(place, at, f"is not Python: {error.msg}") from None
            sentence = f"{fails}: {_description(error)}{_remedy(error)}"
            raise NotDerivable(place, at or line, sentence) from error


@contextmanager
def called_later(
    bank: Bank, problem: Problem, fails: str, line: int, passing: tuple[type[Exception], ...] = ()
) -> Generator[None]:
    """Around a call of a function that a solution brought, after it was loaded: what it raises is a NotDerivable that names the
    file and line, what it prints is no output of a command, and it may import what lies beside the solution."""
    path = bank.solution(problem)
    with importable(path.parent), redirect_stdout(sys.stderr), authors_code(path, fails, line, passing):
        yield


def _read(problem: Problem, path: Path, bank: Bank) -> Loaded:
    """A solution in text. Nothing is run: its scene, in the file of the same name beside it, is loaded when it is asked for."""
    from corollary.derive.solution_text import read_solution  # only here, as sympy above

    try:
        text = path.read_text(encoding="utf-8")
        with time_limit(AUTHOR_S, AUTHOR_WALL_S), _letters(problem) as (symbols, meanings):
            stated = read_solution(text, symbols, path.parent)
    except MarkdownError as error:
        raise NotDerivable(path, error.line, error.sentence) from error
    except UnicodeDecodeError as error:
        raise NotDerivable(path, *not_utf8(error)) from None
    except (OSError, TooLong) as error:
        raise NotDerivable(path, 0, f"cannot be read: {error}") from None
    return Loaded(path, bank, stated[0].derivation, 1, _scene_beside(path), stated, meanings)


@contextmanager
def _letters(problem: Problem) -> Generator[tuple[dict[str, Any], dict[str, str]]]:
    """While a derivation of the problem is stated: the symbols of its givens and variables, and what letters stand for, filled as they are named."""
    from corollary.laws.law import own_letters  # only here, as sympy above

    names = [given.symbol for given in problem.givens if not given.words]  # words are for the statement
    names += [each.symbol for each in problem.variables]
    symbols = {name: symbol_of(problem, name) for name in names}
    with own_letters(symbols, numbered=problem.path.is_relative_to(chapter_bank().problems)) as meanings:
        yield symbols, meanings


def _scene_beside(path: Path) -> Callable[[], Callable[..., Any]] | None:
    """The function `scene` of the program beside a solution in text, loaded when it is asked for. Raises NotDerivable."""
    program = path.with_suffix(".py")
    if not program.is_file():
        return None
    try:
        body = ast.parse(program.read_bytes()).body
    except (SyntaxError, ValueError) as error:
        raise NotDerivable(program, getattr(error, "lineno", 0) or 0, f"is not Python: {error}") from None
    functions = {node.name: node.lineno for node in body if isinstance(node, ast.FunctionDef)}
    if "derive" in functions:
        sentence = f"states a solution that stands in {path.name}, too; keep one of the two"
        raise NotDerivable(program, functions["derive"], sentence)

    def loaded() -> Callable[..., Any]:
        with importable(program.parent), time_limit(AUTHOR_S, AUTHOR_WALL_S), redirect_stdout(sys.stderr):
            return cast("Callable[..., Any]", _module(program).scene)

    return loaded if "scene" in functions else None


def _loaded(problem: Problem, path: Path, bank: Bank) -> Loaded:
    module = _module(path)
    derive = getattr(module, "derive", None)
    if not inspect.isfunction(derive):
        raise NotDerivable(path, 1, "defines no function derive(…) with the givens as arguments")
    line = derive.__code__.co_firstlineno
    wanted = list(inspect.signature(derive).parameters)
    have = [each.symbol for each in problem.letters if not getattr(each, "words", ())]
    if strange := [name for name in wanted if name not in have]:
        words = [given.symbol for given in problem.givens if given.symbol in strange]
        why = f"; {', '.join(words)} is a word, which stands in the text only" if words else ""
        known = f"the givens of {problem.code} ({', '.join(have)})"
        raise NotDerivable(path, line, f"derive takes {', '.join(strange)}, not among {known}{why}")
    with authors_code(path, "derive fails", line), _letters(problem) as (symbols, meanings):
        derivation = derive(**{name: symbols[name] for name in wanted})
    stated = cast("tuple[Any, ...]", derivation) if isinstance(derivation, tuple) else ()
    if not all(isinstance(each, Branch) for each in stated) or not stated:
        raise NotDerivable(path, line, "derive must return derivation(…)")
    scene = getattr(module, "scene", None)
    found = (lambda: scene) if inspect.isfunction(scene) else None
    return Loaded(path, bank, stated[0].derivation, line, found, stated, meanings)


def source(bank: Bank, problem: Problem) -> bytes:
    """The text of a solution with those of the files beside it that it is made of. Raises NotDerivable when it is missing."""
    return b"\0".join(sources(bank, problem).values())


def sources(bank: Bank, problem: Problem) -> dict[Path, bytes]:
    """The texts of a solution and of the files beside it that it imports or names, its own first, and of the ready-made scenes that
    these name. Raises NotDerivable."""
    path = bank.solution(problem)
    try:
        own, scenes = path.read_bytes(), scene_folders(bank.home_of(problem.path))
        return {path: own} | {each: each.read_bytes() for each in files_beside(path, own, scenes)}
    except OSError as error:
        raise NotDerivable(path, 0, f"cannot be read: {error.strerror}") from None


@cache
def scene_folders(bank: Bank | None) -> tuple[Path, ...]:
    """Where the ready-made scenes of a bank lie, and after them the chapter's."""
    banks = () if bank is None else bank.each
    with suppress(UnknownCode):  # where the chapter's bank is missing, a bank has its own
        banks = (*banks, chapter_bank())
    return tuple(dict.fromkeys(each.scenes for each in banks))


def place_in(error: BaseException, path: Path) -> tuple[Path, int]:
    """The deepest line that took part in an exception of a solution's file, or of one beside it; its own file and 0 without one."""
    frames = [(frame.filename, frame.lineno) for frame in traceback.extract_tb(error.__traceback__)]
    if isinstance(error, SyntaxError) and error.filename:
        frames.append((error.filename, error.lineno or 1))
    for name, line in reversed(frames):
        if line and Path(name).is_relative_to(path.parent):
            return Path(name), line
    return path, 0


def _module(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(SOLUTION + path.stem, path)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    vars(module).update(NAMES)
    with authors_code(path, "cannot be loaded"):
        # Compiled anew: Python takes its own copy for the same file when size and second are, as after a quick change of a sign.
        exec(compiled(path.read_bytes(), str(path)), vars(module))
    return module


def _description(error: BaseException) -> str:
    try:
        text = str(error)
        text = text if len(text) <= LONGEST else f"{text[:LONGEST]} …"
        return f"{type(error).__name__}: {text}".removesuffix(": ")
    except Exception:  # an author's own exception may fail at its own words
        return failure_of(error).what


def _in_scenes(name: str) -> str:
    """The module that has a body, a scene or a force; "" where none has."""
    import corollary.scenes.forces as forces
    from corollary.scenes import body, scene

    homes = [scene.__name__, *(f"{forces.__name__}.{each.name}" for each in iter_modules(forces.__path__))]
    for home in homes:
        made_in = getattr(getattr(importlib.import_module(home), name, None), "__module__", "")
        if made_in in (home, body.__name__):  # bodies are to be had from the module of scenes
            return home
    return ""


AUTHOR_WORDS = "author", "laws", "misconceptions"
"""The modules of Corollary that authors take words from."""


def _home_of(name: str) -> str:
    """The module that an author takes this name from; "" where none of the usual ones has it."""
    top = Path(__file__).parents[1]
    for word in AUTHOR_WORDS:
        files = [top / f"{word}.py", *sorted((top / word).glob("*.py"))]
        texts = (path.read_text(encoding="utf-8") for path in files if path.is_file())
        if any(
            re.search(rf"^(?:def {name}\(|from \S+ import .*\bas {name}$)", text, re.MULTILINE)
            for text in texts
        ):
            return f"corollary.{word}"
    return "sympy" if name in vars(importlib.import_module("sympy")) else ""


def _remedy(error: BaseException) -> str:
    """What to do about a law that no installed package brings, or a module that is not there."""
    if isinstance(error, ImportError) and error.name == "corollary.laws":
        return (
            '; Corollary has no such law, nor has a package that is installed: write it as law("Name", "a = b"), or install '
            "the package whose entry point corollary.laws brings it (a bank's own: pip install its folder)"
        )
    if isinstance(error, ImportError) and error.name in ("corollary.author", "corollary.scenes"):
        wanted = re.search(r"cannot import name '(\w+)'", str(error))
        if wanted and (home := _in_scenes(wanted[1])):
            return f"; write from {home} import {wanted[1]}"
    if isinstance(error, TypeError) and "truth value of Relational" in str(error):
        return (
            "; Python cannot join or ask conditions with letters: write And(a < b, b < c), Or(…) or Not(…) of sympy in place "
            "of a < b < c, and, or, not, write Max and Min for max and min, and cases(…) for if"
        )
    if isinstance(error, TypeError) and any(each in str(error) for each in OF_NUMBERS):
        return "; math and numpy know numbers only: take sqrt, sin, exp, pi and the like from sympy"
    if isinstance(error, NameError) and error.name and (home := _home_of(error.name)):
        return f"; write from {home} import {error.name} at the top"
    if isinstance(error, TypeError) and "'NoneType' object is not iterable" in str(error):
        return "; an argument that is a list, as mistakes=[…] or routes=[…], is None: leave it out where there is nothing"
    if isinstance(error, TooLong):
        return "; correct the loop that does not end"
    if isinstance(error, ModuleNotFoundError):
        return "; put the module beside the solution, or install the package that has it"
    return ""
