"""The code by which a sheet is known again: the set and the form or the student, as a QR code."""

from __future__ import annotations

import io
from functools import lru_cache
from urllib.parse import quote

from corollary.problem.roster import Student
from corollary.render.paper.document import typesetter


def sheet_address(set_name: str, owner: Student, form: str) -> str:
    """What the code says: `corollary:momentum_1?student=ada`, or `?form=A`; the set alone for a sheet that is nobody's."""
    if form:
        return f"corollary:{quote(set_name)}?form={quote(form)}"
    return f"corollary:{quote(set_name)}" + (f"?student={quote(owner.id, safe='@')}" if owner.id else "")


@lru_cache(maxsize=1)  # the sheet's and its marking scheme's
def code_svg(address: str) -> str:
    """The QR code as an SVG drawing, with a quiet border. Raises CannotTypeset without the extra `pdf`."""
    out = io.BytesIO()
    typesetter("segno").make(address, error="m", micro=False).save(
        out, kind="svg", xmldecl=False, border=2, omitsize=True
    )
    return out.getvalue().decode()
