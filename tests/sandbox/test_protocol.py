"""Whatever a child writes, the reading end gives a frame, says it is late or over, or refuses; it never grows without bound."""

from __future__ import annotations

import socket
import time
from collections.abc import Iterator

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as some

from corollary.sandbox.protocol import (
    MOST_BYTES,
    MOST_FRAME,
    Began,
    CellFrame,
    Frames,
    Garbled,
    WorkerFrame,
    worker_frames,
)

Ends = tuple[Frames[WorkerFrame], socket.socket]


@pytest.fixture
def ends() -> Iterator[Ends]:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        yield Frames(ours, worker_frames), theirs


def framed(said: object) -> bytes:
    text = msgspec.msgpack.encode(said)
    return len(text).to_bytes(4, "big") + text


def soon() -> float:
    return time.monotonic() + 0.05


def test_frames_arrive_whole_however_they_are_cut(ends: Ends) -> None:
    frames, theirs = ends
    text = framed({"t": "began", "what": "cell", "index": 3})
    for byte in text[:-1]:
        theirs.sendall(bytes([byte]))
    assert frames.read(soon()) == "late"
    theirs.sendall(text[-1:] + text)
    assert frames.read(soon()) == Began("cell", 3) == frames.read(soon())
    theirs.close()
    assert frames.read(soon()) == "end"


@pytest.mark.parametrize(
    "sent",
    [
        (MOST_FRAME + 1).to_bytes(4, "big"),
        b"\xff\xff\xff\xff",
        (10_000).to_bytes(4, "big") + b"\x91" * 10_000,
        framed({"t": "nonsense"}),
        framed({"t": "began", "what": "cell", "index": -1}),
        framed({"t": "began", "what": "cell", "index": 1, "grade": 100}),
        framed({"t": "cell", "index": 0}),
        framed([1, 2]),
        (5).to_bytes(4, "big") + b"\xdd\xff\xff\xff\xff",
        (0).to_bytes(4, "big"),
        framed({"t": "broken", "why": "x"}).replace(b"x", b"\xff"),
        framed({"t": "probed", "held": {"x": True}}).replace(b"x", b"\xff"),
    ],
)
def test_what_is_no_frame_is_refused(ends: Ends, sent: bytes) -> None:
    frames, theirs = ends
    theirs.sendall(sent)
    with pytest.raises(Garbled):
        frames.read(soon())


LINE = {"x": [0.0], "y": [1.0], "label": "", "kind": "line"}
AXES = {
    "title": "",
    "xlabel": "t [s]",
    "ylabel": "",
    "xlim": [0.0, 1.0],
    "ylim": [0.0, 1.0],
    "xscale": "linear",
}
AXES |= {"yscale": "linear", "legend": [], "lines": [LINE]}


def cell(*figures: object) -> bytes:
    empty = {"status": "ok", "error": "", "outputs": [], "values": {}}
    return framed({"t": "cell", "index": 0, "figures": list(figures), **empty})


def test_a_forged_figure_has_no_more_curves_points_or_axes_than_a_drawn_one(ends: Ends) -> None:
    frames, theirs = ends
    theirs.sendall(cell(*[{"axes": [AXES | {"lines": [LINE] * 60}] * 20, "picture": None}] * 3))
    assert isinstance(frames.read(soon()), CellFrame)
    for axes in (
        [AXES] * 21,
        [AXES | {"lines": [LINE] * 61}],
        [AXES | {"lines": [LINE | {"x": [0.0] * 5001, "y": [0.0] * 5001}]}],
        [AXES | {"xlabel": "t" * 501}],
        [AXES | {"legend": [""] * 61}],
    ):
        ours, theirs = socket.socketpair()
        with ours, theirs:
            theirs.sendall(cell({"axes": axes, "picture": None}))
            with pytest.raises(Garbled):
                Frames(ours, worker_frames).read(time.monotonic() + 1)


@given(some.binary(min_size=1, max_size=60))
@settings(max_examples=80, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_bytes_as_a_frame_are_refused_or_read(text: bytes) -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        theirs.sendall(len(text).to_bytes(4, "big") + text)
        with pytest.raises(Garbled):
            Frames(ours, worker_frames).read(time.monotonic() + 1)


def test_all_frames_together_are_bounded(ends: Ends) -> None:
    frames, theirs = ends
    theirs.settimeout(1)
    text = framed({"t": "began", "what": "cell", "index": 0}) * 2000

    def send_too_much() -> None:
        for _ in range(MOST_BYTES // len(text) + 20):
            theirs.sendall(text)
            for _ in range(2000):
                frames.read(soon())

    with pytest.raises(Garbled):
        send_too_much()
