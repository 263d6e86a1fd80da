"""The outside world: nbgrader, pages, paper."""
