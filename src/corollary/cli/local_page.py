"""A page on this machine: its address printed and opened, and served until ctrl-C."""

from __future__ import annotations

import webbrowser
from contextlib import suppress

from corollary.cli.ending import say
from corollary.course.one_page_server import OnePageServer


def serve(server: OnePageServer, what: str, no_browser: bool) -> None:
    """`what` is said of the page behind its address; the server is closed at the end."""
    with server:
        print(server.address, flush=True)
        say(f"this address is for you alone; {what}")
        if not no_browser:
            webbrowser.open(server.address)
        with suppress(KeyboardInterrupt):
            server.serve_forever()
