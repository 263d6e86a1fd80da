"""A solution in Markdown, read into the statements of a derivation; nothing in it is run."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import sympy

from corollary.derive.beside import LazyModule, program_text
from corollary.derive.declared_judges import BY_FORMULA
from corollary.derive.derivation import (
    Always,
    Branch,
    Case,
    Cases,
    Entry,
    Limit,
    Special,
    branches,
    one_for_each_part,
)
from corollary.derive.formula_text import LetterTable, is_call, parted
from corollary.derive.function_values import value_of
from corollary.derive.item_clauses import (
    ALLOWED,
    BELOW,
    CLAIMS,
    QUOTED,
    clauses_of,
    first_item,
    formula_and_words,
    formula_of,
    name_of_mistake,
    named_below,
    one_formula,
    only_text,
    refuse_misplaced,
    refuse_others,
)
from corollary.derive.markdown_items import ListItem, MarkdownError, Section, at_line, sections
from corollary.derive.numbered_items import mistake_in_list, numbers_letter, numbers_of
from corollary.derive.stated_words import function, unknowns, variable
from corollary.derive.statements import (
    Acting,
    Along,
    Choice,
    Code,
    Confirm,
    Each,
    Example,
    Exchange,
    Explain,
    Forces,
    Mistake,
    Neglected,
    Optimum,
    Plot,
    Printed,
    Proof,
    Rejected,
    Route,
    Simulated,
    Statement,
    Step,
    Supposed,
)
from corollary.derive.step_heading import CASE, step_heading
from corollary.laws.law import Law, Meaning, known_by_name
from corollary.messages import did_you_mean

OPTION = re.compile(
    r"\((?P<option>\w+)\)\s+is\s+(?P<right>right|wrong)(?:\s+if\s+`(?P<condition>[^`]+)`)?(?::\s+(?P<text>.*))?$"
)
KINDS = ("optimum", "simulated", "example", "neglected", "proof", "code", "plot", *BY_FORMULA)
"""Items that say of which kind a section is."""


def read_solution(text: str, givens: Mapping[str, sympy.Symbol], folder: Path) -> tuple[Branch, ...]:
    """The derivation that a text states, in each case. `folder` is where the programs lie that it names.

    To be read within `own_letters`. Raises MarkdownError.
    """
    keys = {key for words in ALLOWED.values() for key in words} | {*CLAIMS, *BELOW}
    return SolutionReader(givens, folder).derivation(sections(text, keys))


def _kind(section: Section, part: str, letters: Sequence[str]) -> str:
    keys = {item.key for item in section.items}
    for kind in KINDS:
        if kind in keys:
            return kind
    if letters:
        return "step"
    if "force" in keys:
        return "forces"
    if "rubric" in keys:
        return "explain"
    return "choice" if part else "checks"


class SolutionReader:
    def __init__(self, givens: Mapping[str, sympy.Symbol], folder: Path) -> None:
        self.table = LetterTable(givens)
        self.givens, self.folder = givens, folder
        self.supposed: dict[str, Supposed] = {}

    def derivation(self, found: list[Section]) -> tuple[Branch, ...]:
        first, *others = found
        titled = [each for each in others if each.level > 1]
        for section in (
            first,
            *(each for each in others if each.level == 1),
        ):  # a title, and what is said of letters
            if section.title.startswith("("):
                raise MarkdownError(section.line, f"a step has a heading of level two: ## {section.title}")
            self._allowed(section, "letters")
            self._declarations(section)
        for section in titled:
            self._declare(section)
        entries: list[Entry | Cases] = []
        stated: list[tuple[Section, re.Match[str], list[Entry]]] = []
        within = 0
        for section in titled:
            with at_line(section.line):
                if case := CASE.match(section.title):
                    if stated and len(entries) > within:
                        raise ValueError(
                            "all cases stand one after the other; state what holds in each of them before or after"
                        )
                    stated.append((section, case, []))
                    within = len(entries)
                elif stated and section.level > stated[-1][0].level:
                    stated[-1][2].extend(self._entries(section))
                else:
                    entries += self._entries(section)
        if stated:
            entries.insert(within, Cases(tuple(self._case(*each) for each in stated), stated[0][0].line))
        if not entries:
            raise MarkdownError(1, "it states no step; begin one with a heading, such as ## (a) v")
        with at_line(stated[0][0].line if stated else 1):
            return branches(entries)

    def _case(self, section: Section, case: re.Match[str], entries: list[Entry]) -> Case:
        with at_line(section.line):
            return Case(case["text"], self.table.condition(case["condition"]), tuple(entries), section.line)

    # letters

    def _know(self, letter: str, meaning: Meaning) -> None:
        self.table.meanings[letter] = meaning

    def _unknown(self, letter: str, meaning: str = "") -> sympy.Symbol:
        (symbol,) = unknowns(letter, **({letter: meaning} if meaning else {}))
        self._know(letter, symbol)
        return symbol

    def _declarations(self, section: Section) -> None:
        for item in section.items:
            with at_line(item.line):
                letters, meaning = formula_and_words(item)
                match item.key:
                    case "letter":
                        self._vector([each.strip() for each in parted(letters)], meaning)
                    case "variable":
                        self._know(letters, variable(letters, meaning))
                    case "function":
                        called = re.fullmatch(r"([A-Za-z]\w*)\(([A-Za-z]\w*)\)", letters.strip())
                        if not called:
                            raise ValueError("write a function with what it depends on, such as `v(t)`")
                        if called[2] not in self.table.meanings:
                            self._know(called[2], variable(called[2]))
                        self._know(called[1], function(called[1], self.table.symbol(called[2]), meaning))
                    case _:
                        self._suppose(letters, meaning)

    def _vector(self, names: Sequence[str], meaning: str = "") -> None:
        """Unknowns by their letters; v_x and v_y, and v_z, are the vector v, too."""
        symbols = tuple(self._unknown(name, meaning) for name in names)
        ends = [name.rpartition("_") for name in names]
        heads = {head for head, _, _ in ends}
        if len(names) > 1 and len(heads) == 1 and [end for _, _, end in ends] == list("xyz")[: len(names)]:
            (name,) = heads
            known_by_name(name, symbols)
            self._know(name, symbols)

    def _suppose(self, text: str, why: str) -> None:
        name, _, value = (each.strip() for each in text.partition("="))
        if not name.isidentifier() or not value:
            raise ValueError("write what is supposed as a letter with its value, such as `tau = 1 ms`")
        symbol = sympy.Symbol(name, positive=True)
        known_by_name(name, symbol)
        self._know(name, symbol)
        self.supposed[name] = Supposed(name, value, why)

    def _declare(self, section: Section) -> None:
        """The letters that a section finds, or needs."""
        heading = step_heading(section)
        letters, meaning = heading.letters, heading.meaning
        with at_line(section.line):
            if given := [letter for letter in letters if letter in self.givens]:
                raise ValueError(f"{given[0]} is a given; call the unknown by another letter")
            for name, of in heading.functions:
                if name not in self.table.meanings:
                    self._know(name, function(name, self.table.symbol(of), meaning))
            new = [letter for letter in letters if letter not in self.table.meanings]
            if new:
                self._vector(new, meaning)
            elif meaning and not heading.functions:
                self._vector(letters, meaning)
        for item in section.items:
            with at_line(item.line):
                if item.key == "letter":
                    named, words = formula_and_words(item)
                    self._vector([each.strip() for each in parted(named)], words)
                elif item.key == "each":
                    letter, symbol = numbers_letter(item, self.table)
                    self._know(letter, symbol)
                elif item.key == "also":
                    beside = [each.strip() for each in parted(formula_of(item))]
                    self._vector([each for each in beside if each not in self.table.meanings])

    # sections

    def _entries(self, section: Section) -> list[Entry]:
        heading = step_heading(section)
        part, letters = heading.part, heading.letters
        kind = _kind(section, part, letters)
        self._allowed(section, kind)
        names = tuple(map(self.table.found, letters))
        if heading.answers and kind != "step":
            raise MarkdownError(
                section.line, f"only the laws of a step answer several parts at once; this is {kind}"
            )
        check = " ".join(item.text for item in section.items if item.key == "check")
        statement = Statement(part, section.paragraph, section.line, check)
        found: list[Entry] = []
        if kind in BY_FORMULA:
            found.append(BY_FORMULA[kind](section, statement, self.givens))
        elif kind != "checks":
            read: Callable[[Section, Statement, tuple[sympy.Symbol, ...]], Entry] = getattr(self, f"_{kind}")
            entry = read(section, statement, names)
            if isinstance(entry, Step):
                found += one_for_each_part(
                    entry,
                    {name: tuple(map(self.table.found, letters)) for name, letters in heading.answers},
                )
            else:
                found.append(entry)
        for item in section.items:
            if item.key in CLAIMS:
                with at_line(item.line):
                    claim: Callable[[ListItem], Entry] = getattr(self, f"_{item.key}")
                    found.append(claim(item))
        return found

    def _allowed(self, section: Section, kind: str) -> None:
        claims = () if kind == "letters" else CLAIMS
        words = (*ALLOWED[kind], *claims)
        options = kind in ("choice", "forces")
        for item in section.items:
            if item.key in words or (options and OPTION.match(item.text)):
                refuse_misplaced(item)
                continue
            begin = f"begin it with one of: {', '.join(f'{word}:' for word in words)}"
            if options:
                begin += ", (a) is right, (b) is wrong"
            if item.key in ALLOWED["letters"]:
                begin = f"move {item.key}: above the first heading"
            word = item.key or item.text.partition(":")[0].partition(" ")[0]
            raise MarkdownError(
                item.line,
                f"an item that begins with {word!r} has no place here{did_you_mean(word, words)}; {begin}",
            )

    def _texts(self, section: Section, key: str) -> list[str]:
        found: list[str] = []
        for item in section.items:
            if item.key == key:
                with at_line(item.line):
                    found.append(formula_of(item))
        return found

    def _laws(self, items: Iterable[ListItem], key: str = "law", *, named: bool = True) -> tuple[Law, ...]:
        return tuple(self._law(item, named) for item in items if item.key == key)

    def _law(self, item: ListItem, named: bool) -> Law:
        with at_line(item.line):
            name, clauses = clauses_of(item)
            refuse_others(clauses, "law", "with")
            words = {key: only_text(item.values(key)) for key in ("source", "holds") if item.values(key)}
            letters = [*clauses["with"], *(formula_of(each) for each in item.values("with"))]
            formula = one_formula(clauses["law"], "law", "Momentum, `p = m*v`")
            if named and not name and not is_call(formula):
                raise ValueError(f"name the law before its formula: Momentum, `{formula}`")
            return self.table.law(name, formula, ", ".join(letters), **words)

    def _where(self, section: Section) -> Any:
        conditions: list[Any] = []
        for item in section.items:
            if item.key == "where":
                with at_line(item.line):
                    conditions.append(self.table.condition(formula_of(item)))
        return sympy.And(*conditions) if len(conditions) > 1 else conditions[0] if conditions else True

    def _step(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Step:
        laws = self._laws(section.items)
        with at_line(section.line):
            if not laws:
                raise ValueError(
                    f"{section.title}: state the laws from which it follows, each in an item such as law: Momentum, `p = m*v`"
                )
            (scale,) = [self.table.expression(each) for each in self._texts(section, "scale")] or [None]
        also = tuple(
            self.table.symbol(letter) for each in self._texts(section, "also") for letter in parted(each)
        )
        rejected: list[Rejected] = []
        routes: list[Route[Law]] = []
        for item in section.items:
            with at_line(item.line):
                if item.key == "reject":
                    formula, reason = formula_and_words(item)
                    roots = {
                        self.table.symbol(name): root for name, root in self.table.equations(formula).items()
                    }
                    rejected.append(Rejected(reason, roots))  # type: ignore[arg-type]
                elif item.key == "route":
                    because, clauses = clauses_of(item)
                    refuse_others(clauses, "law")
                    called = tuple(self.table.law("", each) for each in clauses["law"])
                    routes.append(Route(because, called + self._laws(item.items), item.line))
        where = self._where(section)
        each = numbers_of(section, self.table)
        return Step(
            statement,
            names,
            laws,
            also,
            where,
            tuple(rejected),
            self._mistakes(section, laws, each),
            tuple(routes),
            scale,
            each,
        )

    def _mistakes(
        self, section: Section, laws: Sequence[Law] = (), each: Each | None = None
    ) -> tuple[Mistake[Exchange], ...]:
        names = {law.name for law in laws}
        every = [item for item in section.items if item.key == "mistake"]
        if each is None:
            return tuple(self._mistake(item, names) for item in every)
        return tuple(
            mistake_in_list(item, each, self.table, lambda rest: self._mistake(rest, names)) for item in every
        )

    def _mistake(self, item: ListItem, names: Collection[str] = ()) -> Mistake[Exchange]:
        """`names` are those of the step's laws: a law of that name takes its place."""
        with at_line(item.line):
            text, clauses = clauses_of(item)
            where = [*clauses["where"], *(formula_of(each) for each in item.values("where"))]
            below = (each.text.strip('"') for each in item.values("instead of"))
            instead = (*clauses["instead of"], *below)
            which = self.table.condition(one_formula(where, "condition", "v > 0")) if where else None
            nested = self._laws(item.items, named=False)
            if not instead and nested and all(law.name in names for law in nested):
                instead = tuple(dict.fromkeys(law.name for law in nested))
            name = name_of_mistake(item, clauses["named"])
            formulas = clauses["law"]
            if len(formulas) == 1 and is_call(formulas[0]) and not nested:
                called = self.table.call(formulas[0])
                if isinstance(called, Mistake):
                    found = cast("Mistake[Exchange]", called)
                    rule = Exchange(
                        found.rule.laws,
                        instead or found.rule.instead,
                        found.rule.where if which is None else which,
                    )
                    return Mistake(text or found.text, rule, item.line, name or found.name)
            letters = ", ".join([*clauses["with"], *(formula_of(each) for each in item.values("with"))])
            laws = tuple(
                self.table.law("", formula, "" if is_call(formula) else letters) for formula in formulas
            )
            if not laws + nested:
                raise ValueError(
                    "say which law the mistake puts in the place of the right one: a sentence, then its formula, `K = m*v^2`"
                )
            if not text:
                raise ValueError("say what the student reads who made this mistake, before the formula")
            return Mistake(text, Exchange(laws + nested, instead, which), item.line, name)

    def _optimum(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Optimum:
        item = first_item(section, "optimum")
        with at_line(item.line):
            found = re.fullmatch(
                r"`([^`]+)` is (largest|smallest) for `([^`]+)` from `([^`]+)` to `([^`]+)`", item.text
            )
            if not found:
                raise ValueError("write it as in `R` is largest for `theta` from `0` to `pi/2`")
            of, low, high = (self.table.expression(found[place]) for place in (1, 4, 5))
            over = self.table.symbol(found[3])
        return Optimum(
            statement, names, of, over, (low, high), found[2] == "largest", self._mistakes(section)
        )

    def _simulated(
        self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]
    ) -> Simulated:
        item = first_item(section, "simulated")
        with at_line(item.line):
            quoted = QUOTED.findall(item.text)
            if len(quoted) != 2:
                raise ValueError("name the scene and what is observed in it, as in `cradle`, `velocities`")
            settings = [each for below in item.values("with") for each in parted(formula_of(below))]
            formulas = {
                name: value for each in settings for name, value in self.table.equations(each).items()
            }
        return Simulated(statement, names, quoted[0], formulas, quoted[1], self._mistakes(section))  # type: ignore[arg-type]

    def _example(
        self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]
    ) -> Example[sympy.Symbol, sympy.Expr, Law]:
        item = first_item(section, "example")
        apart: list[tuple[tuple[sympy.Expr, ...], str]] = []
        with at_line(item.line):
            found = re.fullmatch(r"(?:(\d+) free)?", item.text)
            if not found:
                raise ValueError("say how many of the numbers are free, as in example: 1 free")
            (scale,) = [self.table.expression(each) for each in self._texts(section, "scale")] or [
                sympy.Integer(1)
            ]
        for each in section.items:
            if each.key == "apart":
                with at_line(each.line):
                    formula, why = formula_and_words(each)
                    apart.append((tuple(map(self.table.expression, parted(formula))), why))
        return Example(statement, names, self._laws(section.items), tuple(apart), int(found[1] or 1), scale)

    def _neglected(
        self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]
    ) -> Neglected[Step, Supposed]:
        item = first_item(section, "neglected")
        with at_line(item.line):
            what, asked = re.subn(r",? as asked$", "", item.text)
            supposed = [each.strip() for text in self._texts(section, "supposing") for each in parted(text)]
            if missing := [each for each in supposed if each not in self.supposed]:
                raise ValueError(
                    f"{missing[0]} is not supposed above; say supposed: `{missing[0]} = 1 ms`, and why"
                )
        also = tuple(
            self.table.symbol(letter) for each in self._texts(section, "also") for letter in parted(each)
        )
        bound = Step(statement, names, self._laws(section.items), also, True, (), (), (), None)
        return Neglected(what, bound, tuple(self.supposed[each] for each in supposed), bool(asked))

    def _proof(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Proof[Law]:
        (target,) = self._laws(section.items, "proof")
        mistakes: list[Mistake[tuple[Law, ...]]] = []
        rates: list[tuple[str, sympy.Expr]] = []
        for item in section.items:
            with at_line(item.line):
                if item.key == "mistake":
                    wrong = self._mistake(item)
                    mistakes.append(Mistake(wrong.text, wrong.rule.laws, wrong.line, wrong.name))
                elif item.key == "rate":
                    for name, rate in self.table.equations(formula_of(item)).items():
                        rates.append((self.table.symbol(name).name, rate))  # type: ignore[arg-type]
        return Proof(
            statement,
            self._laws(section.items),
            target,
            tuple(self._texts(section, "line")),
            tuple(mistakes),
            self._laws(section.items, "given"),
            tuple(rates),
        )

    def _forces(
        self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]
    ) -> Forces[sympy.Expr, Law]:
        acting: list[Acting[sympy.Expr]] = []
        along: list[Along[Law]] = []
        mistakes: dict[str, str] = {}
        for item in section.items:
            with at_line(item.line):
                if item.key == "force":
                    found = re.fullmatch(r"\((\w+)\) (?:`([^`]+)` )?(?:`([^`]+)`|([\w ]+))", item.text)
                    if not found:
                        raise ValueError("write it as in (a) `m*g` down, or (a) `N` `pi/2 + alpha`")
                    way = found[4] or self.table.expression(found[3])
                    acting.append(Acting(found[1], self.table.expression(found[2] or "0"), way))
                elif item.key == "along":
                    head, _, _rest = item.text.partition(":")
                    way = self.table.expression(head.strip("`")) if head.startswith("`") else head
                    (law,) = self._laws([replace(item, key="law", text=_rest.strip())])
                    along.append(Along(way, law))
                elif option := OPTION.match(item.text):
                    mistakes[option["option"]] = option["text"] or ""
        return Forces(statement, tuple(acting), tuple(along), mistakes)

    def _choice(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Choice[Any]:
        options: dict[str, Any] = {}
        mistakes: dict[str, str] = {}
        for item in section.items:
            if found := OPTION.match(item.text):
                with at_line(item.line):
                    right = found["right"] == "right"
                    if found["condition"]:
                        condition = self.table.condition(found["condition"])
                        options[found["option"]] = condition if right else sympy.Not(condition)
                    else:
                        options[found["option"]] = right
                    if found["text"]:
                        mistakes[found["option"]] = found["text"]
        if not options:
            raise MarkdownError(
                section.line,
                f"({statement.part}) has no unknown in its heading and no options below it; write (a) v, or items such as "
                "(a) is right and (b) is wrong: why",
            )
        return Choice(statement, options, mistakes)

    def _explain(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Explain:
        rubric = tuple(item.text for item in section.items if item.key == "rubric")
        return Explain(replace(statement, because=""), rubric, statement.because)

    def _code(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Code:
        item = first_item(section, "code")
        with at_line(item.line):
            judges = LazyModule(self.folder / formula_of(item), self.folder)
            inputs = (
                getattr(judges, named_below(item, "inputs")) if item.values("inputs") else _without_arguments
            )
            judge, example = (
                getattr(judges, named_below(item, "judge")),
                program_text(self.folder / named_below(item, "example")),
            )
            return Code(statement, inputs, judge, example)

    def _plot(self, section: Section, statement: Statement, names: tuple[sympy.Symbol, ...]) -> Plot:
        item = first_item(section, "plot")
        with at_line(item.line):
            judge = getattr(
                LazyModule(self.folder / formula_of(item), self.folder), named_below(item, "judge")
            )
            example = program_text(self.folder / named_below(item, "example"))
            return Plot(statement, judge, example, bool(item.values("with calls")))

    # claims

    def _at(self, item: ListItem) -> Special:
        formula, because = formula_and_words(item)
        return Special(Statement("", because, item.line), self.table.equations(formula))  # type: ignore[arg-type]

    def _limit(self, item: ListItem) -> Limit:
        quoted = QUOTED.findall(item.text)
        pairs = [each.split("->") for each in quoted]
        if len(pairs) != 2 or any(len(pair) != 2 for pair in pairs):
            raise ValueError("write it as in `F -> 0` as `dt -> oo`")
        (of, equals), (letter, to) = pairs
        because = item.text.partition("`")[0].strip()
        of, equals, to = (self.table.expression(each) for each in (of, equals, to))
        of = value_of(of) or of
        return Limit(Statement("", because, item.line), of, self.table.symbol(letter), to, equals)

    def _always(self, item: ListItem) -> Always:
        condition, words = formula_and_words(item)
        return Always(Statement("", words, item.line), self.table.condition(condition))

    def _confirm(self, item: ListItem) -> Confirm:
        because, clauses = clauses_of(item)
        refuse_others(clauses, "law")
        laws = tuple(self.table.law("", each) for each in clauses["law"]) + self._laws(item.items)
        return Confirm(Statement("", because, item.line), laws)

    def _printed(self, item: ListItem) -> Printed:
        found = re.fullmatch(r"\((\w+)\) `([^`]+)`(?:,? in (.*))?", item.text)
        if not found:
            raise ValueError("write it as in (a) `2.28 kg m/s` in (12.31)")
        erratum = only_text(item.values("erratum")) if item.values("erratum") else ""
        return Printed(Statement(found[1], "", item.line), found[2], found[3] or "", erratum)


def _without_arguments(given: object, draw: object) -> list[dict[str, Any]]:
    """One call without arguments."""
    return [{}]
