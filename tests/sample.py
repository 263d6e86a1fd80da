"""A small problem set, one student's marked work, and a look at a page for anything that leads out of it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from textwrap import dedent

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Wrong
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet, read_set
from corollary.problem.roster import Student
from corollary.problem.variant import at
from corollary.records.marks import handed_in, rows
from corollary.records.report_model import Report, report
from corollary.sandbox.job import Axes, CellRun, DrawnLine, Figure

KICK = r"""
    ---
    code: X12.5
    title: Kicking a ball
    source: Exercise 12.5
    given:
      m:  {is: mass of the ball, value: 0.43, from: 0.30, to: 0.60, step: 0.01, unit: kg}
      v:  {is: speed after the kick, value: 20, from: 8, to: 35, step: 0.5, unit: m/s}
    figure: |
      <svg viewBox="0 0 40 20"><marker id="tip"/><line marker-end="url(#tip)"/><text>m = {{m}}</text><script>run()</script></svg>
    alt: A ball of mass {{m}} [at rest].
    ---
    A ball of mass {{m}} lies still until you kick it; it leaves at $v = {{v}}$.

    ## Momentum {#a .value unit="kg m/s" points=1}
    By how much does it change, $\Delta p$?

    ## Impulse {#b .value unit="N s" points=1}
    Which impulse acts?

    ## Energy {#c .value unit="J" points=2}
    How much energy does it have?

    ## What is kept? {#c_2 .choice points=1}
    When two balls collide,

    - (a) the momentum, $\sum p$
    - (b) nothing

    ## In words {#e .explain points=2}
    And the *Earth*?
"""
FALL = r"""
    ---
    code: P12.14
    title: A ball on the floor
    given:
      k: {is: stiffness, value: 2, from: 1, to: 9, step: 1, unit: N/m}
    ---
    The floor pushes back with

    $$F = \begin{cases} k(R-y)^{3/2} & y < R \\ 0 & y \ge R \end{cases}$$

    ## Program {#a .code .plot function="bounce(k)" points=4}
    Plot $F(t)$.

    ## Speed {#b .value unit="m/s" points=1}
    How fast is it?
"""
SET = """
    ---
    title: Momentum & impulse
    problems: [X12.5, P12.14]
    credit: {late: 0.5}
    ---
"""
PNG = b"\x89PNG\r\n\x1a\n not a real picture"


def problem_set(folder: Path) -> ProblemSet:
    """The set, written into the folder and read from there."""
    bank = Bank(folder)
    bank.sets.mkdir(parents=True)
    for name, text in {"kick.md": KICK, "fall.md": FALL, "sets/momentum.md": SET}.items():
        (bank.problems / name).write_text(dedent(text).lstrip(), encoding="utf-8")
    return read_set(bank, bank.sets / "momentum.md")


def marked(of: ProblemSet, student: str = "ada") -> Marked:
    """Work with every verdict in it: 4.5 of 12 points, one part waiting."""
    said = [
        (Right(), 1, "8.6 kg m/s", "Well done."),
        (Follows(("a",)), 1, "8.6 N s", "It follows from (a)."),
        (Mistaken("You forgot the $\\frac12$."), 0.25, "172 J", "You forgot the $\\frac12$."),
        (Unread("", blank=True), 0, "", "Nothing was handed in."),
        (
            Unmarked("a person reads this", ("names the floor",)),
            0,
            "<b>The</b> Earth\nrecoils",
            "Your teacher reads this.",
        ),
        (Slip("the sign is turned round"), 0.5, "function bounce", "The sign of $F(t)$ is turned round."),
        (
            Wrong("this is too fast"),
            0,
            "3e9 m/s",
            "Too fast <script>alert(2)</script> [here](http://example.org).",
        ),
    ]
    parts = [part for problem in of.problems for part in problem.parts]
    grades = tuple(
        PartGrade(part, verdict, part.points * share, part.points, answer, feedback)
        for part, (verdict, share, answer, feedback) in zip(parts, said, strict=True)
    )
    kick, fall = of.problems
    first = len(kick.parts)
    axes = Axes(
        "Force",
        "t (s)",
        "F (N)",
        (0, 1),
        (0, 1),
        "linear",
        "linear",
        (),
        (DrawnLine((0, 1), (0, 1), "F", "line"),),
    )
    return Marked(
        Student(student, "Ada", "Lovelace <x>"),
        (Grade(at(kick, 7), grades[:first]), Grade(at(fall, 3), grades[first:])),
        (
            CellRun("X12_5_a_answer", "ok", (), 0.1, ""),
            CellRun("P12_14_b_answer", "error", (), 0.1, "NameError: name 'x' is not defined"),
        ),
        (
            Figure("X12_5_c_2_answer", (axes,), None),
            Figure("P12_14_a_plot", (axes,), PNG),
            Figure("scratch", (), PNG),
        ),
        "namespaces and rlimits",
        "",
        0.0,
        1.0,
    )


def summary(works: Iterable[Marked], roster: Iterable[str] = ()) -> Report:
    """The report on marked work, by way of what is recorded of it."""
    works = list(works)
    return report(
        [handed_in(one) for one in works], [row for one in works for row in rows(one)], roster=roster
    )


def late(work: Marked) -> Marked:
    return replace(work, late=7500.0, late_share=0.5)


class Page(HTMLParser):
    """What a page shows, and what in it leads out of it or runs."""

    LEADS = frozenset({"href", "xlink:href", "src", "srcset", "action", "data", "poster", "background"})
    RUNS = frozenset({"script", "link", "iframe", "object", "embed", "base", "form", "image"})
    FETCHES = re.compile(r"url\(\s*['\"]?(?!['\"]?(?:#|data:font/woff2;base64,))[^)]{0,40}|@import")

    def __init__(self, text: str):
        super().__init__()
        self.tags: list[str] = []
        self.out: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.pictures: list[str] = []
        self.said: list[str] = []
        self.inside = ""
        self.feed(text)
        self.close()
        self.words = " ".join(" ".join(self.said).split())

    def handle_starttag(self, tag, attrs):
        self.inside = tag
        self.tags.append(tag)
        self.out += [tag] if tag in self.RUNS else []
        for name, value in attrs:
            value = value or ""
            self.ids += [value] if name == "id" else []
            self.links += [value[1:]] if name == "href" and value.startswith("#") else []
            self.pictures += [value] if tag == "img" and name == "alt" else []
            if name.startswith("on") or (
                name in self.LEADS and not value.startswith(("#", "data:image/png;base64,"))
            ):
                self.out.append(f"{tag} {name}={value}")
            self.out += self.FETCHES.findall(value) if name != "alttext" else []

    def handle_endtag(self, tag):
        self.inside = ""

    def handle_data(self, data):
        if self.inside == "style":
            self.out += self.FETCHES.findall(data)
        else:
            self.said.append(data)
