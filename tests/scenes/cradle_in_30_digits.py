"""Reference velocities of the cradle in 30 digits, by a method that shares nothing with the package: extrapolated midpoint steps.

Plain time, no change of variable: the steps shrink geometrically toward every opening and closing instead, where the force is not
smooth. Run as a script it prints the table that `references.json` holds.
"""

import json
import sys

import mpmath as mp

mp.mp.dps = 34
COLUMNS = (2, 4, 6, 8, 10, 12, 14, 16)
TINY = mp.mpf(10) ** -20


def velocities(count: int, q: str) -> list[mp.mpf]:
    """Equal masses, k = 1, all touching, the first comes in with speed 1."""
    power, rest = mp.mpf(q), range(count - 1)
    overlaps, speeds = [mp.mpf(0)] * (count - 1), [mp.mpf(1)] + [mp.mpf(0)] * (count - 1)
    touching = [True] * (count - 1)

    def slope(state):
        d, v = state[: count - 1], state[count - 1 :]
        f = [x**power if on and x > 0 else mp.mpf(0) for x, on in zip(d, touching, strict=True)]
        return [v[j] - v[j + 1] for j in rest] + [
            (f[i - 1] if i else 0) - (f[i] if i < count - 1 else 0) for i in range(count)
        ]

    def midpoint(state, h, n):
        step = h / n
        old, here = state, [y + step * s for y, s in zip(state, slope(state), strict=True)]
        for _ in range(n - 1):
            old, here = here, [y + 2 * step * s for y, s in zip(old, slope(here), strict=True)]
        return [(a + b + step * s) / 2 for a, b, s in zip(old, here, slope(here), strict=True)]

    def extrapolated(state, h):
        table = []
        for k, n in enumerate(COLUMNS):
            row = [midpoint(state, h, n)]
            for j in range(1, k + 1):
                ratio = (mp.mpf(n) / COLUMNS[k - j]) ** 2 - 1
                row.append([a + (a - b) / ratio for a, b in zip(row[-1], table[-1][j - 1], strict=True)])
            table.append(row)
        return table[-1][-1]

    # The first instant, in which no force counts yet (t^(q+1) is below the digits kept).
    first = mp.mpf(10) ** -14
    overlaps[0] = first
    state = overlaps + speeds
    while True:
        d, u = state[: count - 1], [state[count - 1 + j] - state[count + j] for j in rest]
        for j in rest:
            if touching[j] and d[j] < TINY and u[j] < 0:
                touching[j] = False
            elif not touching[j] and d[j] > -TINY and u[j] > 0:
                touching[j] = True
                state[j] = TINY
        if not any(touching[j] and state[j] > TINY for j in rest):
            closing = [-state[j] / u[j] for j in rest if not touching[j] and u[j] > TINY]
            if not closing:
                return state[count - 1 :]
        h = mp.mpf("0.1")
        for j in rest:
            if abs(state[j]) > TINY and u[j] != 0:
                h = min(h, mp.mpf("0.25") * abs(state[j] / u[j])) if touching[j] or u[j] > 0 else h
        state = extrapolated(state, h)


if __name__ == "__main__":
    found = {}
    for q in ("1", "1.25", "1.5", "2", "3", "5"):
        for count in (3, 4, 5, 6):
            found[f"{count} {q}"] = [mp.nstr(v, 20) for v in velocities(count, q)]
            print(count, q, found[f"{count} {q}"], file=sys.stderr, flush=True)
    print(json.dumps(found, indent=1))
