"""The page of scenes shows a ready-made scene of one's own bank that works as it stands, and the example bank has one."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import settings as examples
from hypothesis import strategies as st

from corollary.cli.commands import app
from corollary.derive.load import sources
from corollary.derive.ready_scenes import film_of, run
from corollary.problem.bank import Bank

TOP = Path(__file__).parents[2]
PAGE = (TOP / "docs" / "howto" / "compose_a_scene.md").read_text(encoding="utf-8")
MECHANICS = Bank(TOP / "examples" / "banks" / "corollary-mechanics" / "src" / "corollary_mechanics")


def test_the_scene_of_the_page_is_found_in_a_bank_and_played(tmp_path):
    (text,) = re.findall(r"```python\n(\"\"\"A stone is thrown up.*?)```", PAGE, re.DOTALL)
    for folder in ("problems", "solutions/scenes"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "solutions" / "scenes" / "thrown.py").write_text(text, encoding="utf-8")
    words = ["scene", "thrown", "--set", "t=2", "--json", "--bank", str(tmp_path)]
    played = json.loads(CliRunner().invoke(app, words, catch_exceptions=False).stdout)
    assert played["observed"]["velocities"] == pytest.approx([5.0 - 9.8 * 2.0], rel=1e-12)
    assert played["set"] == {"v": 5.0, "g": 9.8, "t": 2.0}


@given(st.floats(0.1, 1.4), st.floats(0.0, 1.5), st.floats(0.05, 20.0), st.booleans())
@examples(max_examples=25, deadline=None)
def test_a_block_on_the_example_banks_incline_moves_as_newton_says(theta, mu, t, second_way):
    found = run("slide", {"theta": theta, "mu": mu, "t": t}, second_way=second_way, bank=MECHANICS)
    pull = 9.8 * max(0.0, math.sin(theta) - mu * math.cos(theta))
    along = math.cos(theta), -math.sin(theta)
    assert found.observed["velocities"] == pytest.approx([pull * t * x for x in along], abs=1e-7 * t)
    assert found.observed["trajectory"] == pytest.approx(
        [pull * t * t / 2 * x for x in along], abs=1e-7 * t * t
    )
    assert found.error_is == ("estimate" if second_way else "bound")


def test_its_film_shows_the_slide():
    film = film_of("slide", {"m": 2.0, "theta": 0.5, "t": 1.0}, MECHANICS)
    assert film is not None
    (x, y), (u, v) = film.places[-1][0], film.velocities[-1][0]
    # Who does not ask for friction does not see any.
    assert (x, y) == pytest.approx((4.9 * math.sin(0.5) * math.cos(0.5), -4.9 * math.sin(0.5) ** 2), abs=1e-6)
    assert math.hypot(u, v) == pytest.approx(9.8 * math.sin(0.5), abs=1e-6)


@pytest.mark.parametrize("name", ["block_on_a_rough_incline", "down_a_slide"])
def test_solutions_that_play_it_change_with_it(name):
    assert MECHANICS.scenes / "slide.py" in sources(MECHANICS, MECHANICS[name])
