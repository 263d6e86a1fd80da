"""What a student's process may say: frames of closed shapes, each short, all of them together bounded."""

from __future__ import annotations

import contextlib
import select
import socket
import time
from typing import Annotated, Literal, final

import msgspec

from corollary.sandbox.decode import Sent
from corollary.sandbox.result import Axes

MOST_FRAME = 4 << 20
MOST_BYTES = 48 << 20

_Words = Annotated[str, msgspec.Meta(max_length=20_000)]
_Long = Annotated[str, msgspec.Meta(max_length=MOST_FRAME)]
_Index = Annotated[int, msgspec.Meta(ge=0, le=100_000)]


class SentFigure(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    axes: Annotated[tuple[Axes | None, ...], msgspec.Meta(max_length=100)]
    picture: _Index | None


class Stream(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="stream", tag_field="output_type"):
    name: Literal["stdout", "stderr"]
    text: _Long


class Display(
    msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="display_data", tag_field="output_type"
):
    data: dict[_Words, _Long]
    metadata: dict[_Words, None]


class Result(
    msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="execute_result", tag_field="output_type"
):
    data: dict[_Words, _Long]
    metadata: dict[_Words, None]
    execution_count: _Index


class Error(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="error", tag_field="output_type"):
    ename: _Words
    evalue: _Words
    traceback: Annotated[list[_Words], msgspec.Meta(max_length=100)]


Output = Stream | Display | Result | Error


class Began(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="began", tag_field="t"):
    what: Literal["cell", "call", "picture"]
    index: _Index


class CellTold(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="cell", tag_field="t"):
    index: _Index
    status: Literal["ok", "error", "timeout"]
    error: _Words
    outputs: Annotated[list[Output], msgspec.Meta(max_length=1_000)]
    figures: Annotated[list[SentFigure], msgspec.Meta(max_length=100)]
    values: Annotated[dict[_Words, Sent], msgspec.Meta(max_length=10_000)]


class CallTold(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="call", tag_field="t"):
    index: _Index
    value: Sent
    output: _Words
    trouble: _Words


class Done(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="done", tag_field="t"):
    pictures: _Index


class PictureTold(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="picture", tag_field="t"):
    index: _Index
    png: Annotated[bytes, msgspec.Meta(max_length=MOST_FRAME)] | None
    changed: bool


class WallTest(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="trial", tag_field="t"):
    held: dict[_Words, bool]


class Broken(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="broken", tag_field="t"):
    why: _Words


Frame = Began | CellTold | CallTold | Done | PictureTold | WallTest | Broken

_decoder = msgspec.msgpack.Decoder(Frame)


class Garbled(Exception):
    """What came is not a frame, or too much of it came."""


@final
class Frames:
    """The reading end of one child's channel."""

    def __init__(self, channel: socket.socket) -> None:
        self.channel = channel
        self._waiting = bytearray()
        self._received = 0

    def read(self, until: float) -> Frame | Literal["late", "end"]:
        """The next frame; "late" when the monotonic clock reaches `until` first, "end" when there will be none.

        Raises Garbled when what came cannot be one of ours.
        """
        while True:
            length = int.from_bytes(self._waiting[:4], "big") if len(self._waiting) >= 4 else None
            if length is not None and length > MOST_FRAME:
                raise Garbled
            if length is not None and len(self._waiting) >= 4 + length:
                text = bytes(self._waiting[4 : 4 + length])
                del self._waiting[: 4 + length]
                return _decoded(text)
            if not select.select([self.channel], [], [], max(0.0, until - time.monotonic()))[0]:
                return "late"
            part = b""
            with contextlib.suppress(ConnectionError):
                part = self.channel.recv(1 << 20)
            if not part:
                return "end"
            self._received += len(part)
            if self._received > MOST_BYTES:
                raise Garbled
            self._waiting += part


def _decoded(text: bytes) -> Frame:
    try:
        return _decoder.decode(text)
    except (msgspec.DecodeError, RecursionError) as error:
        raise Garbled from error
