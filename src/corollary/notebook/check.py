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
from corollary.notebook.unbound import binds, text_found, unquoted
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
        self._before: dict[str, object] = {}
        self._stopped: set[str] = set()
        self._cells: dict[
            str, str
        ] = {}  # the cell of each answer, where the notebook names the cells it runs
        self._older: dict[
            str, str
        ] = {}  # what stands now in a cell that gave an answer, and gives it no more
        shell = space.get("get_ipython")
        if callable(shell) and (events := getattr(shell(), "events", None)) is not None:
            events.register("pre_run_cell", self._note_values)
            events.register("post_run_cell", self._note_error)

    def _note_values(self, *_info: object) -> None:
        self._before = {name: self._space.get(name) for name in self._questions}

    def _note_error(self, result: Any) -> None:
        """Notes of each answer whether the last cell that was to give its value stopped before it did, or no longer gives it any;
        the value is then an older one."""
        error = result.error_before_exec or result.error_in_exec
        text, cell = str(result.info.raw_cell), getattr(result.info, "cell_id", None)
        for name in self._questions:
            unchanged = self._space.get(name) is self._before.get(name)
            if _assigns(name, text) or binds(text, name):
                self._stopped.discard(name)
                self._older.pop(name, None)
                if cell:
                    self._cells[name] = cell
                if error is not None and unchanged:
                    self._stopped.add(name)
            elif cell and cell == self._cells.get(name):
                self._stopped.discard(name)
                self._older.pop(name, None)
                if unchanged:
                    self._older[name] = text

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

        IPython keeps the cells that were run, also those that failed; the last of them is the one that asks. A cell that gave the
        answer a value and was changed since is known by its id.
        """
        history = self._space.get("In")
        cells = (
            [text for text in cast("list[object]", history) if isinstance(text, str)]
            if isinstance(history, list)
            else []
        )
        older = self._older.get(name)
        last = (
            next((text for text in reversed(cells) if _assigns(name, text)), "") if older is None else older
        )
        if bare := unquoted(name, last, self._space.keys()):
            line = f'{name} = "{bare}"'
            if bare[0] in "+-.,0123456789":
                return _("no answer yet: write a number with its unit in quotes: {line}", line=line)
            return _("no answer yet: write a formula, a letter or a word in quotes: {line}", line=line)
        if name in self._stopped:
            return _("no answer yet: its cell stopped with an error; correct it and run it again")
        if older is None and self._space.get(name) is not None:
            return ""
        for other in self._space:
            if other != name and other.lower() == name.lower() and other not in self._questions:
                return _("no answer yet: you wrote {other} instead of {name}", other=other, name=name)
        written = text_found(last, blank, name)
        if written.startswith(f"{name} =") and "#" in written:
            return _("no answer yet: text behind # is not read; write your answer in place of None")
        before = (cells[-2] if len(cells) > 1 else "") if older is None else older
        before = before.strip()
        if BARE.fullmatch(before):
            value = before if before[0] in "\"'" else f'"{before}"'
            return _("no answer yet: give the value its name: {line}", line=f"{name} = {value}")
        elsewhere = (
            "" if "check(" in before or before == last.strip() else text_found(before, blank, name, "")
        )
        if older is not None or written or (last and elsewhere):
            return _(
                "no answer yet: its cell gives {name} no value; write {line}", name=name, line=f"{name} = …"
            )
        if cells and not last and name not in self._space:
            return _("no answer yet: run the cell with your answer first")
        return ""

    @property
    def source(self) -> str:
        """The text of the modules that read answers, one below the other."""
        return "\n\n".join(f"# {name}\n\n{text}" for name, text in self._modules.items())


def _assigns(name: str, cell: str) -> bool:
    """True if a line of a cell gives the name a value."""
    return re.search(rf"^[ \t]*{name}[ \t]*=(?!=)", cell, re.MULTILINE) is not None
