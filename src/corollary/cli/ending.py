"""The end of a command: its exit status, one sentence for what it cannot do, and questions before something is lost."""

from __future__ import annotations

import importlib
import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from errno import ENOSPC, EROFS
from pathlib import Path
from typing import Any, NoReturn

import click

KNOWN = "banks-used"


def first_use(options: Mapping[str, Any]) -> str:
    """What to say of the banks that are used for the first time and are not the chapter's; nothing where no person reads it."""
    if not sys.stderr.isatty():
        return ""
    from corollary.problem.bank import CHAPTER, VARIABLE, Bank, chapter_bank

    banks = str(options["bank"] or os.environ.get(VARIABLE, "")).split(os.pathsep)
    code = str(options.get("code") or "")
    if not any(banks) and code.endswith(".md"):  # the bank is the folder above its problems/
        banks = [str(above.parent) for above in Path(code).resolve().parents if above.name == "problems"][:1]
    named = {str(Path(bank).resolve()) if Path(bank).is_dir() else bank for bank in banks if bank}
    new = named - {CHAPTER, str(chapter_bank().folder)} - set(known())
    new -= {bank for bank in new if Path(bank).is_dir() and not Bank(Path(bank)).has_programs}
    if not new:
        return ""
    remember(new)
    return (
        f"{', '.join(sorted(new))}: beside its solutions this bank has Python programs, which run as you and may do what you may; "
        "use banks of people you trust (said once for each bank)"
    )


def known() -> list[str]:
    """The banks used before."""
    from corollary import user_cache  # only where banks are used

    return json.loads(user_cache.read(KNOWN, KNOWN) or b"[]")


def remember(banks: set[str]) -> None:
    from corollary import user_cache  # only where banks are used

    user_cache.write(KNOWN, KNOWN, json.dumps(sorted({*known(), *banks})).encode())


# Done; something asked for does not hold; the request is wrong; stopped by ctrl-C (128 and the signal, as shells have it).
HOLDS, FAILS, REFUSED, STOPPED = 0, 1, 2, 130

# What is raised when a request or an author's file is wrong, by the module that defines it.
RAISED = {
    "corollary.api": ["UnknownPart"],
    "corollary.answers.registry": ["UnknownAnswerType"],
    "corollary.plug_ins": ["PlugInFault"],
    "corollary.notebook.packing": ["NotCarried"],
    "corollary.problem.diagnostic": ["Malformed"],
    "corollary.problem.bank": ["UnknownCode"],
    "corollary.problem.variant": ["OutOfRange"],
    "corollary.derive.load": ["NotDerivable"],
    "corollary.grading.assign": ["NoVariant"],
    "corollary.formula.errors": ["Undefined"],
    "corollary.scenes.run": ["BadSetting"],
    "corollary.records.files": ["NotACourse", "BeingGraded", "UnknownStudent"],
    "corollary.records.marks": ["NothingGraded"],
    "corollary.records.editions": ["NotSettled"],
    "corollary.render.exports": ["UnknownTarget"],
    "corollary.render.paper.typst": ["CannotTypeset"],
    "corollary.parallel": ["NoCluster"],
    "corollary.course.grade": ["NotGenerated"],
    "corollary.course.lms_places": ["NoPlaces"],
    "corollary.course.release": ["NoSheets"],
    "corollary.course.sharing": ["NotShareable"],
    "corollary.course.renew": ["OneFolder"],
    "corollary.nbgrader.gradebook": ["NoNbgrader", "GradebookLocked", "GradebookUnusable", "NotRegistered"],
    "corollary.nbgrader.hand_marking": ["NotMarkable"],
    "corollary.nbgrader.config": ["NotOurs", "BrokenConfig"],
    "corollary.sandbox.isolation": ["WeakIsolation"],
    "corollary.sandbox.zygote": ["CannotStart"],
}


class Refusal(Exception):
    """The request itself is wrong; the message says what, and what to do."""


def refuse(sentence: str) -> NoReturn:
    raise Refusal(sentence)


def run(
    module: str, prepared: Callable[[dict[str, Any]], dict[str, Any]] = dict[str, Any], **options: object
) -> None:
    """The command of that module, imported only now; its status, one sentence on a failing, no traceback. `prepared` gives
    the options with those that were left out."""
    options = {name: _listed(value) for name, value in options.items()}
    try:
        options = prepared(options)
        banks: Any = options.get("bank")
        if isinstance(options.get("bank"), list):  # several banks are one, parted as in PATH
            options["bank"] = Path(os.pathsep.join(map(str, banks))) if banks else None
        if "bank" in options and (sentence := _first_use(options)):
            say(sentence)
        status = importlib.import_module(f"corollary.cli.{module}").run(**options)
        sys.stdout.flush()
    except KeyboardInterrupt:
        say("stopped")
        status = STOPPED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = FAILS
    except Exception as error:
        if not isinstance(error, expected()):
            status = _unforeseen(error)
        else:
            say(f"corollary: {error}")
            status = REFUSED
    if status:
        raise click.exceptions.Exit(status)


def _first_use(options: dict[str, Any]) -> str:

    return first_use(options)


def _listed(value: Any) -> Any:
    """What may be repeated comes as a tuple, and goes on as a list."""
    several = value
    return list(several) if isinstance(value, tuple) else value


def expected() -> tuple[type[BaseException], ...]:
    """The exceptions of RAISED as far as their modules are loaded: what is not loaded has raised nothing."""
    return (
        Refusal,
        *(
            getattr(sys.modules[module], name)
            for module, names in RAISED.items()
            if module in sys.modules
            for name in names
        ),
    )


REMEDIES = {
    ENOSPC: "; free disk space and run this again; what is written so far is valid",
    EROFS: "; this disk cannot be written to: copy the course to another one, or mount this one for writing",
}


def _unforeseen(error: Exception) -> int:
    """A fault of ours, or of the machine: one sentence, and the traceback only when asked for."""
    sentence = unforeseen(error)
    if isinstance(error, OSError):
        remedy = REMEDIES.get(error.errno or 0, "")
        say(f"corollary: {error.strerror or error}{f': {error.filename}' if error.filename else ''}{remedy}")
        return REFUSED
    say(f"corollary: {sentence}")
    return FAILS


def unforeseen(error: Exception) -> str:
    """What is said of a fault of ours; with COROLLARY_DEBUG it is raised instead."""
    if os.environ.get("COROLLARY_DEBUG"):
        raise error
    return (
        f"internal error: {type(error).__name__}: {error} (COROLLARY_DEBUG=1 shows where; please report it)"
    )


def say(sentence: str) -> None:
    """A message for a person, on standard error."""
    from corollary.messages import visible  # only now: --help loads nothing but the command line

    print(visible(sentence), file=sys.stderr)


MOST_LISTED = 10  # lines, or names in a line; the rest is counted


def say_each(sentences: Iterable[str], rest: str = "") -> None:
    """The first messages of one kind, and how many more there are; `rest` says where these are."""
    several = list(sentences)
    for each in several[:MOST_LISTED]:
        say(each)
    if len(several) > MOST_LISTED:
        say(f"and {len(several) - MOST_LISTED} more{f'; {rest}' if rest else ''}")


def counted(count: int, what: str) -> str:
    """`1 problem`, `2 problems`."""
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def answer(document: Any) -> None:
    """The one JSON document of a command, on standard output."""
    text = json.dumps(document, ensure_ascii=False, allow_nan=False)
    try:
        text.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:  # a terminal without these letters, or a file name that is not UTF-8
        text = json.dumps(document, allow_nan=False)
    print(text)


def agreed(question: str, yes: bool) -> bool:
    """Whether to go on. Without a terminal and without `yes` it is no, and what to do is said."""
    if yes:
        return True
    if not (sys.stdin.isatty() and sys.stderr.isatty()):
        say(f"{question} Nothing is changed; --yes agrees")
        return False
    return click.confirm(question, default=False, err=True)
