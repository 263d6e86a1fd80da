"""The settings of a course: what its file `corollary.toml` says, so that no option has to be typed each time."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

from corollary.atomic import write_whole
from corollary.messages import did_you_mean, languages
from corollary.problem.dates import REVEAL, machine_zone, zone_named
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.front_matter import Reader, TableNode, TextNode
from corollary.problem.late_penalty import LateSteps, read_late_steps
from corollary.problem.packages import fault, module_named
from corollary.problem.problem_set import Usual
from corollary.records.term_rules import TermRules, term_complaint, term_rules

FILE = "corollary.toml"
TEXT = """\
# The settings of this course. A line behind # says what holds when it is left out; an option on the command line wins.

# Dates without a zone are in this one, and students read its name.
{timezone}

# The bank that sets are generated from: a folder (seen from here), or the name of an installed bank.
# bank = "chapter"

# When feedback may give right values and worked solutions, in sets that say nothing themselves:
# "no", "after due" (each student after the own deadline), "after extensions" (nobody before the last deadline),
# or "by hand" (after corollary grade SET --reveal).
# reveal = "no"

# Late work, in sets that say nothing themselves: a grace period, what each calendar day takes, and the last day that counts.
# late = {{grace = "12 hours", daily = "10 %", least = "50 %", last = "7 days"}}

# Grading: the lowest isolation level to run notebooks at (0 to 3), how many to mark side by side (as many as there are
# cores when left out), or the Dask cluster to mark on.
# isolation = 1
# jobs = 2
# executor = "tcp://HOST:PORT"

# Where formgrader is, for the links of the report.
# formgrader = "http://localhost:8888/formgrader"

# The packages that students may import, besides numpy, scipy, matplotlib and sympy.
# packages = ["pandas"]

# The language of what students read.
# language = "en"

# The term as a whole (corollary term): weights of sets, how many of the worst are left out, and who falls behind.
# term = {{weights = {{project = 3}}, drop = 1, missing = 2, below = 50}}
"""


@dataclass(frozen=True, slots=True)
class Settings:
    """What a course's file says; `None` and empty: it says nothing. `bank` is what `open_bank` opens."""

    timezone: str = ""
    bank: str = ""
    reveal: str = ""
    isolation: int | None = None
    jobs: int | None = None
    executor: str = ""
    formgrader: str = ""
    language: str = ""
    late: LateSteps | None = None
    term: TermRules = field(default_factory=TermRules)
    packages: tuple[str, ...] | None = None

    @property
    def usual(self) -> Usual:
        """What holds for its sets."""
        zone = zone_named(self.timezone) if self.timezone else None
        return Usual(zone or machine_zone(), REVEAL[self.reveal or "no"], self.late, self.packages)


def read_settings(folder: Path) -> Settings:
    """The settings of the course in a folder; all usual where there is no file. Raises Malformed."""
    path, text = folder / FILE, ""
    try:
        text = path.read_text(encoding="utf-8-sig")
        table = tomllib.loads(text)
    except FileNotFoundError:
        return Settings()
    except (OSError, UnicodeDecodeError) as error:
        raise Malformed([Diagnostic(path, 1, f"cannot be read: {error}")]) from None
    except tomllib.TOMLDecodeError as error:
        at = re.search(r"at line (\d+)", str(error))
        line = int(at[1]) if at else max(1, text.count("\n"))
        sentence = f'is not TOML: {error}; a line is a name, = and a value, such as timezone = "Europe/Oslo"'
        raise Malformed([Diagnostic(path, line, sentence)]) from None
    complaints = [
        Diagnostic(path, _line(text, name), sentence)
        for name, value in table.items()
        if (sentence := _complaint(name, value))
    ]
    if complaints:
        raise Malformed(complaints)
    late = table.pop("late", None)
    steps = None if late is None else _late_steps(path, late, _line(text, "late"))
    rules = term_rules(table.pop("term", {}))
    return Settings(**_with_bank(folder, table), late=steps, term=rules)


def _late_steps(path: Path, table: Mapping[str, object], line: int) -> LateSteps:
    """Raises Malformed."""
    complaints: list[Diagnostic] = []
    node = TableNode({name: TextNode(str(value), line) for name, value in table.items()}, line)
    front = Reader(path, node, "the settings", complaints)
    found = read_late_steps(front, node, None, 1.0)
    if complaints:
        raise Malformed(complaints)
    return found


def write_settings(folder: Path) -> None:
    """Writes the file once, with the machine's time zone in it: from then on the dates are the same on every machine."""
    path = folder / FILE
    if not path.exists():
        zone = machine_zone()
        line = f'timezone = "{zone.key}"' if zone else '# timezone = "Europe/Oslo"'
        write_whole(path, TEXT.format(timezone=line))


def write_language(folder: Path, code: str) -> None:
    """Writes the language of what students read into the course's file, in place of the one it had. Raises Malformed."""
    if (read_settings(folder).language or "en") == code:
        return
    path = folder / FILE
    text, line = path.read_text(encoding="utf-8-sig"), f'language = "{code}"'
    found, count = re.subn(r"(?m)^[ \t]*(?:# )?language[ \t]*=.*$", line, text, count=1)
    # At the top: below the last line it would belong to a table such as [term].
    write_whole(path, found if count else f"{line}\n\n{text}")


def _with_bank(folder: Path, table: Mapping[str, Any]) -> dict[str, Any]:
    bank = str(table.get("bank", ""))
    there = (folder / bank).resolve()
    packages = {"packages": tuple(map(module_named, table["packages"]))} if "packages" in table else {}
    return {**table, "bank": str(there) if bank and there.is_dir() else bank, **packages}


def _line(text: str, name: str) -> int:
    """The line on which a name stands; tomllib does not say."""
    pattern = re.compile(rf"""\[?\s*["']?{re.escape(name)}["']?\s*[=.\]]""")
    lines = enumerate(text.splitlines(), start=1)
    return next((number for number, line in lines if pattern.match(line.strip())), 1)


def _complaint(name: str, value: object) -> str:
    """What is wrong with a setting, and what to write; empty when nothing is."""
    if name not in CHECKS:
        known = ", ".join(CHECKS)
        return f"`{name}` is not known{did_you_mean(name, CHECKS)}; known are {known}"
    return CHECKS[name](value)


def _timezone(value: object) -> str:
    if isinstance(value, str) and zone_named(value):
        return ""
    from zoneinfo import available_timezones

    names = {each.rpartition("/")[2]: each for each in sorted(available_timezones())}
    guess = names.get(str(value).replace(" ", "_"))
    hint = f" (did you mean {guess}?)" if guess else did_you_mean(str(value), available_timezones())
    return f'timezone: {value} is no time zone{hint}; write it as "Europe/Oslo" or "UTC"'


def _bank(value: object) -> str:
    return "" if isinstance(value, str) and value else 'bank: give the name of a folder, as "../bank"'


def _reveal(value: object) -> str:
    return "" if value in REVEAL else f"reveal: {value}: say one of {', '.join(REVEAL)}, in quotes"


def _isolation(value: object) -> str:
    return (
        "" if value in (0, 1, 2, 3) and type(value) is int else f"isolation: {value}: say a level from 0 to 3"
    )


def _jobs(value: object) -> str:
    right = type(value) is int and value >= 1
    return "" if right else f"jobs: {value}: say how many to mark side by side, 1 or more"


def _executor(value: object) -> str:
    right = isinstance(value, str) and "://" in value
    return "" if right else f'executor: {value}: give the address of a Dask scheduler, as "tcp://HOST:8786"'


def _formgrader(value: object) -> str:
    right = isinstance(value, str) and value.startswith(("http://", "https://"))
    return "" if right else f'formgrader: {value}: give its address, as "http://localhost:8888/formgrader"'


def _language(value: object) -> str:
    have = languages()
    return "" if value in have else f"language: {value}: the texts are there in {', '.join(have)}"


def _late(value: object) -> str:
    right = isinstance(value, dict)
    return "" if right else f'late: {value}: give a table, as late = {{daily = "10 %", last = "7 days"}}'


def _packages(value: object) -> str:
    if not isinstance(value, list):
        return 'packages: give a list of names, as ["pandas"], or [] for none but the usual ones'
    return next((complaint for each in cast("list[object]", value) if (complaint := fault(each))), "")


CHECKS: dict[str, Callable[[object], str]] = {
    "timezone": _timezone,
    "bank": _bank,
    "reveal": _reveal,
    "isolation": _isolation,
    "jobs": _jobs,
    "executor": _executor,
    "formgrader": _formgrader,
    "language": _language,
    "late": _late,
    "term": term_complaint,
    "packages": _packages,
}
