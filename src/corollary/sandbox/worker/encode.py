"""A student's value turned into inert data: by its exact type, never by what the value says of itself."""

import re
import sys
from decimal import Decimal
from fractions import Fraction

MOST_ITEMS = 20_000
MOST_BITS = 100_000
MOST_LETTERS = 10_000
MOST_NAMES = 20
LONGEST_NAME = 40
DEEPEST = 12

# Read a class through `type` itself: a class of the student's may answer for `__name__` with anything.
_NAME = type.__dict__["__name__"].__get__
_MODULE = type.__dict__["__module__"].__get__
_ANCESTORS = type.__dict__["__mro__"].__get__

# The word for each kind that has one; the sentences are in sandbox/tagged.py.
_KINDS = {
    name: name
    for name in ("bool", "dict", "set", "generator", "range", "map", "zip", "function", "module", "bytes")
} | {
    "frozenset": "set",
    "builtin_function_or_method": "function",
    "method": "function",
    "type": "class",
    "Figure": "figure",
}
_NUMPY_REALS = {"float16", "float32", "float64", "longdouble", "float128"}
_NUMPY_WHOLES = {f"{sign}{size}" for sign in ("int", "uint") for size in (8, 16, 32, 64)} | {
    "longlong",
    "ulonglong",
}
# Units that the reader knows by the names that pint and astropy give them. What is in any other (`mile`, `dyn`, `force_pound`,
# astropy's `J(1/2)` and `10 m`) the library itself turns into base units.
_READABLE_UNIT = re.compile(
    "(?:micro|milli|centi|kilo|mega)?(?:meter|gram|second|newton|joule|watt|pascal|hertz|volt|ampere|coulomb|ohm|tesla)"
    "|[numckMG]?(?:m|g|s|N|J|W|Pa|Hz|V|A|C|T|eV)|kelvin|K|mole|mol|minute|min|hour|h|day|d|year|yr"
    "|radian|rad|degree|deg|percent|%|liter|l|bar|calorie|cal|u|t"
)
_NAME_OF_UNIT = re.compile(r"[^\W\d]+|%")
_SCALE_OR_ROOT = re.compile(r"^(?!1 )\d|[(]\d")
_NUMPY_COMPLEX = {"complex64", "complex128", "clongdouble", "complex256"}


def encode(value: object) -> tuple[object, ...]:
    """Gives a tagged tuple: ("nothing",), ("real", float), ("exact", hex, hex), ("complex", float, float), ("text", str),
    ("measured", float, unit), ("items", [tagged…], [shape…]), ("named", [names…], [tagged…]) or ("refused", word, what, excerpt).

    Never raises, except KeyboardInterrupt when the clock runs out.
    """
    try:
        return _encode(value, DEEPEST, [MOST_ITEMS])
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # whatever a strange object does, the answer is that it could not be read
        return _refused("raised", _kind(error)[1])


def _encode(value, depth, left):
    left[0] -= 1
    if left[0] < 0:
        return _refused("items")
    if depth < 0:
        return _refused("depth")
    kind = type(value)
    if value is None or value is Ellipsis:
        return ("nothing",)
    if kind is float:
        return ("real", value)
    if kind is int:
        return _exact(value, 1)
    if kind is complex:
        return ("complex", value.real, value.imag)
    if kind is str:
        return _text(value)
    if kind is list or kind is tuple:
        return _items(list(value), [len(value)], depth, left)
    if kind is dict and value and len(value) <= MOST_NAMES and all(type(key) is str for key in value):
        names = [_printable(key[:LONGEST_NAME]) for key in value]
        return ("named", names, [_encode(each, depth - 1, left) for each in value.values()])
    if kind is Fraction:
        return _exact(value.numerator, value.denominator)
    if kind is Decimal:
        return _decimal(value)
    module, name = _kind(value)
    family = module.partition(".")[0]
    if family == "numpy":
        return _numpy(value, name, depth, left)
    if family == "sympy":
        return _sympy(value, kind, name, depth, left)
    if family == "pint" and name == "Quantity":
        own = value if _is_readable(str(value.units)) else value.to_base_units()
        unit = str(own.units)
        return _measured(_encode(own.magnitude, depth - 1, left), "" if unit == "dimensionless" else unit)
    if any(
        _MODULE(each) == "astropy.units.quantity" and _NAME(each) == "Quantity" for each in _ANCESTORS(kind)
    ):
        own = value if _is_readable(str(value.unit)) else value.si
        return _measured(_encode(own.value, depth - 1, left), str(own.unit))
    return _unfit(value, name)


def _kind(value):
    kind = type(value)
    module, name = _MODULE(kind), _NAME(kind)
    return (module if type(module) is str else ""), name[:60]


def _refused(word, what: object = "", excerpt=""):
    return ("refused", word, _printable(f"{what}")[:200], _printable(excerpt))


def _unfit(value, name):
    excerpt = repr(value) if type(value) is bool else name
    return _refused(_KINDS.get(name, "object"), name, excerpt)


def _exact(numerator, denominator):
    if type(numerator) is not int or type(denominator) is not int:
        return _refused("fraction")
    bits = max(numerator.bit_length(), denominator.bit_length())
    if bits > MOST_BITS:
        return _refused("digits", bits * 30103 // 100000)
    return ("exact", f"{numerator:x}", f"{denominator:x}")


def _decimal(value):
    # An exponent of a million would make an integer of a million digits; beyond the doubles a float says the same.
    if not value.is_finite() or not -5000 < value.adjusted() < 5000 or len(value.as_tuple().digits) > 5000:
        return ("real", float(value))
    return _exact(*value.as_integer_ratio())


def _text(value):
    if len(value) > MOST_LETTERS:
        return _refused("letters", len(value), _printable(value[:80]))
    return ("text", _printable(value))


def _printable(text):
    """Text that can be written down: half a surrogate becomes U+FFFD, which no answer holds, not a question mark, which one may."""
    return str.encode(text, "utf-16-le", "surrogatepass").decode("utf-16-le", "replace")


def _items(values, shape, depth, left):
    if len(values) > left[0]:
        return _refused("items")
    return ("items", [_encode(each, depth - 1, left) for each in values], shape)


def _numpy(value, name, depth, left):
    if name in _NUMPY_REALS:
        return ("real", float(value))
    if name in _NUMPY_WHOLES:
        return _exact(int(value), 1)
    if name in _NUMPY_COMPLEX:
        return ("complex", float(value.real), float(value.imag))
    if name == "str_":
        return _text(str.__str__(value))
    if name in ("bool", "bool_"):
        return _refused("bool", excerpt=str(bool(value)))
    if type(value) is not sys.modules["numpy"].ndarray:
        return _unfit(value, name)
    shape = [int(length) for length in value.shape]
    if value.size > left[0]:  # before any copy: a broadcast array of a million million items takes no room
        return _refused("numbers", int(value.size), f"shape {tuple(shape)}"[:80])
    if value.dtype.kind not in "iufcUO":
        return _refused("no numbers", repr(value.dtype.kind), str(value.dtype)[:80])
    if not shape:
        return _encode(value[()], depth - 1, left)
    return _items(value.ravel().tolist(), shape, depth, left)


def _sympy(value, kind, name, depth, left):
    if name in ("Integer", "Zero", "One", "NegativeOne"):
        return _exact(int(value.p), 1)
    if name in ("Rational", "Half"):
        return _exact(int(value.p), int(value.q))
    if name == "Float":
        return ("real", float(value))
    if name in ("Tuple", "MutableDenseMatrix", "ImmutableDenseMatrix"):
        shape = [len(value)] if name == "Tuple" else list(value.shape)
        return _items(list(value), shape, depth, left)
    if not any(_MODULE(each) == "sympy.core.expr" and _NAME(each) == "Expr" for each in _ANCESTORS(kind)):
        return _refused("sympy", name, _printable(str(value)[:80]))
    if value.free_symbols:
        return _text(_printable(str(value)))
    try:
        return ("real", float(value))
    except (
        TypeError,
        ValueError,
        OverflowError,
    ):  # a number with a unit, or a complex one: let its text be read
        return _text(_printable(str(value)))


def _is_readable(unit):
    if _SCALE_OR_ROOT.search(unit):
        return False
    return all(_READABLE_UNIT.fullmatch(name) for name in _NAME_OF_UNIT.findall(unit))


def _measured(magnitude, unit):
    """Every number in it with the unit; a text is what a number too strange to be one is."""
    match magnitude:
        case ("real", number):
            return ("measured", number, _printable(unit)[:200])
        case ("exact", numerator, denominator):
            return ("measured", int(numerator, 16) / int(denominator, 16), _printable(unit)[:200])
        case ("items", items, shape):
            return ("items", [_measured(item, unit) for item in items], shape)
        case _:
            return magnitude
