"""The figure of a problem: its lines as the author writes them, drawn at a variant's numbers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache, reduce
from typing import Any, Final

from corollary.figure.drawing import PRIMITIVES, FigurePanel, describe, draw, graphs_in_words, unmentioned
from corollary.figure.drawing_sheet import WORDS, FigureItem, NotDrawable, Place, Takes
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Relation, names
from corollary.formula.errors import ParseError, sentence
from corollary.formula.misspelt import one_apart
from corollary.formula.syntax import author_formula
from corollary.problem.front_matter import exact
from corollary.problem.graph_axes import (
    GRAPH,
    GRAPH_SAMPLES,
    NOT_ON_AXES,
    ON_AXES,
    GraphAxes,
    in_unit,
    on_sheet,
    si,
)
from corollary.problem.problem import Problem
from corollary.problem.statement import filled
from corollary.problem.variant import Variant
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, Dimension, Unit, show, unit

# Brackets in brackets, six deep, such as (a*tan(asin(sin(alpha)/n)),0).
INSIDE: Final = reduce(lambda inside, _: rf"[^()\"]|\((?:{inside})*\)", range(6), r"[^()\"]")
TOKEN = re.compile(rf'"(?P<text>[^"]*)"|(?P<word>[a-z]+)=(?P<value>(?:(?!\s){INSIDE})+)|(?P<bare>[^\s"=]+)')
NAME = re.compile(r"[A-Za-z]\w*$|\d+$")
ANCHOR = re.compile(r"([A-Za-z]\w*|\d+)(\.(left|right|top|bottom))?$")
LETTER = re.compile(r"(?<![\w.])[A-Za-z]\w*")
COMMENT = re.compile(r'(?:^|\s)#[^"]*$')
PANEL: Final = "panel"
COUNTS: Final = {
    "by": (2, 2),
    "radius": (1, 1),
    "length": (1, 1),
    "size": (1, 2),
    "angle": (1, 1),
    "between": (2, 2),
    "turn": (1, 1),
    "along": (1, 1),
}
SAMPLE: Final = {
    "by": "v,0",
    "radius": "R",
    "length": "L",
    "size": "2,1",
    "angle": "theta",
    "between": "0,theta",
    "turn": "theta",
    "along": "0.5",
}
Number = Callable[[Mapping[str, Any]], float]
Numbers = tuple[Number, ...]
Located = str | tuple[Number, Number]


@dataclass(frozen=True, slots=True)
class FigureLine:
    """A line of the figure, its formulas ready to be evaluated."""

    line: int
    kind: str
    name: str
    texts: tuple[str, ...]
    places: Mapping[str, tuple[Located, ...]]
    numbers: Mapping[str, Numbers]
    flags: frozenset[str]
    group: str = ""
    over: tuple[str, Number, Number] | None = None
    graph: GraphAxes | None = None
    letters: frozenset[str] = frozenset()
    """The givens in the formulas of what stands on the axes of a graph, where it can be read off."""

    @property
    def smooth(self) -> bool:
        """True for the curve of a formula."""
        return self.kind == "curve" and self.over is not None


@lru_cache(maxsize=512)
def read_lines(
    text: str, givens: tuple[tuple[str, Dimension], ...]
) -> tuple[tuple[FigureLine, ...], tuple[tuple[int, str], ...]]:
    """The lines of a figure, and what is wrong with it: line, counted from 0, and sentence."""
    lines, complaints = list[FigureLine](), list[tuple[int, str]]()
    reading = _Reading(dict(givens))
    for at, line in enumerate(text.splitlines()):
        line = COMMENT.sub("", line).strip()
        if not line:
            continue
        try:
            lines.append(reading.line(at, line))
        except ValueError as error:
            complaints.append((at, f"figure, `{line}`: {error}"))
    return tuple(lines), tuple(complaints)


def in_letters(figure: str, now: Mapping[str, str]) -> str:
    """The figure with the letters of its formulas called otherwise; names of things stay."""

    def other(found: re.Match[str]) -> str:
        if found["word"] in (None, "units") or ANCHOR.match(found["value"]):
            return found[0]
        value = LETTER.sub(lambda letter: now.get(letter[0], letter[0]), found["value"])
        return f"{found['word']}={value}"

    return TOKEN.sub(other, figure)


class _Reading:
    """Reads one line after the other; what lengths are measured in is the same throughout a panel."""

    def __init__(self, dimensions: Mapping[str, Dimension]) -> None:
        self.dimensions = dimensions
        self.letters: Mapping[str, Dimension] = dimensions
        self.length: tuple[str, Dimension] | None = None
        self.named: set[str] = set()
        self.graph: GraphAxes | None = None
        self.used: set[str] = set()
        self.begun = False

    def line(self, at: int, text: str) -> FigureLine:
        """Raises ValueError with a sentence."""
        self.letters = self.dimensions
        self.used.clear()
        kind, _, rest = text.partition(" ")
        if kind != PANEL and kind not in PRIMITIVES:
            raise ValueError(
                f"there is no `{kind}`{_meant(kind, PRIMITIVES)}; choose one of {', '.join(sorted(PRIMITIVES))}"
            )
        texts, words, bare = self._tokens(rest)
        if kind == PANEL:
            self.length = self.graph = None
            self.begun = False
            self.named.clear()
            if words or set(bare) - {"below"} or len(texts) > 1:
                raise ValueError('a panel has a title, and `below` for a new row: panel "after" below')
            return FigureLine(at, kind, "", texts, {}, {}, frozenset(bare))
        it = PRIMITIVES[kind]
        if wrong := next((word for word in words if word not in it.words), ""):
            known = ", ".join(f"{word}=" for word in sorted(it.words)) or "none"
            raise ValueError(f"{kind} takes no {wrong}={_meant(wrong, it.words)}; it takes {known}")
        if len(texts) > it.most_texts:
            raise ValueError(
                f"{kind} takes {it.most_texts} text{'s' * (it.most_texts > 1)}, here are {len(texts)}"
            )
        flags = frozenset(bare) & it.flags
        named = [word for word in bare if word not in flags]
        if len(named) > 1 or (named and not NAME.match(named[0])):
            guess = named[1] if len(named) > 1 else named[0]
            raise ValueError(
                f"`{guess}` is neither a name nor known of {kind}{_meant(guess, it.flags)}; "
                f"known are {', '.join(sorted(it.flags))}; formulas have no spaces outside of brackets"
            )
        if named and it.laid == 0:
            if named[0] in self.named:
                raise ValueError(f"two things here are called {named[0]}; give one another name")
            self.named.add(named[0])
        if kind == GRAPH:
            return self._graph(at, texts, words, flags)
        self.begun = True
        if self.graph is not None:
            self._on_graph(kind, words)
        elif "of" in words:
            raise ValueError("of= is the height of a curve on a graph; begin with a line graph x=t,0,10 …")
        over = self._over(words.pop("over")) if "over" in words else None
        places: dict[str, tuple[Located, ...]] = {}
        numbers: dict[str, Numbers] = {}
        group = ""
        if (formula := words.pop("of", None)) is not None:
            over, places["through"] = self._height(formula, over)
        for word, value in words.items():
            takes = WORDS[word]
            if takes == "place":
                places[word] = (self._place(word, value),)
            elif takes == "places":
                places[word] = (
                    tuple(self._place(word, each) for each in _split(value))
                    if over is None
                    else (self._place(word, value),)
                )
            else:
                numbers[word], group_of = self._numbers(word, takes, value)
                group = group_of or group
        name = named[0] if named else ""
        used = frozenset(self.used) if self.graph is not None else frozenset[str]()
        return FigureLine(at, kind, name, texts, places, numbers, flags, group, over, letters=used)

    def _graph(
        self, at: int, texts: tuple[str, ...], words: Mapping[str, str], flags: frozenset[str]
    ) -> FigureLine:
        if self.begun or self.graph is not None:
            raise ValueError("a graph begins its panel, and has it for itself: write a line panel before it")
        letter, *ends = _split(words.get("x", ""))
        if len(ends) != 2 or not NAME.match(letter) or letter in self.dimensions:
            raise ValueError(
                "graph needs the letter of its horizontal axis, which is not a given, and from where to where: x=t,0,10"
            )
        if len(texts) != 2:
            raise ValueError('graph needs two texts, what is across and what is up: "t" "v"')
        spelled = _split(words.get("units", "1,1"))
        if len(spelled) != 2:
            raise ValueError("units= are those of both axes: units=s,m/s")
        across, up = (unit(each) for each in spelled)
        steps = [exact(each) for each in _split(words["steps"])] if "steps" in words else [None, None]
        if "steps" in words and (len(steps) != 2 or not all(each and each > 0 for each in steps)):
            raise ValueError("steps= are positive numbers, from tick to tick of both axes: steps=2,5")
        heights = _split(words["y"]) if "y" in words else []
        if len(heights) not in (0, 2):
            raise ValueError("y= is from where to where: y=0,30")
        first, last = (in_unit(self._on(each, across, "x"), across) for each in ends)
        y = [in_unit(self._on(each, up, "y"), up) for each in heights]
        self.graph = GraphAxes(
            letter, (first, last), (y[0], y[1]) if y else None, (across, up),
            (float(steps[0] or 0), float(steps[1] or 0)), (texts[0], texts[1]),
        )  # fmt: skip
        return FigureLine(at, GRAPH, "", texts, {}, {}, flags, graph=self.graph)

    def _on_graph(self, kind: str, words: Mapping[str, str]) -> None:
        if kind not in ON_AXES:
            raise ValueError(f"there is no {kind} on a graph; draw {', '.join(sorted(ON_AXES))} there")
        if wrong := next((word for word in words if word in NOT_ON_AXES), ""):
            raise ValueError(f"{wrong}= has no size on a graph; say from where to where")

    def _on(self, text: str, its_unit: Unit, word: str) -> Number:
        """A coordinate on an axis, in SI: a formula that measures what the axis does, or a plain number in its unit."""
        number, dimension = self._formula(text)
        if dimension is None:
            return si(number, its_unit)
        if dimension != its_unit.dimension:
            raise ValueError(f"{word}: {text} is not in {show(its_unit) or 'plain numbers'}, as the axis is")
        return number

    def _height(
        self, formula: str, over: tuple[str, Number, Number] | None
    ) -> tuple[tuple[str, Number, Number], tuple[Located, ...]]:
        """What is drawn of a formula: the letter with its range, and the place for each value of it."""
        assert self.graph is not None
        letter, (across, up) = self.graph.letter, self.graph.units
        if over is not None and over[0] != letter:
            raise ValueError(f"over= has the letter of the axis: over={letter},0,1")
        first, last = (si(each, across) for each in self.graph.x) if over is None else over[1:]
        self.letters = {**self.dimensions, letter: across.dimension}
        height = in_unit(self._on(formula, up, "of"), up)
        return (letter, first, last), ((in_unit(lambda values: values[letter], across), height),)

    def _tokens(self, rest: str) -> tuple[tuple[str, ...], dict[str, str], list[str]]:
        texts, words, bare, at = list[str](), dict[str, str](), list[str](), 0
        while at < len(rest):
            if rest[at].isspace():
                at += 1
                continue
            found = TOKEN.match(rest, at)
            if found is None:
                raise ValueError(
                    f"cannot read {rest[at:]!r}; texts stand in double quotes, values as word=value without spaces"
                )
            if found["text"] is not None:
                texts.append(found["text"])
            elif found["word"]:
                if found["word"] in words:
                    raise ValueError(f"{found['word']}= is given twice; keep one")
                words[found["word"]] = found["value"]
            else:
                bare.append(found["bare"])
            at = found.end()
        return tuple(texts), words, bare

    def _over(self, value: str) -> tuple[str, Number, Number]:
        letter, *bounds = _split(value)
        if len(bounds) != 2 or not NAME.match(letter) or letter in self.dimensions:
            raise ValueError("over= needs a letter that is not a given, and from where to where: over=s,0,1")
        if self.graph is not None and letter == self.graph.letter:
            across = self.graph.units[0]
            self.letters = {**self.dimensions, letter: across.dimension}
            return letter, self._on(bounds[0], across, "over"), self._on(bounds[1], across, "over")
        (low, dimension), (high, _other) = self._formula(bounds[0]), self._formula(bounds[1])
        self.letters = {**self.dimensions, letter: dimension or _other or ONE}
        return letter, low, high

    def _place(self, word: str, value: str) -> Located:
        if ANCHOR.match(value) and not value.isdigit():
            return value
        inner = value[1:-1] if value.startswith("(") and len(_split(value[1:-1])) == 2 else value
        parts = _split(inner)
        if len(parts) != 2:
            raise ValueError(
                f"{word}={value} is not a place; write two coordinates, {word}=0,h, or a name, {word}=A.top"
            )
        if self.graph is not None:
            across, up = self.graph.units
            return in_unit(self._on(parts[0], across, word), across), in_unit(
                self._on(parts[1], up, word), up
            )
        return self._measured(word, parts[0]), self._measured(word, parts[1])

    def _numbers(self, word: str, takes: Takes, value: str) -> tuple[Numbers, str]:
        parts = _split(value)
        least, most = COUNTS[word]
        if not least <= len(parts) <= most:
            wanted = f"{least}" if least == most else f"{least} or {most}"
            raise ValueError(
                f"{word}={value}: {word} takes {wanted} number{'s' * (most > 1)}, {word}={SAMPLE[word]}"
            )
        if takes == "lengths":
            return tuple(self._measured(word, part) for part in parts), ""
        read = [self._formula(part) for part in parts]
        dimensions = {dimension for _number, dimension in read if dimension is not None}
        if takes == "vector":
            if len(dimensions) > 1:
                raise ValueError(
                    f"{word}={value}: the components measure different things; both must have one unit"
                )
            return tuple(number for number, _dimension in read), str(next(iter(dimensions), ""))
        if dimensions - {ONE}:
            raise ValueError(f"{word}={value} is not {'an angle' if takes == 'angles' else 'a plain number'}")
        if takes == "angles":
            return tuple(
                _in_degrees(number) if dimension is None and "pi" not in part else number
                for (number, dimension), part in zip(read, parts, strict=True)
            ), ""
        return tuple(number for number, _dimension in read), ""

    def _measured(self, word: str, part: str) -> Number:
        """A coordinate or a length; those with letters in them all measure the same. Plain numbers go with any."""
        number, dimension = self._formula(part)
        if dimension is not None:
            if self.length is None:
                self.length = (part, dimension)
            elif self.length[1] != dimension:
                raise ValueError(
                    f"{word}={part} does not measure the same as {self.length[0]}, which stands above; "
                    "the places of one panel are all of one kind, and what is something else is an arrow's by="
                )
        return number

    def _formula(self, text: str) -> tuple[Number, Dimension | None]:
        """A formula of the givens, and what it measures; a number without letters has no dimension of its own."""
        tree = author_formula(text, self.letters)
        if isinstance(tree, Relation):
            raise ValueError(f"{text} is a comparison, no formula")
        used = names(tree) - {"pi"}
        self.used |= used & self.dimensions.keys()
        found = dimension_of(tree, self.letters)
        if isinstance(found, ParseError):
            raise ValueError(f"{text}: {sentence(found)}")
        return ready(tree, DOUBLES), found if used else None


def _in_degrees(number: Number) -> Number:
    return lambda values: math.radians(number(values))


def _split(value: str) -> list[str]:
    """The parts between commas that stand outside of brackets."""
    parts, depth = [""], 0
    for each in value:
        depth += (each == "(") - (each == ")")
        if each == "," and not depth:
            parts.append("")
        else:
            parts[-1] += each
    return [part.strip() for part in parts]


def _meant(word: str, known: Iterable[str]) -> str:
    guess = next((each for each in sorted(known) if one_apart(word, each)), "")
    return f"; is `{guess}` meant?" if guess else ""


SAMPLES: Final = 40
"""Straight pieces of a curve."""


class BadFigure(ValueError):
    """A line of a figure cannot be read or drawn; `line` counts from 0 within the figure."""

    def __init__(self, line: int, why: str) -> None:
        super().__init__(why)
        self.line = line


@dataclass(frozen=True, slots=True)
class VariantFigure:
    """A figure with one student's numbers: SVG text, and the same in words, the values of graphs (`data`) among them."""

    svg: str
    alt: str
    data: tuple[str, ...] = ()


def drawn(variant: Variant) -> VariantFigure:
    """The figure of a variant; without one, empty. Raises BadFigure.

    A figure that begins with `<` is a drawing of the author's own.
    """
    problem = variant.problem
    words = filled(problem.figure_alt, variant)
    if is_svg(problem.figure):
        return VariantFigure(filled(problem.figure, variant), words)
    lines, complaints = read_lines(
        problem.figure, tuple((given.symbol, given.unit.dimension) for given in problem.givens)
    )
    if complaints:
        raise BadFigure(*complaints[0])
    values: dict[str, float] = {}
    for given in problem.givens:
        ratio, pi = given.unit.to_si(variant.values[given.symbol])
        values[given.symbol] = float(ratio) * math.pi**pi
    titles, items = [("", False)], [list[tuple[int, FigureItem]]()]
    graphs: dict[int, GraphAxes] = {}
    for line in lines:
        texts = tuple(filled(text, variant) if "{{" in text else text for text in line.texts)
        if line.kind == PANEL:
            titles.append((texts[0] if texts else "", "below" in line.flags))
            items.append([])
        else:
            items[-1].append((line.line, _item(line, texts, values)))
            if line.graph is not None:
                graphs[len(items) - 1] = replace(line.graph, titles=(texts[0], texts[1]))
    for at, axes in graphs.items():
        try:
            items[at] = on_sheet(axes, items[at], values)
        except NotDrawable as error:
            raise BadFigure(items[at][0][0], str(error)) from None
    panels = [
        FigurePanel(title, tuple(item for _, item in own), below)
        for (title, below), own in zip(titles, items, strict=True)
        if own
    ]
    try:
        svg = draw(panels)
    except NotDrawable as error:
        line = next((line for own in items for line, item in own if item is error.item), 0)
        raise BadFigure(line, str(error)) from None
    data = graphs_in_words(panels)
    more = " ".join([unmentioned(panels, words), *data]).strip() if words else describe(panels)
    return VariantFigure(svg, " ".join(filter(None, (words, more))), data)


def letters_graphed(problem: Problem) -> frozenset[str]:
    """The givens that can be read off a graph of the figure."""
    if is_svg(problem.figure):
        return frozenset()
    letters = tuple((given.symbol, given.unit.dimension) for given in problem.givens)
    lines, _complaints = read_lines(problem.figure, letters)
    return frozenset[str]().union(*(line.letters for line in lines))


def is_svg(figure: str) -> bool:
    """Whether an author drew it by hand, or there is none."""
    return not figure or figure.lstrip().startswith("<")


def _item(line: FigureLine, texts: tuple[str, ...], values: Mapping[str, float]) -> FigureItem:
    try:
        if line.over is None:
            places = {word: tuple(_at(each, values) for each in own) for word, own in line.places.items()}
        else:
            letter, start, end = line.over
            low, high = start(values), end(values)
            count = GRAPH_SAMPLES if line.letters else SAMPLES
            steps = [{**values, letter: low + (high - low) * k / count} for k in range(count + 1)]
            places = {word: tuple(_at(own[0], step) for step in steps) for word, own in line.places.items()}
        numbers = {word: tuple(each(values) for each in own) for word, own in line.numbers.items()}
    except (ArithmeticError, ValueError):
        raise BadFigure(line.line, f"{line.kind}: a formula has no value with these numbers") from None
    found = [*(n for own in numbers.values() for n in own)]
    found += [n for own in places.values() for place in own if not isinstance(place, str) for n in place]
    if not all(map(math.isfinite, found)):
        raise BadFigure(line.line, f"{line.kind}: a formula has no finite value with these numbers")
    return FigureItem(
        line.kind, line.name, texts, places, numbers, line.flags, line.group, smooth=line.smooth
    )


def _at(place: Located, values: Mapping[str, float]) -> Place:
    return place if isinstance(place, str) else (place[0](values), place[1](values))
