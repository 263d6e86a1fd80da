"""The mutation score of a problem: bends of its laws, those noticed and by what, and the others by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

LISTED, MOST_LAWS = 3, 8  # bends of a law, and laws, that are shown to a person


@dataclass(frozen=True, slots=True)
class Unnoticed:
    """A bend that no check would notice: the law by its name, where its step stands, the kind of slip, and the law with it."""

    law: str
    file: str
    line: int
    kind: str
    bend: str


@dataclass(frozen=True, slots=True)
class MutationScore:
    """`by` counts the noticed bends by the first check that would fail; `undecided` are bends of laws that are not solved in
    numbers, and `untried` those laws with file and line; `proposal` is a line that would catch `caught` of the unnoticed."""

    bends: int
    noticed: int
    by: Mapping[str, int] = field(default_factory=dict[str, int])
    unnoticed: tuple[Unnoticed, ...] = ()
    undecided: int = 0
    proposal: str = ""
    caught: int = 0
    untried: tuple[str, ...] = ()

    @property
    def sentence(self) -> str:
        """One line for the author."""
        if not self.bends and not self.undecided:
            return "signs and factors: no law to bend"
        text = f"signs and factors: {self.noticed} of {self.bends} bends noticed"
        return text + (f", {self.undecided} undecided" if self.undecided else "")

    @property
    def lines(self) -> list[str]:
        """The line, the laws in which bends are not noticed, and what would notice them."""
        laws: dict[str, list[str]] = {}
        for each in self.unnoticed:
            laws.setdefault(f"{each.file}:{each.line}: {each.law}", []).append(each.bend)
        found = [self.sentence]
        for law, several in list(laws.items())[:MOST_LAWS]:
            more = f" and {len(several) - LISTED} more" if len(several) > LISTED else ""
            found.append(f"  not noticed in {law}: {'; '.join(several[:LISTED])}{more}")
        if len(laws) > MOST_LAWS:
            found.append(f"  and in {len(laws) - MOST_LAWS} more laws: --json has all")
        if self.untried:
            more = f" and {len(self.untried) - LISTED} more" if len(self.untried) > LISTED else ""
            laws_not_tried = "; ".join(self.untried[:LISTED])
            found.append(f"  only dimensions check the signs in {laws_not_tried}{more}: read them once more")
        if self.proposal:
            found.append(f"  {self.proposal} would notice {self.caught} of {len(self.unnoticed)}")
        return found


def from_data(data: Mapping[str, Any] | None) -> MutationScore | None:
    """The score that `dataclasses.asdict` wrote."""
    if data is None:
        return None
    unnoticed: Any = tuple(Unnoticed(**each) for each in data["unnoticed"])
    content: dict[str, Any] = {**data, "unnoticed": unnoticed, "untried": tuple(data.get("untried", ()))}
    return MutationScore(**content)
