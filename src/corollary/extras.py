"""The extras of this package, and the libraries that each brings: what to install where one is missing.

Never by our own name: on PyPI it belongs to another project.
"""

from __future__ import annotations

import re


def installing(extra: str) -> str:
    """The command that installs the libraries of an extra by their own names, as the package's metadata lists them."""
    from importlib.metadata import PackageNotFoundError, requires  # slow, and needed only for a message

    try:
        listed = requires("corollary") or []
    except PackageNotFoundError:  # run from a folder without being installed
        listed = []
    wanted = [line for line in listed if re.search(rf"extra == ['\"]{re.escape(extra)}['\"]", line)]
    names = sorted(found[0] for line in wanted if (found := re.match(r"[\w.-]+", line)))
    return (
        f"pip install {' '.join(names)}" if names else f"pip install '.[{extra}]' in Corollary's own folder"
    )
