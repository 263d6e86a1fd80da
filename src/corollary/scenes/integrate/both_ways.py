"""Kernels written once, in the part of Python that numba compiles, and run both ways: plain on lists, compiled on arrays.

A module of kernels marks its functions with `kernel, module = ways(__name__)` and takes other modules of kernels from `module`.
Imported as usual it is plain Python; `compiled` loads the same file once more, under another name, for numba.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
from collections.abc import Callable, Sequence
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from corollary.extras import installing
from corollary.scenes.run import BadSetting

if TYPE_CHECKING:
    from numpy.typing import NDArray

HERE = Path(__file__).parent
SUFFIX = "_compiled"
ASKED_BY = "COROLLARY_COMPILED"
"""The environment variable that asks for compiled kernels (1) or plain ones (0)."""


def ways(name: str) -> tuple[Callable, Callable[[str], ModuleType]]:
    """For a module of this name: what its kernels are decorated with, and how it imports another module of kernels."""
    if not name.endswith(SUFFIX):
        return lambda function: function, as_written
    from numba import njit  # pyright: ignore[reportMissingImports]

    # No kernel makes an array, so none counts who still holds one (`_nrt`); that and calls that are no calls halve the time of a row of
    # three.
    return njit(cache=True, error_model="numpy", nogil=True, forceinline=True, _nrt=False), compiled  # pyright: ignore[reportCallIssue]


def as_written(module: str) -> ModuleType:
    """A module of kernels, as it is."""
    return importlib.import_module(f"{__package__}.{module}")


def compiled(module: str) -> ModuleType:
    """A module of kernels, for numba. What is compiled is kept in the user's cache folder until any of the files changes.

    Raises BadSetting when numba is not installed.
    """
    name = f"{__package__}.{module}{SUFFIX}"
    if name in sys.modules:
        return sys.modules[name]
    if importlib.util.find_spec("numba") is None:
        raise BadSetting(f"Compiled steps need numba: {installing('fast')}, or unset COROLLARY_COMPILED.")
    from numba import config  # pyright: ignore[reportMissingImports]

    from corollary.user_cache import folder

    # numba looks at the date of one file only; a kernel is made of several.
    spec = importlib.util.spec_from_loader(name, SourceFileLoader(name, str(HERE / f"{module}.py")))
    assert spec is not None
    assert spec.loader is not None
    found = sys.modules[name] = importlib.util.module_from_spec(spec)
    before, ours = config.CACHE_DIR, folder()  # pyright: ignore[reportAttributeAccessIssue]
    config.CACHE_DIR = before or (  # pyright: ignore[reportAttributeAccessIssue]
        str(ours / f"kernels-{_digest()}") if ours else ""
    )
    try:
        spec.loader.exec_module(found)
    except BaseException:
        del sys.modules[name]
        raise
    finally:
        config.CACHE_DIR = before  # pyright: ignore[reportAttributeAccessIssue]
    return found


def wanted() -> bool:
    """Whether compiled kernels are asked for."""
    return os.environ.get(ASKED_BY, "0") not in ("", "0")


def _digest() -> str:
    import hashlib

    texts = [path.read_bytes() for path in sorted(HERE.glob("*.py"))]
    return hashlib.sha256(b"".join(texts)).hexdigest()[:12]


def arrays(*rows: Sequence) -> list[NDArray]:
    """Rows of numbers or flags as compiled kernels take them."""
    import numpy as np  # here, for plain kernels need none

    return [np.array(row) for row in rows]


def room(rows: int, size: int, compiled: bool) -> Any:
    """Rows for a kernel to work in."""
    if not compiled:
        return [[0.0] * size for _ in range(rows)]
    import numpy as np

    return np.zeros((rows, size))
