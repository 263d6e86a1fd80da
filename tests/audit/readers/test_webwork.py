"""Twenty files of WeBWorK as people write them: what is read of each, and why the others are not."""

from __future__ import annotations

import pytest

from corollary.audit.bank_file import laws_by_id, records_of
from corollary.audit.examine import examine
from corollary.audit.readers.webwork import webwork_records

HEAD = 'DOCUMENT();\nloadMacros("PGstandard.pl", "MathObjects.pl");\nTEXT(beginproblem());\n# a comment; with a mark\n'
TEXT = "BEGIN_TEXT\nA car of mass \\($m\\) kg has $PAR an energy of \\{ans_rule(20)\\} J\nEND_TEXT\n"
MV = "$m = random(1,10,0.5);\n$v = random(2, 30);\n"

READ = [
    (MV + "$ans = $m*$v**2/2;\nANS(num_cmp($ans));", "m*v^2/2", {"m": (1, 10), "v": (2, 30)}),
    (MV + '$ans = Compute("0.5*$m*$v^2");\nANS($ans->cmp);', "1/2*m*v^2", {"m": (1, 10)}),
    (MV + "$p = $m * $v;\n$ans = $p*$v/2;\nANS(Compute($ans)->cmp());", "m*v*v/2", {"v": (2, 30)}),
    (MV + "ANS(num_cmp($m*$v, tol => 0.01));", "m*v", {"m": (1, 10)}),
    ("$F = 12;\n$m = 4;\n$a = $F/$m;\nANS(Real($a)->cmp);", "3", {}),
    ("$F = 12;\n$m = 4;\n$a = $F/$m;\nANS(NumberWithUnits(\"$a m/s^2\")->cmp);", "3 m/s^2", {}),
    ('ANS(NumberWithUnits("9.8 m/s^2")->cmp);', "9.8 m/s^2", {}),
    ('ANS(num_cmp(42.5));', "42.5", {}),
    ("$t = list_random(2, 3, 5);\n$d = 9.8*$t**2/2;\nANS(num_cmp($d));", "49/5*t^2/2", {"t": (2, 5)}),
    ("$theta = random(20,70,1);\n$x = sin($theta*pi/180);\nANS(Real($x)->cmp);", "sin(theta*pi/180)", {"theta": (20, 70)}),
    ("$h = random(1,9,1);\n$v = sqrt(2*9.81*$h);\nANS(num_cmp($v));", "sqrt(2*981/100*h)", {"h": (1, 9)}),
    ("my $k = random(100,500,10);\nmy $w = ($k/2)**0.5;\nANS(Real($w)->cmp);", "(k/2)^(1/2)", {"k": (100, 500)}),
    ("$x = random(1,5,1); $y = random(1,5,1); $r = sqrt($x**2+$y**2);\nANS(num_cmp($r));", "sqrt(x^2 + y^2)", {"y": (1, 5)}),
    ("$a = random(-9,-2,1);\n$unused = join(',', 1, 2);\n$b = 3*$a;\nANS(num_cmp($b));", "3*a", {"a": (-9, -2)}),
    ("$m = random(1,5,1);\nBEGIN_PGML\nThe weight is [____]{$m*9.8} N.\nEND_PGML", "m*49/5", {"m": (1, 5)}),
    ("$m = random(1,5,1);\n$w = $m*10;\nBEGIN_PGML\n[`F`] = [____]{Real($w)} N\nEND_PGML", "m*10", {"m": (1, 5)}),
    ("$m = random(1,5,1);\n$w = log($m);\nANS(num_cmp($w));", "ln(m)", {"m": (1, 5)}),
    ("$m = random(1,5,1);\n$w = exp(-$m)*pi;\nANS(num_cmp($w));", "exp(-m)*pi", {"m": (1, 5)}),
    ("$l = random(1,5,1);\n$t = 2*$PI*sqrt($l/9.8);\nANS(num_cmp($t));", "2*pi*sqrt(l/9.8)", {"l": (1, 5)}),
    ("$d = random(1,5,1);\n$v = sprintf(\"%.2f\", $d/3);\nANS(num_cmp($v));", "d/3", {"d": (1, 5)}),
    (MV + "$a = $m;\n$a *= $v;\n$a = $a + 1;\nANS(num_cmp($a));", "m*v + 1", {"m": (1, 10)}),
    (MV + "=pod\n\n$x = 1;\n$a = $m/$v;\n\n=cut\n\n$a = $m*$v;\nANS(num_cmp($a));", "m*v", {"m": (1, 10)}),
    (MV + "TEXT(EV3(<<'EOT'));\nx;\n$a = $m/$v;\nEOT\n$a = $m*$v;\nANS(num_cmp($a));", "m*v", {"m": (1, 10)}),
    (MV + "$power = $m*$v;\n$gamma = $power/2;\nANS(num_cmp($gamma));", "m*v/2", {"m": (1, 10)}),
    ('$m = sprintf("%.2f", random(1,10,0.5));\nANS(num_cmp(2*$m));', "2*m", {"m": (1, 10)}),
    ('$n = sprintf("%0.0f", random(2,9,1));\nANS(num_cmp(3*$n));', "3*n", {"n": (2, 9)}),
    ("$q = non_zero_random(-5,5,1);\n$v = 2*$q;\nANS(num_cmp($v));", "2*q", {"q": (-5, 5)}),
]  # fmt: skip
NOT_READ = [
    ("$pi = 3;\n" + MV + "ANS(num_cmp($m*pi));", "a pi of its own, 3"),
    (MV + '$a = "$m$v";\nANS(num_cmp($a));', "side by side"),
    (MV + '$d = $m - $v;\n$a = Compute("-$d^2");\nANS($a->cmp);', "minus sign"),
    ("$m = 010;\nANS(num_cmp($m));", "begins with 0"),
    (MV + "$a = $m*$v;\nBEGIN_PGML\n[@ $a = $m @]* [__]{$a}\nEND_PGML", "its text assigns"),
    ('$d = random(1,5,1);\n$v = sprintf("%d", $d/3);\nANS(num_cmp($v));', "v: "),
    (MV + "if ($m > 3) { $v = 2; }\n$a = $m*$v;\nANS(num_cmp($a));", "conditions, loops"),
    (MV + "do { $u = random(1,5,1); } until ($u != $v);\nANS(num_cmp($u));", "conditions, loops"),
    (MV + "$m = $m + 1;\n$a = $m*$v;\nANS(num_cmp($a));", "given a value twice"),
    (MV + "ANS(num_cmp($m));\nBEGIN_PGML\n[__]{$v}\nEND_PGML", "others in ANS"),
    (MV + "ANS(num_cmp($m)); ANS(@more);", "compares several"),
    (MV + "$both = MultiAnswer($m, $v);\nANS($both->cmp); ANS(num_cmp($v));", "compares several"),
    (MV + "NAMED_ANS(a => num_cmp($m), a => num_cmp($v));", "are called 'a'"),
    (MV + "BEGIN_TEXT\n\\{ ANS(num_cmp($m)) \\}\nEND_TEXT\nANS(num_cmp($v));", "its text answers"),
    (MV + "$a = $m*[$v + 1];\nANS(num_cmp($a));", "square brackets"),
    (MV + '$n = sprintf("%0.0f", $m*$v);\nANS(num_cmp($n));', "to a whole one"),
    (MV + "NAMED_ANS(num_cmp($m));", "NAMED_ANS with 1 arguments"),
    (MV + "$gamma_v = 2;\n$gamma = 3;\nANS(num_cmp($m*$gamma));", "gamma_v is not a letter"),
    (MV, "0 answers"),
    (MV + "$ans = 0.5*$m*$v^2;\nANS(Real($ans)->cmp);", "not a power in Perl"),
    (MV + "$m += 1;\n$a = $m*$v;\nANS(num_cmp($a));", "given a value twice"),
    (MV + "$a = $m*$v;\n$a++;\nANS(num_cmp($a));", "is changed"),
    (MV + "($m, $v) = (1, 2);\n$a = $m*$v;\nANS(num_cmp($a));", "is changed"),
    ("@list = (1,2);\n$a = $list[0];\nANS(num_cmp($a));", "a: "),
    ("$f = Formula('x^2');\nANS($f->D('x')->cmp);", ""),
    ("$a = random(1,5,1);\n$b = somebody($a);\nANS(num_cmp($b));", ""),
]


def file_of(tmp_path, text):
    path = tmp_path / "fall.pg"
    path.write_text(HEAD + TEXT + text + "\nENDDOCUMENT();\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(("text", "published", "given"), READ)
def test_what_is_read(tmp_path, same, text, published, given):
    (record,) = webwork_records(file_of(tmp_path, text))
    assert not record.unread
    assert same(*record.published, published)
    found = {each.symbol: (each.low, each.high) for each in record.given}
    assert given.items() <= found.items()


@pytest.mark.parametrize(("text", "why"), NOT_READ)
def test_what_is_not_read_is_said(tmp_path, text, why):
    (record,) = webwork_records(file_of(tmp_path, text))
    assert record.unread
    assert why in record.unread
    assert not record.published


SEVERAL = [
    ("ANS(num_cmp($m)); ANS(num_cmp($m*$v));", {"fall#1": "m", "fall#2": "m*v"}),
    ("ANS(num_cmp($m), num_cmp($m*$v, tol => 0.1));", {"fall#1": "m", "fall#2": "m*v"}),
    ("NAMED_ANS(p => num_cmp($m*$v), m => num_cmp($m));", {"fall#p": "m*v", "fall#m": "m"}),
    ("LABELED_ANS('p', num_cmp($m*$v));\nLABELED_ANS('m', num_cmp($m));", {"fall#p": "m*v", "fall#m": "m"}),
    ("WEIGHTED_ANS(num_cmp($m), 40, num_cmp($v), 60);", {"fall#1": "m", "fall#2": "v"}),
    ("BEGIN_PGML\n[__]{$m} and [____]{Real($m*$v)}\nEND_PGML", {"fall#1": "m", "fall#2": "m*v"}),
    (
        "ANS(str_cmp('up')); ANS(num_cmp($m)); ANS(num_cmp(int($v)));",
        {"fall#1": "", "fall#2": "m", "fall#3": ""},
    ),
    (
        "$p = NumberWithUnits($m*$v, 'N s');\nANS($p->cmp); ANS(num_cmp($v));",
        {"fall#1": "m*v", "fall#2": "v"},
    ),
]


@pytest.mark.parametrize(("text", "expected"), SEVERAL)
def test_each_answer_is_a_record(tmp_path, same, text, expected):
    """One that is not made out costs itself alone, and the others keep their places."""
    records = webwork_records(file_of(tmp_path, MV + text))
    assert [each.id for each in records] == list(expected)
    for record, key in zip(records, expected.values(), strict=True):
        assert bool(record.unread) == (not key)
        assert not key or same(*record.published, key)


def test_the_answers_of_a_file_are_joined_with_laws_by_place_or_in_their_order(tmp_path):
    path = file_of(tmp_path, MV + "ANS(num_cmp($m*$v)); ANS(num_cmp($m*$v**2));")
    for stated, findings in [
        (
            "- {id: fall, given: {m: kg, v: m/s}, laws: [p = m*v, E = m*v^2/2], asked: [p, E]}",
            ["agrees", "wrong"],
        ),
        ("- {id: fall#2, given: {m: kg, v: m/s}, laws: [E = m*v^2], asked: E}", ["cannot say", "agrees"]),
        ("- {id: fall, given: {m: kg, v: m/s}, laws: [p = m*v], asked: p}", ["cannot say", "cannot say"]),
    ]:
        laws = tmp_path / "laws.yaml"
        laws.write_text(stated, encoding="utf-8")
        records = records_of(path, laws_by_id(laws))
        assert [each.finding for record in records for each in examine(record)] == findings


def test_nothing_of_it_is_executed(tmp_path):
    """What would be done by a program is a text here."""
    (record,) = webwork_records(file_of(tmp_path, "$a = `touch /tmp/executed`;\nANS(num_cmp($a));"))
    assert record.unread


LAWS = """
- id: fall
  given: {theta: deg, v: km/h}
  laws: [s = v*t, t = 2 * v*sin(theta)/g]
  convention: g = 9.8 m/s^2
  asked: s in km
"""


@pytest.mark.parametrize(
    ("key", "finding"),
    [
        ("($v/3.6)*2*($v/3.6)*sin($theta*pi/180)/9.8/1000", "agrees"),
        ("($v/3.6)*2*($v/3.6)*sin($theta)/9.8/1000", "wrong"),
        ("$v*2*$v*sin($theta*pi/180)/9.8/1000", "wrong"),
        ("($v/3.6)*2*($v/3.6)*sin($theta*pi/180)/9.8", "wrong"),
    ],
)
def test_a_key_of_bare_numbers_is_held_against_laws_in_its_units(tmp_path, key, finding):
    path = file_of(
        tmp_path, f"$v = random(20,90,1);\n$theta = random(20,70,1);\n$s = {key};\nANS(num_cmp($s));"
    )
    laws = tmp_path / "laws.yaml"
    laws.write_text(LAWS, encoding="utf-8")
    (record,) = records_of(path, laws_by_id(laws))
    (outcome,) = examine(record)
    assert outcome.finding == finding
    (alone,) = records_of(path, {})
    assert "no laws are stated" in examine(alone)[0].why


@pytest.mark.parametrize(
    ("text", "finding"),
    [
        ('$s = 2*$t;\nANS(num_cmp("$s m", units => 1));', "agrees"),
        ('$s = 2*$t;\nANS(num_cmp("$s km", units => 1));', "wrong"),
        ('$s = NumberWithUnits(2*$t/1000, "km");\nANS($s->cmp);', "agrees"),
        ('$s = NumberWithUnits(2*$t, "km");\nANS($s->cmp);', "wrong"),
        ('$s = NumberWithUnits(2*$t, "furlong");\nANS($s->cmp);', "cannot say"),
        ('$s = NumberWithUnits(2*$t, "m");\n$r = 2*$s;\nANS(num_cmp($r));', "cannot say"),
        ("$v = $t/3;\n$s = 6*$v;\nANS(num_cmp($s));", "cannot say"),
        ("$k = random(1,2,1);\n$s = 2*$k;\nANS(num_cmp($s));", "cannot say"),
    ],
)
def test_a_key_is_held_in_its_own_unit_and_in_the_letters_of_the_laws(tmp_path, text, finding):
    """The laws are for a speed that the statement gives, 2 m/s; what the program makes of a speed of its own is not theirs."""
    path = file_of(tmp_path, f"$t = random(2,9,1);\n{text}")
    laws = tmp_path / "laws.yaml"
    given = "{v: m/s, t: s}" if "$v" in text else "{v: 2 m/s, t: s}"
    laws.write_text(f"- {{id: fall, given: {given}, laws: [s = v*t], asked: s in m}}", encoding="utf-8")
    (record,) = records_of(path, laws_by_id(laws))
    assert [each.finding for each in examine(record)] == [finding]
