"""Hostile notebook files: broken, endless, forged, or with texts that a page, a terminal or a spreadsheet would run."""

from __future__ import annotations

import copy
import gzip
import json
from collections.abc import Callable, Mapping
from typing import Any

Notebook = dict[str, Any]
MARK = "corollaryAttack"  # in every text that must reach nobody's page as more than text

RAW: dict[str, Callable[[], bytes]] = {
    "nothing": lambda: b"",
    "blanks": lambda: b" " * 1_000_000,
    "no JSON": lambda: b"\x89PNG\r\n\x1a\n" + bytes(1000),
    "a torn file": lambda: b'{"cells": [{"cell_type": "code", "sou',
    "a list": lambda: b"[]",
    "a number": lambda: b"1e999999",
    "five thousand digits": lambda: b'{"cells": [], "nbformat": ' + b"9" * 5_000 + b"}",
    "a million brackets": lambda: b"[" * 1_000_000,
    "a million objects": lambda: b'{"a":' * 1_000_000,
    "two million values": lambda: b'{"cells": [' + b"0," * 2_000_000 + b"0]}",
    "a hundred thousand cells": lambda: b'{"nbformat": 4, "cells": [' + b"{}," * 100_000 + b"{}]}",
    "a heading of level 10^9": lambda: (
        b'{"nbformat": 3, "metadata": {}, "worksheets": [{"cells": [{"cell_type": "heading", "level": 1000000000, "source": "x"}]}]}'
    ),
    "version 10^9": lambda: b'{"nbformat": 1000000000, "cells": [{"cell_type": "code", "source": "x"}]}',
    "a version that is text": lambda: b'{"nbformat": "4", "cells": [{"cell_type": 5, "source": {}}]}',
    "cells that are none": lambda: (
        b'{"nbformat": 4, "cells": [null, 3, [], {"cell_type": "code", "source": [1, null]}]}'
    ),
    "UTF-16": lambda: '{"cells": []}'.encode("utf-16"),
    "bytes of no encoding": lambda: b'{"cells": ["\xff\xfe\xc0"]}',
    "compressed": lambda: gzip.compress(bytes(20_000_000)),
    "zeros": lambda: bytes(30_000_000),
    "one long text": lambda: (
        b'{"nbformat": 4, "cells": [{"cell_type": "raw", "source": "' + b"x" * 30_000_000 + b'"}]}'
    ),
}


def _metadata(**about: object) -> Callable[[Notebook], object]:
    def change(node: Notebook) -> None:
        node["metadata"].update(about)

    return change


def _each(**about: object) -> Callable[[Notebook], object]:
    def change(node: Notebook) -> None:
        for cell in node["cells"]:
            cell.update(copy.deepcopy(about))

    return change


def _marks(**about: object) -> Callable[[Notebook], object]:
    def change(node: Notebook) -> None:
        for cell in node["cells"]:
            cell["metadata"].setdefault("nbgrader", {}).update(about)

    return change


def _twice(node: Notebook) -> None:
    node["cells"] += copy.deepcopy(node["cells"])


def _check_replaced(node: Notebook) -> None:
    for cell in node["cells"]:
        if cell["metadata"].get("nbgrader", {}).get("locked") and cell["cell_type"] == "code":
            cell["source"] = "check = lambda *names: print('right')\nimport os; os._exit(0)"


def _deep_outputs(node: Notebook) -> None:
    value: Any = "x"
    for _ in range(400):
        value = {"x": [value]}
    for cell in node["cells"]:
        cell["outputs"] = [
            {"output_type": "display_data", "data": {"application/json": value}, "metadata": {}}
        ]


# Changes of the attacker's own notebook; the victim is another student.
FORGED: dict[str, Callable[[Notebook], object]] = {
    "made for the victim": _metadata(corollary={"set": "week", "student": "victim"}),
    "made for a folder": _metadata(corollary={"set": "../../..", "student": "../../.corollary"}),
    "made for a list": _metadata(corollary={"set": ["week"], "student": {"a": 1}}),
    "a kernel that is a program": _metadata(
        kernelspec={"name": "../../bin/sh", "display_name": f"<b>{MARK}"}
    ),
    "a kernel that is a list": _metadata(kernelspec=[], language_info=3, title=[], authors="x"),
    "metadata of a megabyte": _metadata(x="y" * 1_000_000),
    "tests that are skipped": lambda node: (
        [cell["metadata"].update(tags=["skip-execution", "raises-exception"]) for cell in node["cells"]]
        and None
    ),
    "a schema of the future": _marks(schema_version=99),
    "a million points": _marks(points=1e6, grade=True, solution=True, locked=False),
    "points that are no number": _marks(points=float("nan")),
    "grade ids that lead out": _marks(grade_id="../../key"),
    "grade ids that are equal": _marks(grade_id="X12_5_a"),
    "grade ids that are lists": _marks(grade_id=["x"]),
    "every cell twice": _twice,
    "ids that are equal": _each(id="x"),
    "ids of a megabyte": _each(id="x" * 100_000),
    "types that nobody knows": _each(cell_type="widget"),
    "checks replaced": _check_replaced,
    "outputs nested deeply": _deep_outputs,
    "outputs of twenty megabytes": lambda node: node["cells"][-1].update(
        outputs=[{"output_type": "stream", "name": "stdout", "text": "x" * 20_000_000}]
    ),
    "an attachment that leads out": _each(attachments={"../../key.png": {"image/png": "iVBORw0KGgo="}}),
    "an attachment that is a list": _each(attachments=[1]),
    "half characters": _each(source="\ud800\udfff\ud83d"),
    "no metadata": lambda node: node.pop("metadata"),
}

RUN = f"alert('{MARK}')"
TEXTS: dict[str, str] = {
    "a script": f"<script>{RUN}</script>",
    "a picture": f'<img src=x onerror="{RUN}">',
    "a drawing": f'<svg onload="{RUN}"><script>{RUN}</script></svg>',
    "a link": f'<a href="javascript:{RUN}">x</a>',
    "a link of Markdown": f"[x](javascript:{RUN})",
    "a picture from elsewhere": f"![x](http://example.org/{MARK})",
    "a page in a link": f'<a href="data:text/html,<script>{RUN}</script>">x</a>',
    "a frame": f'<iframe srcdoc="<script>{RUN}</script>"></iframe>',
    "an object": f'<object data="http://example.org/{MARK}"></object><embed src="http://example.org/{MARK}">',
    "a form": f'<form action="http://example.org/{MARK}"><input name=p></form>',
    "another base": f'<base href="http://example.org/{MARK}/">',
    "a refresh": f'<meta http-equiv="refresh" content="0;url=http://example.org/{MARK}">',
    "a style": f'<style>@import "http://example.org/{MARK}";</style><link rel=stylesheet href="http://example.org/{MARK}">',
    "the end of a style": f"</style><script>{RUN}</script>",
    "the end of a title": f"</title></textarea></pre></div><script>{RUN}</script>",
    "the end of a comment": f"--><script>{RUN}</script>",
    "the end of data": f"]]></svg></math><script>{RUN}</script>",
    "a detail": f'<details open ontoggle="{RUN}">x</details>',
    "a formula of MathML": f'<math><maction actiontype="statusline" xlink:href="javascript:{RUN}">x</maction></math>',
    "a formula of TeX": f"$\\href{{javascript:{RUN}}}{{x}}$ $\\class{{x\" onclick=\"{RUN}}}{{x}}$",
    "a quotation mark": f'" autofocus onfocus="{RUN}" x="',
    "a quotation mark of another kind": f"' autofocus onfocus='{RUN}' x='",
    "a template": "{{ ''.__class__.__mro__ }} {% for x in ().__class__.__base__.__subclasses__() %}" + MARK + "{% endfor %}",
    "a calculation": f'=HYPERLINK("http://example.org/{MARK}")',
    "a calculation with plus": f"+cmd|' /C {MARK}'!A0",
    "a calculation with minus": f"-2+3+cmd|' /C {MARK}'!A0",
    "a calculation with at": f"@SUM(1)*cmd|' /C {MARK}'!A0",
    "a calculation behind a tab": f"\t=1+{MARK}",
    "signs for the terminal": f"\x1b[2J\x1b]0;{MARK}\x07\x1b[31m{MARK}\x9b31m{MARK}",
    "signs that turn the line around": f"\u202e{MARK}\u2066\u200b\u0000",
}  # fmt: skip


def with_text(node: Notebook, text: str, *, drawn: bool) -> Notebook:
    """A notebook with this text as the first answer, in an error, an output and a cell of words, and where `drawn` in a figure."""
    found = copy.deepcopy(node)
    quoted = json.dumps(text)
    sources = iter(
        (
            "import matplotlib.pyplot as p; p.plot([1]); p.title({0}); p.xlabel({0}); p.show()"
            if drawn
            else "{0}",
            "from IPython.display import HTML, Markdown, SVG, display; display(HTML({0}), Markdown({0})); print({0})",
            "raise ValueError({0})",
        )
    )
    first = True
    for cell in found["cells"]:
        mark = cell["metadata"].get("nbgrader", {})
        if not mark.get("solution"):
            continue
        if cell["cell_type"] != "code":
            cell["source"] = text
        elif "=" in "".join(cell["source"]):
            more = next(sources, "").replace("{0}", quoted)
            name = "".join(cell["source"]).split("=")[0].strip()
            cell["source"] = f"{name} = {quoted if first else None}\n{more}"
            first = False
    found["cells"].append({"cell_type": "markdown", "metadata": {}, "source": text, "id": "of-its-own"})
    return found


def hostile_files(own: Notebook) -> Mapping[tuple[str, str], Callable[[], bytes]]:
    """Family and name of each hostile file; `own` is the attacker's sheet."""

    def forged(change: Callable[[Notebook], object]) -> bytes:
        node = copy.deepcopy(own)
        change(node)
        return json.dumps(node).encode()

    found: dict[tuple[str, str], Callable[[], bytes]] = {("files", name): make for name, make in RAW.items()}
    found |= {("forged notebooks", name): (lambda c=change: forged(c)) for name, change in FORGED.items()}
    return found | {
        ("pages and tables", name): (
            lambda t=text, d=not at % 6: json.dumps(with_text(own, t, drawn=d)).encode()
        )
        for at, (name, text) in enumerate(TEXTS.items())
    }
