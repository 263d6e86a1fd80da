"""The commands' JSON, as the contract states it: one document on standard output, and a status that means something."""

from __future__ import annotations

import importlib
import json
import math
import shutil
from fractions import Fraction
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app

BANK = Path(__file__).parents[2] / "problems"
VERDICTS = {"right", "follows", "mistaken", "slip", "wrong", "unread", "unmarked"}
KINDS = {"value", "vector", "expression", "choice", "example", "code", "plot", "explain", "proof"}


def run(*words: object):
    """Exit status, standard output, standard error."""
    done = CliRunner().invoke(app, [str(word) for word in words], catch_exceptions=False)
    return done.exit_code, done.stdout, done.stderr


def document(*words: object):
    """The JSON document of a command that ends with 0."""
    status, out, err = run(*words, "--json")
    assert status == 0, err
    return json.loads(out, parse_constant=lambda word: pytest.fail(f"{word} is not JSON"))


@pytest.fixture
def cases(tmp_path: Path):
    """A file that holds a JSON value."""

    def written(value: object) -> Path:
        path = tmp_path / "cases.json"
        path.write_text(value if isinstance(value, str) else json.dumps(value), encoding="utf-8")
        return path

    return written


def test_list(tmp_path: Path):
    for name in ("impulse", "projects"):
        shutil.copytree(BANK / name, tmp_path / "problems" / name)
    problems = {each["code"]: each for each in document("list", "--bank", tmp_path)}
    assert {"X12.5", "X12.7", "P12.14"} <= problems.keys()
    for problem in problems.values():
        assert {
            "code",
            "name",
            "title",
            "topic",
            "source",
            "given",
            "parts",
            "variants",
            "exact",
        } <= problem.keys()
        assert problem["variants"] >= 1
        assert problem["parts"]
        for part in problem["parts"].values():
            assert set(part["kind"].split("+")) <= KINDS
            assert part["points"] > 0
            assert part["person"] is (part["kind"] == "explain")
    assert problems["X12.5"]["given"]["m"]["unit"] == "kg"
    assert problems["X12.7"]["parts"]["a"]["components"] == ["x", "y"]


def test_show_as_json():
    found = document("show", "X12.7", "--variant", "5")
    assert (found["code"], found["variant"], found["topic"]) == ("X12.7", 5, "impulse")
    assert found["printed"].keys() == found["given"].keys() == {"m", "v0", "theta", "dt"}
    assert found["parts"]["a"]["components"] == ["x", "y"]
    assert "solution" not in found
    assert "solution" in document("show", "X12.7", "--solution")
    assert document("show", "S12.0")["parts"]["a"]["kind"] == "explain"
    status, out, err = run("show", "X12.7", "--json", "--format", "md")
    assert (status, out, "leave out --format" in err) == (2, "", True)


def test_key_of_the_chapter():
    found = document("key", "X12.5", "--set", "m=0.43", "--set", "v=72 km/h")
    assert found["code"] == "X12.5"
    assert found["given"] == {"m": 0.43, "v": 20.0, "w": 20.0, "dt": 0.1}
    assert found["parts"]["a"] == {
        "value": 8.6,
        "unit": "kg*m/s",
        "expression": "m*v",
        "exact": "43/5",
        "certified": True,
    }
    assert document("key", "kicking_a_ball") == document("key", "X12.5")


def test_key_of_every_kind_of_part():
    parts = document("key", "P12.14")["parts"]
    assert len(parts["b"]["value"]) == len(parts["b"]["expression"]) == 2
    assert parts["i"]["certified"] is False
    assert 0 <= parts["i"]["error"] < 1e-9
    assert "expression" not in parts["i"]
    assert parts["k"]["rubric"]
    assert document("key", "X12.7")["parts"]["d"] == {
        "value": math.pi / 2,
        "unit": "rad",
        "expression": "pi/2",
        "certified": True,
    }


def test_key_at_the_extremes(cases):
    asked = [{"m": 1e150, "v": 1e150}, {"m": 1e-150}, {"m": 1e200, "v": 1e200}, {"m": 0}]
    huge, tiny, beyond, refused = document("key", "X12.5", "--cases", cases(asked))
    assert huge["parts"]["a"]["value"] == 1e300
    assert tiny["parts"]["a"]["value"] == pytest.approx(2e-149, rel=1e-15)
    assert beyond["parts"]["a"] == {
        "value": "inf",
        "unit": "kg*m/s",
        "expression": "m*v",
        "certified": False,
        "decimal": "1.0000000000000000e+400",
    }
    assert set(refused) == {"error"}
    assert "m > 0" in refused["error"]


def test_key_names_what_was_left_to_its_printed_value(cases):
    some, every, none = document(
        "key", "X12.5", "--cases", cases([{"m": 0.4, "dt": 0.2}, {}, {"m": 1, "v": 2, "w": 3, "dt": 4}])
    )
    assert [each["defaulted"] for each in (some, every, none)] == [["v", "w"], ["m", "v", "w", "dt"], []]
    assert some["given"]["v"] == 20.0
    assert "defaulted" not in document("key", "X12.5", "--set", "m=0.4")


def test_an_exact_rational_is_given_too():
    """Fractions in SI, one for each component; what has a root or pi in it has none."""
    assert document("key", "X12.5", "--set", "m=1/3")["parts"]["a"]["exact"] == "20/3"
    parts = {code: document("key", code)["parts"] for code in ("X12.7", "P12.14")}
    assert "exact" not in parts["X12.7"]["d"]  # pi/2
    assert isinstance(parts["P12.14"]["b"].get("exact", []), list)
    for entry in (entry for each in parts.values() for entry in each.values() if "exact" in entry):
        values = entry["value"] if isinstance(entry["value"], list) else [entry["value"]]
        written = entry["exact"] if isinstance(entry["exact"], list) else [entry["exact"]]
        assert [float(Fraction(each)) for each in written] == values
        assert entry["certified"] is True


def test_a_part_without_a_value_says_why_and_the_others_keep_theirs(cases):
    usual, empty = document("key", "X12.2", "--cases", cases([{}, {"v1": 0, "m2": 0}]))
    assert empty["parts"]["c"] == {"why": "no value for these numbers: division by zero"}
    assert [empty["parts"][part] == usual["parts"][part] for part in "abcd"] == [True, True, False, True]
    status, out, _ = run("key", "X12.2", "--set", "v1=0", "--set", "m2=0")
    assert status == 0
    assert "(c) why: no value for these numbers: division by zero" in out


@pytest.mark.parametrize("command", ["key", "judge"])
def test_one_crash_never_loses_the_batch(cases, monkeypatch, command):
    """A fault of ours is said in its own place."""
    module = importlib.import_module(f"corollary.cli.{command}")
    name = "key_record" if command == "key" else "judge"
    real, calls = getattr(module, name), iter(range(9))

    def once_broken(*words, **named):
        if next(calls) == 1:
            raise ZeroDivisionError("of our own")
        return real(*words, **named)

    monkeypatch.setattr(module, name, once_broken)
    monkeypatch.delenv("COROLLARY_DEBUG", raising=False)
    asked = [
        {"m": 0.4 + 0.1 * n} if command == "key" else {"given": {"m": 0.4}, "answers": {"a": 8}}
        for n in range(3)
    ]
    first, second, third = document(command, "X12.5", "--cases", cases(asked))
    assert "parts" in first
    assert "parts" in third
    assert set(second) == {"error"}
    assert "internal error: ZeroDivisionError: of our own" in second["error"]


@pytest.mark.parametrize(
    ("command", "bad"), [("key", {"m": -1}), ("judge", {"given": {"m": -1}, "answers": {}})]
)
def test_a_refused_case_is_answered_in_its_place_by_both_commands(cases, command, bad):
    """The batch was done, so the status is 0; a file that is no list of cases is a wrong request."""
    status, out, _ = run(command, "X12.5", "--cases", cases([bad, bad]), "--json")
    assert status == 0
    assert [set(each) for each in json.loads(out)] == [{"error"}] * 2
    for wrong in ("{", {"m": 1}):
        assert run(command, "X12.5", "--cases", cases(wrong), "--json")[0] == 2


def test_judge(cases):
    asked = [
        {"given": {"m": 0.43}, "answers": {"a": "8.6 kg m/s", "b": 8.6, "c": "0.86 N", "d": "-172 N"}},
        {"given": {}, "answers": {"a": "5 kg m/s", "b": "5 Ns", "c": 60, "d": None}},
        {"answers": {"a": "plenty"}},
        {"given": {"m": -1}, "answers": {}},
        {"given": {}, "answers": {"z": 1}},
        7,
    ]
    status, out, _ = run("judge", "X12.5", "--cases", cases(asked), "--json")
    assert status == 0  # a case that is refused is answered in its place
    first, second, third, *wrong = json.loads(out)
    assert [part["verdict"] for part in first["parts"].values()] == ["right", "right", "mistaken", "slip"]
    assert first["parts"]["c"]["mistake"]
    assert first["parts"]["d"]["slip"]
    assert first["given"]["m"] == 0.43
    assert first["points"] == pytest.approx(1 + 1 + 0.25 + 1)
    assert first["out_of"] == 5
    assert [part["verdict"] for part in second["parts"].values()] == ["wrong", "follows", "wrong", "unread"]
    assert third["parts"]["a"]["verdict"] == "unread"
    assert all(set(each) == {"error"} for each in wrong)
    for record in (first, second, third):
        for part in record["parts"].values():
            assert {"verdict", "points", "out_of", "feedback"} <= part.keys()
            assert part["verdict"] in VERDICTS
            assert part["feedback"]


def test_judge_gives_no_value_away_unless_asked(cases):
    path = cases([{"answers": {"a": "1 kg m/s", "b": "2 Ns", "c": "3 N", "d": "4 N"}}])
    (silent,) = document("judge", "X12.5", "--cases", path)
    (open_,) = document("judge", "X12.5", "--cases", path, "--reveal")
    for part, value in (("a", "8.6"), ("c", "86"), ("d", "172")):
        assert value not in silent["parts"][part]["feedback"]
        assert value in open_["parts"][part]["feedback"]


def test_judge_takes_components_and_programs(cases):
    program = "def contact():\n    return 1e9, 6.0"
    (found,) = document(
        "judge",
        "P12.14",
        "--cases",
        cases([{"answers": {"b": ["0", "1.4 m/s"], "g": [-1 / 3, 2 / 3, 2 / 3], "k": "So.", "j": program}}]),
    )
    assert {part: found["parts"][part]["verdict"] for part in "bgk"} == {
        "b": "right",
        "g": "right",
        "k": "unmarked",
    }
    assert found["parts"]["k"]["rubric"]
    assert found["parts"]["j"]["verdict"] in VERDICTS


def test_show(tmp_path: Path):
    chapter, other = run("show", "X12.5")[1], run("show", "X12.5", "--variant", "17")[1]
    assert "0.43" in chapter
    assert chapter != other
    assert run("show", "X12.5", "--student", "ada")[1] == run("show", "X12.5", "--student", "ada")[1]
    assert "impulse" in run("show", "X12.5", "--solution", "--format", "md")[1]
    status, out, _ = run("show", "X12.5", "--format", "html", "-o", tmp_path / "page.html")
    assert status == 0
    assert out == ""
    assert "<svg" in (tmp_path / "page.html").read_text()
    notebook = json.loads(run("show", "X12.5", "--format", "ipynb")[1])
    assert notebook["nbformat"] == 4


def test_scenes_and_their_settings_are_listed():
    every = {each["scene"]: each["meaning"] for each in document("scene")}
    assert every["kick"] == "a body pushed for a short time by a force of given mean"
    found = document("scene", "cradle", "--settings")
    assert (found["scene"], found["meaning"]) == ("cradle", every["cradle"])
    settings = {each.pop("name"): each for each in found["settings"]}
    assert settings["N"] == {
        "meaning": "number of balls",
        "unit": "1",
        "default": 3.0,
        "takes": "2 to 200, a whole number",
    }
    assert settings["masses"]["default"] == []
    assert "  m = 0.1 kg " in run("scene", "cradle", "--settings")[1]
    assert "ball_on_floor " in run("scene")[1]


def test_a_given_beyond_the_doubles_is_printed_as_it_was_given():
    assert "given (SI): m = 1e+400, v = 20," in run("key", "X12.5", "--set", "m=1e400")[1]
    assert "given (SI): m = 1.5e-400, v = 20," in run("key", "X12.5", "--set", "m=1.5e-400")[1]


def test_scene():
    found = document("scene", "cradle", "--set", "N=3", "--set", "q=1.5", "--tolerance", "1e-10")
    assert {
        "scene",
        "set",
        "observed",
        "error",
        "model",
        "why",
        "evaluations",
        "seconds",
        "outcome",
    } <= found.keys()
    assert found["set"]["N"] == 3
    assert len(found["observed"]["velocities"]) == 3
    assert found["error"] < 1e-8
    assert found["outcome"] == "released"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("key", "X99"), "X99"),
        (("key", "X12.5", "--set", "m=0"), "m > 0"),
        (("key", "X12.5", "--set", "m=red"), "m=red"),
        (("key", "X12.5", "--set", "q=1"), "q is not among"),
        (("key", "X12.5", "--cases", "nowhere.json"), "nowhere.json"),
        (("judge", "X12.5", "--cases", "nowhere.json"), "nowhere.json"),
        (("show", "X12.5", "--format", "docx"), "docx"),
        (("show", "X12.5", "--variant", "999999999"), "999999999"),
        (("show", "X12.5", "--student", "a", "--variant", "1"), "one of them"),
        (("show", "X12.5", "--course", "nowhere"), "is not a course"),
        (("key", "X12.5", "--set", "m=1", "--cases", "nowhere.json"), "one of them"),
        (("key", "X12.5", "--set", "=3"), "name=value"),
        (("key", ""), "empty name"),
        (("read", "v", "--names", "v", "--equals", "v", "--domain", "v=3..1"), "lower bound comes first"),
        (("read", "v", "--names", "v", "--equals", "v", "--domain", "v=nan..1"), "lower bound comes first"),
        (("grade", "momentum_1", "--course", "nowhere", "--require-isolation", "9"), "3"),
        (("scene", "nothing"), "nothing"),
        (("scene", "cradle", "--set", "N"), "name=number"),
        (("scene", "kick", "--set", "F=1", "--set", "F=2"), "F is set twice"),
        (("scene", "--set", "F=1"), "name a scene"),
        (("scene", "nothing", "--settings"), "nothing"),
        (("scene", "kick", "--settings", "--set", "F=1"), "leave out --set"),
        (("key", "X12.5", "--set", "m=1", "--set", "m=2"), "m is set twice"),
        (("list", "--bank", "/nowhere"), "nowhere"),
        (("key", "X12.5", "--no-such"), ""),
        (("no-such",), ""),
    ],
)
def test_a_request_that_is_wrong_ends_with_2_and_a_sentence(words, said):
    status, out, err = run(*words)
    assert status == 2
    assert out == ""
    assert said in err
    assert "Traceback" not in err


@pytest.mark.parametrize(
    ("text", "unit", "verdict", "value"),
    [
        ("8,6 Ns", "kg m/s", "compatible", 8.6), ("5 s", "N", "wrong dimension", 5.0), ("5", "km", "wrong dimension", 5.0),
        ("5", None, None, 5.0), ("0", "km", "compatible", 0.0), ("30°", "rad", "compatible", math.pi / 6),
    ],
)  # fmt: skip
def test_read_gives_one_of_two_verdicts_on_quantities(text, unit, verdict, value):
    found = json.loads(run("read", text, *(("--unit", unit) if unit else ()), "--json")[1])
    assert (found["status"], found["verdict"]) == ("ok", verdict)
    assert found["value"] == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("text", ["{", '{"a": 1}', "7"])
def test_a_file_that_holds_no_cases_ends_with_2(cases, text):
    status, out, err = run("judge", "X12.5", "--cases", cases(text), "--json")
    assert status == 2
    assert out == ""
    assert "cases.json" in err
