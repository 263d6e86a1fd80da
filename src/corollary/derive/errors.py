"""What is wrong with an author's solution: a sentence with file and line."""

from __future__ import annotations

from pathlib import Path


class NotDerivable(Exception):
    """A solution that does not derive what it should; says where and what to do."""

    def __init__(self, path: Path, line: int, sentence: str):
        self.path, self.line, self.sentence = path, line, sentence
        super().__init__(f"{path.name}:{line}: {sentence}" if line else f"{path.name}: {sentence}")

    def __reduce__(self):
        """So that it can be raised in one process and told in another."""
        return NotDerivable, (self.path, self.line, self.sentence)
