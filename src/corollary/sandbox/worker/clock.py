"""The clock of one cell as the child knows it: when it may be interrupted, and whether it was."""

import signal
import time

_now = time.monotonic
_set_handler = signal.signal


class Clock:
    """Turns the coordinator's SIGINT into KeyboardInterrupt, but only inside work that has used up its time.

    An interrupt that comes a moment late must not hit the next cell; so the elapsed time is looked at too.
    """

    def __init__(self):
        self.limit = 0.0
        self.began = None
        self.rang = False

    def start(self, limit):
        self.limit, self.rang = limit, False
        _set_handler(signal.SIGINT, self._ring)
        self.began = _now()

    def stop(self):
        self.began = None

    def _ring(self, number, frame):
        if self.began is not None and _now() - self.began > 0.95 * self.limit:
            self.rang = True
            raise KeyboardInterrupt
