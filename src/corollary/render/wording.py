"""Points, durations and verdicts as people read them: on pages, in marked notebooks, in reports and beside progress bars."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Unread, Verdict, word
from corollary.messages import N_, catalogue, in_convention
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.dates import in_words
from corollary.units.unit import show

if TYPE_CHECKING:
    from corollary.records.manual_marks import RubricItem

_ = catalogue(__name__)


@dataclass(frozen=True, slots=True)
class Look:
    """How a verdict looks on a page: `name` is its CSS class (and so its colour, which never says it alone) and its icon's id,
    `message` speaks to the student, `short` heads a column of the report."""

    name: str
    message: str
    short: str

    @property
    def phrase(self) -> str:
        """The message in the reader's language."""
        return _(self.message)


LOOKS: Final = MappingProxyType(
    {
        look.name: look
        for look in (
            Look("right", N_("Right"), "right"),
            Look("follows", N_("Right, given your earlier answer"), "follows"),
            Look("mistaken", N_("A common mistake"), "mistaken"),
            Look("slip", N_("Nearly there: a slip"), "slip"),
            Look("wrong", N_("Not right yet"), "wrong"),
            Look("unread", N_("Could not be read"), "unread"),
            Look("unmarked", N_("Waits for your teacher"), "waiting"),
        )
    }
)
"""The look of each verdict, by the word of records and reports, from the best to the worst."""

BY_HAND: Final = Look("by_hand", N_("Marked by your teacher"), "by hand")
BLANK: Final = Look("unread", N_("No answer"), "unread")


def look(verdict: Verdict) -> Look:
    return BLANK if isinstance(verdict, Unread) and verdict.blank else LOOKS[word(verdict)]


def points(value: float) -> str:
    """Points as people write them: at most two decimals, and none that are not needed."""
    return f"{round(value, 2) + 0.0:.2f}".rstrip("0").rstrip(".")


def earned(value: float) -> str:
    """Points as students read them, in the convention of their language."""
    return in_convention(points(value))


def percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def spell(seconds: float) -> str:
    """A length of time, as fine as a guess deserves: seconds below a minute, else the two leading units (2 days 3 h, 5 min)."""
    if round(seconds) < 60:
        return f"{round(seconds)} s"
    minutes = round(seconds / 60)
    days, hours, minutes = minutes // 1440, minutes // 60 % 24, minutes % 60
    words = [
        _.plural("{count} day", "{count} days", days) if days else "",
        f"{hours} h" if hours else "",
        f"{minutes} min" if minutes else "",
    ]
    return " ".join([word for word in words if word][:2])


def wanted(prompt: Prompt) -> str:
    """What a part earns, and what is to be given: the unit, the components, the function."""
    part = prompt.part
    words = [points_earned(prompt.out_of)]
    if answer_type(part.answer_type).in_symbols:
        words.append(_("a formula"))
    if unit := show(part.unit):
        words.append(_("in {unit}", unit=unit))
    if part.components and answer_type(part.answer_type).lists_components:
        words.append(_("as {components}", components=", ".join(part.components)))
    if part.signature:
        words.append(_("a function {signature}", signature=part.signature))
    return ", ".join(words)


def points_earned(value: float) -> str:
    return _.plural("{points} point", "{points} points", 1 if value == 1 else 2, points=earned(value))


def facts(sheet: Worksheet) -> list[str]:
    """What stands below a sheet's title: whose it is, when it is due, and what it earns."""
    due = sheet.problem_set.due
    words = [sheet.student.name] if sheet.student.id else []
    if due is not None:
        words.append(_("due {date}", date=in_words(due)))
    words.append(points_earned(sum(prompt.out_of for prompt in sheet.prompts)))
    return [*words, *filter(None, [sheet.problem_set.late_rule])]


def item_points(item: RubricItem, out_of: float) -> str:
    """What an item adds, with its sign."""
    worth = round(item.share * out_of, 2)
    sign = "+" if worth >= 0 else "\N{MINUS SIGN}"
    return f"{sign}{earned(abs(worth))}"
