"""The source of the cell that defines `check`: some twenty lines, with what is asked and the code that reads answers, compressed."""

from __future__ import annotations

import bz2
import json
from base64 import b85encode
from functools import lru_cache
from importlib.metadata import packages_distributions, version
from importlib.resources import files

from corollary.answers.question import Question
from corollary.answers.registry import folder
from corollary.messages import catalogue, spoken
from corollary.notebook.packing import catalogues, modules
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.units.table import rows_of_others
from corollary.version import __version__

_ = catalogue(__name__)

CELL = """\
# {first}
# {second}
def corollary(carried=(
{carried}
)):
    import base64, bz2, json, sys
    if sys.version_info < (3, 11):
        return lambda *names: print({too_old!r})
    carried, loader = json.loads(bz2.decompress(base64.b85decode(carried))), {{"__name__": "corollary_carried"}}
    exec(carried["loader"], loader)
    return loader["checker"](carried, globals())

check = corollary()"""
LINE = (
    9000  # characters; VS Code breaks a line of 10 000 into a hundred lines of the screen, and folds no cell
)


def check_source(sheet: Worksheet) -> str:
    """The cell for one worksheet: it holds what is asked, and nothing of what is right. Raises NotCarried."""
    prompts = [prompt for prompt in sheet.prompts if prompt.answer_types[0].found_in != "cell"]
    return CELL.format(
        first=_(
            'Run this cell first: check("...") then says how an answer is read, never whether it is right.'
        ),
        second=_(
            "No answer is hidden in it, only the code that reads yours when they are marked, compressed; print(check.source) shows it."
        ),
        too_old=_("check needs Python 3.11 or newer; what you write counts all the same"),
        carried=_of_set(tuple(prompts)),
    )


# By identity: everybody's questions are the same, only the numbers are not, and to hash them all takes longer than a notebook.
# What the questions are made of is held, so that its id stays its own.
_OF_SET: dict[tuple[str | int, ...], tuple[list[object], str]] = {}
MOST_SETS = 64


def _of_set(prompts: tuple[Prompt, ...]) -> str:
    made_of = [each for prompt in prompts for each in (prompt.problem, prompt.part)]
    key = (spoken(), *map(id, made_of))
    if key not in _OF_SET:
        if len(_OF_SET) >= MOST_SETS:
            _OF_SET.clear()
        _OF_SET[key] = list(made_of), _carried(spoken(), tuple(prompt.question for prompt in prompts))
    return _OF_SET[key][1]


@lru_cache(maxsize=64)
def _carried(code: str, questions: tuple[Question, ...]) -> str:
    types = tuple(sorted({question.types[0] for question in questions}))
    carried = {
        "loader": files("corollary.notebook").joinpath("carried.py").read_text(encoding="utf-8"),
        "versions": _versions(types),
        "folders": {name: folder(name) for name in types},
        "units": rows_of_others(),
        "questions": [question.as_data() for question in questions],
        "modules": dict(modules(types)),
        "language": code,
        "catalogues": dict(catalogues(modules(types))),
    }
    packed = b85encode(bz2.compress(json.dumps(carried, ensure_ascii=False).encode())).decode()
    return "\n".join(f"    {packed[at : at + LINE]!r}" for at in range(0, len(packed), LINE))


def _versions(types: tuple[str, ...]) -> dict[str, str]:
    """The packages that the code comes from, each with its version."""
    others = {folder(name).partition(".")[0] for name in types} - {"corollary"}
    owners = dict(packages_distributions()) if others else dict[str, list[str]]()
    return {"corollary": __version__} | {
        owner: version(owner) for package in sorted(others) for owner in owners.get(package, [])
    }
