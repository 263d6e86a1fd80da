"""The units: one row each, with what it measures, its size, its prefixes and its names in words."""

from __future__ import annotations

from fractions import Fraction

from corollary.messages import N_
from corollary.units.dimension import ONE, Dimension, Unit

PREFIXES = {"": 0, "p": -12, "n": -9, "u": -6, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9}
TYPED = {"u": "uµμ", "k": "kK"}  # the two signs for micro, and Kg for kg, are both typed
IN_WORDS = {"micro": "u", "milli": "m", "centi": "c", "kilo": "k", "mega": "M"}

ROWS: list[tuple[str, ...]] = []
"""Every unit as it was registered."""
ENGLISH: set[str] = set()
"""Names of units that are offered for a word with one letter amiss: no `times` for `timme`."""
UNITS: dict[str, Unit] = {}
"""What may be typed for a single unit, with its prefix: `kN`, `µs`, `Newton`, `milliseconds`."""


def register(symbols: str, base_units: str, size: str = "1", prefixes: str = "", words: str = "") -> Unit:
    """Makes a unit known to all that reads and writes units; a package of somebody else's calls it when it is imported.

    symbols: how it is written, first as it is in files (`ohm Ω`); base_units: `kg m s^-2`; size: in SI, an exact number
    or a fraction of pi (`pi/180`); prefixes: those it is used with (`u m k`); words: its names, in the singular (`ohm`).
    Returns the unit. Raises ValueError when something that would be typed for it means another unit, and registers nothing.
    """
    dimension, pi = Dimension.of(base_units), int("pi" in size)
    factor = Fraction(size.replace("pi", "1"))
    name = symbols.split()[0]
    found: dict[str, Unit] = {}
    for prefix in ("", *prefixes.split()):
        unit = Unit(prefix + name, dimension, factor * Fraction(10) ** PREFIXES[prefix], pi)
        signs = TYPED.get(prefix, prefix) if prefix else ("",)
        found |= {sign + symbol: unit for symbol in symbols.split() for sign in signs}
        spoken = [word for word, sign in IN_WORDS.items() if sign == prefix] or [""]
        if words and not prefix:
            ENGLISH.update(before + words.split()[0] + end for before in ("", *IN_WORDS) for end in ("", "s"))
        for word in (before + each for each in words.split() for before in spoken if before or not prefix):
            found |= dict.fromkeys(_numbers(word), unit)
    for typed, unit in found.items():
        if UNITS.get(typed, unit) != unit:
            raise ValueError(f"the unit {name}: {typed} means {UNITS[typed].text} already")
    if any(typed not in UNITS for typed in found):
        ROWS.append((symbols, base_units, size, prefixes, words))
    UNITS.update(found)
    return found[name]


def rows_of_others() -> list[tuple[str, ...]]:
    """What other packages have registered: a notebook carries it, for students type those units, too."""
    return ROWS[_OURS:]


def _numbers(word: str) -> tuple[str, ...]:
    """A word in the singular and the plural, in English and in German (`Sekunden`)."""
    return (word, word + "s", word + "n", *(() if word[-1] == "e" else (word + "en",)))


# The siemens is left out as long as `m/S` is rather a slip for seconds than a siemens. Sizes of eV and u: CODATA 2018.
TABLE = """
A       | A                  | 1                 | n u m k       | ampere amp
K       | K                  | 1                 | n u m         | kelvin
mol     | mol                | 1                 | n u m k       | mole
cd      | cd                 | 1                 | m k           | candela
C       | A s                | 1                 | p n u m k     | coulomb
V       | kg m^2 s^-3 A^-1   | 1                 | n u m k M     | volt
ohm Ω Ω | kg m^2 s^-3 A^-2   | 1                 | m k M         | ohm
F       | kg^-1 m^-2 s^4 A^2 | 1                 | p n u m       | farad
Wb      | kg m^2 s^-2 A^-1   | 1                 | u m           | weber
T       | kg s^-2 A^-1       | 1                 | n u m         | tesla
H       | kg m^2 s^-2 A^-2   | 1                 | n u m         | henry
lm      | cd                 | 1                 |               | lumen
lx      | cd m^-2            | 1                 | k             | lux
Bq      | s^-1               | 1                 | k M G         | becquerel
Gy      | m^2 s^-2           | 1                 | u m           | gray
Sv      | m^2 s^-2           | 1                 | u m           | sievert
kat     | mol s^-1           | 1                 | n u m         | katal
"""
MECHANICS = """
g       | kg                 | 1/1000            | n u m k       | gram gramme gramm
m       | m                  | 1                 | n u m c d k   | meter metre mètre
s sec secs | s               | 1                 | p n u m       | second seconde sekunde sekund
N       | kg m s^-2          | 1                 | u m k M G     | newton
J       | kg m^2 s^-2        | 1                 | u m k M G     | joule
W       | kg m^2 s^-3        | 1                 | u m k M G     | watt
Pa      | kg m^-1 s^-2       | 1                 | h k M G       | pascal
Hz      | s^-1               | 1                 | m k M G       | hertz
eV      | kg m^2 s^-2        | 1.602176634e-19   | m k M G       | electronvolt
t       | kg                 | 1000              |               | tonne
u       | kg                 | 1.66053906660e-27 |               |
min     | s                  | 60                |               | minute
h       | s                  | 3600              |               | hour hr heure stunde timme
rad     |                    | 1                 | m             | radian
deg ° º |                    | pi/180            |               | degree degré grad grader
%       |                    | 1/100             |               | percent
"""
for _row in TABLE.strip().splitlines():
    register(*(_cell.strip() for _cell in _row.split("|")))
UNSUGGESTED = frozenset(UNITS)
"""Not offered for what is mistyped: a letter of a formula (`2 m v`) is rather no unit at all than a volt."""
for _row in MECHANICS.strip().splitlines():
    register(*(_cell.strip() for _cell in _row.split("|")))
_OURS = len(ROWS)

NAMED = ("N", "J", "W", "Pa", "C", "V", "F", "ohm", "Wb", "T", "H")
"""Units under whose own name a dimension is shown. Not Hz, Bq, Gy, lm …: 1/s is not always a frequency."""
CALLED = {
    Dimension.of(base_units): name
    for base_units, name in {
        "1": N_("a plain number"),
        "kg": N_("a mass"),
        "m": N_("a length"),
        "s": N_("a time"),
        "m s^-1": N_("a velocity"),
        "m s^-2": N_("an acceleration"),
        "kg m s^-1": N_("a momentum or an impulse"),
        "kg m s^-2": N_("a force"),
        "kg m^2 s^-2": N_("an energy"),
        "kg m^2 s^-3": N_("a power"),
        "s^-1": N_("a rate"),
        "kg s^-1": N_("a rate of mass"),
        "kg s^-2": N_("a spring constant"),
        "kg m^-1 s^-2": N_("a pressure"),
        "m^2": N_("an area"),
        "m^3": N_("a volume"),
        "kg m^-3": N_("a density"),
        "kg m^2": N_("a moment of inertia"),
        "A": N_("a current"),
        "K": N_("a temperature"),
        "mol": N_("an amount of substance"),
        "cd": N_("a luminous intensity"),
        "A s": N_("an electric charge"),
        "kg m^2 s^-3 A^-1": N_("a voltage"),
        "kg m s^-3 A^-1": N_("an electric field"),
        "kg m^2 s^-3 A^-2": N_("a resistance"),
        "kg^-1 m^-2 s^4 A^2": N_("a capacitance"),
        "kg m^2 s^-2 A^-1": N_("a magnetic flux"),
        "kg s^-2 A^-1": N_("a magnetic field"),
        "kg m^2 s^-2 A^-2": N_("an inductance"),
    }.items()
}
assert ONE in CALLED
