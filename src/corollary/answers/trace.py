"""Trace of a reading: the stages an answer's text went through, what each took and what it left."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ReadingStage:
    """One stage: its name, the text it took, and what it left to the next."""

    stage: str
    took: str
    left: str


_stages: ContextVar[list[ReadingStage] | None] = ContextVar("stages", default=None)


@contextmanager
def recorded() -> Generator[list[ReadingStage]]:
    """Record the stages of the readings within."""
    stages: list[ReadingStage] = []
    token = _stages.set(stages)
    try:
        yield stages
    finally:
        _stages.reset(token)


@contextmanager
def silent() -> Generator[None]:
    """Record nothing of the readings within: those of a side, or that were tried and not taken."""
    token = _stages.set(None)
    try:
        yield
    finally:
        _stages.reset(token)


def took(stage: str, text: str, left: str) -> None:
    """Note what a stage took, where somebody records."""
    if (stages := _stages.get()) is not None:
        stages.append(ReadingStage(stage, text.strip(), left.strip()))
