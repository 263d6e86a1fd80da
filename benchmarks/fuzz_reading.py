"""Random text thrown at every reader: how many strings were read, asked about or refused, the slowest, and every crash.

python benchmarks/fuzz_reading.py 100000 [seed]
"""

from __future__ import annotations

import random
import re
import sys
import time
from collections import Counter

from corollary.answers.quantity import read_quantities, read_quantity
from corollary.formula.errors import ParseError
from corollary.formula.numerals import TO_ASCII, scan_number
from corollary.formula.plain_text import text
from corollary.formula.syntax import parse
from corollary.units.unit import read_unit, unit

LETTERS = [
    "m",
    "M",
    "v",
    "v0",
    "vA0",
    "v_B0",
    "mA",
    "mB",
    "theta",
    "mu",
    "dt",
    "g",
    "h",
    "a",
    "aa",
    "e",
    "r",
    "n",
]
WORDS = (
    re.split(
        " ",
        "m M v v0 vA0 v_B0 mA m_{A} mb θ theta μ mu Δt dt g h a aa e r n sin cos tan asin sqrt √ ln log exp abs atan2 max gamma pi π "
        "0 1 2 3.5 1,5 1,234 1e3 1e-300 10^3 ·10^-3 9**9 64 ½ ² ⁻¹ ³ + - * / ^ ** ( ) [ ] | = , ; . : _ { } ! % ° deg at i j k "
        "kg g s ms N Ns Nm J kJ km/h km h W Pa Hz eV u rad min t · × − \u00a0 \u200b \\frac __import__ lambda é 𝐦 ٣",
    )
    + [" "] * 12
)
MUTATED = [
    "8.6 kg m/s",
    "8,6 Ns",
    "(3, 4) m/s",
    "5 m/s at 30 deg",
    "3 i + 4 j",
    "1,2·10^3 J/(kg m)",
    "2mv sin(θ)/dt",
    "(m_A v_A0 + m_B v_B0)/(m_A + m_B)",
]


def strings(count: int, seed: int):
    """Words in a row, runs of any characters, and honest answers with a few characters changed."""
    draw = random.Random(seed)
    for place in range(count):
        match place % 3:
            case 0:
                yield "".join(draw.choice(WORDS) for _ in range(draw.randint(1, 25)))
            case 1:
                yield "".join(
                    chr(draw.choice((draw.randint(32, 126), draw.randint(32, 126), draw.randint(0, 0x2FFF))))
                    for _ in range(draw.randint(1, 30))
                )
            case _:
                letters = list(draw.choice(MUTATED))
                for _ in range(draw.randint(1, 4)):
                    spot = draw.randrange(len(letters) + 1)
                    letters[spot : spot + draw.randint(0, 2)] = draw.choice(WORDS)
                yield "".join(letters)


def main(count: int, seed: int) -> int:
    expected = unit("kg*m/s")
    readers = {
        "number": lambda written: scan_number(written.translate(TO_ASCII)),
        "unit": read_unit,
        "quantity": lambda written: read_quantity(written, expected),
        "vector": lambda written: read_quantities(written, expected, 2),
        "expression": lambda written: parse(written, LETTERS),
    }
    outcomes, slowest, crashes = Counter(), (0.0, "", ""), 0
    for written in strings(count, seed):
        for name, reader in readers.items():
            start = time.perf_counter()
            try:
                found = reader(written)
                if (
                    name == "expression"
                    and not isinstance(found, ParseError)
                    and parse(text(found), LETTERS) != found
                ):
                    raise AssertionError("its text does not read back")
            except Exception as error:  # every kind of crash is what is looked for
                crashes += 1
                print(f"CRASH {name} {written!r}: {type(error).__name__}: {error}")
                continue
            slowest = max(slowest, (time.perf_counter() - start, name, written))
            outcomes[name, found.status if isinstance(found, ParseError) else "ok"] += 1
    for (name, status), times in sorted(outcomes.items()):
        print(f"{name:>10} {status:>8} {times:>9}")
    print(
        f"{count} strings, {crashes} crashes, slowest {slowest[0] * 1e3:.2f} ms: {slowest[1]} {slowest[2]!r}"
    )
    return 1 if crashes else 0


if __name__ == "__main__":
    sys.exit(
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000, int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    )
