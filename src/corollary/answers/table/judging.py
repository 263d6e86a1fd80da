"""A table judged entry by entry, each as a number of its own: what is right of it counts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby

from corollary.answers.answer import Answer, Blank, Entries, Formulas, Letter, Numbers, Unclear
from corollary.answers.expected import Expected, Quantity
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.remade import remade
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.table.entry import entry_name, entry_question
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.messages import catalogue

_ = catalogue(__name__)


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Right when every entry is; else each entry counts the same, with the share that its own verdict earns."""
    assert isinstance(answer, Entries)
    assert expected.quantity is not None
    wanted, question = expected.quantity, expected.question
    return together(
        [
            _of_entry(each, entry(wanted, place), entry_question(question, place))
            for place, each in enumerate(answer.entries)
        ],
        question,
    )


def entry(wanted: Quantity, place: int) -> Quantity:
    """What is expected of one entry alone."""
    return replace(
        remade(wanted, lambda values: (values[place],)),
        scale=wanted.scales[place] if wanted.scales else wanted.scale,
        scales=(),
        residue=wanted.residue[place : place + 1],
        uncertain=(wanted.uncertain[place],),
        signed=wanted.signed[place : place + 1],
        formulas=None if wanted.formulas is None else (wanted.formulas[place],),
        wrong_formulas=lambda: (
            ((trees[place],), sentence)
            for trees, sentence in wanted.wrong_formulas()
            if wanted.formulas is None or trees[place] != wanted.formulas[place]
        ),
    )


def _of_entry(answer: Numbers | Formulas | Blank | Unclear, wanted: Quantity, question: Question) -> Verdict:
    match answer:
        case Numbers():
            return judge_numbers(answer, wanted, question)
        case Formulas():
            return judge_formulas(answer, wanted, question)
        case Blank():
            return Unread(_("It is empty."), blank=True)
        case Unclear(why, readings=readings, benefit=benefit):
            found = [_of_entry(each, wanted, question) for each in readings if not isinstance(each, Letter)]
            if not any(isinstance(each, Right) for each in found):
                return Unread(f"{why[0].upper()}{why[1:].rstrip('.')}.")
            if benefit:
                return Right(_("This can be read in two ways; the right one counts."))
            return Unmarked(_("It can be read in two ways, and one of them is right."))


def together(verdicts: Sequence[Verdict], question: Question) -> Verdict:
    """One verdict on the whole. Raises IndexError where there is no entry."""
    bad = [(place, each) for place, each in enumerate(verdicts) if not isinstance(each, Right | Follows)]
    if not bad:
        return _all_right(verdicts)
    first = bad[0][1]
    if isinstance(first, Mistaken) and all(each == first for _place, each in bad):
        return replace(first, entries=tuple(verdicts))
    if waiting := [each for _place, each in bad if isinstance(each, Unmarked)]:
        return Unmarked(_list(question, bad) or waiting[0].why)
    if all(isinstance(each, Unread) for each in verdicts):
        return Unread(_list(question, bad))
    right = len(verdicts) - len(bad)
    count = _.plural(
        "{right} of {count} entry is right.",
        "{right} of {count} entries are right.",
        len(verdicts),
        right=right,
    )
    return Wrong(f"{count} {_list(question, bad)}", entries=tuple(verdicts))


def _all_right(verdicts: Sequence[Verdict]) -> Verdict:
    if follows := [each for each in verdicts if isinstance(each, Follows)]:
        earlier = dict.fromkeys(part for each in follows for part in each.earlier)
        return Follows(tuple(earlier), all(each.nothing for each in follows), tuple(verdicts))
    noted = [each for each in verdicts if isinstance(each, Right) and each.note]
    return noted[0] if noted else Right()


def _list(question: Question, bad: Sequence[tuple[int, Verdict]]) -> str:
    """What is said of the entries that are not right, those of one sentence together."""
    ordered = sorted(
        bad, key=lambda pair: [_sentence(each) for _place, each in bad].index(_sentence(pair[1]))
    )
    pieces: list[str] = []
    for sentence, group in groupby(ordered, key=lambda pair: _sentence(pair[1])):
        names = "; ".join(entry_name(question, place) for place, _verdict in group)
        pieces.append(f"({names}) {sentence}".strip())
    return " ".join(pieces)


def _sentence(verdict: Verdict) -> str:
    match verdict:
        case Mistaken(text) | Slip(text) | Wrong(text) | Unread(text) | Unmarked(text):
            return text
        case _:
            return ""


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """Rows of texts, one text, one list; one entry off; a row too few; one entry left out."""
    assert not isinstance(truth, str)
    width = len(question.columns)
    texts: list[str] = []
    for place, value in enumerate(truth):
        (number,), unit = to_be_typed([value], entry_question(question, place))
        texts.append(f"{number!r}{unit}")
    rows = [texts[place : place + width] for place in range(0, len(texts), width)]
    largest = max(map(abs, truth)) or 1.0
    (off,), unit = to_be_typed([truth[0] + 2.7 * largest], entry_question(question, 0))
    return (
        Sample(rows, "right"),
        Sample(texts, "right"),
        Sample("; ".join(" | ".join(row) for row in rows), "right"),
        Sample([[f"{off!r}{unit}", *rows[0][1:]], *rows[1:]], "wrong"),
        Sample([[None, *rows[0][1:]], *rows[1:]], "wrong") if len(texts) > 1 else Sample(None, "unread"),
        Sample([*rows, rows[0]], "unread"),
        Sample([[None] * width] * len(rows), "unread"),
        Sample("some", "unread"),
        Sample(None, "unread"),
    )
