"""Options named in a student's own words: `in the steeper wire` for *the steeper one*, `4 times as high` for *four times as large*."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from corollary.answers.changing_words import NEGATIONS, words_of
from corollary.answers.number_words import NUMBERS
from corollary.answers.remark import BECAUSE

MOST_WORDS, LONG = 24, 5
# Words that mean nothing by themselves; of `as large as` and `four times as high` the number is what counts.
FILLING: str = (
    "the a an of to in on at for from by with its it is are was be been being as that this those these they them he she his her i we you my think "
    "answer option then so one ones will would should must can has have had do does did there here which what when just only really because since "
    "make makes making made get gets becomes become large high big great much heavy strong far many also now still"
)
FILLERS = frozenset(FILLING.split())
# What turns an option round, or takes it back: it stands on both sides or on neither.
REVERSING: str = f"{NEGATIONS} nothing cannot without but except unless if or and while although yet opposite oder eller und og"
REVERSED = frozenset(REVERSING.split())
SAME_AS: dict[str, str] = {
    "bigger": "larger", "greater": "larger", "higher": "larger", "increases": "larger", "lower": "smaller", "decreases": "smaller",
    "quicker": "faster", "equal": "same", "equally": "same", "unchanged": "same", "identical": "same", "double": "2 times", "doubled": "2 times", "doubles": "2 times",
    "quarter": "1/4", "fourth": "1/4", "half": "1/2", "halved": "1/2", "third": "1/3", "eighth": "1/8", "thrice": "3 times", "triple": "3 times", "tripled": "3 times",
    "quadruple": "4 times", "quadrupled": "4 times", "twice": "2 times",
}  # fmt: skip
PHRASES = (
    (re.compile(r"\b(in|un|non)-(?=[^\W\d_]{4})"), r"\1"),  # `in-elastic`
    (re.compile(r"\b(?:far|anything|nothing) (?:from|but|like)\b"), "not"),
    (re.compile(r"^\s*(yes|no)\b[,.:;]?\s+(?=\w)"), r"said\1 "),
    (
        re.compile(r"[,;(]\s*(?:i\.e\.|that is|so|=)?\s*[0-9.,]+\s*[a-zµ°%][a-z/°%²³]*\)?\s*\.?$"),
        "",
    ),  # `twice as fast, i.e. 48 km/h`
    (
        re.compile(
            r"(?<!half )(?<!twice )(?<!times )\b(?:just |exactly |equally )?as (?:large|big|high|great|much|long|fast|strong|heavy)(?: as\b(?: before\b)?|\s*[.!]?$)"
        ),
        "same",
    ),
    (
        re.compile(
            r"(?<!half )(?<!twice )(?<!times )\b(?:just|exactly|equally) as (?:large|big|high|great|much|long|fast|strong|heavy)\b"
        ),
        "same",
    ),
    (
        re.compile(r"\b(?:do(?:es)?|did) ?(?:not|n't) (?:change|matter)\b|\bno (?:change|difference)\b"),
        "same",
    ),
    (re.compile(r"'(?:s|re)\b"), ""),
    (re.compile(r"\b(?:more slowly|less fast)\b"), "slower"),
    (re.compile(r"\bmore quickly\b"), "faster"),
    (re.compile(r"\b(?:one|a|an) (?=half|quarter|third|eighth|fourth)"), ""),
    (re.compile(r"(?<=\d)\s*[x×](?![^\W_])"), " times"),
    (re.compile(r"(?<=times) (?:higher|larger|bigger|greater|more|faster|longer|as \w+)\b"), ""),
    (re.compile(r"\beach other\b"), "one another"),
)
# Words about a motion or a state that add nothing where the options do not have them.
ADDITIONS: str = "away mov move stay remain keep go goe act direction point take tak choose pick sea both some always ball wire body"
ADDED = frozenset(ADDITIONS.split())
IN_OPTIONS: str = "from to up on at in by with towards into out off down over under between before after"
INFINITIVE = re.compile(r"\b(?:have|has|had|needs?|need|is|are|got|wants?) to\b")
PREPOSITIONS = frozenset(IN_OPTIONS.split())
ORDINALS = frozenset(["first", "second", "third", "other", "last"])
NUMBER_ALONE = re.compile(rf"\W*(?:[0-9.,]+|{'|'.join(NUMBERS)})\W*", re.IGNORECASE)  # may count the options
BECAUSE_FIRST = re.compile(rf"\W*(?:{BECAUSE})\b", re.IGNORECASE)
CLAUSE_END = re.compile(r"\s*(?:[,;:(]|\.\s|\s[–-]\s)\s*")
ENDINGS = ("ing", "ed", "es", "s", "ly")
REASON = re.compile(rf"(?<=[^\W_])[.)]?[\s,;:–-]+(?:{BECAUSE}|due)\b.*$", re.IGNORECASE | re.DOTALL)


@dataclass(frozen=True, slots=True)
class Worded:
    """The letter of the option that a text means, "" for none; `sure` where every word of it is the option's or the question's."""

    letter: str
    sure: bool


def option_worded(text: str, options: Mapping[str, str], question: str) -> Worded:
    """The one option that has all words of a text which occur in the options at all; none where two have, or none.

    `question` are the words of the question, which a student may repeat.
    """
    known = {letter: _content(each) for letter, each in options.items()}
    typed, repeated = _content(REASON.sub("", text)), set(_content(question))
    whole = _worded(typed, known, repeated)
    if not whole.letter:  # `the elastic ball`, where it is asked which ball
        rest = _worded([word for word in typed if word not in repeated], known, repeated)
        whole = Worded("" if _numbers(typed) else rest.letter, sure=False)
    first = CLAUSE_END.split(text, maxsplit=1)[0]
    of_first = _content(first) if first != text else []
    alone = _exactly(of_first, known)
    if alone and not _begins_against(text[len(first) :]):
        return Worded(alone, sure=True)  # `just as long, the time does not depend on v`
    if whole.letter and _with_other_prepositions(text, options, whole.letter):
        return Worded(whole.letter, sure=False)  # `from a largest speed on` for *up to a largest speed*
    if (
        whole.letter
        and not whole.sure
        and _worded(of_first, known, repeated) == Worded(whole.letter, sure=True)
    ):
        return Worded(whole.letter, sure=True)  # `it stays the same, the mass cancels`
    asked_why = question.rstrip(" .,:").lower().endswith(("because", "since", "weil", "fordi"))
    if whole.letter and (NUMBER_ALONE.fullmatch(text) or (BECAUSE_FIRST.match(text) and not asked_why)):
        return Worded(whole.letter, sure=False)
    return whole


def _exactly(typed: list[str], known: Mapping[str, list[str]]) -> str:
    """The letter of the one option of just these words."""
    found = [letter for letter, words in known.items() if typed and typed == words]
    return found[0] if len(found) == 1 else ""


def _begins_against(rest: str) -> bool:
    """True if what follows a clause takes it back, or names another possibility."""
    return bool(REVERSED & set(re.findall(r"[^\W\d_]+", rest.lower())[:2]))


def _with_other_prepositions(text: str, options: Mapping[str, str], letter: str) -> bool:
    """True if a text has a preposition of another option that the one it means does not have."""
    typed, own = (
        PREPOSITIONS & words_of(INFINITIVE.sub("", each.lower())) for each in (text, options[letter])
    )
    others = set[str]().union(*(words_of(each) for key, each in options.items() if key != letter))
    return bool((typed - own) & others)


def _worded(typed: list[str], known: Mapping[str, list[str]], repeated: set[str]) -> Worded:
    """What the words of a text, without those that mean nothing, are among those of the options; `repeated` are the question's."""
    if not typed or len(typed) > MOST_WORDS:
        return Worded("", sure=False)
    everywhere = set[str]().union(*known.values())
    met = [word for word in typed if word in everywhere]
    found = [letter for letter, words in known.items() if met and set(met) <= set(words)]
    if len(found) != 1:
        return Worded("", sure=False)
    (letter,) = found
    option = known[letter]
    shared = {word for each in known.values() if each is not option for word in each}
    left_out = REVERSED.intersection(option) - {"and"}
    if (
        REVERSED.intersection(typed) - set(option)
        or left_out - set(typed)
        or _numbers(typed) - _numbers(option)
    ):
        return Worded("", sure=False)
    if (_numbers(option) - _numbers(typed)) - shared:
        return Worded("", sure=False)
    if "and" in option and "and" not in typed and not set(met) & set(option[option.index("and") :]):
        return Worded("", sure=False)  # one of two
    if len(option) > LONG and set(option) - set(typed) and len(set(met)) > len(set(option)) / 2:
        return Worded(letter, sure=False)  # an option copied but for a word
    others = {word for word in typed if word not in everywhere}
    if others & repeated and set(option) - set(typed):
        return Worded(letter, sure=False)  # `further from the screen` for *further from the slide*
    in_order = [word for word in dict.fromkeys(option) if word in met] == list(dict.fromkeys(met))
    in_order = in_order or (len(set(met)) < 3 and "than" not in option)
    return Worded(letter, sure=in_order and all(word in everywhere | repeated | ADDED for word in typed))


def _content(text: str) -> list[str]:
    """The words of a text that mean something: small, without endings, numbers as digits, one word for its synonyms."""
    lowered = text.lower().replace("’", "'")
    for pattern, instead in PHRASES:
        lowered = pattern.sub(instead, lowered)
    found: list[str] = re.findall(r"[0-9]+(?:[.,/][0-9]+)?|[^\W\d_]+(?:'t)?", lowered)
    words = [word for word in found if word not in FILLERS]
    spelt = " ".join(SAME_AS.get(word, word) for word in words)
    spelt_out = ("not" if word.endswith("n't") else str(NUMBERS.get(word, word)) for word in spelt.split())
    return [_stem(word) for word in spelt_out if word != "times"]


def _numbers(words: list[str]) -> set[str]:
    """Numbers, and which of several is meant: `as fast as the second` is not *as fast as the first*."""
    return {word for word in words if word[0].isdigit() or word in ORDINALS}


def _stem(word: str) -> str:
    """A word without the ending of a plural, a participle or an adverb."""
    return next(
        (word.removesuffix(each) for each in ENDINGS if word.endswith(each) and len(word) > len(each) + 3),
        word,
    )
