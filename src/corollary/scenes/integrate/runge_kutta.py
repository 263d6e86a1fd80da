"""Explicit Runge-Kutta methods: steps from a table of coefficients, and that of order 8 of Dormand and Prince with its two error estimates.

Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I (2nd edition, 1993), section II.10.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import mul

Slope = Callable[[float, Sequence[float]], Sequence[float]]
"""The rate of change of the state, given x and the state."""


@dataclass(frozen=True, slots=True)
class Coefficients:
    """A weighted sum of earlier slopes; only the slopes that count are named."""

    stages: tuple[int, ...]
    weights: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Tableau:
    """An explicit method: row i gives the state at which slope i is taken, `result` the state after the step.

    `estimates` are sums of slopes that vanish for an exact step (differences from embedded methods), the most sensitive first; a
    method without any does not estimate its own error.
    """

    order: int
    nodes: tuple[float, ...]
    rows: tuple[Coefficients, ...]
    result: Coefficients
    estimates: tuple[Coefficients, ...] = ()


def weighted(row: Coefficients, slopes: Sequence[Sequence[float]]) -> list[float]:
    """The sum the row stands for, component by component."""
    return [
        sum(map(mul, row.weights, column)) for column in zip(*[slopes[i] for i in row.stages], strict=True)
    ]


def step(
    table: Tableau, slope: Slope, x: float, y: Sequence[float], h: float, first: Sequence[float]
) -> tuple[list[float], list[Sequence[float]]]:
    """The state after a step h from (x, y), and the slopes met on the way; `first` is the slope at (x, y)."""
    slopes: list[Sequence[float]] = [first]
    for node, row in zip(table.nodes[1:], table.rows[1:], strict=True):
        slopes.append(slope(x + node * h, [a + h * b for a, b in zip(y, weighted(row, slopes), strict=True)]))
    return [a + h * b for a, b in zip(y, weighted(table.result, slopes), strict=True)], slopes


# After `row` the node of a stage, then the earlier stages and their weights; after the others their order.
TABLE = """
row 0.0
row 0.526001519587677318785587544488e-01
    0 5.26001519587677318785587544488e-2
row 0.789002279381515978178381316732e-01
    0 1.97250569845378994544595329183e-2   1 5.91751709536136983633785987549e-2
row 0.118350341907227396726757197510
    0 2.95875854768068491816892993775e-2   2 8.87627564304205475450678981324e-2
row 0.281649658092772603273242802490
    0 2.41365134159266685502369798665e-1   2 -8.84549479328286085344864962717e-1   3 9.24834003261792003115737966543e-1
row 0.333333333333333333333333333333
    0 3.7037037037037037037037037037e-2   3 1.70828608729473871279604482173e-1   4 1.25467687566822425016691814123e-1
row 0.25
    0 3.7109375e-2   3 1.70252211019544039314978060272e-1   4 6.02165389804559606850219397283e-2
    5 -1.7578125e-2
row 0.307692307692307692307692307692
    0 3.70920001185047927108779319836e-2   3 1.70383925712239993810214054705e-1   4 1.07262030446373284651809199168e-1
    5 -1.53194377486244017527936158236e-2   6 8.27378916381402288758473766002e-3
row 0.651282051282051282051282051282
    0 6.24110958716075717114429577812e-1   3 -3.36089262944694129406857109825   4 -8.68219346841726006818189891453e-1
    5 2.75920996994467083049415600797e1   6 2.01540675504778934086186788979e1   7 -4.34898841810699588477366255144e1
row 0.6
    0 4.77662536438264365890433908527e-1   3 -2.48811461997166764192642586468   4 -5.90290826836842996371446475743e-1
    5 2.12300514481811942347288949897e1   6 1.52792336328824235832596922938e1   7 -3.32882109689848629194453265587e1
    8 -2.03312017085086261358222928593e-2
row 0.857142857142857142857142857142
    0 -9.3714243008598732571704021658e-1   3 5.18637242884406370830023853209   4 1.09143734899672957818500254654
    5 -8.14978701074692612513997267357   6 -1.85200656599969598641566180701e1   7 2.27394870993505042818970056734e1
    8 2.49360555267965238987089396762   9 -3.0467644718982195003823669022
row 1.0
    0 2.27331014751653820792359768449   3 -1.05344954667372501984066689879e1   4 -2.00087205822486249909675718444
    5 -1.79589318631187989172765950534e1   6 2.79488845294199600508499808837e1   7 -2.85899827713502369474065508674
    8 -8.87285693353062954433549289258   9 1.23605671757943030647266201528e1   10 6.43392746015763530355970484046e-1
result 8
    0 5.42937341165687622380535766363e-2   5 4.45031289275240888144113950566   6 1.89151789931450038304281599044
    7 -5.8012039600105847814672114227   8 3.1116436695781989440891606237e-1   9 -1.52160949662516078556178806805e-1
    10 2.01365400804030348374776537501e-1   11 4.47106157277725905176885569043e-2
estimate 5
    0 0.1312004499419488073250102996e-1   5 -0.1225156446376204440720569753e1   6 -0.4957589496572501915214079952
    7 0.1664377182454986536961530415e1   8 -0.3503288487499736816886487290   9 0.3341791187130174790297318841
    10 0.8192320648511571246570742613e-1   11 -0.2235530786388629525884427845e-1
embedded 3
    0 0.244094488188976377952755905512   8 0.733846688281611857341361741547   11 0.220588235294117647058823529412e-1
"""


def _read() -> Tableau:
    rows: list[Coefficients] = []
    nodes: list[float] = []
    sums: dict[str, Coefficients] = {}
    for block in TABLE.replace("\n    ", "   ").split("\n")[1:-1]:
        name, node, *pairs = block.split()
        found = Coefficients(tuple(map(int, pairs[::2])), tuple(map(float, pairs[1::2])))
        if name == "row":
            rows.append(found)
            nodes.append(float(node))
        else:
            sums[name] = found
    result, embedded = sums["result"], dict(zip(*_columns(sums["embedded"]), strict=True))
    # Of the embedded method of order 3 the table has the weights; its estimate is the difference from the result.
    third = tuple(b - embedded.get(i, 0.0) for i, b in zip(*_columns(result), strict=True))
    estimates = (sums["estimate"], Coefficients(result.stages, third))
    return Tableau(8, tuple(nodes), tuple(rows), result, estimates)


def _columns(row: Coefficients) -> tuple[tuple[int, ...], tuple[float, ...]]:
    return row.stages, row.weights


DOP853 = _read()
