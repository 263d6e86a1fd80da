"""A roster that changes: newcomers are added, and who disappears is asked about."""

from __future__ import annotations

import pytest

from corollary.course.renew import OneFolder, check_folders, roster_change
from corollary.problem.roster import Student

ADA, BEN = Student("ada", "Ada", "Lovelace", "ada@example.org"), Student("ben", "Ben", "Bool")
CYD = Student("cyd", "Cyd", "Charisse")


def test_a_file_of_newcomers_takes_nobody_away():
    change = roster_change([ADA, BEN], [CYD])
    assert (change.roster, change.new, change.missing) == ((ADA, BEN, CYD), (CYD,), ())


def test_who_is_not_in_the_file_is_missing_and_found_under_another_id():
    renamed = Student("b17", "Ben", "Bool")
    change = roster_change([ADA, BEN, CYD], [ADA, renamed])
    assert change.roster == (ADA, renamed)
    assert change.missing == ((BEN, "b17"), (CYD, ""))


def test_what_the_file_leaves_blank_stays_known():
    change = roster_change([ADA], [Student("ada", ids=(("ID", "7"),))])
    assert change.roster == (ADA,)
    assert change.roster[0].ids == (("ID", "7"),)


def test_an_id_that_many_disks_take_for_one_of_the_course():
    with pytest.raises(OneFolder, match="id Ada and ada, who is in the course, are one folder on many disks"):
        roster_change([ADA], [Student("Ada")])


def test_an_id_that_is_the_name_of_the_set():
    """Where nbgrader has the chapter's sheet, that student's own would lie, and be given to everybody."""
    check_folders([ADA, BEN], "week_1")
    with pytest.raises(OneFolder, match="id ben is the name of the set too"):
        check_folders([ADA, BEN], "Ben")
