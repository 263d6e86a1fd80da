"""Landlock: an allow list of files, made once and put in force in every worker (landlock(7), Linux 5.13)."""

import os

_ABI_OF_SCOPES = 6  # Linux 6.12: before it, signals are seccomp's to refuse


class NoLandlock(Exception):
    """Landlock cannot be used here; the message says why."""


def prepare(listed, readable, writable):
    """A ruleset that allows to list the folders in `listed`, to read what is in `readable`, to change what is in `writable`.

    Gives the ruleset, and whether it also keeps signals inside. TCP (Linux 6.7), abstract sockets and signals (6.12) are
    refused too, as far as the kernel knows how. Raises NoLandlock.
    """
    try:
        import landlockpy
    except ImportError as error:
        raise NoLandlock("landlockpy is not installed (the extra `isolation`)") from error
    if landlockpy.abi_version() < 1:
        raise NoLandlock("the kernel offers no Landlock")
    access = landlockpy.AccessFS
    scopes = landlockpy.Scope.ABSTRACT_UNIX_SOCKET | landlockpy.Scope.SIGNAL
    ruleset = landlockpy.Ruleset(scoped=scopes)
    # No EXECUTE, no MAKE_CHAR, MAKE_BLOCK, MAKE_SOCK or MAKE_FIFO: what a notebook writes is files, folders and links.
    change = (
        access.READ_FILE
        | access.READ_DIR
        | access.WRITE_FILE
        | access.TRUNCATE
        | access.REMOVE_FILE
        | access.REMOVE_DIR
        | access.MAKE_REG
        | access.MAKE_DIR
        | access.MAKE_SYM
        | access.REFER
    )
    for path in listed:
        ruleset.allow_path(path, access.READ_DIR)
    for path in readable:
        if os.path.isdir(path):
            ruleset.allow_path(path, access.READ_FILE | access.READ_DIR)
        elif os.path.exists(path):
            ruleset.allow_path(path, access.READ_FILE)
    for path in writable:
        allowed = change if os.path.isdir(path) else access.READ_FILE | access.WRITE_FILE
        ruleset.allow_path(path, allowed)
    return ruleset, landlockpy.abi_version() >= _ABI_OF_SCOPES


def entries(folder, prefixes, hidden):
    """The paths in a folder whose names do not begin with one of `prefixes` and which are not in `hidden`.

    Landlock grants whole trees and forbids nothing inside a grant, so what is to stay unread must not be granted.
    """
    return [
        entry.path
        for entry in os.scandir(folder)
        if not entry.name.startswith(prefixes) and entry.path not in hidden
    ]
