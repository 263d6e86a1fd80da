"""Records for the tests of the audit, written as somebody would write them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from corollary.audit.examine import examine
from corollary.audit.outcome import AuditedAnswer
from corollary.audit.record_file import records_in


@pytest.fixture
def audited(tmp_path: Path) -> Callable[[str], list[AuditedAnswer]]:
    """What is found of the records of a YAML text."""

    def found(text: str) -> list[AuditedAnswer]:
        path = tmp_path / "records.yaml"
        path.write_text(text, encoding="utf-8")
        return [outcome for record in records_in(path) for outcome in examine(record)]

    return found
