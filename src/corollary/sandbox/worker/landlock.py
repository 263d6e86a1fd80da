"""Landlock: an allow list of files, made once and put in force in every child."""

import os


class NoLandlock(Exception):
    """Landlock cannot be used here; the message says why."""


def prepare(listed, readable, writable):
    """A ruleset that lets see the names in `listed`, read what is in `readable`, change what is in `writable`.

    Gives the ruleset, and whether it also keeps signals inside. TCP and abstract sockets are refused too, as far as the
    kernel knows how. Raises NoLandlock.
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
    # Nothing is ever executed and no device made; where a folder may be changed, its files and links may be.
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

    return ruleset, landlockpy.abi_version() >= 6


def entries(folder, without):
    """The paths in a folder whose names do not begin with one of `without`.

    Landlock grants whole trees and forbids nothing inside a grant, so what is to stay closed must not be named.
    """
    return [entry.path for entry in os.scandir(folder) if not entry.name.startswith(without)]
