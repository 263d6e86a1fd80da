"""A script that runs another as an ordinary user, also where the tests run as root and root alone may read the interpreter."""

from __future__ import annotations

import os
import pwd
import sys
import tempfile
from pathlib import Path

from kernel import CLONE_NEWNS, MS_BIND, MS_PRIVATE, MS_REC, libc, mount

NOBODY = 65534


def main() -> None:
    script, *arguments = sys.argv[1:]
    if os.geteuid() == 0:
        become_ordinary(int(os.environ.get("AS_ACCOUNT", NOBODY)))
    os.execv(sys.executable, [sys.executable, script, *arguments])


def _group(account: int) -> int:
    """Return the account's own group, so that no two accounts share one."""
    try:
        return pwd.getpwuid(account).pw_gid
    except KeyError:
        return NOBODY


def become_ordinary(account: int) -> None:
    """Give up all rights but those of an account; the interpreter stays readable."""
    interpreter = Path(sys.base_prefix)
    closed = [folder for folder in reversed(interpreter.parents) if not folder.stat().st_mode & 0o001]
    if closed:
        # In a mount namespace of this process alone, the interpreter is all that is left of the folder around it.
        if libc.unshare(CLONE_NEWNS):
            raise SystemExit("no mount namespace to show the interpreter in")
        mount(None, "/", None, MS_REC | MS_PRIVATE)
        aside = tempfile.mkdtemp()
        mount(str(interpreter), aside, None, MS_BIND | MS_REC)
        mount("open", str(closed[0]), "tmpfs", 0, "mode=755")
        umask = os.umask(0o022)  # a stricter one is for the script alone
        interpreter.mkdir(parents=True)
        os.umask(umask)
        mount(aside, str(interpreter), None, MS_BIND | MS_REC)
    os.setgroups([])
    group = _group(account)
    os.setresgid(group, group, group)
    os.setresuid(account, account, account)


if __name__ == "__main__":
    main()
