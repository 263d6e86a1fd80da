"""Every example in docs/howto/compose_a_scene.md does what it prints."""

import doctest
from pathlib import Path

DOCS = Path(__file__).parent.parent.parent / "docs" / "howto" / "compose_a_scene.md"


def test_the_examples_for_scenes_do_what_they_print():
    found = doctest.testfile(str(DOCS), module_relative=False, report=True)
    assert found.attempted > 20
    assert found.failed == 0
