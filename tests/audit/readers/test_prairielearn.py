"""Exercises of PrairieLearn as folders: what is read of each without running it, and why the others are not."""

from __future__ import annotations

import pytest

from corollary.audit.readers.prairielearn import prairielearn_records

PAGE = '<pl-question-panel><p>A mass {{params.m}} kg.</p></pl-question-panel>\n<pl-number-input answers-name="F" comparison="relabs" suffix="N"></pl-number-input>\n'
M = "    m = random.randint(1, 5)\n    data['params']['m'] = m\n"


def program(body, head="import random\nimport math\nimport numpy as np\n"):
    return f"{head}\ndef generate(data):\n{body}"


READ = [
    (PAGE, program(M + "    data['correct_answers']['F'] = m * 9.8\n"), "m*49/5"),
    (PAGE, program(M + "    F = m*9.8\n    data['correct_answers']['F'] = F\n"), "m*49/5"),
    (PAGE, program(M + "    data['correct_answers']['F'] = round(m * 9.8, 2)\n"), "m*49/5"),
    (PAGE, program(M + "    data['correct_answers']['F'] = float(m**2)\n"), "m^2"),
    (
        PAGE,
        program("    a = random.uniform(2, 3.5)\n    data['correct_answers']['F'] = math.sqrt(2*a)\n"),
        "sqrt(2*a)",
    ),
    (
        PAGE,
        program(
            "    a = np.random.uniform(10, 80)\n    data['correct_answers']['F'] = np.sin(np.radians(a))\n"
        ),
        "sin(a*pi/180)",
    ),
    (PAGE, program("    a = random.choice([2, 4, 6])\n    data['correct_answers']['F'] = a/2\n"), "a/2"),
    (
        PAGE,
        program("    a = np.round(np.random.uniform(1, 2), 2)\n    data['correct_answers']['F'] = np.pi*a\n"),
        "pi*a",
    ),
    (
        PAGE,
        program(M + "    data['correct_answers']['F'] = m*g\n", "import random\ng = 9.81\n"),
        "m*(981/100)",
    ),
    (
        PAGE,
        program("    '''Makes numbers.'''\n" + M + "    data['correct_answers']['F'] = m/3\n    return\n"),
        "m/3",
    ),
    (
        PAGE,
        program(M + "    v = random.randint(2, 9)\n    data['correct_answers']['F'] = 0.5*m*v**2\n"),
        "1/2*m*v^2",
    ),
    (PAGE, program(M + "    data['correct_answers']['F'] = math.pow(m, 3)\n"), "m^3"),
    (PAGE, program(M + "    data['correct_answers']['F'] = math.atan2(m, 2)\n"), "atan2(m, 2)"),
    (
        PAGE,
        program("    a = random.randrange(1, 9, 2)\n    data['correct_answers']['F'] = math.log(a)\n"),
        "ln(a)",
    ),
    ('<pl-number-input answers-name="F" correct-answer="3.2" suffix="N"></pl-number-input>', "", "3.2 N"),
    ('<p>…</p><pl-units-input answers-name="F" correct-answer="4.5 m/s"></pl-units-input>', "", "4.5 m/s"),
]
P, C = "data['params']", "data['correct_answers']"
DRAWN = "random.randint(1, 5)"
READ += [
    (PAGE, program(f"    {P}['m'] = {DRAWN}\n    {C}['F'] = 2*{P}['m']\n"), "2*m"),
    (PAGE, program(f"    {P}['m'] = {DRAWN}\n    m = {P}['m']\n    {C}['F'] = 2*m\n    return data\n"), "2*m"),
    (PAGE, program(f"    p = {P}\n    m = {DRAWN}\n    p['m'] = round(m, 1)\n    {C}['F'] = p['m']/2\n"), "m/2"),
    (PAGE, program(f"    {P}['m'] = m = {DRAWN}\n    {C}.update(F=3*m)\n"), "3*m"),
    (PAGE, program(f"    m: int = {DRAWN}\n    {P}.update({{'m': m}})\n    {C}['F'] = str(3*m)\n"), "3*m"),
    (PAGE, program(f"    a, b = {DRAWN}, {DRAWN}\n    {P}['a'], {P}['b'] = a, b\n    {C}['F'] = a - b\n"), "a - b"),
    (PAGE, program(f"    d = {DRAWN}\n    {P} = {{'d': d, 'who': 'a cart'}}\n    {C} = {{'F': d/2}}\n"), "d/2"),
    (PAGE, program(M + "    F = m * 2\n    F /= 5\n    data['correct_answers']['F'] = F\n"), "m*2/5"),
    (PAGE, program(M + "    data['correct_answers']['F'] = cos(m)\n", "import random\nfrom math import sin as cos\n"), "sin(m)"),
    (PAGE, program(M + "    data['correct_answers']['F'] = weight(m)\n", "import random\ng = 9.81\ndef weight(m):\n    return m*g\n"), "m*(981/100)"),
    ('<pl-multiple-choice answers-name="F"><pl-answer correct="true">4.5 N</pl-answer><pl-answer>9 N</pl-answer></pl-multiple-choice>', "", "4.5 N"),
    (PAGE, program(f"    x = {DRAWN}/100\n    {P}['who'] = random.choice(['Ada', 'Bob'])\n    {C}['F'] = 5*x\n"), "5*x"),
]  # fmt: skip
PARAMS_DOUBLED = f"    {P}['a0'] = {DRAWN}\n"
PARAMS_DOUBLED += "".join(f"    {P}['a{i + 1}'] = {P}['a{i}']*{P}['a{i}']\n" for i in range(40))
PARAMS_DOUBLED += f"    {C}['F'] = {P}['a40']\n"
HELPERS_DOUBLED = "def f0(x):\n    return x\n"
HELPERS_DOUBLED += "".join(f"def f{i + 1}(x):\n    return f{i}(x) + f{i}(x)\n" for i in range(30))
NOT_READ = [
    (PAGE, program(f"    m = 3\n    {P}['m'] = {DRAWN}\n    {C}['F'] = 2*{P}['m']\n"), "twice"),
    (PAGE, program(f"    {P}['m'] = random.choice(['a', 'b'])\n    m = 3\n    {C}['F'] = 2*{P}['m']\n"), "after it is shown"),
    (PAGE, program(f"    {P}['m'] = 1\n    {P}['m'] = 2\n    {C}['F'] = 2*{P}['m']\n"), "set twice"),
    (PAGE, program(f"    {C}['F'] = 2*{P}['m']\n"), "Subscript"),
    (PAGE, program(f"    m = {DRAWN}\n    {P}['m'] = f'{{m:.1f}}'\n    {C}['F'] = 2*{P}['m']\n"), "is a text"),
    (PAGE, program(f"    a, b = random.sample(range(9), 2)\n    {C}['F'] = a*b\n"), "is not an assignment"),
    (PAGE, program(f"    a, b = {DRAWN}, {DRAWN}\n    a, b = b, a\n    {C}['F'] = a - b\n"), "twice"),
    (PAGE, program(f"    {P}.update(**numbers())\n    {C}['F'] = 1\n"), "no plain name"),
    (PAGE, program(f"    x = 9 - {DRAWN}\n    {C}['F'] = x\n"), ""),
    (PAGE, program(M + "    if m > 2:\n        m = 1\n    data['correct_answers']['F'] = m\n"), "is not an assignment"),
    (PAGE, program(M + "    for i in range(3):\n        m = m + i\n    data['correct_answers']['F'] = m\n"), "is not an assignment"),
    (PAGE, program(M + "    data['correct_answers']['G'] = m\n"), "no correct answer 'F'"),
    (PAGE, program(M + "    data['correct_answers']['F'] = solve(m)\n"), ""),
    (PAGE, program(M + "    m = m + 1\n    data['correct_answers']['F'] = m\n"), "after it is shown"),
    (PAGE, program(M + "    data['correct_answers']['F'] = m^2\n"), "BitXor"),
    (PAGE, program(M + "    data['correct_answers']['F'] = m//2\n"), "FloorDiv"),
    (PAGE, program(M + "    m += 1\n    data['correct_answers']['F'] = m\n"), "after it is shown"),
    (PAGE, program(M + "    data['correct_answers']['F'] = m\n    data['correct_answers']['F'] += m\n"), "is not an assignment"),
    (PAGE, program(M + "    data['correct_answers']['F'] = math.sin(m)\n", "import random, math\nmath.sin = math.cos\n"), "neither an import"),
    (PAGE, program(M + "    data['correct_answers']['F'] = sqrt(m)\n", "import random\ndef sqrt(x):\n    y = x\n    return y**2\n"), "calls sqrt"),
    (PAGE, program(M + "    data['correct_answers']['F'] = sqrt(m)\n", "import random\nfrom tricks import sqrt\n"), "calls sqrt"),
    (PAGE, program(M + "    sqrt = 2\n    data['correct_answers']['F'] = sqrt*m\n", "import random\nfrom math import sqrt\n"), "something else"),
    (PAGE, program(M + "    data['correct_answers']['F'] = 2*g*m\n", "import random\ng = 9.81\nif True:\n    g = 5\n"), "neither an import"),
    (PAGE, program(M + "    data['correct_answers']['F'] = 2*m\ndef prepare(data):\n    pass\n"), "begins prepare"),
    (PAGE, program(f"    m = {DRAWN}\n    {P}['m'] = 3.6*m\n    {C}['F'] = 2*m\n"), "another number than m"),
    (PAGE, program(M + "    data['correct_answers']['F'] = round(2*m, -1)\n"), "before the decimal point"),
    ('<pl-number-input answers-name="F" correct-answer="1">', program(M + f"    {C}['F'] = m\n"), "sets answers"),
    (PAGE, "def grade(data):\n    pass\n", "no function generate"),
    (PAGE, "", "no server.py"),
    ("<p>How far?</p>", program(M), "no input"),
    (PAGE, program(PARAMS_DOUBLED), "too long an expression"),
    (PAGE, program(M + f"    {C}['F'] = f30(m)\n", "import random\n" + HELPERS_DOUBLED), ""),
    (PAGE, program(M + f"    {C}['F'] = round(m/2)\n"), "to a whole number"),
    (PAGE, program(f"    a0 = {DRAWN}\n" + "".join(f"    a{i + 1} = a{i} + a{i}\n" for i in range(60)) + f"    {C}['F'] = a60\n"), "too long a formula"),
    ('<pl-multiple-choice answers-name="F"></pl-multiple-choice>', "", "0 of its options"),
]  # fmt: skip


def folder_of(tmp_path, page, code):
    (tmp_path / "question.html").write_text(page, encoding="utf-8")
    if code:
        (tmp_path / "server.py").write_text(code, encoding="utf-8")
    return tmp_path / "question.html"


@pytest.mark.parametrize(("page", "code", "published"), READ)
def test_what_is_read(tmp_path, same, page, code, published):
    (record,) = prairielearn_records(folder_of(tmp_path, page, code))
    assert not record.unread
    assert same(*record.published, published)
    assert record.id == tmp_path.name


@pytest.mark.parametrize(("page", "code", "why"), NOT_READ)
def test_what_is_not_read_is_said(tmp_path, page, code, why):
    (record,) = prairielearn_records(folder_of(tmp_path, page, code))
    assert record.unread
    assert why in record.unread


TWO = PAGE.replace('"F"', '"p"', 1) + PAGE.replace('"F"', '"E"', 1)
SEVERAL = [
    (TWO, program(M + f"    {C}['p'] = 2*m\n    {C}['E'] = 2*m**2\n"), {"p": "2*m", "E": "2*m^2"}),
    (TWO, program(M + f"    x = 2*m\n    {C}['p'] = x\n    x = 3*m\n    {C}['E'] = x\n    x = 1\n"), {"p": "2*m", "E": "3*m"}),
    (TWO, program(M + f"    {C}['p'] = solve(m)\n    {C}['E'] = m\n"), {"p": "", "E": "m"}),
    (TWO, program(M + f"    {C}['E'] = m\n"), {"p": "", "E": "m"}),
    (TWO + '<pl-string-input answers-name="who"></pl-string-input>', program(M + f"    {C}.update(p=m, E=3*m, who='Ada')\n"), {"p": "m", "E": "3*m", "who": ""}),
]  # fmt: skip


@pytest.mark.parametrize(("page", "code", "expected"), SEVERAL)
def test_each_answer_is_a_record_by_its_name(tmp_path, same, page, code, expected):
    records = prairielearn_records(folder_of(tmp_path, page, code))
    assert [each.id for each in records] == [f"{tmp_path.name}#{name}" for name in expected]
    for record, key in zip(records, expected.values(), strict=True):
        assert bool(record.unread) == (not key)
        assert not key or same(*record.published, key)


def test_nothing_of_it_is_run(tmp_path):
    mark = tmp_path / "run"
    code = f"open({str(mark)!r}, 'w')\n" + program(M + f"    open({str(mark)!r}, 'w')\n")
    (record,) = prairielearn_records(folder_of(tmp_path, PAGE, code))
    assert record.unread
    assert not mark.exists()
