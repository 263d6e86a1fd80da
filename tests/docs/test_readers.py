"""The documentation as readers use it: how pages open, how many clicks lead to each, and what a search finds."""

from __future__ import annotations

import math
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from posixpath import dirname, join, normpath

import pytest
import yaml

TOP = Path(__file__).parents[2]
DOCS = TOP / "docs"
PAGES = {path.relative_to(DOCS).as_posix(): path.read_text(encoding="utf-8") for path in DOCS.rglob("*.md")}
READERS = ("instructors", "assistants", "authors", "students", "programmers")
STARTS = ("instructor.md", "assistant.md", "author.md", "student.md", "programmer.md")
KINDS = ("tutorial", "howto", "reference", "explanation", "results")
LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")
WORD = re.compile(r"[a-z]+")
COMMON = re.compile(
    "an?|and|are|at|be|by|can|do|does|for|from|has|have|how|i|in|is|it|my|not|of|on|or|that|the|to|what|when|where|which|who|why"
    "|with|your?"
)


def targets(text: str, place: str) -> set[str]:
    return {normpath(join(dirname(place), target)) for target in LINK.findall(text)}


@pytest.mark.parametrize("page", sorted(PAGES))
def test_a_page_opens_with_its_readers(page: str):
    opening = PAGES[page].partition("\n\n")[2].partition("\n\n")[0]
    assert re.match(r"\*\*For (\w+ )*", opening), opening
    assert any(each in opening for each in (*READERS, "everybody")), opening


def test_every_page_has_a_kind():
    folders = {name.partition("/")[0] for name in PAGES if "/" in name} - {"trade"}
    assert folders == set(KINDS)
    beside = {name for name in PAGES if "/" not in name}
    assert beside >= set(STARTS)
    assert beside - set(STARTS) <= {"architecture.md", "contributing.md", "changelog.md", "compared.md"}


VERB = re.compile(
    "(Accept|Add|Ask|Audit|Choose|Collect|Complete|Compose|Confirm|Connect|Correct|Distinguish|Export|Give|Grade|Make|Mark|Practise|Print"
    "|Read|See|Share|Show|State|Translate|Use|Verify|Work|Write)\\b"
)


def test_a_how_to_has_a_task_for_its_title():
    for name, text in PAGES.items():
        if name.startswith("howto/"):
            title = text.splitlines()[0].removeprefix("# ")
            assert title == "When something goes wrong" or VERB.match(title), title


def test_every_page_is_two_clicks_from_the_first():
    first = {
        name.removeprefix("docs/") for name in targets((TOP / "README.md").read_text("utf-8"), "README.md")
    }
    assert set(STARTS) <= first
    second = {target for name in first & PAGES.keys() for target in targets(PAGES[name], name)}
    assert not PAGES.keys() - first - second


def test_the_navigation_goes_by_reader_and_has_every_page():
    text = (TOP / "mkdocs.yml").read_text(encoding="utf-8")
    nav = yaml.safe_load("nav:" + text.partition("\nnav:")[2])["nav"]
    heads = [next(iter(each)) for each in nav if isinstance(each, dict)]
    assert [each.lower() for each in heads][: len(READERS)] == list(READERS)

    def leaves(node: object) -> list[str]:
        if isinstance(node, str):
            return [node]
        inner = node.values() if isinstance(node, dict) else node
        assert not isinstance(inner, str)
        return [leaf for each in inner for leaf in leaves(each)]  # type: ignore[union-attr]

    found = leaves(nav)
    assert PAGES.keys() - set(found) == {"trade/tables.md"}
    assert len(found) == len(set(found))


@dataclass(frozen=True)
class Section:
    page: str
    heading: str
    title: Counter[str]
    text: Counter[str]


def stems(text: str) -> Counter[str]:
    words = (word for word in WORD.findall(text.lower()) if not COMMON.fullmatch(word))
    return Counter(re.sub(r"(ies|es|s|ed|ing)$", "", word) if len(word) > 4 else word for word in words)


def sections() -> list[Section]:
    """Each section of each page, with the words of its headings (the page's, and its own) and of its text."""
    found: list[Section] = []
    for name, text in PAGES.items():
        text = re.sub(r"^( *)```.*?^\1```", "", text, flags=re.MULTILINE | re.DOTALL)
        title, *parts = re.split(r"^(#{1,3} .*)$", text, flags=re.MULTILINE)[1:] or [""]
        blocks = [title, *parts]
        for heading, body in zip(blocks[::2], blocks[1::2], strict=False):
            words = re.sub(r"\]\([^)]*\)", "]", body)
            found.append(Section(name, heading.lstrip("# "), stems(f"{blocks[0]} {heading}"), stems(words)))
    return found


SECTIONS = sections()
FREQUENT = Counter(word for each in SECTIONS for word in {*each.title, *each.text})


def ranked(query: str) -> list[str]:
    """Pages, best first: words weigh by rarity, and in a heading as much as six in the text."""
    asked = stems(query)

    def score(each: Section) -> float:
        length = 0.5 + sum(each.text.values()) / 200
        return sum(
            math.log(1 + len(SECTIONS) / FREQUENT[word])
            * (6 * bool(each.title[word]) + 2 * each.text[word] / (each.text[word] + length))
            for word in asked
            if FREQUENT[word]
        )

    best = sorted(SECTIONS, key=score, reverse=True)
    return list(dict.fromkeys(each.page for each in best))


# Reader, what they type, the page and the section that answers.
QUESTIONS = [
    ("instructor", "give a student more time", "howto/give_more_time.md", "Give a student more time"),
    ("instructor", "import marks into Moodle gradebook", "howto/export_marks.md", "Moodle without a template"),
    ("instructor", "wrong solution after release", "howto/correct_a_problem.md", "Correct a problem after release"),
    ("instructor", "print exam forms on paper", "howto/print_sheets.md", "Print sheets on paper"),
    ("instructor", "which files to back up", "reference/course_files.md", "`.corollary/`: back it up"),
    ("instructor", "grade on windows", "howto/grade_on_windows.md", "Grade on Windows, or in Docker"),
    ("assistant", "keys for marking answers by keyboard", "assistant.md", "Mark answers with the keyboard"),
    ("assistant", "what does follows mean verdict", "reference/verdicts.md", "Verdicts"),
    ("assistant", "answer typed wrong but right accept all", "howto/accept_misread_answers.md", "Accept misread answers"),
    ("assistant", "student says my answer is right", "assistant.md", "When a student asks"),
    ("author", "write my first problem", "tutorial/first_problem.md", "Write your first problem"),
    ("author", "differential equation", "howto/use_functions_of_time.md", "What can be solved"),
    ("author", "tolerance of a part", "reference/problem_file.md", "Parts"),
    ("author", "translate problem German", "howto/translate_a_problem.md", "Translate a problem"),
    ("author", "free-body diagram forces", "howto/ask_for_forces.md", "Ask for forces"),
    ("author", "common misconceptions list of mistakes", "reference/solution_file.md", "Mistakes"),
    ("student", "how many significant figures zeros", "reference/answers.md", "Figures and zeros: significant figures"),
    ("student", "number without a unit", "reference/answers.md", "Units, and numbers without a unit"),
    ("student", "practise with other numbers hints", "howto/practise.md", "Practise"),
    ("student", "how to write show that derivation", "howto/write_a_derivation.md", "Write a derivation"),
    ("programmer", "judge an answer from Python", "tutorial/library.md", "Judging answers"),
    ("programmer", "run the tests", "contributing.md", "Tests"),
    ("programmer", "exit status of commands", "reference/commands.md", "Commands"),
    ("programmer", "compose a simulation with a spring", "howto/compose_a_scene.md", "Compose a scene"),
    ("instructor", "canvas moodle lti", "howto/connect_an_lms.md", "Connect an LMS: Moodle or Canvas"),
    ("instructor", "limit attempts", "reference/sets_and_settings.md", "Late penalty and attempts"),
    ("instructor", "due date late penalty", "reference/sets_and_settings.md", "Late penalty and attempts"),
    ("assistant", "override grade", "howto/mark_by_hand.md", "Mark by hand, or override a grade"),
    ("assistant", "view student submissions", "howto/read_the_report.md", "Read the report: common mistakes, one student's work"),
    ("assistant", "common wrong answers", "howto/read_the_report.md", "Read the report: common mistakes, one student's work"),
    ("instructor", "regrade after fix", "howto/correct_a_problem.md", "Correct a problem after release"),
    ("author", "random numbers variants", "reference/problem_file.md", "Givens: random numbers for each student"),
    ("author", "add image", "howto/show_a_picture.md", "Show a picture or image"),
    ("author", "equivalent formula answer", "reference/answers.md", "Formulas"),
    ("student", "type square root exponent", "reference/answers.md", "Powers, roots, scientific notation, sums and words"),
    ("student", "scientific notation", "reference/answers.md", "Powers, roots, scientific notation, sums and words"),
    ("student", "significant figures", "reference/answers.md", "Figures and zeros: significant figures"),
    ("student", "wrong attempt lose points", "student.md", "When, and how many attempts"),
    ("programmer", "docker", "howto/grade_on_windows.md", "Grade on Windows, or in Docker"),
    ("programmer", "install", "contributing.md", "Set-up"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("reader", "query", "page", "section"), QUESTIONS, ids=[each[1] for each in QUESTIONS]
)
def test_a_search_finds_the_page_among_the_first_three(reader: str, query: str, page: str, section: str):
    assert any(each.page == page and each.heading == section for each in SECTIONS), section
    assert page in ranked(query)[:3]


def test_there_are_questions_of_every_reader():
    readers = Counter(each[0] for each in QUESTIONS)
    assert len(QUESTIONS) >= 20
    assert readers.keys() == {name.removesuffix(".md") for name in STARTS}
    assert min(readers.values()) >= 4
