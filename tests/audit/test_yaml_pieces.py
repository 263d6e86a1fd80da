"""A record that is no YAML costs itself: its place is said, and the others of its file are read."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from corollary.audit.record_file import records_in
from corollary.problem.diagnostic import Malformed

RECORD = """\
- id: NAME
  given: {h: 20 m, g: 9.8 m/s^2}
  laws: ['v^2 = 2*g*h']
  where: v > 0
  asked: v in m/s
  published: 19.8
"""
BROKEN = {
    "a bracket": RECORD.replace("g: 9.8 m/s^2}", "g: 9.8 m/s^2"),
    "a quotation mark": RECORD.replace("2*g*h']", "2*g*h]"),
    "a tab": RECORD.replace("  where", "\twhere"),
    "a colon": RECORD.replace("published: 19.8", "published: a: b: c"),
    "a list within": RECORD.replace("published: 19.8", "published: [19.8"),
}


def records(*texts, head="", indent=""):
    body = "".join(text.replace("NAME", name) for name, text in zip("abcdefgh", texts, strict=False))
    return head + "".join(indent + line for line in body.splitlines(keepends=True))


@pytest.mark.parametrize("fault", BROKEN)
@pytest.mark.parametrize("place", range(3))
@pytest.mark.parametrize(
    ("head", "indent"), [("", ""), ("# of mine\n---\n", ""), ("source: A book\nrecords:\n", "  "), ("records:\n", "")]
)  # fmt: skip
def test_a_broken_record_costs_itself(tmp_path, fault, place, head, indent):
    path = tmp_path / "r.yaml"
    texts = [RECORD] * 3
    texts[place] = BROKEN[fault]
    path.write_text(records(*texts, head=head, indent=indent))
    found = records_in(path)
    first = 1 + head.count("\n") + 6 * place
    assert [each.line for each in found] == [1 + head.count("\n") + 6 * at for at in range(3)]
    assert [bool(each.unread) for each in found] == [at == place for at in range(3)]
    assert [each.id for each in found if not each.unread] == [n for at, n in enumerate("abc") if at != place]
    assert found[place].id == f"r.yaml:{first}"
    line = int(found[place].unread.split(":")[1])
    assert first <= line < first + 6
    assert "is not YAML" in found[place].unread
    assert {each.source for each in found if not each.unread} == {"A book" if "book" in head else ""}


def test_the_documents_of_a_stream(tmp_path):
    path = tmp_path / "r.yaml"
    one = RECORD.replace("- id", "  id").replace("\n  ", "\n").removeprefix("  ")
    path.write_text(
        "---\n" + "---\n".join([one.replace("NAME", "a"), "id: [b\n", RECORD.replace("NAME", "c")])
    )
    found = records_in(path)
    assert [(each.id, each.line) for each in found] == [("a", 2), ("r.yaml:9", 9), ("c", 11)]
    assert found[1].unread.startswith("r.yaml:9: the file is not YAML")


@pytest.mark.parametrize(
    "text", [BROKEN["a bracket"], BROKEN["a tab"] * 2, "records: [\n" + RECORD, "[" * 99]
)
def test_where_nothing_can_be_read_the_file_is_refused(tmp_path, text):
    path = tmp_path / "r.yaml"
    path.write_text(text)
    with pytest.raises(Malformed, match=r"r\.yaml:\d+: "):
        records_in(path)


@given(st.data())
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_other_record_is_lost(tmp_path, data):
    """Whatever stands in one record, those before it are read as they are."""
    path = tmp_path / "r.yaml"
    inside = data.draw(st.text(st.characters(codec="utf-8", exclude_categories=["Cs", "Cc"]), max_size=30))
    path.write_text(records(RECORD, RECORD, f"- id: NAME\n  statement: {inside}\n", RECORD), encoding="utf-8")
    assert [each.id for each in records_in(path) if not each.unread][:2] == ["a", "b"]
