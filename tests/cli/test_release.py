"""`corollary release`: the files, what is said of them, and the exchange."""

from __future__ import annotations

import json
import os
import pwd
from pathlib import Path

import pytest

from corollary.cli.main import main

ACCOUNT = "daemon"  # one that every Debian has


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]):
    (tmp_path / "one.md").write_text("---\ntitle: One\nproblems:\n  - X12.5\n---\nOne.\n")
    (tmp_path / "roster.csv").write_text(
        f"id,first_name,last_name,email\n{ACCOUNT},Ada,Lovelace,ada@example.org\nben,,,\n"
    )
    monkeypatch.chdir(tmp_path)

    def command(*arguments: str) -> tuple[int, str, str]:
        monkeypatch.setattr("sys.argv", ["corollary", *arguments])
        with pytest.raises(SystemExit) as end:
            main()
        captured = capfd.readouterr()
        return int(end.value.code or 0), captured.out, captured.err

    assert command("generate", "one.md", "--roster", "roster.csv", "--course", "course")[0] == 0
    return command


def test_files_and_who_gets_none(run) -> None:
    status, out, err = run("release", "one", "--course", "course", "--to", "mail", "--json")
    document = json.loads(out)
    assert (status, document["students"], document["without"]) == (
        0,
        [ACCOUNT],
        {"ben": "the roster has no email"},
    )
    assert (
        Path(document["files"][0]).read_bytes()
        == Path(f"course/release/{ACCOUNT}/one/one.ipynb").read_bytes()
    )
    assert "no file for ben: the roster has no email" in err
    status, out, _ = run("release", "one", "--course", "course", "--to", "zip", "-o", "out")
    assert (status, out) == (0, "One: own sheets of 2 students in out/\n")
    assert sorted(path.name for path in Path("out").iterdir()) == [
        f"Lovelace Ada ({ACCOUNT}) - one.zip",
        "ben - one.zip",
    ]


def test_one_line_names_all_who_get_none_for_one_reason(run) -> None:
    roster = Path("roster.csv")
    roster.write_text(roster.read_text() + "cyd,,,\n")
    run("generate", "one.md", "--roster", "roster.csv", "--course", "course")
    _, _, err = run("release", "one", "--course", "course", "--to", "mail")
    assert err == "no file for ben, cyd: the roster has no email\n"


def test_numbers_of_the_lms_are_asked_for(run) -> None:
    status, out, err = run("release", "one", "--course", "course", "--to", "moodle")
    assert (status, out) == (2, "")
    assert "give Moodle's grading worksheet" in err


def exchange(setting: str = "") -> None:
    Path("exchange").mkdir()
    Path("exchange").chmod(0o777)
    config = Path("course/nbgrader_config.py")
    config.write_text(
        config.read_text() + f"c.Exchange.root = {str(Path('exchange').absolute())!r}\n{setting}"
    )


def test_the_exchange_refuses_who_has_no_account(run) -> None:
    exchange()
    status, out, err = run("release", "one", "--course", "course", "--to", "exchange")
    assert (status, out) == (1, "")
    assert "ben have no account on this machine" in err
    assert not list(Path("exchange").glob("*/outbound/*"))


def test_an_exchange_that_gives_everybody_the_same_is_refused(run) -> None:
    exchange('c.ExchangeFactory.release_assignment = "nbgrader.exchange.default.ExchangeReleaseAssignment"\n')
    status, _, err = run("release", "one", "--course", "course", "--to", "exchange")
    assert status == 1
    assert "gives everybody the same notebook, with the chapter's numbers" in err
    assert not list(Path("exchange").glob("*/outbound/*"))


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give a folder to somebody else")
def test_the_exchange_has_a_folder_for_each(run) -> None:
    exchange()
    roster = Path("course/.corollary/roster.csv")
    roster.write_text("".join(roster.read_text().splitlines(keepends=True)[:-1]))
    assert run("release", "one", "--course", "course", "--to", "exchange")[0] == 0
    own = Path(f"exchange/course/outbound/one/{ACCOUNT}")
    assert (own.stat().st_uid, own.stat().st_mode & 0o777) == (pwd.getpwnam(ACCOUNT).pw_uid, 0o700)
    status, _, err = run("release", "one", "--course", "course", "--to", "exchange")
    assert status == 1
    assert "is released already; --force releases it again" in err
    assert run("release", "one", "--course", "course", "--to", "exchange", "--force")[0] == 0
