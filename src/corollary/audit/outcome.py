"""The outcome for a published answer, with all that somebody needs to see it for themselves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from corollary.audit.record import ExerciseRecord

FindingName = Literal["agrees", "last figure", "wrong", "not unique", "impossible", "ambiguous", "cannot say"]
FINDINGS: tuple[FindingName, ...] = (
    "agrees", "last figure", "wrong", "not unique", "impossible", "ambiguous", "cannot say",
)  # fmt: skip
FAULTS: frozenset[FindingName] = frozenset({"wrong", "not unique", "impossible"})

PROVEN = ("proven for all numbers", "proven to be another function")


@dataclass(frozen=True, slots=True)
class AuditedAnswer:
    """`derived` is what the laws give, as people write it; `formula` the same in letters; `others` the other roots.

    `values` are all unknowns of the root compared with. `violates` names the law that the published answer breaks, `sides` are
    then its two sides; `counterexample` has the numbers at which a published formula fails; `mistake` says what was done wrong
    where that gives the published answer. `compared` says of a published formula how it was settled: by "algebra", which is a
    proof for all numbers, or at "points".
    """

    record: ExerciseRecord
    asked: str
    published: str
    finding: FindingName
    why: str = ""
    derived: str = ""
    formula: str = ""
    others: tuple[str, ...] = ()
    values: Mapping[str, str] = field(default_factory=dict[str, str])
    violates: str = ""
    sides: tuple[str, str] | None = None
    counterexample: Mapping[str, str] = field(default_factory=dict[str, str])
    mistake: str = ""
    compared: Literal["", "algebra", "points"] = ""

    @property
    def sentence(self) -> str:
        """All that there is to say besides the two answers, in one line."""
        words = [self.why]
        if self.compared == "algebra":
            words.append(PROVEN[self.finding == "wrong"])
        if self.violates:
            words.append(
                f"it breaks {self.violates}" + (f": {' against '.join(self.sides)}" if self.sides else "")
            )
        if self.mistake:
            words.append(f"as it comes out when {self.mistake}")
        if self.counterexample:
            words.append(
                "for " + ", ".join(f"{name} = {value}" for name, value in self.counterexample.items())
            )
        return "; ".join(filter(None, words))

    def as_json(self) -> dict[str, Any]:
        """What `--json` gives of it; what there is nothing to say of is left out."""
        all_fields: dict[str, Any] = {
            "id": self.record.id,
            "asked": self.asked,
            "finding": self.finding,
            "published": self.published,
            "derived": self.derived,
            "formula": self.formula,
            "others": list(self.others),
            "violates": self.violates,
            "sides": list(self.sides or ()),
            "counterexample": dict(self.counterexample),
            "mistake": self.mistake,
            "compared": self.compared,
            "why": self.why,
            "source": self.record.source,
            "file": self.record.place,
            "isolation": self.record.isolation,
        }
        always = {"id", "finding", "derived", "why"}
        return {name: value for name, value in all_fields.items() if value or name in always}
