"""Certificates: what the lemmas claim, and that Coq's kernel accepts right keys and no wrong one."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from corollary.cli.commands import app
from corollary.formula.syntax import author_formula
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.verify.certificate.coq import coq_name
from corollary.verify.certificate.script import (
    AXIOMS,
    OPENING,
    accepted,
    axioms,
    certificate,
    script,
    unproven,
)

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)


def solution(code: str):
    return SOLUTIONS.of(BANK[code])


def with_key(code: str, name: str, formula: str):
    """The solution with another formula for one unknown."""
    right = solution(code)
    unknowns = tuple(
        replace(find, in_givens=(author_formula(formula),)) if find.names == (name,) else find
        for find in right.unknowns
    )
    assert unknowns != right.unknowns
    return replace(right, unknowns=unknowns)


def test_a_lemma_says_what_is_given_and_what_follows():
    """A kick: the mean force is the impulse by the time, for all numbers between the bounds of the problem."""
    found = solution("X12.5")
    text = script(found, certificate(found))
    lemma = re.search(r"Lemma F_only : (.*?)Proof\.", text, re.DOTALL)
    assert lemma is not None
    stated = " ".join(lemma[1].split())
    assert "(3 / 10) <= m <= (3 / 5) ->" in stated
    assert "0 < dt ->" in stated
    assert stated.endswith("F = ((m * v) / dt) -> (F = ((m * v) / dt)).")


def test_both_roots_of_an_elastic_collision_are_in_the_claim():
    found = solution("S12.5el")
    text = script(found, certificate(found))
    assert re.search(r"\(v_A1 = .* /\\ v_B1 = .*\) \\/ \(v_A1 = vA /\\ v_B1 = 0\)", text)


def test_what_is_not_algebraic_is_named():
    found = solution("E12.5.1")
    text = script(found, certificate(found))
    assert "(* not here: the laws hold for theta_max (part d); it has acos *)" in text
    assert "Admitted" not in text
    assert "Axiom" not in text


EMPTY = """\
---
code: X1.1
title: A lever
given:
  a: {is: first force, value: 5, from: 1, to: 9, step: 1, unit: N}
  x: {is: its arm, value: 2, from: 1, to: 4, step: 1, unit: m}
require: ["a > 0", "x > 0", "a > %s N"]
---
A force {{a}} at {{x}}.

## Torque {#a .value unit="N m"}
How large is it?
"""


@pytest.mark.parametrize(("limit", "status"), [("2", 0), ("100", 1)])
def test_conditions_that_no_numbers_keep_are_complained_of(tmp_path, monkeypatch, limit, status):
    """Of no numbers everything could be proven. The letter PI is no pi."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for folder in ("problems", "solutions"):
        (tmp_path / folder / "t").mkdir(parents=True)
    (tmp_path / "problems/t/lever.md").write_text(EMPTY % limit, encoding="utf-8")
    (tmp_path / "solutions/t/lever.py").write_text(
        "from corollary.author import derivation, step, unknowns\nfrom corollary.laws import law\n"
        'def derive(a, x):\n    PI, = unknowns("PI")\n'
        '    return derivation(step(PI, "w", law("Torque", "PI = a*x"), answers="a"))\n',
        encoding="utf-8",
    )
    command = ["certify", "X1.1", "--bank", str(tmp_path), "-o", str(tmp_path / "key.v"), "--json"]
    done = CliRunner().invoke(app, command)
    assert done.exit_code == status, done.output
    assert ("the claims may be empty" in done.stderr) == bool(status)
    outcomes = [each["outcome"] for each in json.loads(done.stdout)["claims"]]
    assert outcomes == ["written", "written", "left out" if status else "written"]


def test_without_a_checker_the_script_is_written_and_checking_is_refused(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    done = CliRunner().invoke(
        app, ["certify", "X12.5", "--bank", "chapter", "-o", str(tmp_path / "kick.v"), "--json"]
    )
    assert done.exit_code == 0, done.output
    claims = json.loads(done.stdout)["claims"]
    assert {each["outcome"] for each in claims} == {"written"}
    assert (tmp_path / "kick.v").read_text(encoding="utf-8").count("Qed.") == len(claims)
    done = CliRunner().invoke(app, ["certify", "X12.5", "--bank", "chapter", "--check"])
    assert done.exit_code == 2
    assert "apt install coq" in done.stderr


def test_what_algebra_proves_and_the_kernel_does_not_is_complained_of(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr("corollary.cli.certify.checker", lambda: "a kernel")

    def one_refused(_solution, steps):
        names = [each.name for step in steps for each in step.lemmas]
        return frozenset(names[:1])

    monkeypatch.setattr("corollary.cli.certify.unproven", one_refused)
    command = ["certify", "X12.5", "--bank", "chapter", "--check", "-o", str(tmp_path / "key.v"), "--json"]
    done = CliRunner().invoke(app, command)
    assert done.exit_code == 1, done.output
    (wrong,) = [each for each in json.loads(done.stdout)["claims"] if each["outcome"] == "not proven"]
    assert "verify proves it by algebra, the kernel does not" in done.stderr
    assert done.stderr.count("the kernel does not") == 1
    assert wrong["claim"] in done.stderr
    monkeypatch.setattr("corollary.cli.certify.unproven", lambda _solution, _steps: frozenset())
    done = CliRunner().invoke(app, command)
    assert done.exit_code == 0
    assert "the kernel does not" not in done.stderr


@pytest.mark.parametrize("code", ["X12.5", "S12.5el"])
@pytest.mark.client
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed (apt install coq)")
def test_the_kernel_accepts_the_key(code, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))  # every later key would say what is on record
    done = CliRunner().invoke(
        app, ["certify", code, "--bank", "chapter", "--check", "-o", str(tmp_path / "key.v"), "--json"]
    )
    assert done.exit_code == 0, done.output
    record = json.loads(done.stdout)
    assert {each["outcome"] for each in record["claims"]} <= {"proven", "left out"}
    key = json.loads(CliRunner().invoke(app, ["key", code, "--bank", "chapter", "--json"]).stdout)
    assert key["certificate"]["sha256"] == record["sha256"]
    assert "Coq" in key["certificate"]["checker"]


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("F", "m*v*dt"),  # the force multiplied by the time
        ("F", "m*v/(2*dt)"),  # a factor
        ("dp_r", "m*(v - w)"),  # a sign
        ("dp_r", "m*v"),  # a dropped term
        ("J", "m*v + m*w/1000000"),  # too small to be seen in a number
    ],
)
@pytest.mark.client
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed (apt install coq)")
def test_the_kernel_accepts_no_wrong_key(name, formula):
    wrong = with_key("X12.5", name, formula)
    claims = {f"{name}_holds", f"{name}_only"}
    step = [each for each in certificate(wrong) if claims <= {lemma.name for lemma in each.lemmas}]
    assert len(step) == 1
    assert claims <= unproven(wrong, step)


def without_comments(text: str) -> str:
    """What Coq reads: comments nest, and a quotation mark begins a string in one and outside."""
    found, depth, place, quoted = "", 0, 0, False
    while place < len(text):
        two = text[place : place + 2]
        if quoted:
            quoted = text[place] != '"'
            place += 1
        elif two == "(*":
            depth, place = depth + 1, place + 2
        elif two == "*)" and depth:
            depth, place = depth - 1, place + 2
        else:
            quoted = text[place] == '"'
            found, place = found + ("" if depth else text[place]), place + 1
    assert not depth
    assert not quoted
    return found


WORDS = ["(", "*", ")", '"', "'", ".", " ", "\n", "\r", "\u2028", "\\", "é", "Axiom bad : False.", "Qed."]
TITLES = st.lists(st.sampled_from(WORDS)).map("".join)


@pytest.mark.whole
@given(TITLES | st.text(), TITLES)
def test_no_word_of_a_problem_is_read_as_a_command(title, claim):
    right = solution("X12.5")
    steps = certificate(right)
    other = replace(right, problem=replace(right.problem, title=title, code=f"X{claim}"))
    told = [
        replace(step, part=title, lemmas=tuple(replace(each, claim=claim) for each in step.lemmas))
        for step in steps
    ]
    said, usual = (without_comments(script(*each)).split() for each in ((other, told), (right, steps)))
    assert said == usual
    assert "Axiom" not in said


@given(st.lists(st.text(st.sampled_from("abPIRx_12θé'3b8K"), min_size=1), unique=True))
def test_two_letters_are_two_names_in_coq(letters):
    letters = [each for each in letters if each.isidentifier()]
    names = [coq_name(each) for each in letters]
    assert len({*names}) == len(letters)
    assert all(re.fullmatch(r"[A-Za-z][A-Za-z0-9_']*", each) for each in names)
    assert not {"PI", "R"} & {*names}


def test_each_lemma_tells_its_axioms_and_has_an_example():
    right = solution("X12.5")
    text = script(right, certificate(right))
    lemmas = re.findall(r"^Lemma (\S+) ", text, re.MULTILINE)
    assert re.findall(r"^Print Assumptions (\S+)\.$", text, re.MULTILINE) == lemmas
    assert "F_example" in lemmas
    assert "  exists " in text


@pytest.mark.parametrize(
    ("printed", "accepted"),
    [
        ("Closed under the global context\n", True),
        ("Axioms:\nClassicalDedekindReals.sig_forall_dec\n  : forall P : nat -> Prop,\n    P\n", True),
        ("Axioms:\nbad : False\n", False),
        ("Axioms:\nsig_forall_dec : False\n", False),  # another one of that name
    ],
)
def test_other_axioms_than_those_of_the_reals_are_seen(printed, accepted):
    assert (axioms(printed) <= AXIOMS) == accepted


@pytest.mark.client
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed (apt install coq)")
@pytest.mark.parametrize(("axiom", "holds"), [("", True), ("Axiom bad : 1 = 0.\n", False)])
def test_a_lemma_that_rests_on_another_axiom_is_not_accepted(axiom, holds):
    by = "exact bad" if axiom else "lra"
    goal = "1 = 0" if axiom else "1 + 1 = 2"
    text = f"{OPENING}{axiom}Lemma one : {goal}.\nProof. {by}. Qed.\nPrint Assumptions one.\n"
    assert accepted(text, 60) == holds
