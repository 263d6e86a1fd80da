"""Feedback pages, or anything else for each student, as the archive by which an LMS gives files back."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping

from corollary.render.exports import Target

DATE = (2000, 1, 1, 0, 0, 0)  # the same archive each time it is made from the same files


def write_archive(files: Mapping[str, bytes]) -> bytes:
    """A zip archive with these files, by their names in it."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as made:
        for name, each in files.items():
            info = zipfile.ZipInfo(name, DATE)
            info.compress_type, info.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            made.writestr(info, each)
    return content.getvalue()


TARGET = Target(ending="zip", feedback=write_archive)
