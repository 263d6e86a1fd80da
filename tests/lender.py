"""One zygote for one run of notebooks after another: it takes seconds to start, and leaves nothing of a run to the next."""

from __future__ import annotations

import os
import shutil
import signal
from types import SimpleNamespace
from typing import Any

from corollary.sandbox.job import Limits
from corollary.sandbox.zygote import CannotStart, Zygote

PLACES = ("TMPDIR", "TZ")
"""What of the environment a zygote has from its start."""


class Lender:
    """Stands for `Zygote` where runners start one: whoever wants a usual one, and nobody has it, gets that of the lender."""

    def __init__(self) -> None:
        self.lendable = True
        self._zygote: Any = None
        self._lent = False
        self._process, self._forked = os.getpid(), False
        self._places = [os.environ.get(name) for name in PLACES]

    def __call__(
        self, limits: Limits, without: frozenset[str] = frozenset(), probe_only: bool = False
    ) -> Any:
        usual = limits == Limits() and not without and not probe_only and os.getpid() == self._process
        if not usual or not self.lendable or [os.environ.get(name) for name in PLACES] != self._places:
            return Zygote(limits, without, probe_only)
        self.start()
        lent, self.lendable, self._lent = self._zygote, False, True
        shutil.rmtree(lent._base.path / "canary", ignore_errors=True)
        lent.stop = lambda: self._take_back(lent)
        return lent

    def start(self) -> None:
        """Raises CannotStart."""
        if self._zygote is not None and not self._zygote.running:
            self.end()
        if self._zygote is None:
            self._zygote = Zygote(Limits())

    def start_if_possible(self) -> None:
        """Leave it to whoever wants one to say that there is none."""
        try:
            self.start()
        except CannotStart:
            self.lendable = False

    def in_fork(self) -> None:
        """Go on in this process, which is not the parent of the zygote and cannot start it again."""
        self._process, self._forked = os.getpid(), True
        if self._zygote is None:
            self.lendable = False
        else:
            self._zygote._process = SimpleNamespace(poll=lambda: None, pid=self._zygote.pid)

    def end(self) -> None:
        if self._zygote is not None:
            Zygote.stop(self._zygote)
            self._zygote = None

    def settle(self) -> None:
        """In a fork that ends: a zygote that was not given back is of no more use to anybody."""
        if self._lent:
            os.kill(self._zygote.pid, signal.SIGKILL)

    def _take_back(self, lent: Any) -> None:
        """Wait for the end of all its workers, so that who has it next reads no answer to somebody else."""
        self._lent, self.lendable = False, True
        for listening in lent._base._sockets:
            listening.close()
        lent._base._sockets.clear()
        try:
            if lent._next is not None:
                lent._next.close()
                lent._next = None
            lent.reap()
        except OSError:
            if self._forked:  # its parent starts another
                os.kill(lent.pid, signal.SIGKILL)
                self.lendable = False
            else:
                self.end()
