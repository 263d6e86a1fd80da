"""`corollary new`: a problem and its solution that verify as written, to be bent into one's own."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

from corollary.cli.ending import HOLDS, answer, refuse
from corollary.derive.load import sources
from corollary.messages import LOCALE
from corollary.problem.bank import (
    VARIABLE,
    Bank,
    UnknownCode,
    chapter_bank,
    chapter_order,
    codes,
    find,
    open_bank,
)
from corollary.problem.packed_pictures import pictures_of
from corollary.problem.problem import Problem
from corollary.problem.reader import CODE

FIRST = Path(__file__).parent / "first_problem"
NAME = re.compile(r"(?:([A-Za-z0-9][\w-]*)/)?([A-Za-z]\w*)$", re.ASCII)
NO_TOPIC = "exercises"


def run(code: str, name: str, like: str | None, translate: bool, bank: Path | None, as_json: bool) -> int:
    if translate:
        return _translate(code, name, bank, as_json)
    place = _place(bank)
    problem, solution = create(place, code, name, like)
    if as_json:
        answer({"code": code, "problem": str(problem), "solution": str(solution)})
        return HOLDS
    printed = re.search(r"printed[(:]", solution.read_text(encoding="utf-8")) if like else None
    _say_what_next(code, place, problem, solution, like if printed else None)
    return HOLDS


def create(place: Bank, code: str, name: str, like: str | None = None) -> tuple[Path, Path]:
    """Write the files of a new problem and return their paths. Raises Refusal where nothing can be written."""
    if not CODE.match(code):
        refuse(
            f"{code} is not a valid code; use letters and digits, separated by points, such as Q1 or X12.5"
        )
    if (words := NAME.match(name)) is None:
        refuse(
            f"{name} is not a valid file name; use letters, digits and _, such as sliding_box, or topic/sliding_box"
        )
    topic, stem = words.groups()
    have = codes(place)
    for path, other in have.items():
        if other.lower() == code.lower():
            refuse(f"{path} has the code {other} already; choose another (nothing was written)")
    model = None if like is None else _model(place, like)
    folder = topic or (model[1].topic if model else _topic(have, code))
    problem = place.problems / folder / f"{stem}.md"
    solution = place.solution_beside(problem)
    if model:
        solution = solution.with_suffix(model[0].solution(model[1]).suffix)
    namesakes = [path for path in have if path.stem == stem]
    for path in (*namesakes, solution, *([solution.with_suffix("")] if model else [])):
        if path.exists():
            refuse(f"{path} exists already; choose another name (nothing was written)")
    copies = _pictures(model[1].path, problem) | _beside(*model, solution) if model else {}
    asks, derives = _texts(code, stem.replace("_", " ").capitalize(), stem, model)
    for path, text in ((problem, asks), (solution, derives)):
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("x", encoding="utf-8") as file:
            file.write(text)
    for theirs, ours in copies.items():
        ours.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(theirs, ours)
    if model and (beside := model[0].solution(model[1]).with_suffix("")).is_dir():
        shutil.copytree(beside, solution.with_suffix(""), ignore=shutil.ignore_patterns("__pycache__"))
    return problem, solution


def _translate(code: str, spoken: str, bank: Path | None, as_json: bool) -> int:
    """Writes the file of a translation, with every text that is to be translated."""
    from corollary.derive.cache import solution_of  # only here: a new problem needs none of them
    from corollary.problem.translation import to_translate, untranslated
    from corollary.verify.words.check_words import named_in, texts_of

    if not re.fullmatch(r"[a-z]{2,3}", spoken):
        refuse(
            f"{spoken} is not a language; write its code of two letters, such as: corollary new --translate {code} de"
        )
    place = open_bank(bank)
    problem = find(place, code)
    path = problem.path.with_suffix(f".{spoken}.md")
    if path.exists():
        refuse(f"{path} is there already; corollary verify {code} names what it lacks, nothing was written")
    found = [text for text in texts_of(solution_of(place, problem)) if not named_in(spoken, text)]
    texts = list(dict.fromkeys([*to_translate(problem), *found]))
    with path.open("x", encoding="utf-8") as file:
        file.write(untranslated(problem, texts))
    if as_json:
        answer({"code": code, "language": spoken, "translation": str(path), "texts": len(texts)})
        return HOLDS
    print(
        f"written: {_short(path)}  title, question and {len(texts)} more texts to translate, each in its place"
    )
    print(
        f"corollary verify {code} names what is left, corollary preview {code} --language {spoken} shows it."
    )
    return HOLDS


def _place(bank: Path | None) -> Bank:
    """The bank to write into: the one that is named, made when it is not there, or the working folder."""
    named = str(bank or os.environ.get(VARIABLE, ""))
    if os.pathsep in named:
        refuse("a problem goes into one bank; name it with --bank")
    if not named and not (Path.cwd() / "problems").is_dir():
        refuse(
            "the working folder is not a bank: it has no folder problems/; say with --bank FOLDER where the problem goes "
            "(a missing folder is made)"
        )
    folder = Path(named) if named else Path.cwd()
    if folder.is_file():
        refuse(f"{folder} is a file; a bank is a folder")
    try:
        return open_bank(folder)
    except UnknownCode:
        return Bank(folder.resolve())


def _model(place: Bank, like: str) -> tuple[Bank, Problem]:
    """The problem to copy and its bank: this bank, or the chapter's."""
    try:
        return place, find(place, like)
    except UnknownCode:
        chapter = chapter_bank()
        return chapter, find(chapter, like)


def _pictures(model: Path, problem: Path) -> dict[Path, Path]:
    """The pictures that the model shows, and where they are to lie beside the copy; those that lie there already are left out."""
    return _missing(
        {each: problem.parent / each.relative_to(model.parent) for each in pictures_of(model)}, "picture"
    )


def _beside(bank: Bank, model: Problem, solution: Path) -> dict[Path, Path]:
    """The files beside the model's solution that it imports, and the translations of what its judges say, in the same way; those of
    its own folder are copied with that."""
    theirs, texts = bank.solution(model), sources(bank, model)
    wanted = {
        each: solution.with_suffix(".py")
        if each == theirs.with_suffix(".py")
        else solution.parent / each.relative_to(theirs.parent)
        for each in texts
        if each != theirs and each.parent == theirs.parent
    }
    translations, ours = theirs.parents[1] / LOCALE, solution.parents[1] / LOCALE
    if not ours.exists() and any(b"catalogue(" in text for text in texts.values()):
        wanted |= {each: ours / each.relative_to(translations) for each in translations.rglob("*.*")}
    return _missing(wanted, "file")


def _missing(wanted: dict[Path, Path], what: str) -> dict[Path, Path]:
    """Those that are not there yet; refuses where another one is."""
    for theirs, ours in wanted.items():
        if ours.exists() and ours.read_bytes() != theirs.read_bytes():
            refuse(f"{ours} exists already as another {what}; rename it (nothing was written)")
    return {theirs: ours for theirs, ours in wanted.items() if not ours.exists()}


def _topic(have: dict[Path, str], code: str) -> str:
    """The topic of the problem whose code comes next before this one, or of the first one."""
    in_order = sorted(have, key=lambda path: chapter_order(have[path]))
    before = [path for path in in_order if chapter_order(have[path]) <= chapter_order(code)]
    return before[-1].parent.name if before else in_order[0].parent.name if in_order else NO_TOPIC


def _texts(code: str, title: str, stem: str, model: tuple[Bank, Problem] | None) -> tuple[str, str]:
    """What the two files hold."""
    if model is None:
        asks, derives = ((FIRST / name).read_text(encoding="utf-8") for name in ("problem.md", "solution.md"))
        return asks.replace("CODE", code, 1).replace("TITLE", title, 1), derives.replace("TITLE", title, 1)
    bank, problem = model
    asks = problem.path.read_text(encoding="utf-8")
    for line, text in (("code", code), ("title", title), ("source", f"after {problem.code}")):
        asks = re.sub(rf"^{line}:.*$", f"{line}: {text}", asks, count=1, flags=re.MULTILINE)
    derives = next(iter(sources(bank, problem).values())).decode()  # its own text
    return asks, re.sub(rf'(["`]){problem.path.stem}/', rf"\1{stem}/", derives)  # its programs' folder


def _say_what_next(code: str, place: Bank, problem: Path, solution: Path, printed: str | None) -> None:
    here = chapter_bank().folder == place.folder
    option = "" if here or os.environ.get(VARIABLE) else f" --bank {_short(place.folder)}"
    print(f"written: {_short(problem)}  what is asked")
    print(f"         {_short(solution)}  what is true")
    print("Both verify as they are. Change a little, save, look, and so on:")
    print(f"  corollary preview {code}{option}")
    print(f"  corollary verify --watch {code}{option}")
    if option:
        print(f"To leave out --bank from now on: export {VARIABLE}={place.folder}")
    if printed:
        print(f"Its lines printed are what the chapter prints for {printed}: drop them.")


def _short(path: Path) -> Path:
    """As somebody in the working folder would type it."""
    return path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
