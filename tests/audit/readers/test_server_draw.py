"""Programs of PrairieLearn run behind the walls: what they draw is held against the laws, and what they try costs a sentence."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from html import unescape

import pytest
from click.testing import CliRunner

from corollary.audit.examine import examine
from corollary.audit.limited_reading import LimitedReader
from corollary.audit.readers.server_draw import ServerRuns
from corollary.cli.commands import app

PAGE = '<p>A mass {{params.m}} kg.</p>\n<pl-number-input answers-name="F" suffix="N"></pl-number-input>\n'
TWO = PAGE + '<pl-number-input answers-name="p" suffix="$\\rm kg\\,m/s$"></pl-number-input>\n'
LAWS = """
- id: push
  given: {m: kg, a: m/s^2}
  laws: [F = m*a]
  asked: F
- id: fixed
  given: {m: "5 kg", a: m/s^2}
  laws: [F = m*a]
  asked: F
- id: both
  given: {m: kg, a: m/s^2, t: s}
  laws: [F = m*a, p = F*t]
  asked: [F, p in kg m/s]
- id: shot
  given: {v: km/h, alpha: deg}
  laws: [h = (v*sin(alpha))^2/(2*g)]
  convention: g = 9.8 m/s^2
  asked: h in m
"""
HEAD = "import random\nimport numpy as np\nfrom math import sin, radians, inf\n\n"
DRAWN = (
    "    m, a = random.randint(2, 9), random.choice([1.5, 2.25, 3.1])\n    data['params'].update(m=m, a=a)\n"
)
ANSWER = "    data['correct_answers']['F'] = "
SHOT = (
    "    p = data['params']\n    p['v'], p['alpha'] = float(np.random.uniform(30, 90)), np.random.randint(20, 70)\n"
    "    while p['alpha'] == 45:\n        p['alpha'] += 1\n"
)
PLACES = "    data['correct_answers']['F'] = round((p['v']/3.6*sin(radians(p['alpha'])))**2/19.6, 2)\n"
FIGURES = (
    "    data['correct_answers']['F'] = float('%.3g' % ((p['v']/3.6*sin(radians(p['alpha'])))**2/19.6))\n"
)
HONEST = [
    ("push", PAGE, DRAWN + "    if m > 5:\n        m = m + 0\n" + ANSWER + "m*a\n", ["agrees"]),
    ("push", PAGE, DRAWN + "    data['params']['a'] = f'{a:.2f}'\n" + ANSWER + "m*a\n", ["agrees"]),
    ("push", PAGE, DRAWN + "    for i in range(2): m = m + 1\n" + ANSWER + "m*a\n", ["wrong"]),
    ("both", TWO, DRAWN + "    data['params']['t'] = 2\n" + ANSWER + "m*a\n    data['correct_answers']['p'] = str(2*m*a)\n", ["agrees", "agrees"]),
    ("shot", PAGE, SHOT + PLACES, ["agrees"]),
    ("shot", PAGE, SHOT + FIGURES, ["agrees"]),
    ("shot", PAGE, SHOT + PLACES.replace("19.6", "9.8"), ["wrong"]),
]  # fmt: skip
BIG = (
    "    m, a = random.randint(1100, 1900), random.choice([1.33, 2.27, 3.11])\n    data['params'].update(m=m, a=a)\n"
    "    data['correct_answers']['F'] = float('%.3g' % (m*a))\n"
)
HONEST += [
    ("push", PAGE, BIG, ["agrees"]),  # 1230 of 1234.5 has three figures
    ("push", PAGE.replace("suffix", 'rtol="1e-5" suffix'), BIG, ["wrong"]),  # and its question refuses 1234.5
]
HOSTILE = [
    ("    import os\n    os._exit(0)\n", "os._exit"),
    ("    import ctypes\n    ctypes.string_at(0)\n", "crash in compiled code"),
    ("    open(MARK, 'w').write('x')\n", "No such file"),
    ("    data['params']['m'] = open(MARK).read()\n", "No such file"),
    ("    import prairielearn_of_nobody as pl\n", "prairielearn_of_nobody"),
    ("    raise ValueError('x' * 10**7)\n", "stopped with an error (xxx"),
    ("    data['params'].update(m='7' * 10**7, a=1)\n" + ANSWER + "1\n", "params['m']"),
    ("    data['params'].update(m=10**20000, a=1)\n" + ANSWER + "1\n", "too large"),
    ("    data['params'].update(m=1, a=inf)\n" + ANSWER + "1\n", "no finite number"),
    (DRAWN + ANSWER + "True\n", "True or False"),
    (DRAWN + ANSWER + "'m*a'\n", "is a text"),
    (DRAWN + "    data['correct_answers']['G'] = m\n", "correct_answers['F']"),
    (ANSWER + "1\n", "params['m']"),
]  # fmt: skip


@pytest.fixture(scope="module")
def servers():
    with ServerRuns(3, 1) as running:
        yield running


@pytest.fixture
def run(tmp_path, servers):
    def records(name, page, body, head=HEAD):
        folder = tmp_path / name
        folder.mkdir()
        (folder / "question.html").write_text(page, encoding="utf-8")
        (folder / "server.py").write_text(f"{head}def generate(data):\n{body}", encoding="utf-8")
        laws = tmp_path / "laws.yaml"
        laws.write_text(LAWS, encoding="utf-8")
        with LimitedReader(laws, servers) as reader:
            return reader.read(folder).records

    return records


@pytest.mark.parametrize(("name", "page", "body", "findings"), HONEST)
def test_what_is_drawn_is_held_against_the_laws(run, name, page, body, findings):
    records = run(name, page, body)
    assert [each.id for each in records] == [f"{name}, seed {seed}" for seed in (1, 2, 3)]
    for record in records:
        assert [each.finding for each in examine(record)] == findings, examine(record)


def test_a_number_of_the_laws_in_place_of_a_drawn_one_is_said(run):
    drawn = "    data['params'].update(m=7, a=2)\n" + ANSWER + "14\n"
    for record in run("fixed", PAGE, drawn):
        (outcome,) = examine(record)
        assert outcome.finding == "wrong"
        assert "m = 5 kg is from the laws' file, and the question draws 7" in outcome.why
    assert all(not record.note for record in run("push", PAGE, drawn))


@pytest.mark.parametrize(("body", "why"), HOSTILE)
def test_what_is_hostile_or_broken_costs_one_sentence(run, tmp_path, body, why):
    mark = tmp_path / "mark"
    mark.touch()
    (record,) = run("push", PAGE, body, HEAD + f"MARK = {str(mark)!r}\n")
    (outcome,) = examine(record)
    assert outcome.finding == "cannot say"
    assert why in outcome.why
    assert "\n" not in outcome.why
    assert len(outcome.why) < 300
    assert not mark.read_text()


def test_an_endless_loop_costs_one_sentence(run, monkeypatch):
    monkeypatch.setattr("corollary.audit.readers.server_draw.SECONDS", 1.0)
    (record,) = run("push", PAGE, "    while True:\n        pass\n")
    assert record.unread == "server.py was run and gave no numbers: generate ran longer than 1 s"


def test_a_shell_is_not_to_be_had(run, tmp_path):
    mark = tmp_path / "mark"
    records = run("push", PAGE, f"    import os\n    os.system('touch {mark}')\n" + DRAWN + ANSWER + "m*a\n")
    assert not mark.exists()
    assert {each.finding for record in records for each in examine(record)} <= {"cannot say", "agrees"}


def test_what_is_read_is_said_beside_what_is_run(run):
    assigned = "    m = random.randint(2, 9)\n    a = random.randint(2, 5)\n    data['params']['m'] = m\n    data['params']['a'] = a\n"
    first, *drawn = run("push", PAGE, assigned + ANSWER + "m*a\n")
    assert (first.id, first.published) == ("push", ("m*a",))
    assert len(drawn) == 3


@pytest.fixture
def question(tmp_path):
    """The arguments of the command for a question whose program leaves a mark where it can."""
    folder = tmp_path / "push"
    folder.mkdir()
    (folder / "question.html").write_text(PAGE, encoding="utf-8")
    wrong = DRAWN + "    if m:\n        m = m + 1\n" + ANSWER + "m*a\n"
    (folder / "server.py").write_text(f"{HEAD}def generate(data):\n{wrong}", encoding="utf-8")
    (tmp_path / "laws.yaml").write_text(LAWS, encoding="utf-8")
    return ["audit", str(folder), "--laws", str(tmp_path / "laws.yaml"), "--json"]


def test_the_command_runs_nothing_unasked(question, monkeypatch):
    monkeypatch.setattr(ServerRuns, "draws", None)
    done = CliRunner().invoke(app, question)
    (only,) = json.loads(done.stdout)
    assert (only["id"], only["finding"]) == ("push", "cannot say")
    assert "is not an assignment" in only["why"]
    assert "isolation" not in only


@pytest.mark.whole
def test_the_command_runs_what_it_is_asked_to(question):
    done = CliRunner().invoke(app, [*question, "--run", "--seeds", "2"])
    assert done.exit_code == 1, done.stderr
    found = json.loads(done.stdout)
    assert [(each["id"], each["finding"]) for each in found] == [
        ("push, seed 1", "wrong"),
        ("push, seed 2", "wrong"),
    ]
    assert all(re.match(r"level [123] \(.*seccomp", each["isolation"]) for each in found)


@pytest.mark.whole
def test_the_command_says_how_well_what_it_ran_was_isolated(question, tmp_path):
    page = tmp_path / "page.html"
    command = [sys.executable, "-c", "from corollary.cli.main import main; main()", *question[:-1]]
    done = subprocess.run(
        [*command, "--run", "--seeds", "1", "--report", str(page)],
        capture_output=True,
        text=True,
        timeout=300,
    )
    said = re.search(r"server\.py was run at isolation (level [123] \(.*seccomp.*\))", done.stdout)
    assert said, done.stderr
    assert said[1] in unescape(page.read_text(encoding="utf-8"))


@pytest.mark.whole
def test_the_command_refuses_without_walls(question, monkeypatch):
    from corollary.sandbox import runner
    from corollary.sandbox.isolation import Isolation

    monkeypatch.setattr(runner, "isolation_of", lambda *_: Isolation(0, "nothing holds", ("seccomp: none",)))
    done = CliRunner().invoke(app, [*question, "--run"])
    assert done.exit_code == 2
    assert "Isolation level 1 is required" in done.stderr
    allowed = CliRunner().invoke(app, [*question, "--run", "--seeds", "1", "--require-isolation", "0"])
    assert allowed.exit_code == 1, allowed.stderr
