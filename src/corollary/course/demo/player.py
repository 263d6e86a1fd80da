"""A student of the demonstration: what they write into their notebook, and the verdicts this deserves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from corollary.answers.evaluation import number
from corollary.answers.option_names import option_named
from corollary.derive.statements import Code, Explain, Plot
from corollary.grading.forces_on_body import as_answered, free_body
from corollary.grading.key import Key, named
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.roster import Student

Sources = dict[str, str]


@dataclass(frozen=True, slots=True)
class Hand:
    """What a student hands in: new sources of cells by their name, and the verdict each part deserves (where not right).

    `raw` replaces the whole file; `late` is in hours.
    """

    sources: Sources
    deserves: Mapping[str, str] = field(default_factory=dict[str, str])
    raw: bytes | None = None
    late: float = 0.0
    nothing: str = ""


@dataclass(frozen=True, slots=True)
class Player:
    student: Student
    plays: str
    hand: Callable[[Worksheet, Mapping[str, Key]], Hand]


def right_sources(
    sheet: Worksheet, keys: Mapping[str, Key], write: Callable[[Prompt, tuple[float, ...]], str] | None = None
) -> Sources:
    """A cell for every part with the right answer, as `write` puts it; programs, figures and texts are the solution's examples."""
    sources: Sources = {}
    for prompt in sheet.prompts:
        key = keys[prompt.problem.code]
        if prompt.part.id in key.truths:
            sources[f"{prompt.key}_answer"] = (
                f"{prompt.name} = {(write or plainly)(prompt, key.truths[prompt.part.id].values)}"
            )
        elif prompt.part.id in key.choices:
            option = option_named(prompt.part, key.choices[prompt.part.id]).strip("()")
            sources[f"{prompt.key}_answer"] = f"{prompt.name} = {option!r}"
        elif prompt.part.id in key.solution.examples:
            sources[f"{prompt.key}_answer"] = f"{prompt.name} = {instance(key, prompt.part.id)!r}"
        elif prompt.part.id in key.solution.forces:
            body = free_body(key.solution.forces[prompt.part.id], key.variant)
            sources[f"{prompt.key}_answer"] = f"{prompt.name} = {as_answered(body, prompt.part)!r}"
        else:
            sources |= _examples(prompt, key)
    return sources


def plainly(prompt: Prompt, values: tuple[float, ...]) -> str:
    """Machine numbers."""
    return repr(list(values)) if prompt.part.components else repr(values[0])


def instance(key: Key, part: str) -> list[float]:
    """One good example of an example part, as numbers."""
    trees = key.solution.examples[part].instance
    assert trees is not None
    known = key.variant.exact | named(key.solution, list(key.values))
    return [number(tree, known) for tree in trees]


def _examples(prompt: Prompt, key: Key) -> Sources:
    """Programs, figures and explanations from the solution."""
    sources: Sources = {}
    numbers = {name: repr(value) for name, value in key.variant.si.items()}
    for entry in key.solution.entries:
        match entry:
            case Code() if entry.statement.part == prompt.part.id:
                sources[f"{prompt.key}_answer"] = f"import numpy as np\n{entry.example.strip()}"
            case Plot() if entry.statement.part == prompt.part.id:
                body = entry.example.strip()
                for name, value in numbers.items():
                    body = body.replace(f"{{{name}}}", value)
                sources[f"{prompt.key}_plot"] = f"import numpy as np\nimport matplotlib.pyplot as plt\n{body}"
            case Explain() if entry.statement.part == prompt.part.id:
                sources[prompt.key] = entry.answer
            case _:
                continue
    return sources
