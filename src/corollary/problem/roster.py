"""A roster: the students of a course, from columns as LMSs and spreadsheets name them."""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from corollary.messages import few
from corollary.problem.csv_table import Table, read_table
from corollary.problem.diagnostic import Diagnostic, Malformed

USERNAMES = (
    "username", "user name", "user", "login", "login id", "netid", "uid", "benutzername", "anmeldename", "kennung", "brukernavn",
    "nom d'utilisateur", "nombre de usuario",
)  # fmt: skip
ID_NUMBERS = (
    "id number", "idnumber", "student number", "student no", "matriculation number", "matrikelnummer", "id-nummer",
    "studentnummer", "studentnr", "numéro d'identification", "número de id",
)  # fmt: skip
# From the most to the least wanted; Canvas's own ID is a number that no student knows, and comes after what they log in with.
IDS = (
    "sis login id", "sis user id",
    "id", "student id", "student_id", "studentid",
    *USERNAMES,
    *ID_NUMBERS,
)  # fmt: skip
EMAILS = (
    "email", "e-mail", "email address", "e-mail address", "mail", "e-mail-adresse", "email-adresse", "e-postadresse", "e-post",
    "adresse de courriel", "dirección de correo",
)  # fmt: skip
FIRST_NAMES = (
    "first_name", "first name", "firstname", "given name", "forename", "first", "vorname", "fornavn", "prénom", "nombre",
)  # fmt: skip
LAST_NAMES = (
    "last_name", "last name", "lastname", "surname", "family name", "last", "nachname", "etternavn", "nom", "nom de famille",
    "apellido(s)", "apellidos",
)  # fmt: skip
NAMES = (
    "name",
    "full name",
    "fullname",
    "student",
    "student name",
    "vollständiger name",
    "fullt navn",
    "participant",
)
SECTIONS = ("section", "sections", "sektion", "seksjon")
GROUPS = ("group", "groups", "gruppe", "gruppen", "grupper", "groupe", "groupes", "grupo", "grupos")
OTHERS = (
    "identifier", "roles", "role", "status", "root account", "integration id", "institution", "department",
    "last access to course", "last access", "grade", "maximum grade", "city/town", "country",
)  # fmt: skip
HEADINGS = frozenset((*IDS, *EMAILS, *FIRST_NAMES, *LAST_NAMES, *NAMES, *SECTIONS, *GROUPS, *OTHERS))
AT, DIGIT = re.compile("@"), re.compile(r"\d")


@dataclass(frozen=True, slots=True)
class Columns:
    """Where in a row stand the candidates for the id, in the order in which they are wanted, and the names; None: nowhere."""

    headings: tuple[str, ...]
    ids: tuple[int, ...]
    first_name: int | None
    last_name: int | None
    name: int | None
    email: int | None
    section: int | None = None
    group: int | None = None


def columns_of(headings: Sequence[str]) -> Columns:
    """The columns by their headings."""
    lower = [heading.strip().lower() for heading in headings]

    def places(names: Sequence[str]) -> tuple[int, ...]:
        return tuple(lower.index(name) for name in names if name in lower)

    others = (
        next(iter(places(names)), None)
        for names in (FIRST_NAMES, LAST_NAMES, NAMES, EMAILS, SECTIONS, GROUPS)
    )
    return Columns(tuple(headings), (*places(IDS), *places(EMAILS)), *others)


def is_header(row: Sequence[str]) -> bool:
    """Whether a row names columns."""
    return any(cell.strip().lower() in HEADINGS for cell in row)


def is_surely_header(row: Sequence[str]) -> bool:
    """Whether a row that is not the first one names columns: a person may be called what one is called."""
    known = [cell.strip().lower() in HEADINGS for cell in row]
    return sum(known) > 1 or any(cell.strip().lower() in IDS for cell in row)


def guessed(rows: Sequence[Sequence[str]]) -> Columns | None:
    """The columns of a file without headings; None when its first row seems to be headings of another kind."""
    width = max(map(len, rows))
    cells = [[row[at] if at < len(row) else "" for row in rows] for at in range(width)]
    for column in cells:
        for mark in (AT, DIGIT):
            if len(column) > 1 and all(map(mark.search, column[1:])) and not mark.search(column[0]):
                return None
    email = next((at for at, column in enumerate(cells) if all("@" in cell for cell in column)), None)
    unique = [at for at, column in enumerate(cells) if all(column) and len(set(column)) == len(column)]
    numbered = [at for at in unique if at != email and all(DIGIT.search(cell) for cell in cells[at])]
    ids = list(dict.fromkeys((*numbered, *(at for at in (0, email) if at is not None), *unique)))
    names = [at for at in range(width) if at not in (email, ids[0])]
    first, last = (names[0], names[1]) if len(names) > 1 else (None, None)
    name = names[0] if len(names) == 1 else None
    headings = [f"column {at + 1}" for at in range(width)]
    return Columns(tuple(headings), tuple(ids), first, last, name, email)


COLUMNS = ("id", "first_name", "last_name", "email")
ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.@-]{0,99}$")
# Windows takes these for devices, with any ending, and drops a dot at the end of a name.
NO_FOLDER = re.compile(r"((con|prn|aux|nul|com\d|lpt\d)(\..*)?|.*\.)$", re.IGNORECASE)
# Canvas's rows that are no people: what each assignment is out of, how marks are posted, and its invented student.
NOBODY = re.compile(r"\s*(points possible|student, test|test student)\s*$", re.IGNORECASE)
# Letters that Unicode does not take apart into one of ASCII's and an accent.
WITHOUT_STROKES = str.maketrans(
    {
        "Ł": "L",
        "ł": "l",
        "Ø": "O",
        "ø": "o",
        "Đ": "D",
        "đ": "d",
        "ß": "ss",
        "Æ": "AE",
        "æ": "ae",
        "Œ": "OE",
        "œ": "oe",
        "ı": "i",
    }
)
TWINS = (
    "are one folder on many disks (macOS, Windows); change one of them, or take other ids with --id-column"
)
ROUNDED = re.compile(r"\d(?:[.,]\d+)?E\+\d+$", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Student:
    """`id` names the student's folders; `ids` are all that a roster or an LMS knows the student by, with the heading of each.
    `section` and `group` are as the roster has them; several stand with commas between."""

    id: str
    first_name: str = ""
    last_name: str = ""
    email: str = ""
    ids: tuple[tuple[str, str], ...] = field(default=(), compare=False)
    section: str = field(default="", compare=False)
    group: str = field(default="", compare=False)

    def is_in(self, section: str = "", group: str = "") -> bool:
        """True if the student is in this section and in this group; an empty name is that of all."""
        return (not section or _among(section, self.section)) and (not group or _among(group, self.group))

    @property
    def name(self) -> str:
        return " ".join(part for part in (self.first_name, self.last_name) if part) or self.id

    @property
    def name_with_id(self) -> str:
        return name_with_id(self.name, self.id)


def name_with_id(name: str, student: str) -> str:
    """`Ada Lovelace (0101014)`; the id alone where there is no name."""
    return student if name in ("", student) else f"{name} ({student})"


def _among(name: str, listed: str) -> bool:
    """True if a cell names it, alone or among others."""
    found = {each.strip().casefold() for each in (listed, *re.split("[,;]", listed))}
    return name.strip().casefold() in found


@dataclass(frozen=True, slots=True)
class Roster:
    """`notes` are sentences on how the file was read, where that could have been otherwise."""

    students: tuple[Student, ...]
    notes: tuple[str, ...]


def read_roster(path: Path, id_column: str = "", known: Collection[str] = (), heading: str = "") -> Roster:
    """The students of a CSV file, in its order. `id_column` names the column of the ids, or gives its number from 1; when left
    out, the one with most of the `known` ids, then the one of that `heading`, then the most usual. Raises Malformed."""
    table = read_table(path, HEADINGS)
    columns, rows, notes = _columns(table, id_column)
    if not rows:
        raise _refused(path, f"lists no students; the first line names the columns ({', '.join(COLUMNS)})")
    at = _id_place(columns, rows, known, heading) if not id_column else columns.ids[0]
    complaints: list[Diagnostic] = []
    found: dict[str, tuple[int, Student]] = {}
    for line, row in rows:
        if any(row[len(columns.headings) :]):
            sentence = f"has {len(row)} cells, and there are {len(columns.headings)} columns; put quotes round a cell that holds {table.delimiter!r}"
            complaints.append(Diagnostic(path, line, sentence))
            continue
        student = _student(columns, row, at, known)
        if sentence := _trouble(student, found, columns.headings[at], _cell(row, at), known):
            complaints.append(Diagnostic(path, line, sentence))
        found.setdefault(student.id, (line, student))
    if complaints:
        raise Malformed(complaints)
    students = tuple(student for _, student in found.values())
    return Roster(students, (*notes, *_notes(columns, at, students)))


def folder_name(given: str) -> str:
    """The id as it is where it can name a folder on every computer; else its letters without accents and a digest of it,
    so that it is the same each time and nobody else's."""
    given = unicodedata.normalize("NFC", given)
    if not given or (ID.match(given) and not NO_FOLDER.match(given)):
        return given
    ascii_only = (
        unicodedata.normalize("NFKD", given.translate(WITHOUT_STROKES)).encode("ascii", "ignore").decode()
    )
    legible = re.sub(r"[^A-Za-z0-9]+", "-", ascii_only).strip("-")[:40]
    return f"{legible or 'student'}-{hashlib.sha256(given.encode()).hexdigest()[:8]}"


def _columns(table: Table, id_column: str) -> tuple[Columns, list[tuple[int, tuple[str, ...]]], list[str]]:
    """The columns, the rows of people, and what is to be noted."""
    rows, notes = list(table.rows), list[str]()
    if table.encoding == "cp1252" and rows:
        notes.append(
            f"{table.path.name} is not in UTF-8 and was read as Windows-1252; check that names are spelt correctly"
        )
    named = is_header(table.first) or (id_column and id_column.lower() in map(str.lower, table.first))
    columns = columns_of(table.first) if named or not rows else guessed([row for _, row in rows])
    seen = ", ".join(table.first)
    if columns is None:
        raise _refused(
            table.path,
            f"has no column `id`; its columns are {seen}; say which holds the ids with --id-column",
        )
    if named:
        rows = [row for row in rows[1:] if not _is_nobody(columns, row[1])]
    elif rows:
        for line, row in rows[:20]:
            if is_surely_header(row):
                raise _refused(table.path, "has its column names here; delete the lines above", line)
        notes.append(f"{table.path.name} has no line with names of columns; {_described(columns)}")
    if id_column:
        columns = _with_ids(table, columns, id_column, seen)
    if rows and not columns.ids:
        raise _refused(
            table.path,
            f"has no column `id`; its columns are {seen}; say which holds the ids with --id-column",
        )
    return columns, rows, notes


def _notes(columns: Columns, at: int, students: Sequence[Student]) -> Iterator[str]:
    """What might have been read otherwise: where the ids come from, and which became other names of folders."""
    heading = columns.headings[at]
    if heading.lower() != "id" or at != columns.ids[0]:
        others = ", ".join(columns.headings[other] for other in columns.ids if other != at)
        yield f"ids are those of {heading}" + (f"; --id-column takes others ({others})" if others else "")
    renamed = [(dict(each.ids)[heading], each.id) for each in students if (heading, each.id) not in each.ids]
    if renamed:
        names = few([f"{given} is {name}" for given, name in renamed])
        yield f"these ids cannot name folders on every computer, so their folders are called: {names}"


def _with_ids(table: Table, columns: Columns, id_column: str, seen: str) -> Columns:
    lower = [heading.lower() for heading in columns.headings]
    if id_column.lower() in lower:
        at = lower.index(id_column.lower())
    elif id_column.isdecimal() and 1 <= int(id_column) <= len(lower):
        at = int(id_column) - 1
    else:
        raise _refused(table.path, f"has no column {id_column}; its columns are {seen}")
    ids = (at, *(other for other in columns.ids if other != at))
    return replace(columns, ids=ids)


def _described(columns: Columns) -> str:
    about = {
        "first names": columns.first_name,
        "last names": columns.last_name,
        "names": columns.name,
        "email": columns.email,
    }
    words = [f"{what} in {columns.headings[at]}" for what, at in about.items() if at is not None]
    return f"taken to hold ids in {columns.headings[columns.ids[0]]}" + "".join(f", {each}" for each in words)


def _is_nobody(columns: Columns, row: Sequence[str]) -> bool:
    """Canvas's rows that are no people."""
    if "sis login id" not in (heading.lower() for heading in columns.headings) and columns.headings[:1] != (
        "Student",
    ):
        return False
    return is_nobody(row) or (not row[0] and not any(_cell(row, at) for at in columns.ids))


def is_nobody(row: Sequence[str]) -> bool:
    """Whether a row's name is one that Canvas writes where there is no person; it may have last and first names in columns of
    their own."""
    return any(NOBODY.match(name) for name in (*row[:1], ", ".join(row[:2])))


def ids_heading(students: Sequence[Student]) -> str:
    """What the column was called from which most have their ids; empty where nothing says so."""
    often = Counter(
        heading for each in students for heading, value in each.ids if folder_name(value) == each.id
    )
    return next((heading for heading, _ in often.most_common(1)), "")


def _id_place(
    columns: Columns, rows: Sequence[tuple[int, Sequence[str]]], known: Collection[str], heading: str
) -> int:
    """The column in which most of the known ids stand; else that of this heading, else the first that says something for
    everybody."""

    def met(at: int) -> int:
        return sum(folder_name(_cell(row, at)) in known for _, row in rows)

    best = max(columns.ids, key=met)
    if met(best):
        return best
    same = [at for at in columns.ids if columns.headings[at].lower() == heading.lower()]
    if same and all(_cell(row, same[0]) for _, row in rows):
        return same[0]
    if columns.headings[columns.ids[0]] == "id":  # nbgrader's own, and ours
        return columns.ids[0]
    filled = (at for at in columns.ids if all(_cell(row, at) for _, row in rows))
    return next(filled, columns.ids[0])


def _cell(row: Sequence[str], at: int | None) -> str:
    return row[at] if at is not None and at < len(row) else ""


def _student(columns: Columns, row: Sequence[str], at: int, known: Collection[str]) -> Student:
    first, last = _cell(row, columns.first_name), _cell(row, columns.last_name)
    if (name := _cell(row, columns.name)) and not (first or last):
        last, comma, first = name.partition(",")
        if not comma:
            first, _, last = name.rpartition(" ")
    ids = tuple((columns.headings[each], value) for each in columns.ids if (value := _cell(row, each)))
    given = _cell(row, at)
    own = given if given in known else folder_name(given)
    about = {"section": _cell(row, columns.section), "group": _cell(row, columns.group)}
    return Student(own, first.strip(), last.strip(), _cell(row, columns.email), ids, **about)


def _trouble(
    student: Student,
    found: Mapping[str, tuple[int, Student]],
    column: str,
    given: str,
    known: Collection[str],
) -> str:
    """What is wrong with an id; empty when nothing is."""
    if not given:
        return f"id {given!r}: the cell in {column} is blank; every student needs an id"
    if not given.isprintable():
        return f"id {given!r} holds an invisible character; type it again"
    if given.startswith((".", "/", "\\")) or ".." in given:
        return f"id {given!r} cannot name a folder; use letters, digits, _ . @ -"
    if ROUNDED.match(given):
        return f"id {given} was rounded by a spreadsheet; make {column} a column of text there, and save it again"
    if student.id in found:
        return f"id {given} stands on line {found[student.id][0]} already; every student needs an id of their own"
    for other, (line, _) in found.items():
        if other.lower() == student.id.lower() and not {other, student.id} <= set(known):
            return f"id {student.id} and {other} on line {line} {TWINS}"
    return ""


def _refused(path: Path, sentence: str, line: int = 1) -> Malformed:
    return Malformed([Diagnostic(path, line, sentence)])
