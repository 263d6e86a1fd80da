"""A fall through zero within a step is found where the function is not smooth, too, and wherever in the step it lies."""

import numpy as np
import pytest

from corollary.scenes.motion.path import POINTS, bracketed, first_fall


@pytest.mark.parametrize("law", [lambda x: x, lambda x: x * abs(x), lambda x: np.sign(x) * np.sqrt(abs(x))])
def test_a_fall_is_found_wherever_it_lies(law):
    draw = np.random.default_rng(4)
    for root in [0.5, 0.25, 0.375, 0.538211, *draw.uniform(0.02, 0.98, 300)]:
        for off in (0.0, 1e-17, -1e-17, 1e-15):
            at = lambda x, root=root, off=off: law(root - np.asarray(x)) + off  # noqa: E731
            found = first_fall(at, at(POINTS))
            assert found is not None, (root, off)
            left, right = bracketed(at, *found)
            assert left <= root + 1e-7
            assert root - 1e-7 <= right
            assert at(left) > 0.0 or left == right
