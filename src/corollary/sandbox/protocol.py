"""Messages of a zygote and its workers: length-prefixed MessagePack frames of closed shapes, and tagged data, checked on arrival."""

from __future__ import annotations

import contextlib
import select
import socket
import time
from typing import Annotated, Generic, Literal, TypeVar, final

import msgspec

from corollary.formula.value import Value
from corollary.sandbox.job import Axes
from corollary.sandbox.tagged import refused, value_of

_Hex = Annotated[str, msgspec.Meta(min_length=1, max_length=25_002, pattern=r"^-?[0-9a-f]+$")]
_TaggedWords = Annotated[str, msgspec.Meta(max_length=10_000)]
_Length = Annotated[int, msgspec.Meta(ge=0, le=1 << 40)]


class EncodedNothing(msgspec.Struct, array_like=True, tag="nothing", frozen=True, forbid_unknown_fields=True):
    pass


class EncodedReal(msgspec.Struct, array_like=True, tag="real", frozen=True, forbid_unknown_fields=True):
    value: float


class EncodedExact(msgspec.Struct, array_like=True, tag="exact", frozen=True, forbid_unknown_fields=True):
    numerator: _Hex
    denominator: _Hex


class EncodedComplex(msgspec.Struct, array_like=True, tag="complex", frozen=True, forbid_unknown_fields=True):
    real: float
    imaginary: float


class EncodedText(msgspec.Struct, array_like=True, tag="text", frozen=True, forbid_unknown_fields=True):
    text: _TaggedWords


class EncodedMeasured(
    msgspec.Struct, array_like=True, tag="measured", frozen=True, forbid_unknown_fields=True
):
    value: float
    unit: _TaggedWords


class EncodedItems(msgspec.Struct, array_like=True, tag="items", frozen=True, forbid_unknown_fields=True):
    items: Annotated[list[Encoded], msgspec.Meta(max_length=20_000)]
    shape: Annotated[list[_Length], msgspec.Meta(max_length=64)]


class EncodedNamed(msgspec.Struct, array_like=True, tag="named", frozen=True, forbid_unknown_fields=True):
    names: Annotated[list[Annotated[str, msgspec.Meta(max_length=100)]], msgspec.Meta(max_length=20)]
    items: Annotated[list[Encoded], msgspec.Meta(max_length=20)]


class EncodedRefused(msgspec.Struct, array_like=True, tag="refused", frozen=True, forbid_unknown_fields=True):
    word: _TaggedWords
    what: _TaggedWords
    excerpt: _TaggedWords


Encoded = (
    EncodedNothing
    | EncodedReal
    | EncodedExact
    | EncodedComplex
    | EncodedText
    | EncodedMeasured
    | EncodedItems
    | EncodedNamed
    | EncodedRefused
)


def to_value(encoded: Encoded) -> Value:
    """The value itself; what contradicts itself, or is nested too deeply, is refused."""
    try:
        return value_of(msgspec.to_builtins(encoded))
    except RecursionError:
        return refused("nesting")


MOST_FRAME = 4 << 20
MOST_BYTES = 48 << 20  # of one notebook: 2 000 cells with their outputs and 40 pictures fit easily

_Words = Annotated[str, msgspec.Meta(max_length=20_000)]
_Long = Annotated[str, msgspec.Meta(max_length=MOST_FRAME)]
_Index = Annotated[int, msgspec.Meta(ge=0, le=100_000)]


class FigureFrame(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    axes: Annotated[tuple[Axes | None, ...], msgspec.Meta(max_length=20)]
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
    what: Literal["cell", "call", "again", "picture"]
    index: _Index


class CellFrame(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="cell", tag_field="t"):
    index: _Index
    status: Literal["ok", "error", "timeout"]
    error: _Words
    outputs: Annotated[list[Output], msgspec.Meta(max_length=1_000)]
    figures: Annotated[list[FigureFrame], msgspec.Meta(max_length=20)]
    values: Annotated[dict[_Words, Encoded], msgspec.Meta(max_length=10_000)]
    again: bool = False


class CallFrame(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="call", tag_field="t"):
    index: _Index
    value: Encoded
    output: _Words
    trouble: Literal["", "missing", "no function", "raised", "late"]
    error: _Words
    again: bool = False


class Done(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="done", tag_field="t"):
    """All cells and calls have been run; so many pictures may still follow."""

    pictures: _Index


class PictureFrame(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="picture", tag_field="t"):
    index: _Index
    png: Annotated[bytes, msgspec.Meta(max_length=MOST_FRAME)] | None
    changed: bool


class Probed(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="probed", tag_field="t"):
    held: dict[_Words, bool]


class Broken(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="broken", tag_field="t"):
    why: _Words


WorkerFrame = Began | CellFrame | CallFrame | Done | PictureFrame | Probed | Broken


class Ready(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="ready", tag_field="t"):
    """A zygote can fork: the layers it could not have and why, the user its workers run as (None: its own), its size."""

    missing: dict[str, str]
    namespaces: bool
    user: int | None
    threads: int
    kilobytes: int


class Exited(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag="exited", tag_field="t"):
    """A worker's exit status, or 128 and the number of the signal that killed it."""

    code: int


ZygoteFrame = Ready | Exited

_Frame = TypeVar("_Frame")
worker_frames = msgspec.msgpack.Decoder(WorkerFrame)
zygote_frames = msgspec.msgpack.Decoder(ZygoteFrame)


class Garbled(Exception):
    """What arrived is not a frame, or too much of it arrived."""


def send(channel: socket.socket, message: object) -> None:
    """One frame; raises OSError when nobody reads any more."""
    text = msgspec.msgpack.encode(message)
    channel.sendall(len(text).to_bytes(4, "big") + text)


@final
class Frames(Generic[_Frame]):
    """The reading end of one channel; `most_bytes` bounds all that it reads in its life."""

    def __init__(
        self,
        channel: socket.socket,
        decoder: msgspec.msgpack.Decoder[_Frame],
        most_bytes: float = MOST_BYTES,
    ) -> None:
        self.channel = channel
        self._decoder = decoder
        self._most_bytes = most_bytes
        self._buffer = bytearray()
        self._received = 0

    def read(self, until: float) -> _Frame | Literal["late", "end"]:
        """The next frame; "late" when the monotonic clock reaches `until` first, "end" when there will be none.

        Raises Garbled when what arrived cannot be a frame.
        """
        while True:
            length = int.from_bytes(self._buffer[:4], "big") if len(self._buffer) >= 4 else None
            if length is not None and length > MOST_FRAME:
                raise Garbled
            if length is not None and len(self._buffer) >= 4 + length:
                text = bytes(self._buffer[4 : 4 + length])
                del self._buffer[: 4 + length]
                return self._decoded(text)
            if not select.select([self.channel], [], [], max(0.0, until - time.monotonic()))[0]:
                return "late"
            part = b""
            with contextlib.suppress(ConnectionError):
                part = self.channel.recv(1 << 20)
            if not part:
                return "end"
            self._received += len(part)
            if self._received > self._most_bytes:
                raise Garbled
            self._buffer += part

    def _decoded(self, text: bytes) -> _Frame:
        try:
            return self._decoder.decode(text)
        except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
            raise Garbled from error
