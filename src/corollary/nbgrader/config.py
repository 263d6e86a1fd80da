"""The file nbgrader_config.py of a course: an ordinary one, which its owner may add to."""

from __future__ import annotations

from pathlib import Path

from corollary.atomic import write_whole
from corollary.records.files import Course

MARK = "# Written by corollary."
TEXT = f"""\
{MARK} Add your own settings below; corollary leaves this file alone from now on.
from nbconvert.preprocessors import ClearMetadataPreprocessor
from nbgrader.preprocessors import (
    CheckCellMetadata, ClearOutput, ComputeChecksums, DeduplicateIds, IgnorePattern, LimitOutput, LockCells,
    OverwriteKernelspec, SaveCells,
)

from corollary.nbgrader.autograde import JudgedOutside, LatenessInMarks, OwnNumbers, OwnSheet, RecordMarks
from corollary.nbgrader.export_command import CurrentMarks
from corollary.nbgrader.feedback_command import FeedbackPage

c = get_config()  # noqa: F821
c.CourseDirectory.course_id = __NAME__

# The exchange gives each student the own sheet, and `nbgrader zip_collect` knows the names that Moodle and Canvas give to files.
c.ExchangeFactory.release_assignment = "corollary.nbgrader.exchange.ReleaseOwnSheets"
c.ExchangeFactory.fetch_assignment = "corollary.nbgrader.exchange.FetchOwnSheet"
c.ExchangeFactory.submit = "corollary.nbgrader.exchange.SubmitOwnSheet"
c.ExchangeFactory.collect = "corollary.nbgrader.exchange.CollectFromEach"
c.ExchangeFactory.list = "corollary.nbgrader.exchange.ListEach"
c.ExchangeFactory.release_feedback = "corollary.nbgrader.exchange.ReleaseOwnFeedback"
c.ZipCollectApp.extractor_plugin = "corollary.nbgrader.zip_collect.BoundedExtractor"
c.ZipCollectApp.collector_plugin = "corollary.nbgrader.zip_collect.OwnerCollector"

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
        f"{where}: {type(error).__name__}: {why}; correct the file, or move it away and run corollary generate again"
    )


def write_config(course: Course) -> None:
    """Writes the file once. Raises NotOurs when another tool's course is already set up in the folder."""
    check_config(course.folder)
    path = course.folder / "nbgrader_config.py"
    if not path.exists():
        write_whole(path, TEXT.replace("__NAME__", repr(course.name)))


def check_config(folder: Path) -> None:
    """Raises NotOurs when another tool's course is set up in the folder; changes nothing."""
    path = folder / "nbgrader_config.py"
    if path.exists() and MARK not in path.read_text(encoding="utf-8", errors="replace"):
        raise NotOurs(
            f"{path} was not written by corollary; choose another folder with --course, "
            f"or put this line at its head if its settings will do: {MARK}"
        )
