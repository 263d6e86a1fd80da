"""A bank: one or several folders with `problems/` and `solutions/`, and how a problem is found in it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.messages import did_you_mean
from corollary.plug_ins import fault, plug_ins
from corollary.plug_ins import load as load_plug_in
from corollary.problem.diagnostic import Diagnostic, Malformed

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

    from corollary.problem.problem import Problem

MOST_LOOKED_AT = 200
GROUP, VARIABLE, CHAPTER = "corollary.banks", "COROLLARY_BANK", "chapter"
CODE_LINE = re.compile(r"""^code:[ \t]*["']?([\w.]+)["']?[ \t]*(?:#.*)?$""", re.MULTILINE)


class UnknownCode(LookupError):
    """Nothing in the bank has this name; one sentence says what has."""


@dataclass(frozen=True, slots=True)
class Bank:
    """`folder` has the problems; where several banks are used as one, `more` are the folders of the others."""

    folder: Path
    more: tuple[Path, ...] = ()

    @property
    def problems(self) -> Path:
        return self.folder / "problems"

    @property
    def each(self) -> tuple[Bank, ...]:
        """The banks it is made of, each with one folder."""
        return tuple(Bank(folder) for folder in (self.folder, *self.more))

    @property
    def sets(self) -> Path:
        return self.problems / "sets"

    @property
    def scenes(self) -> Path:
        """Where ready-made scenes lie."""
        return self.folder / "solutions" / "scenes"

    @property
    def has_programs(self) -> bool:
        """Whether any of its solutions, or anything beside them, is a program rather than a text."""
        return any(next(bank.folder.joinpath("solutions").rglob("*.py"), None) for bank in self.each)

    @property
    def place(self) -> str:
        """What `open_bank` opens it by."""
        return os.pathsep.join(str(bank.folder.resolve()) for bank in self.each)

    def __getitem__(self, code: str) -> Problem:
        """The problem with this code, or this file name. Raises UnknownCode or Malformed."""
        return find(self, code)

    def __iter__(self) -> Iterator[Problem]:
        """Every problem, in the order of the chapter. Raises Malformed."""
        return iter(load(self))

    def __len__(self) -> int:
        return len(files(self))

    def solution(self, problem: Problem) -> Path:
        """Where the solution of a problem must lie: the same path, the same name, under solutions/."""
        return self.solution_beside(problem.path)

    def solution_beside(self, path: Path) -> Path:
        """Where the solution of the problem in a file lies, or must lie: a text, or else a program of that name. A set may take
        problems of other banks than this."""
        home = self.home_of(path)
        text = home.folder / "solutions" / path.relative_to(home.problems)
        program = text.with_suffix(".py")
        return program if program.is_file() and not text.is_file() else text

    def home_of(self, path: Path) -> Bank:
        """The one bank in which the file of a problem lies. Raises UnknownCode."""
        home = next((bank for bank in self.each if bank.problems in path.parents), None)
        if home is None:  # not `or`: a bank's truth is that of its length, for which every file is looked for
            home = _bank_above(path)
        return home


def chapter_bank() -> Bank:
    """The chapter's bank: inside an installed package, or at the top of a checkout."""
    package = Path(__file__).resolve().parent.parent
    for folder in (package / "bank", package.parent.parent):
        if (folder / "problems").is_dir() and (folder / "solutions").is_dir():
            return Bank(folder)
    raise UnknownCode(
        f"the chapter's bank is missing beside {package}; install Corollary anew, from its folder, or name a bank with --bank DIR"
    )


def open_bank(place: Path | None) -> Bank:
    """The bank in a folder, or that of an installed package; several, parted as in PATH, are one bank.

    When nothing is named, what COROLLARY_BANK names, or the chapter's. Raises UnknownCode for what is no bank.
    """
    names = str(place or os.environ.get(VARIABLE, "")).split(os.pathsep)
    folders = [_folder(name) for name in names if name] or [chapter_bank().folder]
    first, *more = dict.fromkeys(folders)
    return Bank(first, tuple(more))


def _folder(name: str) -> Path:
    """A folder, `chapter`, or the folder of a package that is installed: its entry point in `corollary.banks` has this name."""
    folder = Path(name)
    if name == CHAPTER or folder == chapter_bank().folder:
        return chapter_bank().folder
    installed = plug_ins(GROUP, (CHAPTER,))
    if (folder / "problems").is_dir():
        for entry in installed.values():
            if folder.resolve() in _folders_of(entry):
                load_plug_in(entry, "the bank")  # it may bring units: also when it is named by its folder
        return folder.resolve()
    if name in installed:
        for package in _folders_of(installed[name]):
            if (package / "problems").is_dir():
                load_plug_in(installed[name], "the bank")
                return package
        raise fault(installed[name], "the bank", "it has no folder problems/")
    if folder.is_dir():
        raise UnknownCode(f"{folder} is not a bank: it has no folder problems/")
    have = ", ".join([CHAPTER, *sorted(installed)])
    raise UnknownCode(
        f"{folder} is not a bank: it has no folder problems/, and the banks installed are {have}"
    )


def installed_bank(folder: Path) -> str:
    """The name by which an installed package has the bank in this folder, or `chapter`; empty where it is in none."""
    if folder.resolve() == chapter_bank().folder.resolve():
        return CHAPTER
    found = plug_ins(GROUP, (CHAPTER,)).items()
    return next((name for name, entry in found if folder.resolve() in _folders_of(entry)), "")


def _folders_of(entry: EntryPoint) -> list[Path]:
    """Where a package lies; nowhere, when what an entry point names is not there."""
    try:
        spec = find_spec(entry.module)
    except ModuleNotFoundError:
        return []
    except Exception as error:  # finding a package inside another runs the outer one
        raise fault(entry, "the bank", f"{type(error).__name__}: {error}") from error
    places = (spec.submodule_search_locations or ()) if spec is not None else ()
    return [Path(place).resolve() for place in places]


def files(bank: Bank) -> list[Path]:
    """Every problem file, by bank, topic and name."""
    return [
        path
        for each in bank.each
        for path in sorted(each.problems.rglob("*.md"))
        if each.sets not in path.parents and not _is_translation(path)
    ]


def _is_translation(path: Path) -> bool:
    """Whether a file is another one in a language, as `kicking_a_ball.de.md` is `kicking_a_ball.md` in German."""
    original, _, language = path.stem.rpartition(".")
    return re.fullmatch("[a-z]{2,3}", language) is not None and path.with_name(f"{original}.md").is_file()


def load(bank: Bank) -> list[Problem]:
    """Every problem, in the order of the chapter. Raises Malformed with the complaints of every file, or for one code used twice."""
    problems, complaints = readable(bank)
    if complaints:
        raise Malformed(complaints)
    return sorted(problems, key=lambda problem: chapter_order(problem.code))


def readable(bank: Bank) -> tuple[list[Problem], list[Diagnostic]]:
    """The problems that can be read, in the order of their files, and what is wrong with the others and with codes used twice."""
    problems: list[Problem] = []
    complaints: list[Diagnostic] = []
    for path in files(bank):
        try:
            problems.append(_read(path))
        except Malformed as error:
            complaints += error.complaints
    return problems, [*complaints, *doubles(problems)]


def _read(path: Path) -> Problem:
    # Only here: it loads formulas and YAML, and a list that is cached needs neither.
    from corollary.problem.reader import read_problem

    return read_problem(path)


def doubles(problems: list[Problem]) -> list[Diagnostic]:
    """One complaint for each problem whose code or name another has already: neither would be found."""
    complaints: list[Diagnostic] = []
    codes: dict[str, Problem] = {}
    names: dict[str, Problem] = {}
    for problem in problems:
        if (other := codes.setdefault(problem.code.lower(), problem)) is not problem:
            complaints.append(
                Diagnostic(
                    problem.path,
                    2,
                    f"{other.path.name} has the code {problem.code} already; change one of them",
                )
            )
        if (other := names.setdefault(problem.name, problem)) is not problem:
            complaints.append(
                Diagnostic(
                    problem.path,
                    1,
                    f"there is another {problem.path.name} in {other.topic}/; rename one of them",
                )
            )
    return complaints


def chapter_order(code: str) -> tuple[int, list[int], str]:
    """Sections first, then examples, exercises and projects, each by number."""
    head, numbers = code[:1], "".join(letter if letter.isdigit() else " " for letter in code[1:]).split()
    return ("STEXP".find(head) % 9, [int(number) for number in numbers], code)


def find(bank: Bank, code: str) -> Problem:
    """The problem named by its code, its file's name, or a path to a .md file. Raises UnknownCode or Malformed."""
    return _read(locate(bank, code))


def locate(bank: Bank, code: str) -> Path:
    """The file of the problem named so, whatever is in it. Raises UnknownCode."""
    if code.endswith(".md"):
        path = Path(code).resolve()
        if not path.is_file():
            raise UnknownCode(f"there is no file {code}")
        if not any(each.problems.resolve() in path.parents for each in bank.each):
            places = ", ".join(str(each.problems) for each in bank.each)
            raise UnknownCode(f"{code} is not in {places}; name its bank with --bank, or leave --bank out")
        return path
    for path in files(bank):
        if path.stem == code:
            return path
    for path, its in codes(bank).items():
        if its.lower() == code.lower():
            return path
    hint = did_you_mean(code, names(bank))
    raise UnknownCode(
        f"no problem is called {code or 'by an empty name'}{hint}; `corollary list` shows the codes"
    )


def names(bank: Bank) -> list[str]:
    """The code and the file's name of every problem, at a glance."""
    found = codes(bank)
    return [name for name in (*found.values(), *(path.stem for path in found)) if name]


def codes(bank: Bank) -> dict[Path, str]:
    """Every problem file and the code that it gives itself, at a glance."""
    return {path: _code_at_a_glance(path) for path in files(bank)}


def _code_at_a_glance(path: Path) -> str:
    """The code a file gives itself, without reading all of it."""
    found = (
        CODE_LINE.search(path.read_text(encoding="utf-8", errors="replace")[:2000])
        if path.is_file()
        else None
    )
    return found[1] if found else ""


def home(folder: Path | None, code: str) -> tuple[Bank, Problem]:
    """A problem and the bank it lives in: for a path to a .md file, the folder above its problems/.

    Raises UnknownCode or Malformed.
    """
    bank, path = home_of_file(folder, code)
    return bank, _read(path)


def home_of_file(folder: Path | None, code: str) -> tuple[Bank, Path]:
    """The same for a problem's file, whatever is in it. Raises UnknownCode."""
    if code.endswith(".md") and folder is None:
        path = Path(code).resolve()
        above = next((parent for parent in path.parents if parent.name == "problems"), None)
        if path.is_file() and above is None:
            raise UnknownCode(
                f"{code} is in no bank: problems are below a folder problems/, solutions below solutions/"
            )
        if above is not None:
            return Bank(above.parent), locate(Bank(above.parent), str(path))
    bank = open_bank(folder)
    return bank, locate(bank, code)


def bank_of(problem: Problem) -> Bank:
    """The bank a problem was read from: the folder above its problems/, beside which its solutions/ lie. Raises UnknownCode."""
    return _bank_above(problem.path)


def bank_around(name: str) -> Bank | None:
    """The bank that a set's file lies in; None for a set's name, and for a file in no bank. Raises UnknownCode."""
    above = Path(name).resolve().parents if name.endswith(".md") else ()
    folders = (each.parent for each in above if each.name == "problems")
    found = next((folder for folder in folders if (folder / "solutions").is_dir()), None)
    return None if found is None else open_bank(found)


def banks_below(place: Path) -> list[Bank]:
    """The banks that lie one or two folders below a place, of which the first so many are looked at."""
    found = {
        each.parent.resolve()
        for pattern in ("*/problems", "*/*/problems")
        for each in islice(place.glob(pattern), MOST_LOOKED_AT)
    }
    return [Bank(folder) for folder in sorted(found) if (folder / "solutions").is_dir()]


def _bank_above(path: Path) -> Bank:
    above = [parent.parent for parent in path.parents if parent.name == "problems"]
    if not above:
        raise UnknownCode(f"{path} is in no bank: it is not below a folder problems/")
    return Bank(next((folder for folder in above if (folder / "solutions").is_dir()), above[0]))
