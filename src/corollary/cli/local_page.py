"""A page on this machine, for who knows its address: served until ctrl-C, and again when files change that are watched."""

from __future__ import annotations

import json
import secrets
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from contextvars import copy_context
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Lock
from typing import Any, cast

from corollary.cli.ending import say
from corollary.problem.bank import Bank
from corollary.problem.packed_pictures import pictures_of

MOST_BYTES = 1 << 20


class OnePageServer(ThreadingHTTPServer):
    """Serves `page` below a secret path on 127.0.0.1, and hands what is posted to `PATH/give` to `receive`, one at a time.

    `receive` takes the posted JSON, says what to answer ("saved" when nothing), and raises ValueError with a sentence for what it
    does not take. `PATH/edition` answers
    `edition`, by which a page knows that it would be another today.
    """

    daemon_threads = True

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

    @property
    def address(self) -> str:
        """What to open."""
        return f"http://127.0.0.1:{self.server_port}/{self.token}/"


class _Handler(BaseHTTPRequestHandler):
    server: OnePageServer  # pyright: ignore[reportIncompatibleVariableOverride]

    def do_GET(self) -> None:
        if self._is_meant() and self.path.partition("?")[0] == f"/{self.server.token}/":
            with self.server.one_at_a_time:
                text = self.server.context.run(self.server.page)
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
        try:
            posted: object = json.loads(self.rfile.read(int(size)))
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
        }.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)


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
    with server:
        print(server.address, flush=True)
        say(f"this address is private; {what}")
        if not no_browser:
            webbrowser.open(server.address)
        with suppress(KeyboardInterrupt):
            server.serve_forever()
