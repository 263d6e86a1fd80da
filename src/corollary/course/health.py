"""Checks of this machine's set-up and of a course's files: programs, isolation, disk, settings, banks; key, roster, permissions, other runs."""

from __future__ import annotations

import locale
import os
import platform
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError, distribution, version
from pathlib import Path
from shlex import quote

from corollary import user_cache
from corollary.course.sharing import rights_findings
from corollary.course.term_archive import archive_findings
from corollary.extras import installing
from corollary.nbgrader.nbgrader_health import nbgrader_findings
from corollary.parallel import cores
from corollary.plug_ins import PlugInFault, load, plug_ins
from corollary.problem.bank import UnknownCode, chapter_bank, files, open_bank
from corollary.problem.dates import machine_zone, zone_named
from corollary.problem.diagnostic import Finding, Malformed
from corollary.records.files import Course, NotACourse, at_work, open_course, students
from corollary.records.origin import bank_near, is_file_gone, set_of
from corollary.records.settings import FILE, Settings, read_settings
from corollary.version import DISTRIBUTION, full_version

NAMESAKE = "corollary"  # on PyPI: another project, whose module has our name
WRITTEN_IN = ("", ".corollary", "submitted", "autograded", "feedback", "reports")


def of_course(folder: Path) -> tuple[Course | None, Settings, list[Finding]]:
    """The course in a folder, as far as it can be opened, its settings, and what was found. Nothing is changed."""
    course, settings = None, Settings()
    found: list[Finding] = []
    path = folder / FILE
    try:
        settings = read_settings(folder)
        found.append(
            Finding(
                "settings",
                "good",
                str(path) if path.exists() else f"no {FILE}, so every setting has its default",
            )
        )
    except Malformed as error:
        found.append(Finding("settings", "broken", str(error), f"correct {path}"))
    try:
        course = open_course(folder)
    except NotACourse as error:
        there = (folder / ".corollary").is_dir()
        remedy = (
            "restore .corollary from a backup: students' numbers and answer keys depend on it"
            if there
            else "name the course with --course, or generate a set"
        )
        return None, settings, [*found, Finding("course", "broken", str(error), remedy)]
    return (
        course,
        settings,
        [*found, _roster(course), *rights_findings(course), *_writable(course.folder), *_work(course)],
    )


def _roster(course: Course) -> Finding:
    try:
        count = len(students(course))
    except NotACourse as error:
        path = course.folder / ".corollary" / "roster.csv"
        away = f"move {path} away, then " if path.is_dir() else ""
        return Finding("course", "broken", str(error), f"{away}corollary generate SET --roster FILE")
    if not count:
        remedy = "corollary generate SET --roster FILE"
        return Finding("course", "broken", f"{course.folder}, nobody on the roster", remedy)
    return Finding("course", "good", f"{course.folder}, {count} on the roster")


def _writable(folder: Path) -> Iterator[Finding]:
    """Whether we may write."""
    for name in WRITTEN_IN:
        place = folder / name
        if place.is_dir() and not os.access(place, os.R_OK | os.W_OK | os.X_OK):
            yield Finding("rights", "broken", f"you cannot write into {place}", f"chmod u+rwx {place}")
        elif place.exists() and not place.is_dir():
            yield Finding("rights", "broken", f"{place} is not a folder", "move it away")


def _work(course: Course) -> Iterator[Finding]:
    """A lock goes with the process that held it, however it ended, so there is none to be removed by hand."""
    if at_work(course):
        yield Finding(
            "lock", "weak", "another corollary command is running in the course", "wait until it has ended"
        )


GROUPS = ("corollary.banks", "corollary.answers", "corollary.laws", "corollary.exports")
NEEDED = ("sympy", "python-flint", "numpy", "matplotlib", "msgspec", "nbformat", "ipython")
JUPYTER = ("jupyterlab", "notebook")  # either, to look at notebooks and formgrader
LITTLE, TOO_LITTLE = (
    1 << 30,
    100 << 20,
)  # bytes free; a notebook may fill a folder of hundreds of MB while it runs


def findings(folder: Path | None) -> Iterator[Finding]:
    """Everything that was found, one after another; `folder`: a course. Nothing is changed."""
    yield from _programs()
    course, settings = None, Settings()
    if folder is not None:
        course, settings, found = of_course(folder)
        yield from found
    yield from archive_findings(folder)
    yield _isolation(settings)
    yield from _packages(course, settings)
    yield from nbgrader_findings(course)
    yield from _places(folder)
    yield _time_zone(settings)
    yield _encoding()
    jobs = "" if settings.jobs is None else f", of which the settings take {settings.jobs}"
    yield Finding("cores", "good", f"{cores()}{jobs}")
    yield from _banks(course, settings)
    yield from _plug_ins()


def _programs() -> Iterator[Finding]:
    yield Finding("corollary", "good", full_version())
    if _overwritten():
        yield Finding(
            "namesake",
            "broken",
            f"another project's package {NAMESAKE} {_version(NAMESAKE)} is installed in this environment, too: "
            "both have the module corollary, and the files of one replace those of the other",
            f"pip uninstall {NAMESAKE}, then pip install --force-reinstall --no-deps {DISTRIBUTION}",
        )
    old = sys.version_info < (3, 11)
    yield Finding(
        "Python",
        "broken" if old else "good",
        f"{platform.python_version()} in {sys.executable}",
        "use 3.11 or newer" if old else "",
    )
    windows = sys.platform == "win32"
    yield Finding(
        "platform",
        "weak" if windows else "good",
        f"{platform.system()} {platform.release()}"
        + (": everything works here but grading" if windows else ""),
        "grade in WSL, or in the container of the Dockerfile" if windows else "",
    )
    for name in NEEDED:
        found = _version(name)
        yield Finding(
            name,
            "good" if found else "broken",
            found or "not installed",
            "" if found else f"pip install {name}",
        )
    found = [f"{name} {number}" for name in JUPYTER if (number := _version(name))]
    yield Finding(
        "Jupyter",
        "good" if found else "weak",
        ", ".join(found) or "not installed: notebooks cannot be opened here",
        "" if found else "pip install jupyterlab",
    )


def _overwritten() -> bool:
    """True if the other project's package has files in the folder `corollary`."""
    try:
        return any(path.parts[0] == "corollary" for path in distribution(NAMESAKE).files or ())
    except PackageNotFoundError:
        return False


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return ""


def _isolation(settings: Settings) -> Finding:
    try:
        from corollary.sandbox.isolation import GUARANTEES, WeakIsolation
        from corollary.sandbox.runner import probe_isolation
        from corollary.sandbox.zygote import CannotStart
    except ImportError as error:
        return Finding(
            "isolation",
            "weak",
            f"notebooks cannot be run here ({error})",
            "grade on Linux, in WSL or in a container",
        )
    try:
        found = probe_isolation()
    except (CannotStart, WeakIsolation, OSError) as error:
        return Finding(
            "isolation",
            "broken",
            f"no notebook can be run: {error}",
            "grade on another machine, or in a container",
        )
    required = 1 if settings.isolation is None else settings.isolation
    holds = "; ".join(GUARANTEES[name] for name in found.guaranteed) or "nothing is guaranteed"
    state = "broken" if found.level < required else "weak" if found.missing else "good"
    short = [name for name in ("landlockpy", "pyseccomp") if sys.platform == "linux" and not _version(name)]
    remedy = installing("isolation") if short else "see docs/reference/isolation.md" if found.missing else ""
    missing = f"; missing: {'; '.join(found.missing)}" if found.missing else ""
    return Finding("isolation", state, f"level {found.level} ({found.line}): {holds}{missing}", remedy)


def _packages(course: Course | None, settings: Settings) -> Iterator[Finding]:
    try:
        from corollary.course.package_health import package_findings
    except ImportError:  # where notebooks cannot be run
        return
    yield from package_findings(course, settings)


def _places(folder: Path | None) -> Iterator[Finding]:
    places = {
        "disk": folder or Path.cwd(),
        "temporary files": Path(tempfile.gettempdir()),
        "cache": user_cache.folder(),
    }
    for name, place in places.items():
        if place is None:
            yield Finding(
                name,
                "weak",
                "there is no home folder, so solutions are not cached",
                "set XDG_CACHE_HOME to a folder",
            )
            continue
        there = next((each for each in (place, *place.parents) if each.exists()), place)
        free = shutil.disk_usage(there).free
        sentence = f"{place}, {free / 1e9:.1f} GB free"
        if not os.access(there, os.W_OK):
            needed = name != "cache"
            yield Finding(
                name, "broken" if needed else "weak", f"{place} cannot be written to", f"chmod u+w {there}"
            )
        elif free < LITTLE:
            yield Finding(name, "broken" if free < TOO_LITTLE else "weak", sentence, "make room")
        else:
            yield Finding(name, "good", sentence)


def _time_zone(settings: Settings) -> Finding:
    if zone_named("Europe/Oslo") is None:
        return Finding("time zone", "broken", "this machine has no table of time zones", "pip install tzdata")
    machine = machine_zone()
    own = machine.key if machine is not None else "not known by name"
    if settings.timezone:
        return Finding("time zone", "good", f"{settings.timezone} (the machine's is {own})")
    return Finding(
        "time zone",
        "weak",
        f"the machine's, {own}",
        f'write timezone = "…" into {FILE}, so that dates mean the same on every machine',
    )


def _encoding() -> Finding:
    used = (sys.stdout.encoding or "", sys.getfilesystemencoding(), locale.getpreferredencoding(False))
    words = "output {}, file names {}, text {}".format(*used)
    narrow = [each for each in used if each.lower().replace("-", "") not in {"utf8", "cp65001"}]
    return Finding(
        "encoding",
        "weak" if narrow else "good",
        words + ("; characters that it lacks are written as ?" if narrow else ""),
        "set PYTHONUTF8=1, or a locale with UTF-8" if narrow else "",
    )


def _banks(course: Course | None, settings: Settings) -> Iterator[Finding]:
    def found(name: str, look: Callable[[], str], remedy: str) -> Finding:
        try:
            return Finding(name, "good", look())
        except (UnknownCode, Malformed, NotACourse, PlugInFault) as error:
            return Finding(name, "broken", str(error), remedy)

    def bank(place: Path | None) -> str:
        opened = open_bank(place)
        return f"{opened.place}, {len(files(opened))} problems"

    yield found(
        "chapter's bank", lambda: bank(Path(chapter_bank().place)), "install Corollary anew, from its folder"
    )
    if settings.bank:
        yield found("course's bank", lambda: bank(Path(settings.bank)), f"correct bank in {FILE}")
    elif os.environ.get("COROLLARY_BANK"):
        yield found("COROLLARY_BANK", lambda: bank(None), "set COROLLARY_BANK to a bank's folder")
    if course is None:
        return
    for path in sorted(course.record("origin", "any").parent.glob("*.json")):
        name = path.stem
        yield found(
            f"set {name}",
            lambda name=name: f"{set_of(course, name)[1].title}, from {set_of(course, name)[0].place}",
            _place_named(course, name),
        )


def _place_named(course: Course, name: str) -> str:
    """The command after which a set is found again; it takes the bank that lies near, where there is one."""
    in_course = f"--course {quote(str(course.folder))}"
    if is_file_gone(course, name):
        return f"corollary generate {quote(f'PATH/{name}.md')} {in_course}, PATH being the file's folder"
    near = bank_near(course, name)
    command = f"corollary generate {quote(name)} {in_course} --bank "
    return command + (quote(str(near)) if near else "DIR, DIR being the bank's folder")


def _plug_ins() -> Iterator[Finding]:
    for group in GROUPS:
        try:
            theirs = plug_ins(group)
        except PlugInFault as error:
            yield Finding(group, "broken", str(error), "uninstall one of the two")
            continue
        for entry in theirs.values():
            try:
                load(entry, "the plug-in")
                yield Finding(f"{group}: {entry.name}", "good", entry.value)
            except PlugInFault as error:
                yield Finding(
                    f"{group}: {entry.name}", "broken", str(error), "update or uninstall its package"
                )
