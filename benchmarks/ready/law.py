"""Bodies in a plane that push each other: their law, an extrapolated midpoint step (Gragg, Bulirsch, Stoer; order 18), and where in it
something falls through zero. Compiled, in numbers of twice a double's length.

A `law` is (inverse masses, gravity, contacts); a contact is (body, body, reach, k, q, eta, outer distance, core, wall or not).
"""

# pyright: reportMissingParameterType=false, reportUnknownParameterType=false, reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false, reportUntypedFunctionDecorator=false, reportOptionalSubscript=false, reportOptionalMemberAccess=false

from __future__ import annotations

from ready.twofold import compiled, minus, over, plus, power, root, times

PARTS = 9
A, B, REACH, K, Q, ETA, OUTER, CORE = range(8)
"""Columns of a contact. It acts while the distance is below OUTER, and turns bodies back at CORE (none: zero)."""


@compiled
def get(y, i):
    return y[i, 0], y[i, 1]


@compiled
def put(y, i, a):
    y[i, 0], y[i, 1] = a


@compiled
def seen(y, n, contact):
    """Unit vector from the one body to the other, distance, relative velocity, the rate at which the distance grows."""
    a, b = int(contact[A]), int(contact[B])
    x, z = minus(get(y, 2 * b), get(y, 2 * a)), minus(get(y, 2 * b + 1), get(y, 2 * a + 1))
    u = minus(get(y, 2 * n + 2 * b), get(y, 2 * n + 2 * a))
    w = minus(get(y, 2 * n + 2 * b + 1), get(y, 2 * n + 2 * a + 1))
    r = root(plus(times(x, x), times(z, z)))
    nx, nz = over(x, r), over(z, r)
    return nx, nz, r, u, w, plus(times(nx, u), times(nz, w))


@compiled
def push(y, n, contact):
    """The force on the second body of a contact."""
    nx, nz, r, u, w, _ = seen(y, n, contact)
    deep = minus((contact[REACH], 0.0), r)
    spring = times((contact[K], 0.0), power(deep, contact[Q]))
    eta = -contact[ETA], 0.0
    return plus(times(spring, nx), times(eta, u)), plus(times(spring, nz), times(eta, w))


@compiled
def slope(y, n, inverse, gravity, contacts, acts, out):
    """Newton's second law."""
    for i in range(2 * n):
        put(out, i, get(y, 2 * n + i))
    for i in range(n):
        put(out, 2 * n + 2 * i, (0.0, 0.0))
        put(out, 2 * n + 2 * i + 1, (-gravity if inverse[i, 0] > 0.0 else 0.0, 0.0))
    for c in range(len(contacts)):
        if not acts[c]:
            continue
        fx, fz = push(y, n, contacts[c])
        a, b = int(contacts[c, A]), int(contacts[c, B])
        for body, sign in ((a, -1.0), (b, 1.0)):
            if inverse[body, 0] > 0.0:
                share = sign * inverse[body, 0], sign * inverse[body, 1]
                put(out, 2 * n + 2 * body, plus(get(out, 2 * n + 2 * body), times(share, fx)))
                put(out, 2 * n + 2 * body + 1, plus(get(out, 2 * n + 2 * body + 1), times(share, fz)))


@compiled
def stepped(y, h, n, inverse, gravity, contacts, acts, work, out):
    """One step into `out`; gives the largest difference of the last two extrapolations of a place and of a velocity."""
    size = 4 * n
    table, before, now, new, f, start = work
    slope(y, n, inverse, gravity, contacts, acts, start)
    for k in range(PARTS):
        count = 2 * (k + 1)
        part = over(h, (float(count), 0.0))
        double = 2.0 * part[0], 2.0 * part[1]
        for i in range(size):
            put(before, i, get(y, i))
            put(now, i, plus(get(y, i), times(part, get(start, i))))
        for _ in range(count - 1):
            slope(now, n, inverse, gravity, contacts, acts, f)
            for i in range(size):
                put(new, i, plus(get(before, i), times(double, get(f, i))))
                put(before, i, get(now, i))
                put(now, i, get(new, i))
        for i in range(size):
            # Aitken and Neville in the square of the parts' length; the table keeps the row before.
            value = get(now, i)
            for j in range(k + 1):
                older = table[j, i, 0], table[j, i, 1]
                table[j, i, 0], table[j, i, 1] = value
                if j < k:
                    ratio = over((float((k + 1) ** 2), 0.0), (float((k - j) ** 2), 0.0))
                    value = plus(value, over(minus(value, older), minus(ratio, (1.0, 0.0))))
    places = speeds = 0.0
    for i in range(size):
        last, former = table[PARTS - 1, i], table[PARTS - 2, i]
        put(out, i, (last[0], last[1]))
        off = abs(minus((last[0], last[1]), (former[0], former[1]))[0])
        if i < 2 * n:
            places = max(places, off)
        else:
            speeds = max(speeds, off)
    return places, speeds


@compiled
def left_of(y, n, contact, act):
    """What is positive while a contact stays as it is, and its rate."""
    _, _, r, _, _, rate = seen(y, n, contact)
    room = minus((contact[OUTER], 0.0), r)
    if act:
        return room[0], -rate[0]
    return -room[0], rate[0]


@compiled
def force_growth(y, f, n, contact):
    """Half the rate of change of the square of a contact's force; `f` is the slope."""
    a, b = int(contact[A]), int(contact[B])
    nx, nz, r, u, w, rate = seen(y, n, contact)
    fx, fz = push(y, n, contact)
    deep, q = contact[REACH] - r[0], contact[Q]
    if deep <= 0.0:
        return -1.0
    spring, harder = contact[K] * deep**q, -contact[K] * q * deep ** (q - 1.0) * rate[0]
    turn_x, turn_z = (u[0] - nx[0] * rate[0]) / r[0], (w[0] - nz[0] * rate[0]) / r[0]
    ax = f[2 * n + 2 * b, 0] - f[2 * n + 2 * a, 0]
    az = f[2 * n + 2 * b + 1, 0] - f[2 * n + 2 * a + 1, 0]
    gx = harder * nx[0] + spring * turn_x - contact[ETA] * ax
    gz = harder * nz[0] + spring * turn_z - contact[ETA] * az
    return fx[0] * gx + fz[0] * gz


CHANGE, INNER, NEAREST, FARTHEST, GROWTH = range(5)


@compiled
def watched(kind, y, f, n, inverse, gravity, contacts, acts, c):
    """The value whose fall through zero is looked for."""
    if kind == CHANGE:
        return left_of(y, n, contacts[c], acts[c])[0]
    if kind == GROWTH:
        slope(y, n, inverse, gravity, contacts, acts, f)
        return force_growth(y, f, n, contacts[c])
    _, _, r, _, _, rate = seen(y, n, contacts[c])
    if kind == INNER:
        return minus(r, (contacts[c, CORE], 0.0))[0]
    return rate[0] if kind == FARTHEST else -rate[0]


@compiled
def located(kind, y, h, above, below, n, inverse, gravity, contacts, acts, c, work, out):
    """The part of a step until a value falls to zero: false position (Illinois); the state there into `out`."""
    f = work[4]
    low, high = (0.0, 0.0), h
    for _ in range(90):
        share = above / (above - below) if above > below else 0.5
        width = minus(high, low)
        middle = plus(low, times(width, (min(max(share, 1e-9), 1.0 - 1e-9), 0.0)))
        stepped(y, middle, n, inverse, gravity, contacts, acts, work, out)
        there = watched(kind, out, f, n, inverse, gravity, contacts, acts, c)
        if there > 0.0:
            low, above, below = middle, there, 0.5 * below
        else:
            high, below, above = middle, there, 0.5 * above
        precise = 1e-10 if kind == GROWTH else 1e-24
        if there == 0.0 or width[0] < precise * h[0]:
            return middle
    return high


@compiled
def largest(y, n, contact, best):
    """The squares of the largest force so far, and the largest overlap."""
    r = seen(y, n, contact)[2]
    fx, fz = push(y, n, contact)
    square = plus(times(fx, fx), times(fz, fz))
    deep = minus((contact[REACH], 0.0), r)
    if minus(deep, get(best, 0))[0] > 0.0:
        put(best, 0, deep)
    if minus(square, get(best, 1))[0] > 0.0:
        put(best, 1, square)
