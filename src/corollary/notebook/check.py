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
from corollary.notebook.unbound import text_found, unquoted
from corollary.sandbox.tagged import value_of
from corollary.sandbox.worker.encode import encode

_ = catalogue(__name__)

BARE = re.compile(r"[-+.\d\"'][^=\n#]*")  # a cell that is one value and nothing else
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
        if trouble := self._why_unbound(name, its_type.blank(question)):
            return Preview(False, trouble)
        return its_type.preview(value_of(encode(self._space.get(name))), question)

    def _why_unbound(self, name: str, blank: str) -> str:
        """Why the last text written for an answer gave it no value; what is older is not spoken of. Empty where it did.

        IPython keeps the cells that were run, also those that failed; the last of them is the one that asks.
        """
        history = self._space.get("In")
        cells = (
            [text for text in cast("list[object]", history) if isinstance(text, str)]
            if isinstance(history, list)
            else []
        )
        last = next(
            (
                text
                for text in reversed(cells)
                if re.search(rf"^[ \t]*{name}[ \t]*=(?!=)", text, re.MULTILINE)
            ),
            "",
        )
        if bare := unquoted(name, last, self._space.keys()):
            line = f'{name} = "{bare}"'
            if bare[0] in "+-.,0123456789":
                return _("no answer yet: a number with its unit stands in quotes: {line}", line=line)
            return _("no answer yet: a formula, a letter or a word stands in quotes: {line}", line=line)
        if self._space.get(name) is not None:
            return ""
        for other in self._space:
            if other != name and other.lower() == name.lower() and other not in self._questions:
                return _("no answer yet: {other} is another name than {name}", other=other, name=name)
        written = text_found(last, blank, name)
        if written.startswith(f"{name} =") and "#" in written:
            return _("no answer yet: what stands behind # is not read; write it in place of None")
        before = cells[-2].strip() if len(cells) > 1 else ""
        if BARE.fullmatch(before):
            value = before if before[0] in "\"'" else f'"{before}"'
            return _("no answer yet: a value needs its name: {line}", line=f"{name} = {value}")
        return ""

    @property
    def source(self) -> str:
        """The text of the modules that read answers, one below the other."""
        return "\n\n".join(f"# {name}\n\n{text}" for name, text in self._modules.items())
