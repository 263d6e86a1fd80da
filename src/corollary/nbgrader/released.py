"""A set released through nbgrader's exchange, by nbgrader's own command in this process."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

from contextlib import redirect_stderr
from io import StringIO

from corollary.nbgrader.gradebook import directory, need_nbgrader, programs_on_path
from corollary.records.files import Course


def release_in_exchange(course: Course, name: str, force: bool) -> str:
    """Releases; what stands in the way is said in a sentence, empty when nothing does. Raises NoNbgrader, BrokenConfig."""
    need_nbgrader()
    from nbgrader.apps import NbGraderAPI
    from nbgrader.exchange import ExchangeFactory

    from corollary.nbgrader.exchange import INSTEAD, ReleaseOwnSheets

    place = directory(course)
    config = place.config
    theirs = ExchangeFactory(config=config).release_assignment
    if not issubclass(theirs, ReleaseOwnSheets):
        return (
            f"{theirs.__module__}.{theirs.__name__}, which nbgrader_config.py names, gives everybody the same notebook, with the "
            f"chapter's numbers (ngshare has one folder for all); {INSTEAD}"
        )
    if force:
        config.ExchangeReleaseAssignment.force = True
        config.ReleaseOwnSheets.force = True
    with programs_on_path(), redirect_stderr(StringIO()):
        result = NbGraderAPI(place, config=config).release_assignment(name)
    if result["success"]:
        return ""
    lines = [
        line for line in f"{result.get('log', '')}\n{result.get('error', '')}".splitlines() if line.strip()
    ]
    failures = [line for line in lines if "CRITICAL" in line or "ERROR" in line or "ExchangeError" in line]
    return (failures or lines or ["nbgrader gave no reason"])[0].partition("] ")[2].strip() or (
        failures or lines
    )[0].strip()
