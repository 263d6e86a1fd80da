"""Judges stated by a formula: what cannot be read is named with its line and what to write there."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.problem.bank import Bank, find

BANK = Path(__file__).parents[1] / "author" / "bank"
PLACE = "solutions/motion/braking.md"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("`place(v, a, t) = v*min", "`v*min", "write the function as it is called, and what it returns"),
        ("- drawn: `a` from", "- drawn: `b` from", "b is no argument of the function; its arguments are v, a, t"),
        ("`10 m/s` to `40 m/s`", "`40 m/s` to `10 m/s`", "40 m/s is not below 10 m/s; the smaller number comes first"),
        ("- drawn: `a` from `2 m/s^2` to `9 m/s^2`\n", "", "say from where to where a is drawn: drawn: `a` from"),
        ("`10 m/s` to", "`10 parsnips` to", "'10 parsnips' is no quantity"),
        ("(v, a, t) = v*min", "(v, a, t) = q*min", "what does q mean in"),
        ("place(v, a, t) =", "where(v, a, t) =", 'asks for function="place(v, a, t)", and where(v,a,t) is judged'),
        ("against `t` from", "over `t` from", "write it as in `v - a*t` against `t` from `0` to `v/a`"),
        ("- axes: `t [s]`, `v [m/s]`", "- axes: `t [s]`", "say what each axis shows, with its SI unit"),
        ("slope `2*a`, intercept", "slope `2*k`, intercept", "what does k mean in '2*k'"),
        ("within: 3 %", "within: 3", "write a share in per cent, such as within: 2 %"),
        ("rolls back after it has stopped. `v - a*t`", "rolls back after it has stopped.", "one formula between backticks"),
        ("- within: 3 %", "- drawn: `a` from `1` to `2`", "an item that begins with 'drawn' has no place here"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_said_with_its_line(tmp_path, old, new, words):
    for name in ("problems/motion/braking.md", PLACE):
        text = (BANK / name).read_text(encoding="utf-8")
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text.replace(old, new, 1) if name == PLACE else text, encoding="utf-8")
    assert old in (BANK / PLACE).read_text(encoding="utf-8")
    with pytest.raises(NotDerivable) as fault:
        solve(Bank(tmp_path), find(Bank(tmp_path), "ONE.6"))
    assert words in fault.value.sentence
    assert fault.value.line > 2
