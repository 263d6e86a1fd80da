"""The units: one row each, with what it measures, its size, its prefixes and its names in words."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from corollary.messages import N_
from corollary.units.dimension import ONE, Dimension, Unit

_BELOW = {"d": -1, "c": -2, "m": -3, "u": -6, "n": -9, "p": -12, "f": -15, "a": -18, "z": -21}
_ABOVE = {"da": 1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12, "P": 15, "E": 18, "Z": 21, "Y": 24}
PREFIXES = {"": 0, **_BELOW, "y": -24, "r": -27, "q": -30, **_ABOVE, "R": 27, "Q": 30}
TYPED = {"u": "uµμ", "k": "kK"}  # the two signs for micro, and Kg for kg, are both typed
IN_WORDS = {"micro": "u", "milli": "m", "centi": "c", "kilo": "k", "mega": "M"}

ANGLES = {"rad": Fraction(1), "sr": Fraction(2)}
"""Powers of a plane angle that are not told by a pi in the size."""
ROWS: list[tuple[str, ...]] = []
"""Every unit as it was registered."""
WITH_PREFIXES: dict[str, Unit] = {}
"""Units that take prefixes. Those of their rows are looked up first; any other is one in the end (`prefixed`)."""
ENGLISH: set[str] = set()
"""Names of units that are offered for a word with one letter amiss: no `times` for `timme`."""
UNITS: dict[str, Unit] = {}
"""What may be typed for a single unit, with its prefix: `kN`, `µs`, `Newton`, `milliseconds`."""


def register(symbols: str, base_units: str, size: str = "1", prefixes: str = "", words: str = "") -> Unit:
    """Makes a unit known to all that reads and writes units; a package of somebody else's calls it when it is imported.

    symbols: how it is written, first as it is in files (`ohm Ω`); base_units: `kg m s^-2`; size: in SI, an exact number
    or a fraction of pi (`pi/180`) or a multiple (`2*pi`), and behind a plus where its zero lies (`1 + 273.15`);
    prefixes: those it is used with (`u m k`); words: its names, in the singular (`ohm`).
    Returns the unit. Raises ValueError when something that would be typed for it means another unit, and registers nothing.
    """
    size_alone, _plus, zero = size.partition(" + ")
    dimension, pi, offset = Dimension.of(base_units), int("pi" in size), Fraction(zero or 0)
    factor = Fraction(size_alone.replace("*pi", "").replace("pi", "1"))
    angle = ANGLES.get(symbols.split()[0], Fraction(pi))
    name = symbols.split()[0]
    found: dict[str, Unit] = {}
    for prefix in ("", *prefixes.split()):
        unit = Unit(prefix + name, dimension, factor * Fraction(10) ** PREFIXES[prefix], pi, offset, angle)
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
    if prefixes:
        WITH_PREFIXES.update(dict.fromkeys(symbols.split(), found[name]))
    return found[name]


def prefixed(symbol: str) -> Unit | None:
    """A unit with a prefix that its row does not list: `aJ`, `Mbar`, `Ym`. None for `Tm`, which is rather T m."""
    if symbol == "Tm":
        return None
    for prefix, power in PREFIXES.items():
        for sign in TYPED.get(prefix, (prefix,)):
            unit = WITH_PREFIXES.get(symbol.removeprefix(sign)) if sign and symbol.startswith(sign) else None
            if unit is not None:
                size = unit.factor * Fraction(10) ** power
                return replace(unit, text=prefix + unit.text, factor=size, offset=Fraction(0))
    return None


def rows_of_others() -> list[tuple[str, ...]]:
    """What other packages have registered: a notebook carries it, for students type those units, too."""
    return ROWS[_OURS:]


def _numbers(word: str) -> tuple[str, ...]:
    """A word in the singular and the plural, in English and in German (`Sekunden`); others stand in the tables."""
    return (word, word + "s", word + "n", *(() if word[-1] == "e" else (word + "en",)))


# Sizes of eV, e and u: CODATA 2022. The calorie is the thermochemical one; the year is 365.25 days.
NEVER_SUGGESTED = """
A       | A                  | 1                 | n u m k       | ampere amp
K       | K                  | 1                 | n u m         | kelvin
mol     | mol                | 1                 | n u m k       | mole
cd      | cd                 | 1                 | m k           | candela
C       | A s                | 1                 | p n u m k     | coulomb
V       | kg m^2 s^-3 A^-1   | 1                 | n u m k M     | volt
ohm Ω Ω | kg m^2 s^-3 A^-2   | 1                 | m k M         | ohm
S       | kg^-1 m^-2 s^3 A^2 | 1                 | u m           | siemens
F       | kg^-1 m^-2 s^4 A^2 | 1                 | p n u m       | farad
Wb      | kg m^2 s^-2 A^-1   | 1                 | u m           | weber
T       | kg s^-2 A^-1       | 1                 | n u m         | tesla
H       | kg m^2 s^-2 A^-2   | 1                 | n u m         | henry
lm      | cd                 | 1                 | k             | lumen
lx      | cd m^-2            | 1                 | k             | lux
Bq      | s^-1               | 1                 | k M G         | becquerel
Gy      | m^2 s^-2           | 1                 | u m           | gray
Sv      | m^2 s^-2           | 1                 | u m           | sievert
kat     | mol s^-1           | 1                 | n u m         | katal
"""
NEVER_RUN_TOGETHER = """
degC    | K                  | 1 + 273.15        |               | celsius centigrade
degF    | K                  | 5/9 + 45967/180   |               | fahrenheit
delta_degC | K               | 1                 |               |
delta_degF | K               | 5/9               |               |
delta_K | K                  | 1                 |               |
bar     | kg m^-1 s^-2       | 100000            | u m k         |
atm     | kg m^-1 s^-2       | 101325            |               | atmosphere
mmHg    | kg m^-1 s^-2       | 133.322387415     |               |
Torr torr | kg m^-1 s^-2     | 20265/152         |               |
l L ℓ   | m^3                | 1/1000            | u m c d h     | liter litre
cal     | kg m^2 s^-2        | 4.184             | k             | calorie kalorie
e       | A s                | 1.602176634e-19   |               |
rpm     | s^-1               | pi/30             |               |
d       | s                  | 86400             |               | day tag dag
yr yrs  | s                  | 31557600          | k M G         | year jahr
month   | s                  | 2629800           |               | month
ha      | m^2                | 10000             |               | hectare
acre    | m^2                | 62726400000/15499969|               | acre
au      | m                  | 149597870700      |               |
ly      | m                  | 9460730472580800  |               | lightyear
pc      | m                  | 30856775814913673 | k M G         | parsec
angstrom Å \N{ANGSTROM SIGN} | m             | 1/10000000000     |               | angstrom ångström ångstrøm
inch inches in | m           | 0.0254            |               |
ft feet | m                  | 0.3048            |               | foot
yd      | m                  | 0.9144            |               | yard
nmi     | m                  | 1852              |               |
micron  | m                  | 1/1000000         |               | micron
mi      | m                  | 1609.344          |               | mile
lb lbs  | kg                 | 0.45359237        |               | pound
oz      | kg                 | 0.028349523125    |               | ounce
slug    | kg                 | 14.593902937206   |               | slug
lbf     | kg m s^-2          | 4.4482216152605   |               |
dyn     | kg m s^-2          | 1/100000          |               | dyne
kgf kp  | kg m s^-2          | 9.80665           |               | kilopond
erg     | kg m^2 s^-2        | 1/10000000        |               | erg
BTU Btu | kg m^2 s^-2        | 1055.056          |               |
hp      | kg m^2 s^-3        | 745.69987158227022 |              | horsepower
PS hk   | kg m^2 s^-3        | 735.49875         |               | Pferdestärke hestekraft hestekrefter
psi     | kg m^-1 s^-2       | 44482216152605/6451600000 |       |
gauss   | kg s^-2 A^-1       | 1/10000           | m k           | gauss
kn kt   | m s^-1             | 463/900           |               | knot
c       | m s^-1             | 299792458         |               |
dpt     | m^-1               | 1                 |               | dioptre diopter
cc ccm  | m^3                | 1/1000000         |               |
gal     | m^3                | 0.003785411784    |               | gallon
week wk | s                  | 604800            |               | week Woche uke
barn    | m^2                | 1/10000000000000000000000000000 | | barn
Ci      | s^-1               | 37000000000       | u m           | curie
rem     | m^2 s^-2           | 1/100             | m             |
poise   | kg m^-1 s^-1       | 1/10              | c             | poise
cP      | kg m^-1 s^-1       | 1/1000            |               |
cSt     | m^2 s^-1           | 1/1000000         |               | centistokes
inHg    | kg m^-1 s^-2       | 3386.388640341    |               |
ppm     |                    | 1/1000000         |               |
ppb     |                    | 1/1000000000      |               |
‰       |                    | 1/1000            |               | permille
sr      |                    | 1                 |               | steradian
arcmin  |                    | pi/10800          |               |
arcsec  |                    | pi/648000         |               |
gon     |                    | pi/200            |               |
turn rev |                   | 2*pi              |               | turn revolution rotation cycle umdrehung omdreining omdreininger
"""
MECHANICS = """
g       | kg                 | 1/1000            | n u m k       | gram gramme gramm
m       | m                  | 1                 | f p n u m c d k | meter metre mètre
s sec secs | s               | 1                 | f p n u m     | second seconde sekunde sekund sekunder sek
N       | kg m s^-2          | 1                 | u m k M G     | newton
J       | kg m^2 s^-2        | 1                 | u m k M G T   | joule
W       | kg m^2 s^-3        | 1                 | u m k M G T   | watt
Pa      | kg m^-1 s^-2       | 1                 | h k M G T     | pascal
Hz      | s^-1               | 1                 | m k M G T     | hertz
eV      | kg m^2 s^-2        | 1.602176634e-19   | m k M G T     | electronvolt
t       | kg                 | 1000              |               | tonne
u Da amu | kg                | 1.66053906892e-27 |               | dalton
min     | s                  | 60                |               | minute minutt minutter
h       | s                  | 3600              |               | hour hr heure stunde timme timer
rad     |                    | 1                 | m             | radian radianer radiant
deg ° º |                    | pi/180            |               | degree degré grad grader Grad
%       |                    | 1/100             |               | percent prozent prosent pct
"""
REFUSED = dict.fromkeys(
    ("dB", "db", "dBA", "decibel", "Np", "phon", "mag"),
    N_("{unit} is a logarithm of a ratio, not a unit: give the ratio itself, or the quantity"),
)
"""What looks like a unit and is none, with the reason."""
for _row in NEVER_RUN_TOGETHER.strip().splitlines():
    register(*(_cell.strip() for _cell in _row.split("|")))
APART = frozenset(UNITS)
"""Not looked for in letters that are run together: `kgd` is no kilogram times a day."""
for _row in NEVER_SUGGESTED.strip().splitlines():
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
