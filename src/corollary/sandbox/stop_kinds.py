"""Kinds of stops: why a cell ended before its last line, by its status and the text of its error."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from corollary.sandbox.job import CellRun

Kind = Literal[
    "package", "version", "file", "network", "process", "time", "memory", "crash", "input", "exit", "magic",
    "syntax", "name", "error", "not run",
]  # fmt: skip

_NO_MODULE = re.compile(r"No module named '([^']+)'")
_HALTED = re.compile(r"import of ([\w.]+) halted")
_NO_NAME = re.compile(r"cannot import name '([^']+)' from '([^']+)'")
_NO_ATTRIBUTE = re.compile(r"module '([\w.]+)' has no attribute '([^']+)'")
_NOT_DEFINED = re.compile(r"name '([^']+)' is not defined")
_QUOTED = re.compile(r"'([^']+)'")
_MAGIC = re.compile(r"`(%[^`]+)`")
_NETWORK = (
    "URLError",
    "gaierror",
    "HTTPError",
    "ConnectionError",
    "ConnectTimeout",
    "ConnectionRefusedError",
    "RemoteDisconnected",
)
_FILES = ("FileNotFoundError", "NotADirectoryError", "IsADirectoryError")
_PROCESS = ("Operation not permitted", "can't start new thread", "Resource temporarily unavailable")
_SYNTAX = ("SyntaxError", "IndentationError", "TabError")


@dataclass(frozen=True, slots=True)
class CellStop:
    """`about` is the package, version's name, file, magic or name that it is about, else what Python says, without a class."""

    kind: Kind
    about: str = ""


def stop_of(run: CellRun) -> CellStop | None:
    """Why a cell stopped; None where it did not."""
    match run.status:
        case "ok":
            return None
        case "timeout":
            return CellStop("time")
        case "killed":
            return CellStop("memory")
        case "ended":
            return CellStop("crash", run.error)
        case "not run":
            return CellStop("not run")
        case "error":
            return stop_by(run.error)


def stop_by(error: str) -> CellStop:
    """The kind of an error such as `NameError: name 'm' is not defined`."""
    name, _, words = error.partition(":")
    words = words.strip()
    match name:
        case "ModuleNotFoundError" | "ImportError":
            if found := _NO_MODULE.search(words) or _HALTED.search(words):
                module = found[1]
                return CellStop("version" if "." in module else "package", module)
            if found := _NO_NAME.search(words):
                return CellStop("version", f"{found[2]}.{found[1]}")
            return CellStop("version", words)
        case "AttributeError" if found := _NO_ATTRIBUTE.search(words):
            return CellStop("version", f"{found[1]}.{found[2]}")
        case "NameError" if found := _NOT_DEFINED.search(words):
            return CellStop("name", found[1])
        case "MemoryError" | "_ArrayMemoryError":
            return CellStop("memory")
        case "StdinNotImplementedError":
            return CellStop("input")
        case "SystemExit":
            return CellStop("exit")
        case "UsageError":
            found = _MAGIC.search(words)
            return CellStop("magic", found[1] if found else words)
        case _ if name in _SYNTAX:
            return CellStop("syntax", words)
        case _ if name in _FILES:
            quoted = _QUOTED.search(words)
            return CellStop("file", quoted[1] if quoted else words)
        case _ if name in _NETWORK or "name resolution" in words:
            return CellStop("network")
        case _ if any(each in words for each in _PROCESS):
            return CellStop("process")
        case _:
            return CellStop("error", words)
