"""`corollary trade` and `corollary verify --extremes` from the front door."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree

import pytest

from corollary.cli import trade, verify
from corollary.cli.ending import Refusal


def test_the_document(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert trade.run(["ball_on_floor"], None, True, True) == 0
    found = json.loads(capsys.readouterr().out)
    (scene,) = found["scenes"]
    assert (scene["scene"], scene["planned"], scene["cheapest"]["1e-12"]) == (
        "ball_on_floor",
        "quadrature",
        "quadrature",
    )
    assert not list(tmp_path.iterdir())  # --json alone writes nothing


def test_table_and_picture(capsys, tmp_path):
    assert trade.run(["atom bound"], tmp_path / "out", False, True) == 0
    printed = capsys.readouterr().out
    assert "| atom bound" in printed
    assert (tmp_path / "out" / "trade.md").read_text(encoding="utf-8").strip() == printed.strip()
    assert (
        json.loads((tmp_path / "out" / "trade.json").read_text(encoding="utf-8"))["scenes"][0]["ready"]
        == "atom"
    )
    drawn = ElementTree.parse(tmp_path / "out" / "atom_bound_evaluations.svg").getroot()
    assert drawn.tag == "{http://www.w3.org/2000/svg}svg"


def test_a_scene_nobody_races_on():
    with pytest.raises(
        Refusal, match="no trade is measured for a scene called 'rockets'; choose one of cradle"
    ):
        trade.run(["rockets"], None, True, True)


def test_extremes_of_one_problem(capsys):
    assert verify.run(["X12.5"], None, 1, True, extremes=True) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["ok"]
    assert found["problems"][0]["code"] == "X12.5"
    assert found["problems"][0]["certified"] > 50
    assert found["problems"][0]["worst_ulp"] <= 4.0
