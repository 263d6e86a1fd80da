"""nbgrader's own exchange with several users of one machine, as JupyterHub has them: each gets the own sheet and no other."""

from __future__ import annotations

import json
import os
import pwd
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from tests import forked

pytest.importorskip("nbgrader")

from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.nbgrader.exchange import access_list, open_for
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.files import BESIDE

pytestmark = [
    pytest.mark.whole,
    pytest.mark.usefixtures("open_to_everybody"),
    pytest.mark.skipif(os.geteuid() != 0, reason="only root can act as several users"),
]
SET = "---\ntitle: One exercise\nproblems:\n  - X12.5\n---\nOne exercise.\n"
NBGRADER = Path(sys.executable).with_name("nbgrader")
COROLLARY = NBGRADER.with_name("corollary")
ORDINARY_USER = Path(__file__).parents[1] / "adversary" / "ordinary_user.py"
# Accounts that every Debian has: no user is made for a test.
ADA, BEN, TEACHER = (pwd.getpwnam(name) for name in ("daemon", "games", "bin"))
HUB = """\
c = get_config()
c.CourseDirectory.course_id = "course"
c.Exchange.root = {root!r}
c.ExchangeFactory.fetch_assignment = "corollary.nbgrader.exchange.FetchOwnSheet"
c.ExchangeFactory.submit = "corollary.nbgrader.exchange.SubmitOwnSheet"
"""


@dataclass(frozen=True, slots=True)
class Hub:
    folder: Path

    @property
    def course(self) -> Path:
        return self.folder / "course"

    @property
    def outbound(self) -> Path:
        return self.folder / "exchange" / "course" / "outbound" / "one"

    def home(self, who: pwd.struct_passwd) -> Path:
        return self.folder / who.pw_name

    def run(
        self,
        who: pwd.struct_passwd | None,
        *words: object,
        program: Path = NBGRADER,
        umask: int = 0o022,
        started: bool = False,
    ) -> subprocess.CompletedProcess[str]:
        """A command of nbgrader's or ours, by a student or by the instructor, who is root or an account; started as the
        program that it is, or forked."""
        home = self.course if who in (None, TEACHER) else self.home(who)
        about = {"HOME": home, "PATH": os.environ["PATH"], "PYTHONDONTWRITEBYTECODE": "1", "TMPDIR": home}
        environment = {name: str(value) for name, value in about.items()}
        by, account = [], None if who is None else who.pw_uid
        if started and account is not None:
            by, account, environment["AS_ACCOUNT"] = [sys.executable, ORDINARY_USER], None, str(account)
        return forked.run(
            [*by, program, *words], cwd=home, env=environment, timeout=200, umask=umask, account=account
        )


def notebook(path: Path) -> bytes:
    return path.read_bytes()


@pytest.fixture(scope="module")
def place() -> Iterator[Path]:
    with tempfile.TemporaryDirectory() as name:  # pytest's own folders are for one user
        Path(name).chmod(0o755)
        yield Path(name)


def copied(source: Path, folder: Path) -> Hub:
    """A hub where the one that was copied had been made, with everybody's rights."""
    subprocess.run(["cp", "-a", source, folder], check=True)
    return Hub(folder)


@pytest.fixture(scope="module")
def just_made(place: Path) -> Path:
    hub = Hub(place / "hub")
    hub.folder.mkdir()
    (hub.folder / "one.md").write_text(SET)
    bank = chapter_bank()
    problem_set = find_set(bank, str(hub.folder / "one.md"))
    roster = [Student(ADA.pw_name), Student(BEN.pw_name)]
    generate(hub.course, problem_set, roster, Solutions(bank))
    (hub.folder / "exchange").mkdir()
    (hub.folder / "exchange").chmod(0o777)
    config = hub.course / "nbgrader_config.py"
    config.write_text(config.read_text() + f"c.Exchange.root = {str(hub.folder / 'exchange')!r}\n")
    for who in (ADA, BEN):
        hub.home(who).mkdir()
        (hub.home(who) / "nbgrader_config.py").write_text(HUB.format(root=str(hub.folder / "exchange")))
        shutil.chown(hub.home(who), who.pw_uid, who.pw_gid)
    return hub.folder.rename(place / "just made")


@pytest.fixture(scope="module")
def handed_in(place: Path, just_made: Path) -> Path:
    """The sheets released by an instructor who is not root, fetched and handed in by both."""
    hub = copied(just_made, place / "hub")
    for path in (hub.course, *hub.course.rglob("*")):
        shutil.chown(path, TEACHER.pw_uid, TEACHER.pw_gid)
    assert hub.run(TEACHER, "release_assignment", "one").returncode == 0
    for who in (ADA, BEN):
        for words in ("fetch_assignment", "submit"):
            assert hub.run(who, words, "one").returncode == 0
    return hub.folder.rename(place / "handed in")


@pytest.fixture
def hub(place: Path, just_made: Path) -> Iterator[Hub]:
    yield copied(just_made, place / "hub")
    shutil.rmtree(place / "hub")


@pytest.fixture
def hub_with_hand_ins(place: Path, handed_in: Path) -> Iterator[Hub]:
    yield copied(handed_in, place / "hub")
    subprocess.run(["rm", "-rf", place / "hub"], check=True)  # deeper than Python's own removal goes


def test_each_fetches_the_own_sheet_and_can_read_no_other(hub: Hub) -> None:
    released = hub.run(None, "release_assignment", "one")
    assert released.returncode == 0, released.stderr
    assert sorted(path.name for path in hub.outbound.iterdir()) == sorted([ADA.pw_name, BEN.pw_name])
    for who in (ADA, BEN):
        done = hub.run(who, "fetch_assignment", "one", started=who == ADA)
        assert done.returncode == 0, done.stderr
        own = hub.course / "release" / who.pw_name / "one" / "one.ipynb"
        assert notebook(hub.home(who) / "one" / "one.ipynb") == notebook(own)
    other = hub.run(
        ADA, "fetch_assignment", "one", "--student", BEN.pw_name, "--Exchange.assignment_dir=other"
    )
    assert other.returncode != 0
    assert not list(hub.home(ADA).glob("other/**/*.ipynb"))
    # hand in, collect: nbgrader's own, and nothing is missing
    handed_in = hub.run(ADA, "submit", "one")
    assert handed_in.returncode == 0, handed_in.stderr
    assert "missing" not in handed_in.stderr
    collected = hub.run(None, "collect", "one")
    assert collected.returncode == 0, collected.stderr
    theirs = json.loads(notebook(hub.course / "submitted" / ADA.pw_name / "one" / "one.ipynb"))
    assert theirs["metadata"]["corollary"]["student"] == ADA.pw_name


def test_feedback_comes_back_to_who_handed_in_through_it_and_the_others_are_named(hub: Hub) -> None:
    """Ada hands in through the exchange, Ben by mail."""
    for who, words in ((None, ("release_assignment",)), (ADA, ("fetch_assignment",)), (ADA, ("submit",))):
        assert hub.run(who, *words, "one").returncode == 0
    assert hub.run(None, "collect", "one").returncode == 0
    by_mail = hub.course / "submitted" / BEN.pw_name / "one"
    by_mail.mkdir(parents=True)
    shutil.copy(hub.course / "release" / BEN.pw_name / "one" / "one.ipynb", by_mail)
    for each in BESIDE:
        (by_mail / each).write_bytes(b"\xff\xfe")
    nothing = hub.run(None, "release_feedback", "one")
    assert nothing.returncode != 0
    assert "nobody has a feedback page of one; run corollary grade one" in nothing.stderr
    # once as graded, and once more when the pages were lost and made again
    for _ in range(2):
        graded = hub.run(None, "grade", "one", program=COROLLARY)
        assert graded.returncode == 0, graded.stderr
        released = hub.run(None, "release_feedback", "one")
        assert released.returncode == 0, released.stderr
        assert f"{BEN.pw_name} did not hand in one through this exchange" in released.stderr
        assert "Traceback" not in released.stderr
        fetched = hub.run(ADA, "fetch_feedback", "one")
        assert fetched.returncode == 0, fetched.stderr
        (page,) = (hub.home(ADA) / "one" / "feedback").glob("*/*.html")
        own = hub.course / "feedback" / ADA.pw_name / "one" / "one.html"
        assert page.read_bytes() == own.read_bytes()
        shutil.rmtree(hub.home(ADA) / "one" / "feedback")
        shutil.rmtree(hub.course / "feedback")


def test_released_again_for_newcomers_and_never_the_chapters_numbers(hub: Hub) -> None:
    hub.outbound.mkdir(parents=True)
    assert (
        "is released already; --force releases it again" in hub.run(None, "release_assignment", "one").stderr
    )
    assert hub.run(None, "release_assignment", "one", "--force").returncode == 0
    assert sorted(path.name for path in hub.outbound.iterdir()) == sorted([ADA.pw_name, BEN.pw_name])
    assert {path.stat().st_mode & 0o777 for path in hub.outbound.iterdir()} == {0o700}


def test_who_has_no_account_cannot_have_a_sheet_alone(hub: Hub) -> None:
    roster = hub.course / ".corollary" / "roster.csv"
    roster.write_text(roster.read_text() + "zoe,,,\n")
    shutil.copytree(hub.course / "release" / ADA.pw_name, hub.course / "release" / "zoe")
    done = hub.run(None, "release_assignment", "one")
    assert done.returncode != 0
    assert "zoe have no account on this machine" in done.stderr
    assert "corollary release --to zip" in done.stderr
    assert not hub.outbound.exists()


def test_zip_collect_works_by_default(hub: Hub) -> None:
    downloaded = hub.course / "downloaded" / "one" / "archive"
    downloaded.mkdir(parents=True)
    sheets = {who.pw_name: hub.course / "release" / who.pw_name / "one" / "one.ipynb" for who in (ADA, BEN)}
    shutil.copy(sheets[ADA.pw_name], downloaded / "one (1).ipynb.txt")
    inner = downloaded / "games_18_assignsubmission_file_"
    inner.mkdir()
    deep = (
        hub.folder / "deep" / ADA.pw_name / "of" / "mine"
    )  # folders of the student's own say nothing of whose it is
    deep.mkdir(parents=True)
    shutil.copy(sheets[BEN.pw_name], deep)
    shutil.make_archive(str(inner / "mine"), "zip", hub.folder / "deep")
    (downloaded / "scan.pdf").write_bytes(b"%PDF")
    done = hub.run(None, "zip_collect", "one")
    assert done.returncode == 0, done.stderr
    for who, sheet in sheets.items():
        place = hub.course / "submitted" / who / "one"
        assert notebook(place / "one.ipynb") == notebook(sheet)
        assert (place / "timestamp.txt").is_file()
    assert "scan.pdf is not a notebook, and is left out" in done.stderr


def test_an_instructor_who_is_not_root_opens_each_sheet_for_its_student_alone(hub: Hub) -> None:
    """By the access lists of the file system."""
    for path in (hub.course, *hub.course.rglob("*")):
        shutil.chown(path, TEACHER.pw_uid, -1)
    released = hub.run(TEACHER, "release_assignment", "one")
    assert released.returncode == 0, released.stderr
    assert {path.stat().st_uid for path in hub.outbound.iterdir()} == {TEACHER.pw_uid}
    for who, other in ((ADA, BEN), (BEN, ADA)):
        done = hub.run(who, "fetch_assignment", "one")
        assert done.returncode == 0, done.stderr
        own = hub.course / "release" / who.pw_name / "one" / "one.ipynb"
        assert notebook(hub.home(who) / "one" / "one.ipynb") == notebook(own)
        theirs = hub.outbound / other.pw_name
        for place in (theirs, theirs / "one.ipynb"):
            assert may_read(hub, who, place) is False
    assert may_read(hub, TEACHER, hub.outbound / ADA.pw_name)


def all_the_way(hub: Hub, *students: pwd.struct_passwd) -> None:
    """Release, fetch, submit, collect, grade and feedback, everybody with an account, and files that nobody else may read."""
    for path in (hub.course, *hub.course.rglob("*")):
        shutil.chown(path, TEACHER.pw_uid, TEACHER.pw_gid)

    def done(who: pwd.struct_passwd, *words: object, program: Path = NBGRADER) -> str:
        found = hub.run(who, *words, program=program, umask=0o077)
        assert found.returncode == 0, found.stderr
        assert "Traceback" not in found.stderr
        return found.stderr

    done(TEACHER, "release_assignment", "one")
    for who in students:
        done(who, "fetch_assignment", "one")
        sheet = hub.home(who) / "one" / "one.ipynb"
        assert "system.posix_acl_access" not in {*os.listxattr(sheet), *os.listxattr(sheet.parent)}
        done(who, "submit", "one")
    done(TEACHER, "collect", "one")
    done(TEACHER, "collect", "one", "--update")
    done(TEACHER, "grade", "one", program=COROLLARY)
    done(TEACHER, "release_feedback", "one")
    for who in students:
        handed_in = hub.course / "submitted" / who.pw_name / "one" / "one.ipynb"
        assert json.loads(notebook(handed_in))["metadata"]["corollary"]["student"] == who.pw_name
        done(who, "fetch_feedback", "one")
        (page,) = (hub.home(who) / "one" / "feedback").glob("*/*.html")
        assert page.read_bytes() == (hub.course / "feedback" / who.pw_name / "one" / "one.html").read_bytes()


def test_all_the_way_with_an_instructor_who_is_not_root(hub: Hub) -> None:
    all_the_way(hub, ADA, BEN)


def test_whatever_rights_a_student_gives_the_own_files(hub: Hub) -> None:
    """Ada has given her sheet an access list; Ben allows himself to read."""
    for path in (hub.course, *hub.course.rglob("*")):
        shutil.chown(path, TEACHER.pw_uid, TEACHER.pw_gid)
    assert hub.run(TEACHER, "release_assignment", "one").returncode == 0
    for who in (ADA, BEN):
        assert hub.run(who, "fetch_assignment", "one").returncode == 0
    for place in (hub.home(ADA) / "one", hub.home(ADA) / "one" / "one.ipynb"):
        os.setxattr(place, "system.posix_acl_access", access_list(ADA.pw_uid, 5))
    (hub.home(BEN) / "one" / "one.ipynb").chmod(0o400)
    (hub.home(BEN) / "one").chmod(0o500)
    for again in ((), ("--update",)):
        for who in (ADA, BEN):
            done = hub.run(who, "submit", "one")
            assert done.returncode == 0, done.stderr
        done = hub.run(TEACHER, "collect", "one", *again)
        assert done.returncode == 0, done.stderr
        for who in (ADA, BEN):
            assert (hub.course / "submitted" / who.pw_name / "one" / "one.ipynb").is_file()


@pytest.mark.parametrize("harm", ["closed", "link", "pipe", "name", "large", "deep", "loop"])
def test_what_one_student_hands_in_keeps_no_other_from_being_collected(
    hub_with_hand_ins: Hub, harm: str
) -> None:
    hub = hub_with_hand_ins
    (place,) = (hub.folder / "exchange" / "course" / "inbound").glob(f"{ADA.pw_name}+one+*")
    match harm:
        case "closed":
            place.chmod(0o700)
        case "link":
            (place / "other.ipynb").symlink_to(hub.course / "gradebook.db")
        case "pipe":
            os.mkfifo(place / "other.ipynb")
        case "name":
            place.rename(place.with_name(f"{ADA.pw_name}+one+yesterday"))
        case "loop":
            (place / "one").symlink_to(".")
        case "deep":
            script = "import os\nfor _ in range(1200): os.mkdir('a'); os.chdir('a')"
            subprocess.run([sys.executable, "-c", script], cwd=place, check=True)
        case _:
            with (place / "data.ipynb").open("wb") as file:
                file.truncate(200_000_000)
    done = hub.run(TEACHER, "collect", "one")
    assert done.returncode == 0, done.stderr
    assert f"of {ADA.pw_name} is left out" in done.stderr
    assert "Traceback" not in done.stderr
    assert (hub.course / "submitted" / BEN.pw_name / "one" / "one.ipynb").is_file()
    assert not (hub.course / "submitted" / ADA.pw_name / "one").exists()


def test_a_request_for_regrading_comes_with_the_same_notebook_and_its_first_time(
    hub_with_hand_ins: Hub,
) -> None:
    hub = hub_with_hand_ins
    assert hub.run(None, "collect", "one").returncode == 0
    place = hub.course / "submitted" / ADA.pw_name / "one"
    first = (place / "timestamp.txt").read_text()
    form = hub.home(ADA) / "one" / "request_one.md"
    form.write_text("## X12.5 (a)\nI went by p = 2mv\n")
    shutil.chown(form, ADA.pw_uid, ADA.pw_gid)
    assert hub.run(ADA, "submit", "one").returncode == 0
    done = hub.run(None, "collect", "one", "--update")
    assert done.returncode == 0, done.stderr
    assert (place / "request_one.md").read_text() == form.read_text()
    assert (place / "timestamp.txt").read_text() == first


def test_a_time_that_is_none_keeps_no_other_from_being_collected_again(hub: Hub) -> None:
    """What Ada hands in holds a timestamp.txt of her own; Ben has pipes for folders."""
    inbound = hub.folder / "exchange" / "course" / "inbound"
    inbound.mkdir(parents=True)
    for when in ("2030-01-01 10:00:00 UTC", "2030-01-02 10:00:00 UTC"):
        for who in (ADA.pw_name, BEN.pw_name, ".."):
            place = inbound / f"{who}+one+{when}"
            place.mkdir()
            (place / "one.ipynb").write_text("{}")
            (place / "timestamp.txt").write_text("never" if who == ADA.pw_name else when)
        os.mkfifo(inbound / f"{BEN.pw_name}+one+2029-12-0{when[9]} 10:00:00 UTC")
        done = hub.run(None, "collect", "one", "--update")
        assert done.returncode == 0, done.stderr
    assert f"of {ADA.pw_name} is left out" in done.stderr
    assert (
        (hub.course / "submitted" / BEN.pw_name / "one" / "timestamp.txt")
        .read_text()
        .startswith("2030-01-02")
    )
    listed = hub.run(None, "list", "one", "--inbound")
    assert listed.returncode == 0, listed.stderr
    assert listed.stderr.count("is left out") == 2
    assert f"course {BEN.pw_name} one 2030-01-02" in listed.stderr


def may_read(hub: Hub, who: pwd.struct_passwd, place: Path) -> bool:
    script = hub.folder / "read.py"
    script.write_text("import os, sys; print(os.access(sys.argv[1], os.R_OK))")
    line = [sys.executable, str(ORDINARY_USER), str(script), str(place)]
    about = {"PATH": os.environ["PATH"], "AS_ACCOUNT": str(who.pw_uid), "TMPDIR": str(hub.folder)}
    done = subprocess.run(line, env=about, capture_output=True, encoding="utf-8", timeout=60, check=True)
    return done.stdout.strip() == "True"


def test_a_file_system_without_access_lists_says_so(monkeypatch) -> None:
    """As on some network disks: `/proc` is one without."""
    monkeypatch.setattr(os, "geteuid", lambda: BEN.pw_uid)
    with pytest.raises(OSError, match="not supported"):
        open_for(Path("/proc/self/status"), ADA.pw_uid)
