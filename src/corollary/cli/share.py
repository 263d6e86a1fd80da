"""`corollary share`: rights of a course for a teaching team."""

from __future__ import annotations

from pathlib import Path

from corollary.cli.ending import FAILS, HOLDS, answer, counted, say
from corollary.course.sharing import group_named, left_to_do, names_of, share
from corollary.records.files import open_course


def run(group: str, course: Path, as_json: bool) -> int:
    opened = open_course(course)
    done = share(opened, group_named(group))
    left = left_to_do(done, opened)
    if as_json:
        answer(
            {
                "course": str(opened.folder),
                "group": done.group.name,
                "members": list(done.group.members),
                "changed": done.changed,
                "left": left,
            }
        )
    else:
        print(f"{opened.folder} is shared with {done.group.name} ({names_of(done.group.members)})")
        print(
            f"new rights for {counted(done.changed, 'file or folder') if done.changed == 1 else f'{done.changed} files and folders'}"
        )
    for each in left:
        say(each)
    return FAILS if left else HOLDS
