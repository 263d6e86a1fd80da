"""A student's value turned into inert data: by its exact type, never by what the value says of itself."""

import sys
from decimal import Decimal
from fractions import Fraction

MOST_ITEMS = 20_000
MOST_BITS = 100_000
MOST_LETTERS = 10_000
DEEPEST = 12

# Read a class through `type` itself: a class of the student's may answer for `__name__` with anything.
_NAME = type.__dict__["__name__"].__get__
_MODULE = type.__dict__["__module__"].__get__
_ANCESTORS = type.__dict__["__mro__"].__get__

_KINDS = {
    "bool": "is True or False, not a number",
    "dict": "is a dictionary: give the number itself",
    "set": "is a set, which has no order: give a list",
    "frozenset": "is a set, which has no order: give a list",
    "generator": "is a generator: turn it into a list first",
    "range": "is a range: turn it into a list first",
    "map": "is a map: turn it into a list first",
    "zip": "is a zip: turn it into a list first",
    "function": "is a function: call it, and give what it returns",
    "builtin_function_or_method": "is a function: call it, and give what it returns",
    "method": "is a function: call it, and give what it returns",
    "type": "is a class, not a value",
    "module": "is a module, not a value",
    "bytes": "is bytes: give a number or text",
    "Figure": "is a figure: the plot itself is looked at, no variable is needed",
}
_NUMPY_REALS = {"float16", "float32", "float64", "longdouble", "float128"}
_NUMPY_WHOLES = {f"{sign}{size}" for sign in ("int", "uint") for size in (8, 16, 32, 64)} | {
    "longlong",
    "ulonglong",
}
_NUMPY_COMPLEX = {"complex64", "complex128", "clongdouble", "complex256"}


def encode(value: object) -> tuple[object, ...]:
    """Gives a tagged tuple: ("nothing",), ("real", float), ("exact", hex, hex), ("complex", float, float), ("text", str),
    ("measured", float, unit), ("items", [tagged…], [shape…]) or ("refused", why, shown).

    Never raises, except KeyboardInterrupt when the clock runs out.
    """
    try:
        return _encode(value, DEEPEST, [MOST_ITEMS])
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # whatever a strange object does, the answer is that it could not be read
        return _refused(f"could not be read: looking at it raised {_kind(error)[1]}")


def _encode(value, depth, left):
    left[0] -= 1
    if left[0] < 0:
        return _refused(f"has more than {MOST_ITEMS} items")
    if depth < 0:
        return _refused(f"is nested deeper than {DEEPEST} lists")
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
        return _measured(value.magnitude, value.units)
    if family == "astropy" and name == "Quantity":
        return _measured(value.value, value.unit)
    return _unfit(value, name)


def _kind(value):
    kind = type(value)
    module, name = _MODULE(kind), _NAME(kind)
    return (module if type(module) is str else ""), name[:60]


def _refused(why, excerpt=""):
    return ("refused", why, excerpt)


def _unfit(value, name):
    excerpt = repr(value) if type(value) is bool else name
    return _refused(
        _KINDS.get(name, f"is an object of the kind {name}, from which no answer can be read"), excerpt
    )


def _exact(numerator, denominator):
    if type(numerator) is not int or type(denominator) is not int:
        return _refused("is a fraction whose parts are not whole numbers")
    bits = max(numerator.bit_length(), denominator.bit_length())
    if bits > MOST_BITS:
        return _refused(f"is a whole number of about {bits * 30103 // 100000} digits")
    return ("exact", f"{numerator:x}", f"{denominator:x}")


def _decimal(value):
    # An exponent of a million would make an integer of a million digits; beyond the doubles a float says the same.
    if not value.is_finite() or not -5000 < value.adjusted() < 5000 or len(value.as_tuple().digits) > 5000:
        return ("real", float(value))
    return _exact(*value.as_integer_ratio())


def _text(value):
    if len(value) > MOST_LETTERS:
        return _refused(f"is a text of {len(value)} letters", _printable(value[:80]))
    return ("text", _printable(value))


def _printable(text):
    return str.encode(text, "utf-8", "replace").decode("utf-8")


def _items(values, shape, depth, left):
    if len(values) > left[0]:
        return _refused(f"has more than {MOST_ITEMS} items")
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
        return _refused(_KINDS["bool"], str(bool(value)))
    if type(value) is not sys.modules["numpy"].ndarray:
        return _unfit(value, name)
    shape = [int(length) for length in value.shape]
    if value.size > left[0]:  # before any copy: a broadcast array of a million million items takes no room
        return _refused(
            f"is an array of {int(value.size)} numbers, more than {MOST_ITEMS}", f"shape {tuple(shape)}"[:80]
        )
    if value.dtype.kind not in "iufcUO":
        return _refused(f"is an array of {value.dtype.kind!r}, not of numbers", str(value.dtype)[:80])
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
        return _refused(f"is a {name} of sympy, not an expression", _printable(str(value)[:80]))
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


def _measured(magnitude, unit):
    return ("measured", float(magnitude), _printable(str(unit))[:200])
