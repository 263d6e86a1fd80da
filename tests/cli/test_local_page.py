"""The server of a local page: slow clients, its policy for content, and the file by which a browser opens it."""

from __future__ import annotations

import socket
import struct
import threading
import time
import urllib.request
import webbrowser
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from corollary.cli.local_page import OnePageServer, serve
from corollary.practice.practice import practice
from corollary.problem.bank import Bank, chapter_bank
from corollary.render.practice_page import practice_page


@pytest.fixture
def received() -> list[dict]:
    return []


@pytest.fixture
def server(received: list[dict]) -> Iterator[OnePageServer]:
    with OnePageServer(lambda: "<p>the page</p>", received.append) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield server
        server.shutdown()
        thread.join()


def get(server: OnePageServer) -> tuple[str, str]:
    """The page's policy for content, and the page."""
    with urllib.request.urlopen(server.address, timeout=20) as answer:
        return str(answer.headers["Content-Security-Policy"]), answer.read().decode()


def test_a_client_that_is_slow_or_leaves_costs_nothing(
    server: OnePageServer, received: list[dict], capfd: pytest.CaptureFixture[str]
) -> None:
    server.seconds = 0.4
    home = f"/{server.token}/"
    head = f"POST {home}give HTTP/1.1\r\nHost: 127.0.0.1:{server.server_port}\r\nContent-Type: application/json\r\n"
    clients = [socket.create_connection(("127.0.0.1", server.server_port), timeout=20) for _ in range(4)]
    silent, slow, cut_short, gone = clients
    slow.sendall(head.encode())
    cut_short.sendall(f'{head}Content-Length: 90\r\n\r\n{{"group": '.encode())
    cut_short.shutdown(socket.SHUT_WR)
    gone.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))  # a reset, and no farewell
    gone.sendall(f"GET {home} HTTP/1.1\r\nHost: 127.0.0.1:{server.server_port}\r\n\r\n".encode())
    gone.close()
    with suppress(OSError):
        while True:  # a byte now and then, until the server ends it
            slow.sendall(b"X")
            time.sleep(0.05)
    assert silent.recv(10) == cut_short.recv(10) == b""
    assert get(server)[1] == "<p>the page</p>"
    assert (received, capfd.readouterr()) == ([], ("", ""))


def test_nobody_else_may_frame_the_page_and_its_own_policy_holds(server: OnePageServer) -> None:
    assert get(server)[0].startswith("default-src 'none'; frame-ancestors 'none'")
    kicks = practice(Bank(chapter_bank().folder), ["X12.5"], set())
    server.page = lambda: practice_page(kicks)
    assert "script-src 'sha256-" in get(server)[0]
    assert "connect-src 'self'; frame-ancestors 'none'" in get(server)[0]


def test_the_secret_is_not_on_the_command_line_of_the_browser(
    server: OnePageServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []

    def browse(url: str) -> bool:
        file = Path(urllib.request.url2pathname(url.removeprefix("file://")))
        assert file.stat().st_mode & 0o077 == file.parent.stat().st_mode & 0o077 == 0
        assert f"url={server.address}" in file.read_text()
        opened.append(url)
        return True

    monkeypatch.setattr(webbrowser, "open", browse)
    monkeypatch.setattr(server, "serve_forever", lambda: None)
    monkeypatch.setattr(OnePageServer, "server_close", lambda self: None)
    serve(server, "end", no_browser=False)
    (url,) = opened
    assert server.token not in url
    assert not Path(url.removeprefix("file://")).exists()
