"""What the columns of a roster are called, by nbgrader, Moodle, Canvas and people, and which of them holds the ids."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

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
OTHERS = (
    "identifier", "section", "group", "groups", "roles", "role", "status", "root account", "integration id", "institution", "department",
    "last access to course", "last access", "grade", "maximum grade", "city/town", "country",
)  # fmt: skip
HEADINGS = frozenset((*IDS, *EMAILS, *FIRST_NAMES, *LAST_NAMES, *NAMES, *OTHERS))
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


def columns_of(headings: Sequence[str]) -> Columns:
    """The columns by their headings."""
    lower = [heading.strip().lower() for heading in headings]

    def places(names: Sequence[str]) -> tuple[int, ...]:
        return tuple(lower.index(name) for name in names if name in lower)

    first, last, name, email = (
        next(iter(places(names)), None) for names in (FIRST_NAMES, LAST_NAMES, NAMES, EMAILS)
    )
    return Columns(tuple(headings), (*places(IDS), *places(EMAILS)), first, last, name, email)


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
