"""Formulas of the chapter as students write them, beside the right one: equal in other words, or subtly different."""

POSITIVE: dict[str, tuple[float, float]] = {}
VELOCITIES = {
    "v": (-10.0, 10.0),
    "w": (-10.0, 10.0),
    "vA": (-10.0, 10.0),
    "vB": (-10.0, 10.0),
    "u": (-10.0, 10.0),
}
ANGLE = {"theta": (0.1, 1.4), "alpha": (0.2, 1.3)}
FRACTION = {"r": (0.1, 0.95)}

# the truth, its letters, the domain, the same in other words, what is not the same
FAMILIES = [
    (
        "m*v",
        "m v",
        VELOCITIES,
        ["vm", "m v", "m·v", "v*m", "2mv - mv", "mv/1", "m(v + 1) - m"],
        ["-mv", "m/v", "2mv", "mv^2", "m|v|", "½mv²"],
    ),
    (
        "m*v/dt",
        "m v dt",
        POSITIVE,
        ["mv/dt", "m v/Δt", "(m v)/Δt", "m*(v/dt)", "1/dt*m*v", "mv dt^-1"],
        ["mv dt", "m/(v dt)", "mv/(2dt)", "-mv/dt"],
    ),
    (
        "m*(v + w)/dt",
        "m v w dt",
        POSITIVE,
        ["(mv + mw)/dt", "m v/dt + m w/dt", "m(w+v)/Δt", "-m(-v-w)/dt"],
        ["m(v-w)/dt", "m(w-v)/dt", "mv/dt", "m(v+w)dt", "mv + w/dt"],
    ),
    (
        "(mA*vA + mB*vB)/(mA + mB)",
        "mA mB vA vB",
        VELOCITIES,
        [
            "(m_A v_A + m_B v_B)/(m_A+m_B)",
            "mA/(mA+mB)*vA + mB/(mA+mB)*vB",
            "vA + mB/(mA+mB)*(vB - vA)",
            "vB - mA (vB - vA)/(mA + mB)",
            "(vA + mB/mA*vB)/(1 + mB/mA)",
        ],
        [
            "(mA vA - mB vB)/(mA+mB)",
            "(mA vB + mB vA)/(mA+mB)",
            "(vA+vB)/2",
            "(mA vA + mB vB)/mA + mB",
            "(mA vA + mB vB)/(mA - mB)",
            "mA vA/(mA+mB)",
        ],
    ),
    (
        "(mA - mB)/(mA + mB)*vA",
        "mA mB vA",
        VELOCITIES,
        [
            "vA (mA - mB)/(mA + mB)",
            "vA(1 - 2mB/(mA+mB))",
            "(2mA/(mA+mB) - 1)vA",
            "-(mB-mA)/(mB+mA)*vA",
            "(1 - mB/mA)/(1 + mB/mA) * vA",
        ],
        [
            "(mB - mA)/(mA + mB)*vA",
            "2mA vA/(mA+mB)",
            "(mA - mB)*vA",
            "((mA - mB)/(mA + mB))^2*vA",
            "(mA^2 - mB^2)/(mA^2 + mB^2)*vA",
        ],
    ),
    (
        "2*mA/(mA + mB)*vA",
        "mA mB vA",
        VELOCITIES,
        ["2mA vA/(mA+mB)", "2vA/(1 + mB/mA)", "vA + (mA-mB)/(mA+mB)*vA", "4mA vA/(2mA + 2mB)"],
        ["mA vA/(mA+mB)", "2mB vA/(mA+mB)", "2mA vA/(mA-mB)", "2mA/mA + mB*vA", "vA/(1+mB/mA)"],
    ),
    (
        "((mA - mB)*vA + 2*mB*vB)/(mA + mB)",
        "mA mB vA vB",
        VELOCITIES,
        ["(mA vA - mB vA + 2 mB vB)/(mA+mB)", "2(mA vA + mB vB)/(mA + mB) - vA", "vA + 2mB(vB-vA)/(mA+mB)"],
        [
            "((mA - mB)vA + 2 mA vB)/(mA + mB)",
            "((mB - mA)vA + 2 mB vB)/(mA + mB)",
            "((mA - mB)vA + mB vB)/(mA + mB)",
            "vA + mB(vB-vA)/(mA+mB)",
        ],
    ),
    (
        "(mA*vA + mB*vB - mB*r*(vA - vB))/(mA + mB)",
        "mA mB vA vB r",
        VELOCITIES | FRACTION,
        [
            "vA - (1+r)*mB*(vA-vB)/(mA+mB)",
            "((mA - r mB)vA + (1+r)mB vB)/(mA + mB)",
            "(mA vA + mB vB + mB r (vB - vA))/(mA+mB)",
        ],
        [
            "(mA vA + mB vB + mB r (vA - vB))/(mA+mB)",
            "(mA vA + mB vB - mA r (vA - vB))/(mA+mB)",
            "vA - (1-r)*mB*(vA-vB)/(mA+mB)",
            "(mA vA + mB vB - mB r^2 (vA - vB))/(mA+mB)",
        ],
    ),
    (
        "-(1/2)*mA*mB/(mA + mB)*(1 - r^2)*(vA - vB)^2",
        "mA mB vA vB r",
        VELOCITIES | FRACTION,
        [
            "-mA mB (1-r)(1+r)(vA-vB)^2/(2(mA+mB))",
            "½ mA mB (r² - 1)(vB - vA)²/(mA + mB)",
            "-(1-r^2)(vA^2 - 2vA vB + vB^2)/(2(1/mA + 1/mB))",
        ],
        [
            "-mA mB (1-r)^2 (vA-vB)^2/(2(mA+mB))",
            "mA mB (1-r^2)(vA-vB)^2/(2(mA+mB))",
            "-mA mB (1-r^2)(vA-vB)^2/(mA+mB)",
            "-mA mB (1-r^2)(vA+vB)^2/(2(mA+mB))",
            "-mA mB (1-r^2)(vA^2-vB^2)/(2(mA+mB))",
        ],
    ),
    (
        "r^2*h",
        "r h",
        FRACTION,
        ["r²h", "h r r", "h*r^2", "(r h)^2/h"],
        ["r h", "sqrt(r) h", "r^4 h", "(1-r^2)h"],
    ),
    (
        "sqrt(2*g*h)",
        "g h",
        POSITIVE,
        ["√(2gh)", "sqrt(2)*sqrt(g h)", "(2gh)^(1/2)", "(2gh)^0.5", "sqrt(2g)*sqrt(h)"],
        ["sqrt(gh)", "2gh", "sqrt(2g)h", "-sqrt(2gh)", "sqrt(2gh^2)", "2sqrt(gh)", "1.414*sqrt(gh)"],
    ),
    (
        "(mA + mB)/mA*sqrt(2*g*h)",
        "mA mB g h",
        POSITIVE,
        ["(1 + mB/mA) sqrt(2gh)", "(mA+mB)√(2gh)/mA", "sqrt(2gh(mA+mB)^2)/mA", "sqrt(2gh) + mB/mA*sqrt(2gh)"],
        [
            "mB/mA*sqrt(2gh)",
            "(mA+mB)/mB*sqrt(2gh)",
            "mA/(mA+mB)*sqrt(2gh)",
            "sqrt((mA+mB)/mA)*sqrt(2gh)",
            "sqrt(2gh(mA+mB)/mA)",
            "(mA + mB)/mA*2gh",
        ],
    ),
    (
        "-mB/(mA + mB)",
        "mA mB",
        POSITIVE,
        ["mA/(mA+mB) - 1", "-1/(1 + mA/mB)", "-mB/(mB+mA)"],
        ["mB/(mA+mB)", "-mA/(mA+mB)", "1 - mA/(mA+mB)", "-mB/mA"],
    ),
    (
        "acos(1 - h/L)",
        "h L",
        {"h": (0.05, 0.8), "L": (0.9, 2.0)},
        [
            "arccos(1 - h/L)",
            "2 asin(sqrt(h/(2L)))",
            "arccos((L-h)/L)",
            "pi/2 - arcsin(1-h/L)",
            "2arctan(sqrt(h/(2L-h)))",
        ],
        ["arcsin(1 - h/L)", "acos(h/L)", "asin(sqrt(2h/L))", "acos(1-h/L)*180/pi", "sqrt(2h/L)"],
    ),
    (
        "((3*mA - mB)/(mA + mB))^2*h",
        "mA mB h",
        POSITIVE,
        ["h(3mA-mB)^2/(mA+mB)^2", "h((mB-3mA)/(mA+mB))^2", "h(9mA^2 - 6mA mB + mB^2)/(mA^2 + 2mA mB + mB^2)"],
        ["h(3mA-mB)/(mA+mB)", "9h", "h(3mA+mB)^2/(mA+mB)^2", "h(3mA-mB)^2/(mA^2+mB^2)", "4h mA^2/(mA+mB)^2"],
    ),
    (
        "2*m*v*sin(theta)",
        "m v theta",
        ANGLE,
        [
            "2mv sin θ",
            "2 m v cos(pi/2 - θ)",
            "4mv sin(θ/2) cos(θ/2)",
            "2mv sqrt(1 - cos(θ)^2)",
            "mv sin θ + mv sin θ",
            "2mv tan(θ) cos(θ)",
        ],
        ["2mv cos θ", "mv sin θ", "-2mv sin θ", "mv sin(2θ)", "2mvθ", "2mv tan θ", "2mv(θ - θ^3/6)"],
    ),
    (
        "m*sqrt(v^2 + w^2 + 2*v*w*cos(alpha))",
        "m v w alpha",
        ANGLE,
        [
            "m sqrt((v + w cos α)^2 + (w sin α)^2)",
            "m sqrt((v-w)^2 + 4v w cos(α/2)^2)",
            "sqrt(m^2(v^2+w^2) + 2m^2 v w cos(α))",
        ],
        [
            "m sqrt(v^2+w^2-2 v w cos α)",
            "m sqrt(v^2+w^2)",
            "m(v + w cos α)",
            "m(v+w)",
            "m sqrt(v^2 + w^2 + v w cos α)",
        ],
    ),
    (
        "atan2(w*sin(alpha), v + w*cos(alpha))",
        "v w alpha",
        ANGLE,
        ["arctan(w sin(α)/(v + w cos(α)))", "atan2(sin α, v/w + cos α)"],
        ["atan2(v + w*cos(α), w*sin(α))", "arctan(w sin(α)/(v - w cos(α)))", "α/2", "arctan(w sin(α)/v)"],
    ),
    (
        "-m*v*cos(theta)/M",
        "m v theta M",
        ANGLE,
        ["-mv/M*cos(θ)", "-(m v cos(θ))/M", "m v/M*cos(pi - θ)"],
        ["mv cos(θ)/M", "-mv/M", "-mv cos(θ)/(M+m)", "-mv cos(θ)/(M-m)", "-mv sin(θ)/M"],
    ),
    (
        "sqrt(v^2 - 2*mu*g*d)",
        "v mu g d",
        {"v": (30.0, 60.0), "mu": (0.1, 0.9), "d": (0.1, 5.0)},
        ["(v² - 2μgd)^(1/2)", "v sqrt(1 - 2mu g d/v^2)"],
        ["v - sqrt(2mu g d)", "sqrt(v^2 + 2mu g d)", "sqrt(v^2 - mu g d)"],
    ),
    (
        "(m + M)/m*sqrt(2*mu*g*d)",
        "m M mu g d",
        POSITIVE,
        ["(1 + M/m)√(2μgd)", "sqrt(2 mu g d) (m+M)/m", "sqrt(2mu g d (1 + M/m)^2)"],
        ["(m+M)/m*sqrt(mu g d)", "(m+M)/M*sqrt(2mu g d)", "sqrt(2mu g d(1+M/m))", "M/m*sqrt(2mu g d)"],
    ),
    (
        "-v*ln(m1/m0)",
        "v m0 m1",
        POSITIVE,
        [
            "v ln(m0/m1)",
            "v(ln(m0) - ln(m1))",
            "-v ln(1 - (m0-m1)/m0)",
            "v ln(10) log10(m0/m1)",
            "-ln((m1/m0)^v)",
        ],
        ["v ln(m1/m0)", "v log10(m0/m1)", "v(m0-m1)/m0", "v ln(m0)/ln(m1)", "v(m0/m1 - 1)", "v ln(m0 - m1)"],
    ),
    (
        "m0*exp(-u/v)",
        "m0 u v",
        POSITIVE,
        ["m0 e^(-u/v)", "m0/exp(u/v)", "m0 exp(-u/(2v))^2"],
        ["m0 e^(u/v)", "m0 (e^-u)/v", "m0(1-u/v)", "m0 exp(-v/u)"],
    ),
    (
        "sqrt(v^2 + k*d^2/m)",
        "v k d m",
        POSITIVE,
        ["sqrt(v² + (k/m)d²)", "sqrt((m v^2 + k d^2)/m)", "v sqrt(1 + k d^2/(m v^2))"],
        ["v + d sqrt(k/m)", "sqrt(v^2 - k d^2/m)", "sqrt(v^2 + k d^2/(2m))", "sqrt(v^2 + 2k d^2/m)"],
    ),
    (
        "2*sqrt(3)*d*sqrt(k/m)/2",
        "d k m",
        POSITIVE,
        ["d sqrt(3k/m)", "√3*d√(k/m)", "sqrt(3k d^2/m)"],
        ["d sqrt(k/m)", "d sqrt(3k/(2m))", "3d sqrt(k/m)", "1.7321 d sqrt(k/m)"],
    ),
    (
        "m/L*(v^2 + g*y)",
        "m L v g y",
        POSITIVE,
        ["m v^2/L + m g y/L", "(m/L)(v² + gy)", "m(g y + v^2)/L"],
        ["m/L*(v^2 + 2g y)", "m/L*(v^2/2 + g y)", "m g y/L", "m/L*v^2 + g y", "mv^2 + m g y"],
    ),
    (
        "m*g*L/2 + m*v^2",
        "m g L v",
        POSITIVE,
        ["m(gL/2 + v^2)", "½mgL + mv²", "m g L/2 + m v v"],
        ["mgL/2 + mv^2/2", "mgL + mv^2", "m g L/2"],
    ),
    (
        "pi*sqrt(m/(2*k))",
        "m k",
        POSITIVE,
        ["π√(m/(2k))", "pi sqrt(m/2/k)", "π sqrt(2m/k)/2", "π/sqrt(2k/m)"],
        ["2π sqrt(m/(2k))", "π sqrt(m/k)", "3.14 sqrt(m/(2k))", "pi sqrt(2m/k)", "π sqrt(2k/m)"],
    ),
    (
        "v*sqrt(m/(2*k))",
        "v m k",
        POSITIVE,
        ["sqrt(m v^2/(2k))", "v√(m/(2k))", "(m v^2/(2k))^0.5"],
        ["v sqrt(m/k)", "v sqrt(k/(2m))", "v m/(2k)"],
    ),
    ("abs(v)", "v", VELOCITIES, ["|v|", "sqrt(v^2)", "max(v, -v)", "abs(-v)", "|-v|"], ["v", "-v", "v^2/v"]),
    ("R*(v - u)", "R v u", VELOCITIES, ["Rv - Ru", "-R(u - v)"], ["R(u-v)", "R v", "R(v+u)"]),
    (
        "1/3*m*v^2",
        "m v",
        VELOCITIES,
        ["mv^2/3", "m v v/3", "(m/3)v^2"],
        ["0.3333 m v^2", "0.33333333333333333 m v^2", "mv^3/3", "m v^2/2"],
    ),
    (
        "C/r0 + C/2*0 + m*v^2/2",
        "C r0 m v",
        POSITIVE,
        ["C/r_0 + ½mv²", "(2C + m v^2 r0)/(2r0)"],
        ["C/r0^2 + mv^2/2", "C/(r0 + m v^2/2)"],
    ),
]


def pairs() -> list[tuple[str, str, list[str], dict[str, tuple[float, float]], bool]]:
    """Student's text, the truth, the letters, the domain, and whether they are equal."""
    return [
        (student, truth, letters.split(), domain, same)
        for truth, letters, domain, equal, different in FAMILIES
        for same, texts in ((True, equal), (False, different))
        for student in texts
    ]
