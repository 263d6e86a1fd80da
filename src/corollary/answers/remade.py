"""An expected quantity with all its values remade: put in order, cut out, or counted from another zero."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from corollary.answers.expected import FollowThrough, Quantity, Values

WithSentences = Callable[[], Iterable[tuple[Values, str]]] | None


def remade(wanted: Quantity, by: Callable[[Values], Values]) -> Quantity:
    """The same quantity after `by` was applied to what is right, what follows, and what misconceptions and slips give."""

    def moved(several: WithSentences) -> WithSentences:
        return several and (lambda: [(by(values), sentence) for values, sentence in several()])

    def rounded(several: Callable[[], Iterable[Values]] | None) -> Callable[[], Iterable[Values]] | None:
        return several and (lambda: map(by, several()))

    def followed(ways: Callable[[], Iterable[FollowThrough]]) -> Callable[[], Iterable[FollowThrough]]:
        return lambda: (
            FollowThrough(
                by(way.values),
                way.earlier,
                moved(way.misconceptions),
                moved(way.slips),
                rounded(way.moved),
                rounded(way.turned),
            )
            for way in ways()
        )

    return replace(
        wanted,
        values=by(wanted.values),
        routes=followed(wanted.routes),
        follow_through=followed(wanted.follow_through),
    )
