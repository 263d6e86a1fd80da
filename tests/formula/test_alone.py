"""What reads an answer also stands in every notebook: it needs nothing but Python."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import corollary

READS = """
import sys
sys.path.append(sys.argv[1])
from corollary.answers.quantity import read_quantity
from corollary.formula.latex import latex
from corollary.formula.syntax import parse
from corollary.formula.plain_text import text
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import unit
of = {"m": unit("kg").dimension, "g": unit("m/s^2").dimension, "h": unit("m").dimension}
tree = parse("m√(2gh)", of)
print(text(tree), dimension_of(tree, of) == unit("N s").dimension, latex(tree))
print(read_quantity("8,6 Ns", unit("kg m/s")).as_read)
print(read_quantity("2 kg * sqrt(2*9.8*5) m/s", unit("kg m/s")).as_read)
print({name.partition(".")[0] for name in sys.modules} - sys.stdlib_module_names)
"""


def test_reading_needs_python_alone():
    """`-S` and `-I`: no package of anybody's can be found, as on a student's own computer."""
    home = str(Path(corollary.__file__).parent.parent)
    command = [sys.executable, "-S", "-I", "-X", "utf8", "-c", READS, home]
    run = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=120, check=False)
    assert run.stderr == ""
    tree, reading, worked, modules = run.stdout.splitlines()
    assert tree == r"m*sqrt(2*g*h) True m\, \sqrt{2\, g\, h}"
    assert reading == "8.6 N s"
    assert worked == "19.799 kg m/s"
    assert modules in ("{'corollary'}", "{'__main__', 'corollary'}", "{'corollary', '__main__'}")
