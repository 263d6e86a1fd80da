"""How a command ends when it cannot do what it was asked: one sentence, a status, and never a traceback."""

from __future__ import annotations

import json
import sys
from typing import Any, NoReturn

HOLDS, FAILS, REFUSED = 0, 1, 2
# What is raised when a request or an author's file is wrong, by the module that defines it.
RAISED = {
    "corollary.api": ["UnknownPart"],
    "corollary.answers.registry": ["UnknownAnswerType"],
    "corollary.notebook.packing": ["NotCarried"],
    "corollary.problem.diagnostic": ["Malformed"],
    "corollary.problem.bank": ["UnknownCode"],
    "corollary.problem.variant": ["OutOfRange"],
    "corollary.derive.load": ["NotDerivable"],
    "corollary.grading.assign": ["NoVariant"],
    "corollary.formula.errors": ["Undefined"],
    "corollary.scenes.run": ["BadSetting"],
    "corollary.records.files": ["NotACourse", "BeingGraded"],
    "corollary.render.exports": ["UnknownTarget"],
    "corollary.course.cluster": ["NoCluster"],
    "corollary.course.grade": ["NotGenerated"],
    "corollary.nbgrader.gradebook": ["NoNbgrader", "GradebookLocked", "NotRegistered"],
    "corollary.nbgrader.config": ["NotOurs"],
    "corollary.sandbox.isolation": ["WeakIsolation"],
    "corollary.sandbox.zygote": ["CannotStart"],
}


class Refusal(Exception):
    """The request itself is wrong; the message says what, and what to do."""


def refuse(sentence: str) -> NoReturn:
    raise Refusal(sentence)


def expected() -> tuple[type[BaseException], ...]:
    """What the lower floors raise when a request or an author's file is wrong; looked up only when something was raised."""
    return (
        Refusal,
        *(
            getattr(sys.modules[module], name)
            for module, names in RAISED.items()
            if module in sys.modules
            for name in names
        ),
    )


def say(sentence: str) -> None:
    """A message for a person, on standard error."""
    print(sentence, file=sys.stderr)


def answer(document: Any) -> None:
    """The one JSON document of a command, on standard output."""
    print(json.dumps(document, ensure_ascii=False, allow_nan=False))
