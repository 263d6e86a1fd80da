"""A folder with the programs of a bare machine: git, make, bash, Python and the base system of Debian, to stand alone in PATH."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

# From the packages bash, coreutils, dash, diffutils, findutils, grep, hostname, mawk, sed, tar and gzip, which Debian calls essential.
BASE = """
[ awk basename bash cat chmod chown cksum cmp comm cp cut date dd df diff dirname du echo env expr false find grep gunzip gzip head
hostname id install join kill ln ls md5sum mkdir mkfifo mktemp mv nice nproc od paste printenv printf pwd readlink realpath rm
rmdir sed seq sh sha256sum sleep sort split stat stty sum sync tail tar tee test timeout touch tr true truncate tty uname uniq wc
whoami xargs yes
"""
ADDED = ("git", "make")


def main(folder: Path) -> None:
    """Raises SystemExit where one of those added is missing."""
    folder.mkdir(parents=True)
    for name in (*BASE.split(), *ADDED):
        if found := shutil.which(name):
            (folder / name).symlink_to(found)
        elif name in ADDED:
            raise SystemExit(f"{name} is missing")
    python = folder / "python3"  # no link, beside which Python would look for its library
    python.write_text(f'#!/bin/sh\nexec "{os.path.realpath(sys.executable)}" "$@"\n')
    python.chmod(0o755)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
