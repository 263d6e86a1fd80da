"""Hostile files in place of banks and records: each format nested, doubled, repeated, cut off and lied about, and what is no file at all."""

from __future__ import annotations

import gzip
import io
import json
import os
import socket
import zipfile
from collections.abc import Iterator
from pathlib import Path

GOOD = "- {id: good, given: {m: 2 kg, a: 3 m/s^2}, laws: [F = m*a], asked: F, published: 6.0 N}\n"
RECORD = "- {{id: a, given: {{m: {given}}}, laws: ['{law}'], asked: F, published: '{published}'}}\n"
DRAWN = "$v = random(2,8,1);\n"
PAGE = '<pl-number-input answers-name="F"></pl-number-input>'
R_HEAD = "```{r}\nm <- sample(2:9, 1)\n"
R_META = "\nMeta-information\n================\nextype: num\nexsolution: `r F`\n"
PARAMS_DOUBLED = "def generate(data):\n    p = data['params']\n    p['a0'] = 2\n"
PARAMS_DOUBLED += "".join(f"    p['a{i + 1}'] = p['a{i}']*p['a{i}']\n" for i in range(60))
PARAMS_DOUBLED += "    data['correct_answers']['F'] = p['a60']\n"
ITEM = (
    '<assessmentItem identifier="i"><responseDeclaration identifier="R" cardinality="single" baseType="float">'
    "<correctResponse><value>{}</value></correctResponse></responseDeclaration></assessmentItem>"
)


def hostile_files(folder: Path, size: int) -> list[Path]:
    """The files, written into a folder; `size` is how many characters, about, what is repeated comes to."""
    paths: list[Path] = []
    for name, content in (*_texts(size), *_programs(size), *_contents(size)):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode("utf-8", "surrogatepass") if isinstance(content, str) else content)
        if path.name != "server.py":
            paths.append(path)
    return [*paths, *_no_files(folder)]


def _texts(size: int) -> Iterator[tuple[str, str]]:
    """Records and XML."""
    levels = "".join(f"<!ENTITY e{i + 1} '{f'&e{i};' * 10}'>" for i in range(12))
    yield "laughs.xml", f'<?xml version="1.0"?><!DOCTYPE quiz [<!ENTITY e0 "ha">{levels}]><quiz>&e12;</quiz>'
    yield (
        "blowup.xml",
        f"<!DOCTYPE quiz [<!ENTITY a '{'a' * size}'>]><quiz>{'&a;' * (size // 3)}</quiz>",
    )
    yield "external.xml", '<!DOCTYPE quiz [<!ENTITY a SYSTEM "file:///etc/passwd">]><quiz>&a;</quiz>'
    yield "external_dtd.xml", '<!DOCTYPE quiz SYSTEM "http://127.0.0.1:9/x.dtd"><quiz/>'
    yield "parameter.xml", '<!DOCTYPE quiz [<!ENTITY % a "%a;">%a;]><quiz/>'
    yield "nested.xml", "<quiz>" * (size // 6)
    yield "wide.xml", f"<quiz>{'<question/>' * (size // 11)}</quiz>"
    attributes = " ".join(f"a{i}=''" for i in range(size // 9))
    yield "attributes.xml", f"<quiz {attributes}/>"
    yield "long_attribute.xml", f"<quiz a='{'&#65;' * (size // 5)}'/>"
    yield "comments.xml", f"<quiz>{'<!--' * (size // 4)}</quiz>"
    yield "cdata.xml", f"<quiz>{'<![CDATA[' * (size // 9)}</quiz>"
    yield "instructions.xml", f"<quiz>{'<?a?>' * (size // 5)}</quiz>"
    yield "open_brackets.xml", _moodle("<" * size)
    yield "open_tags.xml", _moodle("<sup " * (size // 5))
    yield "raised.xml", _moodle(f"<sup>{' ' * size}")
    yield "entities.xml", _moodle("&amp;lt;" * (size // 8))
    yield "unknown_entity.xml", "<quiz>&nbsp;</quiz>"
    yield "minus.xml", _moodle("text", "-" * size + "1")
    yield "digits.xml", _moodle("text", "9" * size)
    yield "exponent.xml", _moodle("text", "1e999999999")
    yield "wildcards.xml", _moodle("text", "{a" * (size // 2), "calculated")
    yield "powers.xml", _moodle("text", "pow(9," * 300 + "9" + ")" * 300, "calculated")
    yield (
        "datasets.xml",
        "<quiz><question type='calculated'><answer fraction='100'><text>{a}</text></answer><dataset_definitions>"
        f"<dataset_definition><name><text>a</text></name><dataset_items>{'<dataset_item><value>1</value></dataset_item>' * (size // 50)}"
        "</dataset_items></dataset_definition></dataset_definitions></question></quiz>",
    )
    yield (
        "fraction.xml",
        "<quiz><question type='numerical'><answer fraction='9e999'><text>1</text></answer></question></quiz>",
    )
    for encoding in ("UTF-7", "UTF-16", "cp037", "nobodys"):
        yield f"says_{encoding}.xml", f'<?xml version="1.0" encoding="{encoding}"?><quiz>+ADw-</quiz>'
    yield (
        "items_in_items.xml",
        "<assessmentItem><itemBody>" * 49 + "a" * size + "</itemBody></assessmentItem>" * 49,
    )
    yield "qti_minus.xml", ITEM.format("-" * size)
    yield (
        "qti_expression.xml",
        '<assessmentItem><responseDeclaration/><templateProcessing><setCorrectResponse identifier="R">'
        + "<sum>" * 90
        + "<baseValue>1</baseValue>" * (size // 30)
        + "</sum>" * 90
        + "</setCorrectResponse></templateProcessing></assessmentItem>",
    )
    yield "aliases.yaml", "".join(f"a{i}: &a{i} [{f'*a{i - 1}, ' * 9 if i else 'ha'}]\n" for i in range(12))
    yield "many_aliases.yaml", "- &a {id: a}\n- [" + "*a, " * (size // 4) + "]\n"
    yield "alias_to_itself.yaml", "&a [*a]\n"
    yield "merge.yaml", "- &a {<<: *a, id: 1}\n"
    yield "python.yaml", '- !!python/object/apply:os.system ["touch /tmp/hostile"]\n'
    yield "binary.yaml", "- id: !!binary |\n    /w==\n"
    yield "flows.yaml", "[" * size
    yield "tables.yaml", "{a: " * (size // 4)
    yield "dashes.yaml", "- " * (size // 2) + "a\n"
    yield "deep_lines.yaml", "".join(" " * i + "a:\n" for i in range(int((2 * size) ** 0.5)))
    yield "questions.yaml", "? " * (size // 2)
    yield "quotes.yaml", '- id: "' + "a\\\n" * (size // 3)
    yield "tags.yaml", "!a " * (size // 3)
    yield "anchors.yaml", "- " + "&a " * (size // 3)
    yield "folded.yaml", "- statement: >\n" + "   a\n\n" * (size // 6)
    yield (
        "half_character.yaml",
        '- {id: "\\ud800", given: {m: 1 kg}, laws: ["F = m"], asked: F, published: "\\udfff"}\n',
    )
    yield (
        "control.yaml",
        '- {id: "\\e[2J\\0", given: {m: 1 kg}, laws: [F = m], asked: F, published: "\\e]0;x\\a"}\n',
    )
    yield "many_records.yaml", "- {}\n" * (size // 5)
    yield "many_complaints.yaml", "- {id: a, b: c}\n" * (size // 16)
    yield "law_of_minus.yaml", RECORD.format(given="1 kg", law=f"F = {'-' * size}1", published="1 N")
    yield (
        "law_of_brackets.yaml",
        RECORD.format(given="1 kg", law=f"F = {'(' * 3000}m{')' * 3000}", published="1 N"),
    )
    yield "law_of_powers.yaml", RECORD.format(given="1 kg", law="F = m^9^9^9^9", published="1 N")
    yield "law_of_terms.yaml", RECORD.format(given="1 kg", law="F = m" + "*(m+1)" * 600, published="1 N")
    yield "answer_of_minus.yaml", RECORD.format(given="1 kg", law="F = m", published="-" * size + "1")
    yield "answer_of_digits.yaml", RECORD.format(given="1 kg", law="F = m", published="9" * size + " kg")
    yield (
        "answer_of_units.yaml",
        RECORD.format(given="1 kg", law="F = m", published="1 " + "kg " * (size // 3)),
    )
    points = "1..\n\n" * (size // 5)
    yield "given_of_points.yaml", RECORD.format(given=f"'{points}'", law="F = m", published="1 kg")
    yield "given_huge.yaml", RECORD.format(given="1e999999999 kg", law="F = m", published="1 kg")
    yield "convention.yaml", GOOD.replace("}\n", f", convention: 'g = {'1 or ' * (size // 5)}'}}\n")
    yield "answer_of_problem.yaml", f"- {{id: p, problem: X12.5, asked: a, published: '{'(' * size}'}}\n"
    yield "nested.json", "[" * size + "]" * size
    yield "objects.json", '{"a":' * (size // 5)
    yield (
        "not_numbers.json",
        '[{"id": NaN, "given": {"m": 1e999}, "laws": [Infinity], "asked": -0, "published": 1e999}]',
    )
    yield "twice.json", '[{"id": "a", "id": "b", "laws": ["F = m"], "asked": "F", "published": "1 N"}]'
    yield (
        "half_character.json",
        json.dumps([{"id": "\ud800", "laws": ["F = 1"], "asked": "F", "published": "up"}]),
    )
    yield (
        "long_string.json",
        json.dumps([{"id": "a" * size, "laws": ["F = 1"], "asked": "F", "published": "up"}]),
    )
    yield "columns.csv", "id," * (size // 3) + "\n"
    yield "blank_columns.csv", "id" + "," * size + "\n" + "1" + "," * size
    yield "field.csv", "id,laws,asked,published\n" + "a" * size + ",F = 1,F,up\n"
    yield "open_quote.csv", 'id,laws,asked,published\n"' + "a\n" * (size // 2)
    yield "values.csv", "id,given\na," + "m=1;" * (size // 4) + "\n"
    yield "nul.csv", "id,laws\n\0,\0\n"
    yield "rows.csv", "id\n" + "a\n" * (size // 2)


def _moodle(text: str, answer: str = "1", kind: str = "numerical") -> str:
    return (
        f"<quiz><question type='{kind}'><questiontext><text><![CDATA[{text}]]></text></questiontext>"
        f"<answer fraction='100'><text>{answer}</text></answer></question></quiz>"
    )


def _programs(size: int) -> Iterator[tuple[str, str]]:
    """WeBWorK, R/exams and PrairieLearn."""
    doubled = "".join(f"$a{i + 1} = $a{i}*$a{i};\n" for i in range(100))
    yield "doubled.pg", f"{DRAWN}$a0 = $v;\n{doubled}ANS(num_cmp($a100));"
    yield (
        "chained.pg",
        f"{DRAWN}$a0 = $v;\n"
        + "".join(f"$a{i + 1} = -$a{i};\n" for i in range(2000))
        + "ANS(num_cmp($a2000));",
    )
    yield (
        "unread_chain.pg",
        "$a0 = f($x);\n" + "".join(f"$a{i + 1} = $a{i};\n" for i in range(2000)) + "ANS(num_cmp($a2000));",
    )
    yield "minus.pg", f"{DRAWN}$x = {'-' * size}1;\nANS(num_cmp($x));"
    yield "powers.pg", "$x = 9**9**9**9;\n$y = random(1, 64**64**64, 1);\nANS(num_cmp($x)); ANS(num_cmp($y));"
    yield (
        "huge.pg",
        "$x = 1e400;\n$y = $x*1e300;\nANS(num_cmp($x)); ANS(num_cmp($y)); ANS(num_cmp(1e308*10**300));",
    )
    yield "begins.pg", "BEGIN_TEXT\n" * (size // 11)
    yield "begins_of_all.pg", "".join(f"BEGIN_A{i}\n" for i in range(size // 11))
    yield "begin_and_end.pg", "BEGIN_A\n" * (size // 16) + "END_A\n" * (size // 16)
    yield "heredocs.pg", "<<A " * (size // 4)
    yield "heredoc_lines.pg", "<<'A'\n" * (size // 6)
    yield "documentation.pg", "=a\n" * (size // 3)
    yield "blank_lines.pg", "\n" * size + "x"
    yield "spaces.pg", " " * size + "x"
    yield "code_in_text.pg", "BEGIN_TEXT\n" + r"\{ $a" * (size // 5) + "\nEND_TEXT\nANS(1);"
    yield "signs_in_text.pg", "BEGIN_TEXT\n\\{" + "$a " * (size // 3) + "\nEND_TEXT\nANS(1);"
    yield "blanks.pg", "BEGIN_PGML\n" + "[_]{" * (size // 4) + "\nEND_PGML"
    yield "underscores.pg", "BEGIN_PGML\n[" + "_" * size + "\nEND_PGML"
    yield "answers.pg", "ANS(" * (size // 4)
    yield "answers_in_answers.pg", "ANS(" * (size // 5) + ")" * (size // 5)
    yield "many_answers.pg", "ANS(1);" * (size // 7)
    yield "wrapped.pg", "ANS(" + "Real(" * (size // 6) + "1" + ")" * (size // 6) + ");"
    yield "statements.pg", "$a=1;" * (size // 5) + "ANS(num_cmp($a));"
    yield "semicolons.pg", ";" * size
    yield "quotes.pg", "\"'" * (size // 2)
    yield "plus.pg", "+" * size + "\n" + "+ " * (size // 2)
    yield "braces.pg", "{" + " " * size + "x"
    yield "comments.pg", ";#" * (size // 2)
    yield "list.pg", f"$v = list_random({'1,' * (size // 2)}2);\nANS(num_cmp($v));"
    yield "units.pg", 'ANS(NumberWithUnits("$v' + " " * size + '"));'
    yield "nul.pg", "ANS(\0);"
    yield "chunks.Rmd", "```{r}\n" * (size // 7)
    yield "chunk_heads.Rmd", "```{r" * (size // 5)
    yield "sweave.Rnw", "<<a>>=\n" * (size // 7)
    yield "sweave_heads.Rnw", "<<" * (size // 2)
    yield "meta_spaces.Rmd", "exname:" + " " * size + "x" + " " * size + "y"
    yield "meta_blank.Rmd", "\n" * size + R_META
    yield "meta_twice.Rmd", "".join(f"exname: {i}\n" for i in range(size // 10))
    yield "inline.Rmd", "`r " * (size // 3) + R_META
    yield "inline_brace.Rnw", "\\Sexpr{" * (size // 7) + "\\extype{num}\n\\exsolution{\\Sexpr{F}}"
    yield "open_bracket.Rmd", R_HEAD + "F <- (\n" + "1+\n" * (size // 3) + "```\n" + R_META
    yield "doubled.Rmd", R_HEAD + "F <- m\n" + "F <- F*F\n" * 100 + "```\n" + R_META
    yield "minus.Rmd", R_HEAD + f"F <- {'-' * size}m\n```\n" + R_META
    yield "assigned.Rmd", R_HEAD + "F" + " " * size + "<-\n```\n" + R_META
    yield "arrows.Rmd", R_HEAD + "- >" * (size // 3) + "\n```\n" + R_META
    yield (
        "choices.Rmd",
        "Answerlist\n---\n" + "* 1\n" * (size // 4) + f"extype: schoice\nexsolution: {'0' * (size // 4)}\n",
    )
    yield (
        "cloze.Rmd",
        f"extype: cloze\nexclozetype: {'num|' * (size // 4)}\nexsolution: {'1|' * (size // 2)}\n",
    )
    for name, page in [
        ("tags", "<a " * (size // 3)), ("closed", "</" * (size // 2)), ("declared", "<!" * (size // 2)), ("comments", "<!--" * (size // 4)),
        ("cdata", "<![CDATA[" * (size // 9)), ("instructions", "<?" * (size // 2)), ("entities", "&#x" * (size // 3)), ("nested", "<div>" * (size // 5)),
        ("attributes", "<pl-number-input " + "a=1 " * (size // 4) + ">"), ("quote", '<pl-number-input a="' + "x" * size), ("inputs", PAGE * (size // 50)),
        ("holes", "{{" * (size // 2)), ("scripts", "<script>" * (size // 8)),
        ("options", '<pl-multiple-choice><pl-answer correct="true">' + "1&amp;" * (size // 6)),
    ]:  # fmt: skip
        yield f"html_{name}/question.html", page
    for name, server in [
        ("minus", f"def generate(data):\n    x = {'-' * size}1\n"), ("brackets", "(" * size), ("lists", "[" * 90 + "]" * 90 + "\n"),
        ("terms", "def generate(data):\n    x = " + "1+" * (size // 2) + "1\n"), ("blocks", "".join(" " * i + "if 1:\n" for i in range(90))),
        ("attributes", "def generate(data):\n    x = a" + ".a" * (size // 2) + "\n"), ("nul", "def generate(data):\n    x = '\0'\n"),
        ("digits", f"def generate(data):\n    x = {'9' * min(size, 200_000)}\n"), ("lines", "x = 1\n" * (size // 6)),
        ("lambda", "x = " + "lambda:" * 20_000 + "1\n"), ("text", "def generate(data):\n    x = f'" + "{" * (size // 2) + "}'\n"),
        ("power", "def generate(data):\n    data['correct_answers']['F'] = 9**9**9**9**9\n"),
        ("doubled", PARAMS_DOUBLED),
        ("endless", "def generate(data):\n    while True:\n        pass\n"), ("memory", "x = [0]*10**12\ndef generate(data):\n    pass\n"),
        ("recursive", "def f(x):\n    return f(f(x))\ndef generate(data):\n    data['correct_answers']['F'] = f(2)\n"),
        ("long_text", "def generate(data):\n    data['params']['m'] = '9'*10**6\n    data['correct_answers']['F'] = '9'*9000\n"),
    ]:  # fmt: skip
        yield f"server_{name}/server.py", server
        yield f"server_{name}/question.html", PAGE


def _contents(size: int) -> Iterator[tuple[str, bytes]]:
    """What is no text, under the names of texts."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("bank.xml", "<quiz/>" * (size // 7))
    for ending in ("xml", "yaml", "json", "csv", "pg", "Rmd"):
        yield f"zip.{ending}", archive.getvalue()
        yield f"gzip.{ending}", gzip.compress(b"0" * size)
        yield f"nul.{ending}", b"\0" * size
        yield f"empty.{ending}", b""
        yield f"utf16.{ending}", "- id: a\n".encode("utf-16")
        yield f"utf32.{ending}", "- id: a\n".encode("utf-32")
        yield f"invalid.{ending}", b"- id: \xff\xfe\xc0\x80\n"
        yield f"half.{ending}", "- id: \ud800\n".encode("utf-8", "surrogatepass")
        yield f"marks.{ending}", b"\xef\xbb\xbf" * (size // 3)
        yield f"line.{ending}", b"a" * size


def _no_files(folder: Path) -> Iterator[Path]:
    """What is found under a name, and is no file that can be read to its end."""
    os.mkfifo(folder / "pipe.xml")
    (folder / "folder.yaml").mkdir()
    (folder / "loop.csv").symlink_to(folder / "loop.csv")
    (folder / "zero.json").symlink_to("/dev/zero")
    (folder / "random.pg").symlink_to("/dev/urandom")
    (folder / "terminal.pg").symlink_to("/dev/tty")
    (folder / "memory.Rmd").symlink_to("/proc/self/mem")
    (folder / "kernel.Rnw").symlink_to("/proc/kmsg")
    (folder / "broken.xml").symlink_to(folder / "nothing")
    with socket.socket(socket.AF_UNIX) as listening:
        here = os.getcwd()
        os.chdir(folder)  # the path of a socket is short
        try:
            listening.bind("socket.yaml")
        finally:
            os.chdir(here)
    (folder / "sparse.csv").touch()
    os.truncate(folder / "sparse.csv", 1 << 40)
    (folder / "closed.yaml").write_text(GOOD.replace("good", "closed"), encoding="utf-8")
    (folder / "closed.yaml").chmod(0)
    (folder / "pipes").mkdir()
    os.mkfifo(folder / "pipes" / "question.html")
    (folder / "piped_server").mkdir()
    (folder / "piped_server" / "question.html").write_text(PAGE, encoding="utf-8")
    os.mkfifo(folder / "piped_server" / "server.py")
    names = "pipe.xml folder.yaml loop.csv zero.json random.pg terminal.pg memory.Rmd kernel.Rnw broken.xml socket.yaml sparse.csv closed.yaml"
    yield from (folder / name for name in (*names.split(), "pipes/question.html", "piped_server"))
