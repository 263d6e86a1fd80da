"""Rights of files in the exchange: what was opened for one account is ordinary again in a copy."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from corollary.nbgrader.exchange import _unreadable, access_list, make_ordinary

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="access lists of Linux")


@pytest.mark.parametrize("umask", [0o022, 0o027, 0o077])
def test_a_copy_has_no_list_and_the_rights_of_the_umask(tmp_path: Path, umask: int) -> None:
    sheet = tmp_path / "sheet"
    (sheet / "more").mkdir(parents=True)
    (sheet / "more" / "one.ipynb").write_text("{}")
    for place in (sheet, sheet / "more", sheet / "more" / "one.ipynb"):
        place.chmod(0o700)
        os.setxattr(place, "system.posix_acl_access", access_list(12345, 5))
    os.setxattr(sheet, "system.posix_acl_default", access_list(12345, 5))
    copy = tmp_path / "copy"
    shutil.copytree(sheet, copy)
    assert "system.posix_acl_access" in os.listxattr(copy / "more" / "one.ipynb")
    before = os.umask(umask)
    try:
        make_ordinary(copy)
    finally:
        os.umask(before)
    for place in (copy, copy / "more", copy / "more" / "one.ipynb"):
        assert not [each for each in os.listxattr(place) if "acl" in each]
        assert place.stat().st_mode & 0o777 == (0o755 if place.is_dir() else 0o644) & ~umask


def test_what_leads_elsewhere_is_found(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "one.ipynb").write_text("{}")
    assert list(_unreadable(str(tmp_path))) == []
    (tmp_path / "sub" / "link.ipynb").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "pipe")
    assert {os.path.basename(each) for each in _unreadable(str(tmp_path))} == {"link.ipynb", "pipe"}
