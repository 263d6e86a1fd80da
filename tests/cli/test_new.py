"""`corollary new`: what it writes verifies, and nothing is written over."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner
from tests.problem.test_pictures import png

from corollary.cli.commands import app
from corollary.derive.statements import Code
from corollary.grading.solutions import Solutions
from corollary.messages import language
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.translation import in_language
from corollary.programs import Called, Fault
from corollary.verify.verify import verify


@pytest.fixture
def said(tmp_path, monkeypatch):
    """What a command says in an empty folder: its status, standard output and standard error."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("COROLLARY_BANK", raising=False)

    def invoke(*words: str) -> tuple[int, str, str]:
        done = CliRunner().invoke(app, ["new", *words], catch_exceptions=False)
        return done.exit_code, done.stdout, done.stderr

    return invoke


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("like", [(), ("--like", "X12.5"), ("--like", "kicking_a_ball")])
def test_what_is_written_verifies(said, tmp_path, like):
    status, out, _ = said("Q1", "sliding_box", "--bank", "mine", *like)
    assert status == 0
    assert "corollary verify --watch Q1 --bank mine" in out
    bank = Bank(tmp_path / "mine")
    problem = bank["Q1"]
    assert (problem.name, problem.title) == ("sliding_box", "Sliding box")
    assert problem.topic == ("impulse" if like else "exercises")
    checked = verify(bank, problem, 20)
    assert not checked.complaints
    assert checked.checks["mistakes"] >= 2 * sum(part.answer_type == "value" for part in problem.parts) > 0
    assert checked.checks["variants walked"] == 20


def test_a_copy_takes_its_programs_along(said, tmp_path):
    assert said("Q2", "floor", "--bank", "mine", "--like", "P12.14")[0] == 0
    bank, chapter = Bank(tmp_path / "mine"), chapter_bank()
    problem, model = bank["Q2"], chapter["P12.14"]
    beside = chapter.solution(model).with_suffix("")
    assert files(bank.solution(problem).with_suffix("")).keys() >= {path.name for path in beside.glob("*.py")}
    assert f"`{model.name}/" not in bank.solution(problem).read_text(encoding="utf-8")
    assert problem.source == "after P12.14"
    assert problem.parts[0].text == model.parts[0].text


def test_a_copy_takes_along_what_its_judges_import_and_say(said, tmp_path):
    """Two ions and two spheres share a file beside their solutions; what judges say is translated in the bank."""
    assert said("Q2", "collisions/my_ions", "--bank", "mine", "--like", "T12.6")[0] == 0
    assert said("Q3", "collisions/my_spheres", "--bank", "mine", "--like", "S12.6")[0] == 0
    bank = Bank(tmp_path / "mine")
    (program,) = (each for each in Solutions(bank).of(bank["Q2"]).entries if isinstance(each, Code))
    calls = [Called(each, (1.0,)) for each in program.inputs({}, lambda low, high: (low + high) / 2)]
    with language("de"):
        fault = program.judge({}, calls)
    assert fault == Fault(
        "Sie gibt eine Zahl zurück; gib die vier Geschwindigkeiten v_Ax, v_Ay, v_Bx, v_By zurück."
    )
    plain = said("Q4", "impulse/kick", "--bank", "other", "--like", "X12.5")
    assert plain[0] == 0
    assert not (tmp_path / "other" / "solutions" / "locale").exists()


def test_a_copy_takes_its_pictures_along(said, tmp_path):
    said("Q1", "rides/box", "--bank", "mine")
    model, raw = tmp_path / "mine" / "problems" / "rides" / "box.md", png()
    model.write_text(model.read_text() + "\n![a box](box.png)\n")
    model.with_name("box.png").write_bytes(raw)
    assert said("Q2", "other/case", "--bank", "mine", "--like", "Q1")[0] == 0
    copy = tmp_path / "mine" / "problems" / "other" / "box.png"
    assert copy.read_bytes() == raw
    copy.write_bytes(raw + b"other")
    status, _, err = said("Q3", "other/third", "--bank", "mine", "--like", "Q1")
    assert (status, "another picture" in err) == (2, True)
    assert not copy.with_name("third.md").exists()


def test_the_topic_is_the_one_named_or_that_of_the_neighbour(said, tmp_path):
    for code, name in (
        ("Q5", "optics/lens"),
        ("Q7", "heat/kettle"),
        ("Q6", "mirror"),
        ("Q8", "oven"),
        ("Q1", "first"),
    ):
        assert said(code, name, "--bank", "mine")[0] == 0
    topics = {problem.code: problem.topic for problem in Bank(tmp_path / "mine")}
    assert topics == {"Q1": "optics", "Q5": "optics", "Q6": "optics", "Q7": "heat", "Q8": "heat"}


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("Q1", "other"), "has the code Q1 already"),
        (("q1", "other"), "has the code Q1 already"),
        (("Q2", "sliding_box"), "sliding_box.md exists already"),
        (("Q2", "elsewhere/sliding_box"), "sliding_box.md exists already"),
        (("Q 2", "other"), "Q 2 is not a valid code"),
        (("Q2", "../other"), "is not a valid file name"),
        (("Q2", "a/b/other"), "is not a valid file name"),
        (("Q2", "other", "--like", "X99"), "no problem is called X99"),
        (("Q2", "other", "--bank", "a_file"), "is a file; a bank is a folder"),
    ],
)
def test_nothing_is_written_over(said, tmp_path, words, sentence):
    assert said("Q1", "sliding_box", "--bank", "mine")[0] == 0
    (tmp_path / "a_file").write_text("")
    before = files(tmp_path)
    status, out, err = said("--bank", "mine", *words) if "--bank" not in words else said(*words)
    assert (status, out) == (2, "")
    assert sentence in err
    assert files(tmp_path) == before


def test_a_solution_without_its_problem_stays(said, tmp_path):
    left = tmp_path / "mine" / "solutions" / "exercises" / "lens.py"
    left.parent.mkdir(parents=True)
    left.write_text("# mine", encoding="utf-8")
    status, _, err = said("Q1", "lens", "--bank", "mine")
    assert (status, left.read_text(encoding="utf-8")) == (2, "# mine")
    assert "lens.py exists already" in err


def test_where_no_bank_is_named(said, tmp_path, monkeypatch):
    status, _, err = said("Q1", "lens")
    assert status == 2
    assert "say with --bank FOLDER" in err
    monkeypatch.setenv("COROLLARY_BANK", str(tmp_path / "named"))
    status, out, _ = said("Q1", "lens", "--json")
    written = json.loads(out)
    assert (status, Path(written["problem"])) == (
        0,
        tmp_path / "named" / "problems" / "exercises" / "lens.md",
    )
    assert Path(written["solution"]).is_file()
    monkeypatch.delenv("COROLLARY_BANK")
    monkeypatch.chdir(tmp_path / "named")
    assert said("Q2", "mirror")[0] == 0
    assert (tmp_path / "named" / "problems" / "exercises" / "mirror.md").is_file()


def test_a_translation_is_begun_with_every_text_and_verify_names_what_is_left(said, tmp_path):
    assert said("Q1", "ride", "--bank", "mine")[0] == 0
    status, out, _ = said("--translate", "Q1", "fr", "--bank", "mine")
    path = tmp_path / "mine" / "problems" / "exercises" / "ride.fr.md"
    assert (status, "ride.fr.md" in out) == (0, True)
    bank = Bank(tmp_path / "mine")
    left = [each for each in verify(bank, bank["Q1"], 5).complaints if each.startswith("ride.fr.md:")]
    assert "ride.fr.md:1: the statement is still that of the original; translate it" in left
    text = path.read_text(encoding="utf-8")
    line = text.splitlines().index("> length of the way") + 1
    assert f"ride.fr.md:{line}: nothing stands below > length of the way; translate it there" in left
    with language("fr"):
        assert in_language(bank["Q1"]).statement == bank["Q1"].statement
    own = re.sub(r"^> .*$", lambda found: f"{found[0]}\nEn français.", text, flags=re.MULTILINE)
    own = re.sub(r"^(You|How|What|Somebody) ", "Alors ", own, flags=re.MULTILINE).replace(
        'alt: "A', 'alt: "Un'
    )
    path.write_text(own, encoding="utf-8")
    assert verify(bank, bank["Q1"], 5).complaints == ()
    status, _, err = said("--translate", "Q1", "fr", "--bank", "mine")
    assert (status, "is there already" in err) == (2, True)
    assert said("--translate", "Q1", "french", "--bank", "mine")[0] == 2
