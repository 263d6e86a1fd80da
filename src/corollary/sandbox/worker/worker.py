"""One worker from fork to exit: it confines itself, receives its job, runs it, and is gone."""

import os
import random
import sys

from . import libc, namespaces, privileges, probe, protocol


def run(isolation, shell, outputs, channel):
    """Never returns. `channel` is the socket to the process that grades."""
    try:
        privileges.die_with_parent()
        if isolation.namespaces:
            owner, group = isolation.owner()
            namespaces.enter_own_namespaces(isolation.limits["file_bytes"], owner, group)
        _confine(isolation, channel)
        protocol.introduce()
        job = protocol.receive()
        _enforce(isolation)
        if job["probe"] is not None:
            protocol.send({"t": "probed", "held": probe.probe(job["probe"], isolation)})
        else:
            from . import executor

            executor.execute(shell, outputs, job)
        os._exit(0)
    except BaseException as error:
        protocol.send({"t": "broken", "why": f"{type(error).__name__}: {error}"[:500]})
        os._exit(70)  # EX_SOFTWARE of sysexits.h


def _confine(isolation, channel):
    os.setsid()
    inherited = [isolation.ruleset.fileno()] if isolation.ruleset else []
    privileges.keep_descriptors(channel, inherited)
    # Without seccomp nothing stops a fork but RLIMIT_NPROC, which counts all processes that a user has anywhere: an
    # ordinary user's own programs must still fit below it.
    processes = None if isolation.filter else 1024 if isolation.user is None else 64
    privileges.set_limits(isolation.limits, isolation.address_space, processes)
    os.chdir(isolation.folder)
    sys.path.insert(0, "")  # as in Jupyter: what a cell writes beside the notebook can be imported
    privileges.drop_privileges(isolation.user)
    privileges.die_with_parent()  # a change of user clears it (prctl(2), PR_SET_PDEATHSIG)
    random.seed()
    if "numpy" in sys.modules:
        sys.modules["numpy"].random.seed(int.from_bytes(os.urandom(4), "big"))


def _enforce(isolation):
    """Landlock and seccomp, last of all: what the steps before needed is refused from here on."""
    if isolation.ruleset:
        isolation.ruleset.restrict()
        isolation.ruleset.close()
    if isolation.filter:
        libc.load_filter(isolation.filter)
