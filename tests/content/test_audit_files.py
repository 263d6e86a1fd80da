"""Files of banks in formats that their authors chose: none is misread, most are read, and of the rest it is said why."""

from __future__ import annotations

import pytest
from tests.content.audit_files_read import FAMILIES, files_read

pytestmark = pytest.mark.whole


@pytest.mark.parametrize("family", FAMILIES)
def test_none_is_misread_and_most_are_read(family):
    found = list(files_read(family))
    assert [(each.name, each.why) for each in found if each.outcome == "misread"] == []
    assert all(each.why for each in found if each.outcome != "right")
    if family != "traps":
        assert len(found) == 20
        assert sum(each.outcome == "right" for each in found) >= 15
