"""Certificates: what the lemmas claim, and that Coq's kernel accepts right keys and no wrong one."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.formula.syntax import author_formula
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.verify.certificate.check import unproven
from corollary.verify.certificate.script import certificate, script

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
    found = unproven(wrong, certificate(wrong))
    assert {f"{name}_holds", f"{name}_only"} <= found
