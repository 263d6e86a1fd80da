"""The name of this distribution and its version."""

from __future__ import annotations

from pathlib import Path

DISTRIBUTION = "corollary-physics"  # what pip installs; `corollary` is the import and the command
__version__ = "1.1.0.dev0"  # of a release its own; between two the next one's, with .dev0


def full_version() -> str:
    """The version with the commit that it was made from, `1.1.0.dev0+3add5307`; that of a release is the version alone.

    The commit is that of the checkout, or what the installed package or the source distribution was named by when it was built.
    """
    if "dev" not in __version__:
        return __version__
    top = Path(__file__).resolve().parents[2]
    if (top / "pyproject.toml").is_file():
        commit = _commit(top)
        return f"{__version__}+{commit}" if commit else _built(top / "PKG-INFO")
    from importlib.metadata import PackageNotFoundError, version

    try:
        found = version(DISTRIBUTION)
    except PackageNotFoundError:
        return __version__
    return found if found.startswith(__version__) else __version__


def _commit(top: Path) -> str:
    """The short hash of a checkout's commit; nothing without one, or without git."""
    if not (top / ".git").exists():
        return ""
    import subprocess  # only here: every command asks for `__version__`, and none but --version and doctor for more

    line = ["git", "-C", str(top), "rev-parse", "--short=8", "HEAD"]
    try:
        done = subprocess.run(line, capture_output=True, encoding="utf-8", timeout=10, check=True)
    except (OSError, subprocess.SubprocessError):
        return ""
    return done.stdout.strip()


def _built(about: Path) -> str:
    """The version in the file that a source distribution has; the bare one where there is none."""
    if not about.is_file():
        return __version__
    for line in about.read_text(encoding="utf-8").splitlines():
        if line.startswith("Version: "):
            return line.removeprefix("Version: ").strip()
    return __version__
