"""A term on one machine with accounts of their own: a teacher, two assistants, three students, and nbgrader's exchange.

Run as root: `python tests/nbgrader/team_term.py FOLDER`. The accounts exist for this process alone, in a mount namespace. Every
command runs as the account that would run it. Prints one JSON document: each step, by whom, its status, and its last line.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "adversary"))
from kernel import CLONE_NEWNS, MS_BIND, MS_PRIVATE, MS_REC, libc, mount

ACCOUNTS = {"teacher": 23001, "ta1": 23002, "ta2": 23003, "stu1": 23011, "stu2": 23012, "stu3": 23013}
TEACH, TEAM, STUDENTS = 23100, ("teacher", "ta1", "ta2"), ("stu1", "stu2", "stu3")
UMASKS = {"teacher": 0o022, "ta1": 0o077, "ta2": 0o002}
BIN = Path(sys.executable).parent
SET = "---\ntitle: One with words\ndue: 2026-03-02T12:00+00:00\nproblems: [X12.11]\n---\n"
EXCHANGE = """\
c.CourseDirectory.course_id = "mech"
c.Exchange.root = {root!r}
c.ExchangeFactory.fetch_assignment = "corollary.nbgrader.exchange.FetchOwnSheet"
c.ExchangeFactory.submit = "corollary.nbgrader.exchange.SubmitOwnSheet"
"""


@dataclass
class Step:
    who: str
    line: str
    status: int
    last: str
    seconds: float


@dataclass
class Term:
    folder: Path
    steps: list[Step] = field(default_factory=list)

    @property
    def course(self) -> Path:
        return self.folder / "team" / "mech"

    def home(self, who: str) -> Path:
        return self.folder / "home" / who

    def start(self, who: str, words: list[object], cwd: Path, **settings: object) -> subprocess.Popen[str]:
        """A command of an account, with its groups and its umask."""
        about = {"HOME": self.home(who), "PATH": f"{BIN}:/usr/bin:/bin", "USER": who, "LOGNAME": who}
        return subprocess.Popen(
            [str(each) for each in words],
            cwd=cwd,
            env={name: str(value) for name, value in about.items()} | dict(settings.pop("env", {})),  # type: ignore[arg-type]
            user=ACCOUNTS[who],
            group=ACCOUNTS[who],
            extra_groups=[TEACH] if who in TEAM else [],
            umask=UMASKS.get(who, 0o022),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **settings,  # type: ignore[arg-type]
        )

    def run(self, who: str, *words: object, cwd: Path | None = None, start: bool = True) -> str:
        """What a command printed; the step is recorded."""
        begun, program = time.monotonic(), [BIN / str(words[0]), *words[1:]] if start else list(words)
        child = self.start(who, program, cwd or (self.course if who in TEAM else self.home(who)))
        out, errors = child.communicate(timeout=600)
        lines = (out + errors).strip().splitlines() or [""]
        seconds = round(time.monotonic() - begun, 1)
        line = " ".join(map(str, words)).replace(str(self.folder), "")
        self.steps.append(
            Step(who, line, child.returncode, lines[-1][-300:].replace(str(self.folder), ""), seconds)
        )
        return out


def accounts_of_this_process(folder: Path) -> None:
    """Enter a mount namespace in which the accounts exist, and the interpreter is readable."""
    if libc.unshare(CLONE_NEWNS):
        raise SystemExit("no mount namespace")
    mount(None, "/", None, MS_REC | MS_PRIVATE)
    users = [f"{name}:x:{number}:{number}::{folder}/home/{name}:/bin/sh" for name, number in ACCOUNTS.items()]
    groups = [f"{name}:x:{number}:" for name, number in ACCOUNTS.items()]
    groups += [f"teach:x:{TEACH}:{','.join(TEAM)}", f"all:x:{TEACH + 1}:{','.join(ACCOUNTS)}"]
    for name, lines in {"passwd": users, "group": groups}.items():
        file = folder / name
        file.write_text(Path("/etc", name).read_text().rstrip("\n") + "\n" + "\n".join(lines) + "\n")
        file.chmod(0o644)
        mount(str(file), f"/etc/{name}", None, MS_BIND)
    interpreter = Path(sys.base_prefix)
    closed = [each for each in reversed(interpreter.parents) if not each.stat().st_mode & 0o001]
    if closed:
        aside = tempfile.mkdtemp()
        mount(str(interpreter), aside, None, MS_BIND | MS_REC)
        mount("open", str(closed[0]), "tmpfs", 0, "mode=755")
        interpreter.mkdir(parents=True)
        mount(aside, str(interpreter), None, MS_BIND | MS_REC)


def set_the_stage(term: Term) -> None:
    exchange, team = term.folder / "exchange", term.folder / "team"
    for place in (exchange, team):
        place.mkdir()
    exchange.chmod(0o777)
    for who, number in ACCOUNTS.items():
        home = term.home(who)
        home.mkdir(parents=True, mode=0o700)
        (home / "nbgrader_config.py").write_text(EXCHANGE.format(root=str(exchange)))
        os.chown(home, number, number)
    roster = "".join(f"{who},{who.title()},,{who}@uni.example\n" for who in STUDENTS)
    (team / "roster.csv").write_text(f"id,first_name,last_name,email\n{roster}")
    (team / "one.md").write_text(SET)
    os.chown(team, ACCOUNTS["teacher"], TEACH)
    team.chmod(0o2750)


def answer(term: Term, who: str) -> None:
    """The student writes into the cells for answers."""
    sheet = term.home(who) / "one" / "one.ipynb"
    document = json.loads(sheet.read_text())
    for cell in document["cells"]:
        text = "".join(cell["source"])
        if "*Your answer here.*" in text:
            cell["source"] = text.replace("*Your answer here.*", f"The floor takes the energy, says {who}.")
    sheet.write_text(json.dumps(document))


def secret_of_the_page(term: Term) -> dict[str, object]:
    """An assistant marks in a browser; a student reads every command line of the machine, and asks for what is found there."""
    browser = term.folder / "browser"
    browser.write_text(
        '#!/bin/sh\necho "$1" > "$HOME/opened"; cp "${1#file://}" "$HOME/page" 2>/dev/null; sleep 8\n'
    )
    browser.chmod(0o755)
    child = term.start(
        "ta1",
        [BIN / "corollary", "mark", "one"],
        term.course,
        env={"BROWSER": f"{browser} %s"},
        start_new_session=True,
    )
    assert child.stdout is not None
    address = child.stdout.readline().strip()
    token = address.rstrip("/").rpartition("/")[2]
    opened = term.home("ta1") / "opened"
    for _ in range(100):
        if opened.exists() and opened.read_text():
            break
        time.sleep(0.1)
    look = "import glob\nfor f in glob.glob('/proc/[0-9]*/cmdline'):\n  try: print(open(f).read().replace('\\0',' '))\n  except OSError: pass"
    spy = term.start("stu1", [sys.executable, "-c", look], term.home("stu1"))
    lines = spy.communicate(timeout=60)[0]
    file = opened.read_text().strip().removeprefix("file://")
    read = term.start("stu1", ["/bin/cat", file], term.home("stu1"))
    read.communicate(timeout=60)
    page = term.home("ta1") / "page"
    child.terminate()
    child.communicate(timeout=60)
    return {
        "served": bool(token),
        "browser was opened": str(browser) in lines,
        "token on a command line": token in lines,
        "file leads to the page": page.exists() and address in page.read_text(),
        "a student reads the file": read.returncode == 0,
    }


def play(term: Term) -> dict[str, object]:
    run, course = term.run, term.course
    team = course.parent
    run("teacher", "corollary", "generate", "one.md", "--roster", "roster.csv", "--course", "mech", cwd=team)
    config = course / "nbgrader_config.py"
    config.write_text(f"{config.read_text()}c.Exchange.root = {str(term.folder / 'exchange')!r}\n")
    alone = rights(run("teacher", "corollary", "doctor", "--json"))
    before = len(term.steps)
    run("ta1", "corollary", "report", "one", "--course", "mech", cwd=team)
    run("teacher", "corollary", "share", "--group", "all")
    refused = [asdict(each) for each in term.steps[before:]]
    del term.steps[before:]
    run("teacher", "corollary", "share", "--group", "teach")
    shared = rights(run("ta1", "corollary", "doctor", "--json"))
    run("teacher", "corollary", "release", "one", "--to", "exchange")
    for who in STUDENTS:
        run(who, "nbgrader", "fetch_assignment", "one")
        answer(term, who)
        run(who, "nbgrader", "submit", "one")
    run("teacher", "nbgrader", "collect", "one")
    run("ta1", "corollary", "grade", "one", "--yes")
    run("ta2", "corollary", "report", "one")
    run("ta2", "corollary", "mark", "one", "--set", "stu1/X12.11c=1.5", "--set", "stu2/X12.11c=2")
    run("ta1", "corollary", "mark", "one", "--set", "stu3/X12.11c=1")
    run("ta1", "corollary", "extend", "stu3", "one", "2026-12-31")
    run("ta2", "corollary", "grade", "one", "--regrade", "--yes")
    run("ta1", "nbgrader", "autograde", "one", "--force")
    run("teacher", "corollary", "grade", "one", "--yes")
    secret = secret_of_the_page(term)
    run("ta2", "nbgrader", "generate_feedback", "one")
    run("teacher", "nbgrader", "release_feedback", "one")
    for who in STUDENTS:
        run(who, "nbgrader", "fetch_feedback", "one")
    graded = json.loads(run("ta1", "corollary", "report", "one", "--json"))
    after = rights(run("ta2", "corollary", "doctor", "--json"))
    pages = {who: len(list(term.home(who).glob("one/feedback/**/*.html"))) for who in STUDENTS}
    barred = {}
    for who in STUDENTS:
        child = term.start(who, ["/bin/ls", course], term.home(who))
        child.communicate(timeout=60)
        barred[who] = child.returncode != 0
    return {
        "steps": [asdict(each) for each in term.steps],
        "refused": refused,
        "rights": {"alone": alone, "shared": shared, "after": after},
        "secret": secret,
        "feedback": pages,
        "students barred": barred,
        "report": graded,
        "owners": owners(course),
    }


def rights(document: str) -> list[dict[str, str]]:
    with suppress(ValueError):
        return [each for each in json.loads(document)["findings"] if each["name"] == "rights"]
    return []


def owners(course: Path) -> dict[str, int]:
    """How many files each account owns: all of the team have written."""
    names = {number: name for name, number in ACCOUNTS.items()}
    found: dict[str, int] = {}
    for path in course.rglob("*"):
        owner = names.get(path.lstat().st_uid, "another")
        found[owner] = found.get(owner, 0) + 1
    return found


def main() -> None:
    folder = Path(sys.argv[1]).resolve()
    folder.mkdir(mode=0o755)
    accounts_of_this_process(folder)
    term = Term(folder)
    set_the_stage(term)
    print(json.dumps(play(term), indent=1))
    shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
