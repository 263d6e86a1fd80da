"""Ready-made scenes of a bank: found beside its solutions, loaded when asked for, its own before the chapter's, faults by file and line."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

import corollary
from corollary.cli.commands import app
from corollary.derive.load import NotDerivable, sources
from corollary.derive.ready_scenes import definition, film_of, forget, play, ready_scenes, run
from corollary.grading.plain_key import key_of, serialized
from corollary.grading.replay import forget_scenes
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.variant import chapter
from corollary.scenes.run import BadSetting
from corollary.verify.verify import Verification

HEAD = """\
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.run import by_relative_errors
"""
STONE = (
    HEAD
    + """
def play(settings, tolerance):
    speed = one(settings, "g") * one(settings, "t")
    return by_relative_errors({"velocities": (-speed,)}, {"velocities": 2e-15}, "conservation", "it falls freely", 0, "escaped")

SCENE = SceneDefinition(
    "a stone falls",
    (Setting("g", "acceleration", "m/s^2", 9.8, above=0.0), Setting("t", "time", "s", 2.0, above=0.0)),
    play,
)
"""
)
PROBLEM = """\
---
code: X1.1
title: A stone
given:
  t: {is: time, value: 2, unit: s}
  g: {is: gravity, value: 9.8, unit: m/s^2}
---
A stone falls for {{t}}, with g = {{g}}.

## Velocity {#a .value unit="m/s"}
What is its velocity, upwards positive?
"""
MEASURED = """\
from corollary.author import derivation, simulated, unknowns


def derive(t):
    v, = unknowns("v")
    return derivation(simulated(v, "It is measured.", scene="falling_stone", settings={"t": t}, observe="velocities", answers="a"))
"""
DERIVED = """\
from corollary.author import derivation, simulate, step, unknowns
from corollary.laws import law


def derive(t, g):
    v, = unknowns("v")
    return derivation(step(v, "It falls freely.", law("Free fall", "v = -g*t"), answers="a"))


def scene(t, g, answer):
    return [simulate("falling_stone", {"t": t}, velocities=answer["a"])]
"""


def bank(folder: Path, solution: str = MEASURED, **scenes: str) -> Bank:
    files = {
        "problems/falls/stone.md": PROBLEM,
        "solutions/falls/stone.py": solution,
        **{f"solutions/scenes/{name}.py": text for name, text in scenes.items()},
    }
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    forget()
    return Bank(folder)


def test_a_file_that_holds_a_scene_is_one_of_its_name(tmp_path):
    here = bank(tmp_path, falling_stone=STONE, shared="G = 9.8\n")
    found = run("falling_stone", {"t": 3.0}, bank=here)
    assert found.observed == {"velocities": (-9.8 * 3.0,)}
    assert found.settings == {"g": 9.8, "t": 3.0}
    assert set(ready_scenes(here)) - set(ready_scenes()) == {"falling_stone"}
    with pytest.raises(BadSetting, match="must be more than 0 s"):
        run("falling_stone", {"t": -1.0}, bank=here)
    with pytest.raises(BadSetting, match=r"no scene 'falling_ston' \(did you mean falling_stone\?\)"):
        run("falling_ston", {}, bank=here)
    with pytest.raises(BadSetting, match="no scene 'falling_stone'"):
        run("falling_stone", {})
    assert play("falling_stone", {}, bank=here).measured["velocities"].condition == pytest.approx(1.0)
    assert film_of("falling_stone", {}, here) is None


def test_from_python_a_bank_is_named_by_its_folder_too(tmp_path):
    here = bank(tmp_path, falling_stone=STONE)
    for place in (here, tmp_path, str(tmp_path)):
        assert corollary.play("falling_stone", t=3.0, bank=place).observed == {"velocities": (-9.8 * 3.0,)}


def test_an_editors_lock_and_a_folder_are_no_scenes(tmp_path):
    here = bank(tmp_path, falling_stone=STONE)
    (here.scenes / ".#falling_stone.py").symlink_to("someone@somewhere.1234")
    (here.scenes / "folder.py").mkdir()
    forget()
    assert set(ready_scenes(here)) - set(ready_scenes()) == {"falling_stone"}
    assert run("falling_stone", {}, bank=here).observed == {"velocities": (-19.6,)}


def test_a_bank_has_the_chapters_scenes_too_and_its_own_before_a_namesake(tmp_path):
    here = bank(tmp_path, rocket=STONE)
    assert definition("rocket", here).meaning == "a stone falls"
    assert definition("rocket").meaning != "a stone falls"
    assert definition("rocket", chapter_bank()) is definition("rocket")
    assert run("kick", {}, bank=here).observed == run("kick", {}).observed


def test_two_banks_with_one_name_have_each_their_own(tmp_path):
    one = bank(tmp_path / "one", falling_stone=STONE)
    other = bank(tmp_path / "other", falling_stone=STONE.replace("9.8", "1.6"))
    both = Bank(one.folder, (other.folder,))
    for place in (one, other):
        found = Solutions(place).key(chapter(place["X1.1"])).truths["a"].values
        assert found == ((-19.6,) if place == one else (-3.2,))
    assert run("falling_stone", {}, bank=both).observed["velocities"] == (-19.6,)
    assert Solutions(both).key(chapter(other["X1.1"])).truths["a"].values == (-3.2,)


def test_what_lies_beside_a_scene_is_imported_at_the_top_and_within_a_function(tmp_path):
    late = STONE.replace("    speed = one", "    from shared import G\n    speed = G / 9.8 * one")
    early = "from shared import G\n" + STONE.replace("    speed = one", "    speed = G / 9.8 * one")
    here = bank(tmp_path, late=late, early=early, shared="from deeper import G\n", deeper="G = 9.8\n")
    for name in ("late", "early"):
        assert run(name, {"t": 1.0}, bank=here).observed == {"velocities": (-9.8,)}
    assert not {"shared", "deeper", "late", "early"} & sys.modules.keys()
    assert not list(tmp_path.rglob("*.pyc"))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("SCENE = (\n", "stone.py:1: is not Python"),
        ("import nothing_of_this_name\nSCENE = 1\n", "stone.py:1: cannot be loaded: ModuleNotFoundError"),
        ("SCENE = 1 / 0\n", "stone.py:1: cannot be loaded: ZeroDivisionError"),
        ("SCENE = 3\n", "stone.py: SCENE must be a SceneDefinition"),
        (STONE.replace("speed = one", "speed = three"), "stone.py:5: the scene fails: NameError"),
        (STONE.replace("speed = one", "raise SystemExit(3)\n    speed = one"), "the scene fails: SystemExit"),
        (STONE.replace("    return by", "    return\n    by"), "stone.py: play must give a Run"),
    ],
)
def test_a_fault_is_named_by_file_and_line(tmp_path, text, says):
    here = bank(tmp_path, falling_stone=text)
    with pytest.raises(NotDerivable) as refused:
        run("falling_stone", {}, bank=here)
    assert says in str(refused.value)
    assert refused.value.path == here.scenes / "falling_stone.py"
    complaints = verified(here)
    assert len(complaints) == 1
    assert says in complaints[0]
    done = CliRunner().invoke(app, ["scene", "falling_stone", "--bank", str(tmp_path)])
    assert done.exit_code != 0
    assert says in done.stderr
    assert "Traceback" not in done.stderr


def verified(here: Bank) -> list[str]:
    forget()
    whole = Verification(here, here["X1.1"], 8)
    for _ in whole.stages():
        pass
    return whole.tally.complaints


def test_numbers_beyond_doubles_are_refused_as_those_of_any_scene(tmp_path):
    here = bank(tmp_path, falling_stone=STONE.replace("speed = one", "speed = 1e400 / 0.0 * one"))
    with pytest.raises(BadSetting, match="leave the range of a computer"):
        run("falling_stone", {}, bank=here)


def test_a_scene_of_a_bank_confirms_a_derivation_or_contradicts_it(tmp_path):
    assert not verified(bank(tmp_path, DERIVED, falling_stone=STONE))
    (complaint,) = verified(bank(tmp_path, DERIVED, falling_stone=STONE.replace("9.8", "9.9")))
    assert "stone.py:11: scene falling_stone" in complaint
    assert "where the algebra says" in complaint


@pytest.mark.parametrize("solution", [MEASURED, DERIVED])
def test_the_scenes_that_a_solution_names_are_part_of_its_state(tmp_path, solution):
    dashed = bank(
        tmp_path / "dashed", solution.replace("falling_stone", "falling-stone"), **{"falling-stone": STONE}
    )
    assert dashed.scenes / "falling-stone.py" in sources(dashed, dashed["X1.1"])
    early = "from shared import G\n" + STONE
    here = bank(tmp_path, solution, falling_stone=early, shared="G = 9.8\n", other=STONE)
    names = {path.name for path in sources(here, here["X1.1"])}
    assert names == {"stone.py", "falling_stone.py", "shared.py"}
    of_the_chapter = bank(tmp_path / "more", solution.replace("falling_stone", "spheres"))
    names = set(sources(of_the_chapter, of_the_chapter["X1.1"]))
    assert {chapter_bank().scenes / "spheres.py", chapter_bank().scenes / "second_way.py"} <= names


def test_a_changed_scene_is_played_anew(tmp_path):
    here = bank(tmp_path, falling_stone=STONE)
    assert Solutions(here).key(chapter(here["X1.1"])).truths["a"].values == (-19.6,)
    path = here.scenes / "falling_stone.py"
    path.write_text(STONE.replace("9.8", "1.6"), encoding="utf-8")
    forget_scenes()
    assert Solutions(here).key(chapter(here["X1.1"])).truths["a"].values == (-3.2,)


def test_a_key_for_the_browser_does_not_say_where_the_bank_lies(tmp_path):
    here = bank(tmp_path, falling_stone=STONE)
    assert str(tmp_path) not in json.dumps(serialized(Solutions(here).key(chapter(here["X1.1"]))))


def test_a_key_for_the_browser_holds_what_the_banks_own_scene_gives(tmp_path):
    here = bank(tmp_path, falling_stone=STONE)
    back = key_of(json.loads(json.dumps(serialized(Solutions(here).key(chapter(here["X1.1"]))))))
    assert back.solution.unknowns[0].local.runs == {(2.0,): (-19.6,)}


def test_the_command_plays_and_lists_a_banks_own_scenes(tmp_path):
    bank(tmp_path, falling_stone=STONE)
    here = ["--bank", str(tmp_path), "--json"]
    played = CliRunner().invoke(
        app, ["scene", "falling_stone", "--set", "t=3", *here], catch_exceptions=False
    )
    assert json.loads(played.stdout)["observed"] == {"velocities": [-9.8 * 3]}
    listed = json.loads(CliRunner().invoke(app, ["scene", *here], catch_exceptions=False).stdout)
    usual = json.loads(CliRunner().invoke(app, ["scene", "--json"], catch_exceptions=False).stdout)
    assert [each for each in listed if each not in usual] == [
        {"scene": "falling_stone", "meaning": "a stone falls"}
    ]
    assert [each for each in listed if each in usual] == usual
    assert [each["scene"] for each in usual] == sorted(path.stem for path in chapter_bank().scenes.glob("*.py") if "SCENE =" in path.read_text(encoding="utf-8"))  # fmt: skip


def test_no_scene_is_loaded_before_it_is_asked_for():
    program = """
import sys
from corollary.derive.ready_scenes import ready_scenes, run
assert len(ready_scenes()) == 20 and "wall" in ready_scenes()
print(*sorted({"numpy", "scipy", "sympy", "flint"} & set(sys.modules)), file=sys.stderr)
run("wall", {})
print(*sorted({"numpy", "scipy", "sympy"} & set(sys.modules)), file=sys.stderr)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stderr.split() == []
