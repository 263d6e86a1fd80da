"""The commands of the how-to pages, run as they stand there, in the order of a term; those that are not run, with the reason."""

from __future__ import annotations

import csv
import io
import re
import shlex
import shutil
import zipfile
from pathlib import Path

import pytest

from corollary.cli.main import main

DOCS = Path(__file__).parents[2] / "docs"
TERM = [
    f"{page}.md"
    for page in (
        "howto/make_sheets",
        "howto/give_out_sheets",
        "howto/collect_hand_ins",
        "howto/grade_a_set",
        "howto/give_more_time",
        "howto/choose_when_solutions_appear",
        "howto/correct_a_problem",
        "howto/read_the_report",
        "howto/see_the_term",
        "howto/accept_misread_answers",
        "howto/see_which_questions_work",
        "howto/export_marks",
        "howto/give_feedback_back",
        "howto/make_lms_questions",
        "howto/complete_commands",
        "howto/when_something_goes_wrong",
        "howto/work_with_nbgrader",
        "howto/write_a_set",
        "howto/verify_a_problem",
        "howto/translate_a_problem",
        "howto/confirm_by_a_simulation",
        "howto/use_an_exchange",
        "howto/make_a_practice_site",
        "howto/grade_on_several_machines",
        "howto/practise",
        "howto/mark_by_hand",
        "howto/state_an_estimate",
        "assistant",
        "author",
        "explanation/proofs",
        "explanation/accuracy_and_cost",
        "reference/problem_file",
        "reference/errata",
    )
]
ELSEWHERE = {
    "howto/give_a_student_their_data.md",
    "howto/attack_your_own_machine.md",
    "howto/print_sheets.md",
    "howto/compose_a_scene.md",
    "howto/audit_an_answer_key.md",
    "howto/add_an_answer_type.md",
    "howto/write_in_the_browser.md",
    "howto/share_a_course.md",
}  # tests of their own
NOT_RUN = {
    r"--reveal": "needs a set with `reveal: by hand` (tests/cli)",
    r"--executor": "needs a Dask cluster (tests/course)",
    r"--to exchange": "needs an account for each student (tests/nbgrader)",
    r"--ids ARCHIVE": "needs an archive from Canvas (tests/clients)",
    r"--template": "needs a gradebook from Canvas (tests/clients)",
    r"--to site": "needs npm and some minutes (tests/practice)",
    r"--translate": "writes into the bank (tests/cli)",
    r"--check": "needs Coq (tests/verify)",
    r"--anew|kicking_a_ball$|verify --watch$": "verifies for minutes, or for ever",
    r"--watch|^practise|^preview|^mark (momentum_1|SET)( --section A)?$": "goes on until it is stopped",
    r"--accept ID": "needs a near miss (tests/records)",
    r"^trade": "takes minutes (tests/benchmarks)",
}
PLACES = {
    "SET": "momentum_1",
    "--cases FILE": "--cases cases.json",
    "[CODE…]": "X12.5",
    "CODE": "X12.5",
    "FOLDER": "mechanics",
    "FILE": "report.html",
    "FILE.html": "report.html",
    "NAME": "cradle",
    "--roster …": "--roster roster.csv",
    "--course …": "--course mechanics",
    "--variants 20": "--variants 2",  # the same work ten times over
}


def commands(page: str) -> list[str]:
    """Each command with arguments, without its first word: of blocks of code, then of tables and sentences."""
    text = (DOCS / page).read_text(encoding="utf-8")
    block = re.compile(r"^ *```(?:bash)?\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)
    lines = [line.strip() for each in block.findall(text) for line in each.splitlines()]
    lines += re.findall(r"`([^`\n]+)`", re.sub(r"^ *```.*?^ *```", "", text, flags=re.MULTILINE | re.DOTALL))
    named = [line.removeprefix("corollary ") for line in lines if line.startswith("corollary ")]
    return [line for line in dict.fromkeys(named) if " " in line or line in {"doctor", "list"}]


def filled(line: str) -> str:
    for name, value in PLACES.items():
        line = re.sub(rf"(?<![\w.]){re.escape(name)}(?![\w.])", value, line)
    return line.partition(" > ")[0]


def hand_in(work: Path) -> None:
    """What Moodle gives for a class in which ada has handed in: an archive of all submissions and a grading worksheet."""
    (work / "Downloads").mkdir()
    sheet = work / "mechanics" / "release" / "ada" / "momentum_1" / "momentum_1.ipynb"
    answered = sheet.read_text(encoding="utf-8").replace("X12_5_a = None", "X12_5_a = 'm*v'")
    with zipfile.ZipFile(work / "Downloads" / "submissions.zip", "w") as archive:
        archive.writestr("Ada Lovelace_11_assignsubmission_file/momentum_1.ipynb", answered)
    rows = io.StringIO()
    csv.writer(rows).writerows(
        [
            ["Identifier", "Full name", "Email address", "Status", "Grade", "Last modified (submission)"],
            ["Participant 11", "Ada Lovelace", "ada@example.org", "Submitted", "", "Friday, 4 December 2026, 10:00 AM"],
        ]
    )  # fmt: skip
    (work / "Grades.csv").write_text(rows.getvalue(), encoding="utf-8")


@pytest.mark.whole
def test_the_commands_of_the_how_to_pages_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COROLLARY_COURSE", str(tmp_path / "mechanics"))
    Path("roster.csv").write_text(
        "id,first_name,last_name,email,section,group\nada,Ada,Lovelace,ada@example.org,A,3\nbo,Bo,Boole,bo@example.org,B,3\n"
    )

    Path("cases.json").write_text('[{"answers": {"a": "m*v"}}]')

    def run(line: str) -> int:
        monkeypatch.setattr("sys.argv", ["corollary", *shlex.split(line)])
        with pytest.raises(SystemExit) as end:
            main()
        return int(end.value.code or 0)

    done, failed = list[str](), list[str]()
    for page in TERM:
        for line in commands(page):
            if not any(re.search(each, line) for each in NOT_RUN):
                asked = line.startswith(("grade", "generate")) and not re.search("--yes|--dry-run", line)
                status = run(filled(line) + " --yes" * asked)
                if status and (line, status) != ("doctor", 1):  # it found something wrong with this machine
                    failed.append(f"{page}: {line}: {status}: {capsys.readouterr().err}")
                done.append(line)
        if page == "howto/make_sheets.md":
            hand_in(tmp_path)
            Path("momentum_2.md").write_text("---\ntitle: More momentum\nproblems: [X12.4]\n---\nMore.\n")
            assert run("generate momentum_2.md --roster roster.csv --course mechanics") == 0
            Path("mechanics/submitted/ada/momentum_2").mkdir(parents=True)
            shutil.copy(
                "mechanics/release/ada/momentum_2/momentum_2.ipynb", "mechanics/submitted/ada/momentum_2"
            )
            assert run("grade momentum_2") == 0
    assert not failed, "\n".join(failed)
    assert len(done) > 60
    assert (tmp_path / "mechanics" / "feedback" / "ada" / "momentum_1" / "momentum_1.html").is_file()
    assert (tmp_path / "mechanics" / "submitted" / "ada" / "momentum_1" / "momentum_1.ipynb").is_file()


def test_no_how_to_is_left_out():
    pages = {path.relative_to(DOCS).as_posix() for path in DOCS.glob("howto/*.md")}
    assert not {page for page in pages - set(TERM) - ELSEWHERE if commands(page)}


def test_what_is_not_run_is_on_some_page():
    lines = [line for page in TERM for line in commands(page)]
    assert not [each for each in NOT_RUN if not any(re.search(each, line) for line in lines)]
