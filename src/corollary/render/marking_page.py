"""The page for marking by hand: every answer to a part under the other, the rubric to click, the keyboard first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from corollary.problem.problem_set import ProblemSet
from corollary.records.near_miss_groups import PartToMark
from corollary.render.page import page


def marking_page(
    problem_set: ProblemSet,
    parts: Sequence[PartToMark],
    ids: Mapping[tuple[str, int], str],
    *,
    names: Mapping[str, str] | None,
) -> str:
    """One page that needs nothing but the server that gave it. `ids` names a group of answers, by part and place among its
    groups, for the mark that is sent back; `names` are the students' by their ids; without them the page does not say whose the answers are."""
    return page(
        "mark.html",
        title=f"{problem_set.title}: marking",
        script="mark.js",
        sends=True,
        heading=problem_set.title,
        parts=parts,
        ids=ids,
        names=names,
    )
