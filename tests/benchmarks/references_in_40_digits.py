"""Reference answers of the trade's scenes in 40 digits, by methods that share nothing with the package.

Integrals of the energy by tanh-sinh quadrature between turning points, and the damped contact by Taylor series of order 50 in
the root of the overlap. Run as a script it prints the table that `corollary/trade/references.py` holds. The cradles come from
`tests/scenes/cradle_in_30_digits.py`.
"""

import mpmath as mp

mp.mp.dps = 50
ORDER = 50


def ball_on_floor():
    """Height and velocity 5.5 ms after the start of the chapter's ball: down, through the contact, up again."""
    m, k, g, radius, y0, v0, until = map(mp.mpf, ("0.1", "1e6", "9.8", "0.02", "0.021", "-2.8", "0.0055"))
    speed = mp.sqrt(v0**2 + 2 * g * (y0 - radius))
    fall = (speed + v0) / g

    def square(x):
        return speed**2 + 2 * g * x - mp.mpf(4) / 5 * k / m * x ** mp.mpf("2.5")

    deepest = mp.findroot(square, mp.mpf("0.004"))
    stiff = mp.mpf(4) / 5 * k / m * deepest ** mp.mpf("2.5")

    def pace(u):
        """dt/du at the overlap deepest (1 - u^2), which takes away the root at the turning point."""
        missing = -mp.expm1(mp.mpf("2.5") * mp.log1p(-u * u))
        return 2 * u * deepest / mp.sqrt(stiff * missing - 2 * g * deepest * u * u)

    contact = 2 * mp.quad(pace, [0, 1])
    free = until - fall - contact
    return radius + speed * free - g * free**2 / 2, speed - g * free


def atom_bound():
    """Velocity after three radial periods of the chapter's atom, which starts at r = b with 3 m/s across, and the period.

    The square of the radial speed is written as (r - b)(high - r) times a factor without zeros: no digits are lost at the ends.
    """
    w, v, b = mp.sqrt(mp.mpf(100) / 2), mp.mpf(3), mp.mpf(1)
    high = mp.findroot(lambda r: v**2 * (1 / r + b / r**2) - w**2 * (r - b), mp.mpf("1.257"))
    middle, half = (b + high) / 2, (high - b) / 2

    def over(value):
        def integrand(angle):
            r = middle + half * mp.sin(angle)
            factor = w**2 + v**2 * (1 / (r * high) + b * (r + high) / (r * high) ** 2)
            return value(r) / mp.sqrt(factor)

        return 2 * mp.quad(integrand, [-mp.pi / 2, 0, mp.pi / 2])

    period, angle = over(lambda r: 1), over(lambda r: b * v / r**2)
    return -v * mp.sin(3 * angle), v * mp.cos(3 * angle), period


def atom_escaping():
    """Velocity far away, and the time at the edge, when the start is at 5 m/s across."""
    w, v, b, edge = mp.sqrt(mp.mpf(100) / 2), mp.mpf(5), mp.mpf(1), mp.mpf("1.4")

    def over(value):
        def integrand(u):
            r = b + u * u
            return 2 * value(r) / mp.sqrt(v**2 * (r + b) / r**2 - w**2 * u * u)

        return mp.quad(integrand, [0, mp.sqrt(edge - b)])

    angle, time = over(lambda r: b * v / r**2), over(lambda r: 1)
    across = b * v / edge
    out = mp.sqrt(v**2 - (w * (edge - b)) ** 2 - across**2)
    return out * mp.cos(angle) - across * mp.sin(angle), out * mp.sin(angle) + across * mp.cos(angle), time


def product(a, b, n):
    return mp.fsum(a[i] * b[n - i] for i in range(n + 1))


def series(w, rate, spin, time, turn, stiff, drag, reach):
    """Taylor coefficients in sigma, dt = 2 w d(sigma), of one contact with q = 3/2 and overlap w^2."""
    y = [[w], [rate], [spin], [time], [turn]]
    square, cube, near, inverse, two, three, ell, push, swept = [], [], [], [], [], [], [], [], []
    for n in range(ORDER):
        square.append(product(y[0], y[0], n))
        cube.append(product(y[0], square, n))
        near.append((reach if n == 0 else 0) - square[n])
        inverse.append(
            1 / near[0] if n == 0 else -mp.fsum(near[i] * inverse[n - i] for i in range(1, n + 1)) / near[0]
        )
        two.append(product(inverse, inverse, n))
        three.append(product(two, inverse, n))
        ell.append(product(y[2], y[2], n))
        push.append(stiff * cube[n] + drag * y[1][n] + product(ell, three, n))
        swept.append(product(y[2], two, n))
        faded, turned = -2 * drag * product(y[0], y[2], n), 2 * product(y[0], swept, n)
        slopes = (y[1][n], -2 * product(y[0], push, n), faded, 2 * y[0][n], turned)
        for row, slope in zip(y, slopes, strict=True):
            row.append(slope / (n + 1))
    return y


def spheres(eta):
    """Velocities of both spheres of the chapter after the contact: A comes in at 1 m/s, B rests at (0.08, 0.018)."""
    mass, k, reach, b = mp.mpf("0.05"), mp.mpf(20000), mp.mpf("0.04"), mp.mpf("0.018")
    drag, stiff = mp.mpf(eta) / mass, k / mass
    inward = mp.sqrt((reach - b) * (reach + b)) / reach
    state, h = [mp.mpf(0), inward, b, mp.mpf(0), mp.mpf(0)], mp.mpf("0.002")
    while True:
        y = series(*state, stiff, drag, reach)
        size = max(abs(y[0][ORDER]), abs(y[0][ORDER - 1]), mp.mpf(10) ** -60)
        h = mp.mpf("0.3") * (abs(y[0][1]) / size) ** (mp.mpf(1) / (ORDER - 1)) if y[0][1] else h
        after = [mp.polyval(row[::-1], h) for row in y]
        if after[0] <= 0:
            h = mp.findroot(
                lambda s, y=y: mp.polyval(y[0][::-1], s), (mp.mpf(0) + h / 10, h), solver="anderson"
            )
            after = [mp.polyval(row[::-1], h) for row in y]
            break
        state = after
    angle, outward, across = mp.asin(b / reach) + after[4], -after[1], after[2] / reach
    u, v = outward * mp.cos(angle) - across * mp.sin(angle), outward * mp.sin(angle) + across * mp.cos(angle)
    # Seen from A, B flew at (-1, 0) before and flies at (u, v) now; the centre of mass moves at (1/2, 0).
    return (1 - u) / 2, -v / 2, (1 + u) / 2, v / 2


TABLE = {
    "ball_on_floor": ball_on_floor,
    "atom bound": atom_bound,
    "atom escaping": atom_escaping,
    "spheres eta=0": lambda: spheres(0),
    "spheres eta=1": lambda: spheres(1),
}

if __name__ == "__main__":
    for name, reference in TABLE.items():
        print(name, [mp.nstr(value, 40) for value in reference()])
