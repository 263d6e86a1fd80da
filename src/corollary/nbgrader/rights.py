"""Rights of files in the exchange: opened for one account alone, and made ordinary again."""

from __future__ import annotations

import os
import stat
import struct
import sys
from contextlib import suppress
from pathlib import Path

ACCESS_LIST, FOR_NEW, READ, SEARCH = "system.posix_acl_access", "system.posix_acl_default", 4, 5
FOLDER_RIGHTS, FILE_RIGHTS, SHARED = 0o755, 0o644, 0o060


def open_for(path: Path, account: int) -> None:
    """Lets an account read what nobody else but its owner can: by root it becomes the owner; anybody else writes it into the
    access list of what is the own. Raises OSError where the file system has no such lists."""
    if os.geteuid() == 0:
        os.chown(path, account, -1)
    else:
        os.setxattr(path, ACCESS_LIST, access_list(account, SEARCH if path.is_dir() else READ))


def access_list(account: int, rights: int) -> bytes:
    """Linux's access list (acl(5), `posix_acl_xattr.h`) by which the owner may do everything, the account this, and nobody else
    anything."""
    everything, nothing, of_none = 7, 0, 0xFFFFFFFF
    entries = (
        (0x01, everything, of_none),  # the owner
        (0x02, rights, account),
        (0x04, nothing, of_none),  # the group
        (0x10, rights, of_none),  # the most that an account or the group gets
        (0x20, nothing, of_none),  # all others
    )
    return struct.pack("<I", 2) + b"".join(struct.pack("<HHI", *each) for each in entries)


def make_ordinary(folder: Path, shared: bool = False) -> None:
    """Take the access lists off a folder and all that is in it; its owner may write, and others read as far as the umask says.

    A copy by `shutil.copytree` takes the lists and the modes of its source along. `shared`: the group may write, too.
    """
    umask = os.umask(0o077)
    os.umask(umask)
    for place, _, names in os.walk(folder):
        for path in (place, *(os.path.join(place, each) for each in names)):
            if os.path.islink(path) or os.geteuid() not in (0, os.stat(path).st_uid):
                continue
            if sys.platform == "linux":
                for each in (ACCESS_LIST, FOR_NEW):
                    with suppress(OSError):  # it has none, or the file system knows none
                        os.removexattr(path, each)
            mode = os.stat(path).st_mode
            rights = FOLDER_RIGHTS if stat.S_ISDIR(mode) else FILE_RIGHTS
            os.chmod(path, (mode & stat.S_ISGID) | (rights & ~umask) | (shared and SHARED))
