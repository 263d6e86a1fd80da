"""One line of a derivation as typed: the sides of its equations, without the words around them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from corollary.answers.name import keyboard
from corollary.formula.by_hand import by_hand
from corollary.formula.symbols import APART, GREEK, LETTER, RUN

Readable = Callable[[str], bool]
"""Whether a word is a formula in the letters of the problem."""

GOAL = re.compile(
    r"\s*(?:to (?:show|prove|be shown)|we want|want|claim|goal|zu zeigen|behauptung)\b", re.IGNORECASE
)
ARROW = r"<?=>|<?-{1,2}>|[→⇒⟹⟶⇔⟺↔➜➔∴∵]|\\(?:Rightarrow|Longrightarrow|rightarrow|implies|iff|therefore|because|to)(?![A-Za-z])"
LEADING = re.compile(
    rf"\s*(?:(?:{ARROW})\s*|(?:\*|•|\(?[0-9]{{1,2}}[.)])\s+"
    r"|(?:so|thus|hence|therefore|then|and|or|with|where|because|since|also|now)\b[:,]?\s+"
    r"|[A-Za-z][^=:]*:\s*|[(0-9][^=:]*:\s+)*",
    re.IGNORECASE,
)
NUMBERED = re.compile(  # the number of an equation behind it
    r"\s(?:\((?:\*{0,2}[0-9]{1,2}|[ivIV]{1,5}|[0-9]{1,2}\.[0-9]{1,3}[a-z]?)\)|\[[0-9.]{1,7}\])$"
)
ARROWS = re.compile(ARROW)
EQUALS = re.compile(r":=|===?|≡|≝|≔")
REMARK = re.compile(
    r"(?:\s#|//|\s--\s|\s–\s).*$|[\s,;]+\(?(?:q\.?\s?e\.?\s?d|w\.?\s?z\.?\s?b\.?\s?w)\b[.)\s]*$|\s*[□∎■]\s*$",
    re.IGNORECASE,
)
BETWEEN = re.compile(
    r"\s*;\s*|,?\s+(?:and|so|so that|hence|thus|therefore|where|with|then|using|because|since|as|if|for|by|from|"
    r"und|also|daher|mit|wobei|weil|da|"
    r"(?:(?:we|one|you|it|this|that|which)\s+)?(?:gets?|gives?|giving|yields?|follows|implies|means|have|obtains?|finds?|leads to|"
    r"folgt|ergibt|gilt)(?:\s+that)?)\s+|,\s+",
    re.IGNORECASE,
)
QUESTION = re.compile(r"=\s*\?+\s*$")
SPECIAL_CASE = re.compile(r"\s*(?:for|if|when|für|bei|wenn|falls)\b[^:]*=[^:]*:", re.IGNORECASE)
BULLET = re.compile(r"\s*[-–]\s+")
PRIMES = re.compile(rf"(?<=[{LETTER}0-9_}}])['’′]+(?![A-Za-z])")
# `λ'y`: a letter with a prime, glued to the next; `l'impulsion` is a word.
GLUED_PRIME = re.compile(r"(?<![^\W\d_])(?P<letter>[^\W\d_])['’′](?P<run>[^\W\d_]\w*)")
IN_BRACKETS = re.compile(r"\s*[(\[]([^()\[\]=]*=(?:[^()\[\]=]|\([^()]*\))*)[)\]]\s*\.?\s*")
DEFINES_BEHIND = re.compile(
    r"(?P<before>[^=]*=.*[^\s*/^+=(-])\s+[(\[](?:[^()\[\]=]*[\s,:])?(?P<letter>[^\W\d_](?:_?[0-9]|_[A-Za-z]|_prime)?)\s*=\s*(?P<meaning>[^\[\]=,;]+?)(?:,[^()\[\]=]*)?[)\]][\s.]*"
)
REASONS = frozenset(
    ["using", "because", "since", "as", "for", "by", "from", "da", "weil"]
)  # what it is said for comes after it
ABBREVIATION = re.compile(r"[IVX]+|N\.?\s?[123]|[A-Z]{2,4}\.?")
WORD = re.compile(rf"(?:^|(?<=[\s,;])){RUN.pattern}")
SHORT = frozenset(  # words, and no letters
    "by as if of is an to at on in we it da am im so or vs be no do he my up us es".split()  # noqa: SIM905
)
FIRST_WORD = re.compile(rf"\s*({RUN.pattern}|[A-Za-z'’-]+|[0-9]+[a-z]{{2}})[,:]?\s+(?=\S)")
ORDINAL = re.compile(r"[0-9]+(?:st|nd|rd|th)")
OPERATOR = re.compile(r"[=*/^+<>√²³]")
ENDS = re.compile(r"\W*q\.?\s?e\.?\s?d\.?\W*|[^\w]*", re.IGNORECASE)
GREEK_LETTER = re.compile(
    rf"(?:[{''.join(sorted(set(GREEK) - set('Δ∆δπħℏ')))}]|δ(?![A-Za-z]))(?:_\{{[A-Za-z0-9, ]{{1,8}}\}}|_?[0-9₀-₉]+|_[A-Za-z]|_prime)?"
)
LONE = re.compile(rf"\s*({RUN.pattern})\s*")
LATIN = re.compile(rf"[{LETTER}]{{3}}")


def says_nothing(line: str) -> bool:
    """Whether a line has words only, ends the derivation, says what is to be shown, or is about a special case."""
    bare = LEADING.sub("", EQUALS.sub("=", line), count=1)
    if QUESTION.search(line) or GOAL.match(line) or SPECIAL_CASE.match(line) or ENDS.fullmatch(line):
        return True
    return "=" not in bare and bool(re.search(r"[^\W\d]{3}", line)) and not re.search(r"[*^/+<>]", line)


def equations(line: str, readable: Readable) -> list[str]:
    """Each `a = b = c` of the line on its own."""
    typed = PRIMES.sub("_prime", _primes_apart(line.replace("&=", "=").replace("&", ""), readable))
    if whole := IN_BRACKETS.fullmatch(typed):  # `(mass per length λ = m/L)`
        typed = whole[1]
    typed = _definitions_first(LEADING.sub("", EQUALS.sub("=", typed), count=1), readable)
    typed = LEADING.sub("", ARROWS.sub(";", by_hand(typed)), count=1)
    typed = _without_bracketed(APART.sub(r"\1", REMARK.sub("", typed)), readable)
    found: list[str] = []
    for piece, joint in _pieces(typed):
        if found and ("=" not in piece or "=" not in found[-1]):
            found[-1] += joint + piece
        elif joint.strip(" ,").lower() in REASONS:
            found.insert(len(found) - 1, piece)
        else:
            found.append(piece)
    return [piece for piece in found if "=" in piece]


def _primes_apart(line: str, readable: Readable) -> str:
    """`λ'y` as `λ_prime y`, where what follows is made of letters of the problem."""
    return GLUED_PRIME.sub(
        lambda found: f"{found['letter']}_prime {found['run']}" if readable(found["run"]) else found[0], line
    )


def _definitions_first(line: str, readable: Readable) -> str:
    """`mu = λ*y (mass per length λ = m/L)` as two equations, the one in brackets first, where it gives a letter a meaning in others."""
    found = DEFINES_BEHIND.fullmatch(line)
    letters = RUN.findall(found["meaning"]) if found else []
    if found is None or not letters or not all(map(readable, letters)):
        return line
    return f"{found['letter']} = {found['meaning']}; {found['before']}"


def _pieces(text: str) -> list[tuple[str, str]]:
    """What stands between joints, and the joint before it; a joint inside brackets is none."""
    pieces, joint, start = list[tuple[str, str]](), "", 0
    for found in BETWEEN.finditer(text):
        before = text[: found.start()]
        if sum(map(before.count, "([")) == sum(map(before.count, ")]")):
            pieces.append((text[start : found.start()], joint))
            joint, start = found[0], found.end()
    return [*pieces, (text[start:], joint)]


def without_bullets(lines: Sequence[tuple[int, str]]) -> list[tuple[int, str]]:
    """Lines that all begin with a dash are a list; else the dash is a minus."""
    listed = all(BULLET.match(line) for _number, line in lines)
    return [(number, BULLET.sub("", line, count=1) if listed else line) for number, line in lines]


def is_prose(equation: str, readable: Readable) -> bool:
    """`momentum before = momentum after`"""
    words_of_sides = [side.split() for side in equation.split("=")]
    return any(len(each) > 1 for each in words_of_sides) and all(
        each and all(word.isalpha() and _is_word(word, readable) for word in each) for each in words_of_sides
    )


def sides(equation: str, readable: Readable) -> list[str]:
    """The sides of `a = b = c`, without words before the first and the reason behind the last."""
    found = equation.split("=")
    found[0] = without_words(LEADING.sub("", found[0], count=1), readable)
    found[-1] = without_reason(found[-1], readable)
    return found


def without_words(side: str, readable: Readable) -> str:
    """`Momentum is conserved, so p` is `p`."""
    while (word := FIRST_WORD.match(side)) and (ORDINAL.fullmatch(word[1]) or _is_word(word[1], readable)):
        side = side[word.end() :]
    return side


def without_reason(side: str, readable: Readable) -> str:
    """`m*v (momentum)`, `m*v by Newton's second law` and `m*v, momentum` are `m*v`."""
    side = _without_bracketed(side, readable).strip()
    for word in WORD.finditer(side):
        if word.start() and _is_word(word[0], readable) and not OPERATOR.search(side[word.start() :]):
            return _without_numbers(side[: word.start()])
    return side


def _without_numbers(text: str) -> str:
    """Without full stops and the number of the equation at the end."""
    while True:
        text = text.rstrip(" \t.,;")
        found = NUMBERED.search(text[-12:])
        if found is None:
            return text
        text = text[: len(text) - len(found[0])]


def _without_bracketed(text: str, readable: Readable) -> str:
    """Without reasons in brackets at the end, brackets in them too."""
    while True:
        text = _without_numbers(text)
        start, depth = len(text), 0
        for place in range(len(text) - 1, -1, -1):
            depth += (text[place] in ")]") - (text[place] in "([")
            if depth <= 0:
                start = place
                break
        apart = text[:start].endswith((" ", "\t")) and text[:start].rstrip()[-1:] not in "*/^+-=("
        if text[-1:] not in (")", "]") or not apart or not _is_reason(text[start + 1 : -1], readable):
            return text
        text = text[:start]


def lone(side: str) -> str:
    """The letter that stands alone on a side."""
    found = LONE.fullmatch(side)
    return found[1] if found else ""


def lettered(side: str) -> list[str]:
    """What looks like a letter on a side, and not like a word: `J`, `dt`, `v_rel`."""
    return [
        run for run in RUN.findall(side) if not run.isalpha() or (len(run) < 3 and run.lower() not in SHORT)
    ]


def greek_letters(side: str) -> list[str]:
    """The Greek letters of a side with their indices, as they are called on a keyboard: `lambda` of `λgy`, `rho_0` of `ρ_0`."""
    return [re.sub(r"[{}, ]", "", keyboard(found)) for found in GREEK_LETTER.findall(side)]


def _is_word(word: str, readable: Readable) -> bool:
    return word.lower() in SHORT or (bool(LATIN.search(word)) and not readable(word))


def _is_reason(inside: str, readable: Readable) -> bool:
    words = RUN.findall(inside)
    return bool(ABBREVIATION.fullmatch(inside.strip())) or any(_is_word(word, readable) for word in words)
