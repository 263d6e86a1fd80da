"""The file nbgrader_config.py of a course: an ordinary one, which its owner may add to."""

from __future__ import annotations

import re
from pathlib import Path

from corollary.atomic import write_whole
from corollary.records.files import Course

MARK = "# Written by corollary."
FEEDBACK_ROAD = 'c.ExchangeFactory.release_feedback = "corollary.nbgrader.exchange.ReleaseOwnFeedback"\n'
COLLECT_ROAD = 'c.ExchangeFactory.collect = "corollary.nbgrader.exchange.CollectFromEach"\n'
LIST_ROAD = 'c.ExchangeFactory.list = "corollary.nbgrader.exchange.ListEach"\n'
ROADS = f"""\

# The exchange gives each student the own sheet, and `nbgrader zip_collect` knows the names that Moodle and Canvas give to files.
c.ExchangeFactory.release_assignment = "corollary.nbgrader.exchange.ReleaseOwnSheets"
c.ExchangeFactory.fetch_assignment = "corollary.nbgrader.exchange.FetchOwnSheet"
c.ExchangeFactory.submit = "corollary.nbgrader.exchange.SubmitOwnSheet"
{COLLECT_ROAD}{LIST_ROAD}{FEEDBACK_ROAD}c.ZipCollectApp.extractor_plugin = "corollary.nbgrader.zip_collect.BoundedExtractor"
c.ZipCollectApp.collector_plugin = "corollary.nbgrader.zip_collect.OwnerCollector"
"""
TEXT = f"""\
{MARK} Add your own settings below; corollary leaves this file alone from now on.
from nbconvert.preprocessors import ClearMetadataPreprocessor
from nbgrader.preprocessors import (
    CheckCellMetadata, ClearOutput, ComputeChecksums, DeduplicateIds, IgnorePattern, LimitOutput, LockCells,
    OverwriteKernelspec, SaveCells,
)

from corollary.nbgrader.autograde import JudgedOutside, LatenessInMarks, OwnNumbers, OwnSheet, RecordMarks
from corollary.nbgrader.export import CurrentMarks
from corollary.nbgrader.feedback import FeedbackPage

c = get_config()  # noqa: F821
c.CourseDirectory.course_id = __NAME__
{ROADS}
# The source notebooks hold no solutions, so nothing has to be cut out of them.
c.GenerateAssignment.preprocessors = [LockCells, ClearOutput, CheckCellMetadata, ComputeChecksums, SaveCells]

# `nbgrader autograde` marks our sets as `corollary grade` does (and other assignments as ever).
c.Autograde.exporter_class = OwnSheet
c.Autograde.sanitize_preprocessors = [ClearOutput, DeduplicateIds, OverwriteKernelspec, OwnNumbers, CheckCellMetadata]
c.Autograde.autograde_preprocessors = [
    JudgedOutside, IgnorePattern, ClearMetadataPreprocessor, LimitOutput, RecordMarks, LatenessInMarks, CheckCellMetadata,
]

# `nbgrader generate_feedback` gives the student's one page, made anew each time with the marks as they are then.
c.GenerateFeedback.exporter_class = FeedbackPage
c.GenerateFeedback.force = True

# `nbgrader export` works out first what lateness takes off scores that were given by hand.
c.ExportApp.plugin_class = CurrentMarks
"""

# The lines of files from earlier versions that are no longer so, and what stands there now.
FORMER_FEEDBACK = """
# Feedback is made anew each time, so that it never shows older marks than the gradebook.
c.GenerateFeedback.force = True
"""
IMPORTS = """
from corollary.nbgrader.export import CurrentMarks
from corollary.nbgrader.feedback import FeedbackPage

c = get_config()"""


# What a course's file from an earlier version calls our classes; the file stays with the course, and they were renamed.
RENAMED = {
    "corollary.deliver.nbgrader_autograde": "corollary.nbgrader.autograde",
    "MarksKept": "RecordMarks",
    "LatenessKept": "LatenessInMarks",
}
CONFIG = re.compile(r"^c = get_config\(\).*\n", re.MULTILINE)


class NotOurs(Exception):
    """A file stands in the way that somebody else wrote; one sentence says which, and what to do."""


class BrokenConfig(Exception):
    """The file cannot be run, or sets what nbgrader does not take; one sentence says where, and what to do."""


def broken(course: Course, error: BaseException) -> BrokenConfig:
    """The sentence for what running the file raised."""
    where, why = f"{course.folder / 'nbgrader_config.py'}", f"{error}"
    if isinstance(error, SyntaxError):
        where, why = f"{where}, line {error.lineno}", error.msg
    return BrokenConfig(
        f"{where}: {type(error).__name__}: {why}; mend the file, or move it away and run corollary generate again"
    )


def write_config(course: Course) -> None:
    """Writes the file once. Raises NotOurs when another tool's course is already set up in the folder."""
    check_config(course.folder)
    path = course.folder / "nbgrader_config.py"
    if not path.exists():
        write_whole(path, TEXT.replace("__NAME__", repr(course.name)))
    renew_config(course)


def renew_config(course: Course) -> None:
    """Lets a file from an older version find our classes where they are now, and those that were not there yet, before all
    that its owner has set; all else in it is left as it is."""
    path = course.folder / "nbgrader_config.py"
    text = path.read_text(encoding="utf-8", errors="surrogateescape") if path.exists() else ""
    renewed = text
    for former, name in RENAMED.items():
        renewed = renewed.replace(former, name)
    if MARK in renewed and FORMER_FEEDBACK in renewed:
        now = TEXT[TEXT.index("\n# `nbgrader generate_feedback` gives") :]
        renewed = renewed.replace(FORMER_FEEDBACK, now).replace("\n\nc = get_config()", IMPORTS, 1)
    if MARK in renewed and ROADS.split("\n")[1] not in renewed:
        renewed = CONFIG.sub(lambda line: line[0] + ROADS, renewed, count=1)
    for road in (FEEDBACK_ROAD, COLLECT_ROAD, LIST_ROAD):
        if MARK in renewed and road.split(" = ")[0] not in renewed:
            renewed = CONFIG.sub(lambda line, road=road: line[0] + road, renewed, count=1)
    if renewed != text:
        write_whole(path, renewed.encode("utf-8", "surrogateescape"))


def check_config(folder: Path) -> None:
    """Raises NotOurs when another tool's course is set up in the folder; changes nothing."""
    path = folder / "nbgrader_config.py"
    if path.exists() and MARK not in path.read_text(encoding="utf-8", errors="replace"):
        raise NotOurs(
            f"{path} was not written by corollary; choose another folder with --course, "
            f"or put this line at its head if its settings will do: {MARK}"
        )
