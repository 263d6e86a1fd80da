"""`check`, as it runs in a student's notebook: it says how an answer is read, never whether it is right."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from typing import Any, cast

from corollary.answers.answer_type import AnswerType
from corollary.answers.preview import Preview
from corollary.answers.question import Question
from corollary.messages import catalogue, language
from corollary.sandbox.tagged import value_of
from corollary.sandbox.worker.encode import encode

_ = catalogue(__name__)

STAGE = "NBGRADER_EXECUTION"  # nbgrader sets it while it runs a notebook


class Check:
    """`check("X12_5_a")` in the notebook whose names are `space`, in the language `code`; `source` is the text of the code that reads answers."""

    def __init__(
        self,
        types: Mapping[str, AnswerType],
        questions: Iterable[Mapping[str, Any]],
        space: Mapping[str, Any],
        modules: Mapping[str, str],
        code: str = "en",
    ) -> None:
        self._types = types
        self._questions = {data["name"]: Question.from_data(data) for data in questions}
        self._space = space
        self._modules = modules
        self._language = code

    def __call__(self, *names: str) -> None:
        """Says how the answers with these names are read; all answers when no name is given.

        Raises RuntimeError where nbgrader would take silence for full marks, and ValueError where it validates a notebook
        in which an answer cannot be marked as it stands.
        """
        with language(self._language):
            self._say(names or tuple(self._questions))

    def _say(self, names: Iterable[str]) -> None:
        for name in names:
            if name not in self._questions:
                known = ", ".join(self._questions)
                print(
                    _(
                        "{name}: there is no answer of this name; the names are {known}",
                        name=name,
                        known=known,
                    )
                )
                continue
            found = self.preview(name)
            line = f"{name}: {found.text}"
            print(line)
            if os.environ.get(STAGE) == "autograde":
                raise RuntimeError(_("this notebook cannot mark itself; it is marked by `corollary grade`"))
            if os.environ.get(STAGE) == "validate" and not found.ok:
                raise ValueError(line)

    def preview(self, name: str) -> Preview:
        """How one answer is read as it stands in the notebook now."""
        question = self._questions[name]
        its_type = self._types[question.types[0]]
        if its_type.found_in == "function":
            return its_type.preview_function(self._space.get(question.function), question)
        if its_type.found_in == "figure":
            return Preview(True, _("the figure drawn above is what will be marked"))
        if unquoted := _without_quotes(name, self._space.get("In")):
            return Preview(
                False,
                _(
                    "no answer yet: a number with its unit stands in quotes: {line}",
                    line=f'{name} = "{unquoted}"',
                ),
            )
        return its_type.preview(value_of(encode(self._space.get(name))), question)

    @property
    def source(self) -> str:
        """The text of the modules that read answers, one below the other."""
        return "\n\n".join(f"# {name}\n\n{text}" for name, text in self._modules.items())


def _without_quotes(name: str, cells: object) -> str:
    """`8.6 N s` where the last cell with this answer says so, which Python cannot read; IPython keeps the cells."""
    for text in reversed(cast("list[str]", cells) if isinstance(cells, list) else []):
        if re.search(rf"^{name} *=", text, re.MULTILINE):
            found = re.search(rf"^{name} *= *([-+\d.,][^\"'#()\n]*[^\W\d]) *(#.*)?$", text, re.MULTILINE)
            try:
                compile(text, name, "exec")
            except SyntaxError:
                return found[1] if found else ""
            return ""
    return ""
