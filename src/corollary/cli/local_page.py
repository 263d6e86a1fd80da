"""A page on this machine, for who knows its address: served until ctrl-C, and again when files change that are watched."""

from __future__ import annotations

import io
import json
import os
import re
import secrets
import shutil
import socket
import sys
import tempfile
import webbrowser
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from contextvars import copy_context
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import BoundedSemaphore, Lock
from time import monotonic
from typing import Any, Final, cast

from corollary.cli.ending import say
from corollary.problem.bank import Bank
from corollary.problem.packed_pictures import pictures_of

MOST_BYTES = 1 << 20
MOST_SECONDS: Final = 20.0  # for a request to come in, and as much for its answer to be taken
MOST_AT_A_TIME: Final = 32
POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">')
NOTHING = "default-src 'none'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"


class OnePageServer(ThreadingHTTPServer):
    """Serves `page` below a secret path on 127.0.0.1, and hands what is posted to `PATH/give` to `receive`, one at a time.

    `receive` takes the posted JSON, says what to answer ("saved" when nothing), and raises ValueError with a sentence for what it
    does not take. `PATH/edition` answers
    `edition`, by which a page knows that it would be another today.
    """

    daemon_threads = True
    seconds = MOST_SECONDS

    def __init__(
        self,
        page: Callable[[], str],
        receive: Callable[[dict[str, Any]], str | None],
        port: int = 0,
        edition: Callable[[], str] = str,
    ) -> None:
        super().__init__(("127.0.0.1", port), _Handler)
        self.page, self.receive, self.edition = page, receive, edition
        self.token = secrets.token_urlsafe(24)
        self.one_at_a_time = Lock()
        self.context = copy_context()  # a request's own thread would speak English
        self.places = BoundedSemaphore(MOST_AT_A_TIME)

    @property
    def address(self) -> str:
        """What to open."""
        return f"http://127.0.0.1:{self.server_port}/{self.token}/"

    def process_request(self, request: Any, client_address: Any) -> None:
        """Refuse a connection beyond the most at a time: each has a thread."""
        if self.places.acquire(blocking=False):
            super().process_request(request, client_address)
        else:
            self.shutdown_request(request)

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        try:
            super().process_request_thread(request, client_address)
        finally:
            self.places.release()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A client that has left, or is too slow, is nobody's error."""
        error = sys.exception()
        if not isinstance(error, OSError):
            say(f"a request to the page failed: {type(error).__name__}: {error}")


class _InTime(io.RawIOBase):
    """What a client sends, with one limit of time for all of it: a byte now and then would hold a thread for ever."""

    def __init__(self, connection: socket.socket, seconds: float) -> None:
        self.connection, self.until = connection, monotonic() + seconds

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: Any, /) -> int:
        left = self.until - monotonic()
        if left <= 0:
            raise TimeoutError
        self.connection.settimeout(left)
        return self.connection.recv_into(buffer)


class _Handler(BaseHTTPRequestHandler):
    server: OnePageServer  # pyright: ignore[reportIncompatibleVariableOverride]

    def setup(self) -> None:
        super().setup()
        self.rfile.close()
        self.rfile = io.BufferedReader(_InTime(self.connection, self.server.seconds))

    def do_GET(self) -> None:
        if self._is_meant() and self.path.partition("?")[0] == f"/{self.server.token}/":
            try:
                with self.server.one_at_a_time:
                    text = self.server.context.run(self.server.page)
            except Exception as error:  # the course is being changed: the next request may find it whole
                self._answer(HTTPStatus.INTERNAL_SERVER_ERROR, str(error))
            else:
                self._answer(HTTPStatus.OK, text, "text/html")
        elif self._is_meant() and self.path == f"/{self.server.token}/edition":
            self._answer(HTTPStatus.OK, self.server.edition())
        else:
            self._answer(HTTPStatus.NOT_FOUND, "not found")

    def do_POST(self) -> None:
        size = self.headers.get("Content-Length", "")
        if not self._is_meant() or self.path != f"/{self.server.token}/give":
            return self._answer(HTTPStatus.NOT_FOUND, "not found")
        # A form of another site cannot send JSON, and its script would have to say where it is from.
        if self.headers.get("Content-Type") != "application/json" or not self._is_own_origin():
            return self._answer(HTTPStatus.FORBIDDEN, "only this page may send")
        if not size.isdigit() or int(size) > MOST_BYTES:
            return self._answer(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, "too long")
        content = self.rfile.read(int(size))
        if len(content) < int(size):
            raise ConnectionAbortedError  # it has left in the middle
        try:
            posted: object = json.loads(content)
            if not isinstance(posted, dict):
                raise ValueError("the request must be a JSON object")
            with self.server.one_at_a_time:
                answer = self.server.context.run(self.server.receive, cast(dict[str, Any], posted))
        except (ValueError, RecursionError) as error:
            return self._answer(HTTPStatus.BAD_REQUEST, str(error))
        except (
            Exception
        ) as error:  # the gradebook is locked, the disk is full: the page says so, and the rest goes on
            return self._answer(HTTPStatus.INTERNAL_SERVER_ERROR, str(error))
        return self._answer(HTTPStatus.OK, answer or "saved")

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Nothing: the address of each request holds the token."""

    def _is_meant(self) -> bool:
        """Whether the browser was told this very address: a name that somebody lets point here is another host."""
        port = self.server.server_port
        return self.headers.get("Host") in {f"127.0.0.1:{port}", f"localhost:{port}"}

    def _is_own_origin(self) -> bool:
        return self.headers.get("Origin") in {None, f"http://{self.headers.get('Host')}"}

    def _answer(self, status: HTTPStatus, text: str, kind: str = "text/plain") -> None:
        content = text.encode("utf-8", "replace")
        self.send_response(status)
        for name, value in {
            "Content-Type": f"{kind}; charset=utf-8",
            "Content-Length": str(len(content)),
            "Cache-Control": "no-store",
            "X-Content-Type-Options": "nosniff",
            "X-Frame-Options": "DENY",
            "Referrer-Policy": "no-referrer",
            "Content-Security-Policy": _policy(text if kind == "text/html" else ""),
        }.items():
            self.send_header(name, value)
        self.end_headers()
        self.connection.settimeout(self.server.seconds)
        self.wfile.write(content)


def _policy(page: str) -> str:
    """The page's own policy for content, and that no other page frames it, which only a header can say."""
    own = POLICY.search(page)
    return f"{own[1].replace('&#39;', chr(39))}; frame-ancestors 'none'" if own else NOTHING


def edition(bank: Bank, path: Path) -> str:
    """Tells the files of a problem apart from what they were: its own, its pictures, its solution, the programs beside that, and the
    bank's ready-made scenes."""
    solution, scenes = bank.solution_beside(path), bank.home_of(path).scenes
    programs = (*solution.parent.glob("*.py"), *solution.with_suffix("").rglob("*.py"), *scenes.glob("*.py"))
    beside = [solution, *programs]
    with suppress(OSError):
        beside += pictures_of(path)
    states: list[str] = []
    for each in (path, *sorted(set(beside))):
        with suppress(OSError):  # an editor that moves a file into place leaves none for a moment
            found = each.stat()
            states.append(f"{each.name} {found.st_mtime_ns} {found.st_size}")
    return "; ".join(states)


def serve(server: OnePageServer, what: str, no_browser: bool) -> None:
    """`what` is said of the page behind its address; the server is closed at the end."""
    with server, _file_to_open(server.address) as file:
        print(server.address, flush=True)
        say(f"this address is private; {what}")
        if not no_browser:
            webbrowser.open(file)
        with suppress(KeyboardInterrupt):
            server.serve_forever()


@contextmanager
def _file_to_open(address: str) -> Generator[str]:
    """The address of a file that leads to the page, for its owner alone.

    The words of a running browser's command line can be read by every account of the machine: the page's secret must not be
    among them.
    """
    if _is_windows_subsystem():  # Windows' browser does not find the file
        yield address
        return
    folder = Path(tempfile.mkdtemp(prefix="corollary-page-", dir=_where_browsers_read()))
    try:
        file = folder / "open.html"
        file.touch(mode=0o600)
        file.write_text(
            '<!DOCTYPE html><meta charset="utf-8"><meta name="referrer" content="no-referrer">'
            f'<meta http-equiv="refresh" content="0; url={address}"><title>Corollary</title>',
            encoding="utf-8",
        )
        yield file.as_uri()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _where_browsers_read() -> Path | None:
    """The home folder where browsers come as snaps, which see no other temporary files than their own; else the usual place."""
    home = Path(os.path.expanduser("~"))
    return home if Path("/snap/bin").is_dir() and os.access(home, os.W_OK) else None


def _is_windows_subsystem() -> bool:
    with suppress(OSError):
        return "microsoft" in Path("/proc/sys/kernel/osrelease").read_text(encoding="utf-8").lower()
    return False
