"""An item of a solution in text, taken apart: the words for the reader, and behind them formulas, conditions and names."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from corollary.derive.markdown_items import ListItem, MarkdownError, Section
from corollary.messages import did_you_mean

QUOTED = re.compile(r"`([^`]*)`")
CLAIMS = ("at", "limit", "always", "confirm", "printed")
STEP = ("each", "law", "also", "where", "reject", "mistake", "route", "check", "scale", "letter")
ALLOWED: Mapping[str, tuple[str, ...]] = {
    "step": STEP,
    "optimum": ("optimum", "mistake", "check", "letter"),
    "simulated": ("simulated", "mistake", "check", "letter"),
    "example": ("example", "law", "apart", "scale", "letter"),
    "neglected": ("neglected", "law", "also", "supposing", "letter"),
    "proof": ("proof", "law", "line", "given", "rate", "mistake"),
    "forces": ("force", "along"),
    "code": ("code",),
    "plot": ("plot",),
    "returns": ("returns", "drawn", "corner", "within", "mistake"),
    "curve": ("curve", "axes", "mistake"),
    "fit": ("fit", "axes", "within"),
    "explain": ("rubric",),
    "choice": (),
    "checks": (),
    "letters": ("letter", "function", "variable", "supposed"),
}
OF_A_LAW = ("with", "holds", "source")
BELOW: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(("law", "proof", "given", "along"), OF_A_LAW),
    "mistake": ("each", "law", "where", "with", "instead of", "named"),
    "route": ("law",),
    "confirm": ("law",),
    "printed": ("erratum",),
    "simulated": ("with",),
    "code": ("inputs", "judge", "example"),
    "plot": ("judge", "example", "with calls"),
}
"""The items that may stand below an item."""
CLAUSES = ("law", "with", "where", "instead of", "named")


def first_item(section: Section, key: str) -> ListItem:
    return next(item for item in section.items if item.key == key)


def only_text(items: Sequence[ListItem]) -> str:
    if len(items) != 1:
        raise MarkdownError(items[1].line, f"{items[1].key} stands here for the second time")
    return items[0].text


def name_of_mistake(item: ListItem, behind: Sequence[str] = ()) -> str:
    """The name of a misconception: one `behind` the formula, or in an item below. Raises ValueError for several."""
    found = [*behind, *(each.text.strip().strip('"') for each in item.values("named"))]
    if len(found) > 1:
        raise ValueError(f"a mistake has one name, and here stand {' and '.join(found)}")
    return " ".join(found[0].split()) if found else ""


def named_below(item: ListItem, key: str) -> str:
    found = item.values(key)
    if not found:
        raise ValueError(f"say {key}: below it, with a name")
    return formula_of(found[0])


def formula_of(item: ListItem) -> str:
    """What stands between backticks in an item that is nothing else."""
    found = re.fullmatch(r"`([^`]+)`", item.text.strip())
    if not found:
        raise ValueError(f"write {item.key}: and a formula between backticks, `…`")
    return found[1].strip()


def formula_and_words(item: ListItem) -> tuple[str, str]:
    """The formula between backticks of an item, and the words beside it."""
    quoted = QUOTED.findall(item.text)
    if len(quoted) != 1:
        raise ValueError(
            f"write {item.key}: with one formula between backticks, `…`, and words for the reader"
        )
    words = QUOTED.sub("", item.text).strip()
    return quoted[0].strip(), words.removeprefix(":").removesuffix(",").strip()


def clauses_of(item: ListItem) -> tuple[str, dict[str, list[str]]]:
    """The words of an item up to its first formula, and its formulas and names by the word before each: none for a law, `with`,
    `where`, `instead of "…"`, `named "…"`."""
    if item.text.count("`") % 2:
        raise ValueError(f"a backtick is missing; a formula stands between two, `…`: {item.text[:80]}")
    words, mark, rest = item.text.partition("`")
    found: dict[str, list[str]] = {clause: [] for clause in CLAUSES}
    if not mark:
        return words.strip(), found
    rest = mark + rest
    key: str = "law"
    head = re.search(r'\s(instead of)\s+"[^"]+"[,\s]*$', words)
    if head:
        words, rest = words[: head.start()], words[head.start() :].strip() + " " + rest
    for piece in re.finditer(
        r'`(?P<formula>[^`]*)`|"(?P<name>[^"]+)"|(?P<word>with|where|instead of|named|and)\b|(?P<other>[^`"\s,;]+)',
        rest,
    ):
        if piece["word"]:
            key = key if piece["word"] == "and" else piece["word"]
        elif piece["formula"] is not None:
            found["law" if key in {"instead of", "named"} else key].append(piece["formula"].strip())
            key = "law" if key != "with" else key
        elif piece["name"]:
            found["named" if key == "named" else "instead of"].append(piece["name"])
        elif hint := did_you_mean(piece["other"], ("where", "with", "instead of", "named")):
            raise ValueError(f"{piece['other']!r} is no word for what stands behind a formula{hint}")
        else:
            raise ValueError(
                f"{piece['other']!r} stands behind a formula; the words for the reader come before it (formulas among them between $), "
                'and behind it only with `…`, where `…`, instead of "…", named "…"'
            )
    return words.strip().removesuffix(",").strip(), found


def refuse_others(clauses: Mapping[str, Sequence[str]], *allowed: str) -> None:
    for clause, found in clauses.items():
        if found and clause not in allowed:
            raise ValueError(f"{clause} has no place here")


def one_formula(found: Sequence[str], what: str, such_as: str) -> str:
    if len(found) != 1:
        raise ValueError(f"write one {what} between backticks, such as {such_as}")
    return found[0]


def refuse_misplaced(item: ListItem) -> None:
    """Raises MarkdownError for an item below another that does not belong there."""
    words = BELOW.get(item.key, ())
    if item.key and not item.text and not item.items:
        raise MarkdownError(item.line, f"nothing stands behind {item.key}:; write it, or leave the item out")
    for each in item.items:
        if each.key not in words:
            word = each.key or each.text.partition(":")[0].partition(" ")[0]
            what = (
                f"write one of: {', '.join(f'{key}:' for key in words)}" if words else "move it to the left"
            )
            raise MarkdownError(
                each.line,
                f"{word!r} has no place below {item.key or item.text[:20]!r}{did_you_mean(word, words)}; {what}",
            )
        refuse_misplaced(each)
