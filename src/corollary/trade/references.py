"""References for each scene of the trade, by methods that share nothing with those that are judged.

The cradles: extrapolated midpoint steps in 34 digits; the damped contact: Taylor series of order 50 in 50 digits; the rest:
energy integrals by tanh-sinh quadrature in 50 digits. The tests hold the programs that found them.
"""

from __future__ import annotations

from corollary.trade.raced_scene import Reference

MIDPOINT = "extrapolated midpoint steps in 34 digits, shrinking toward every opening and closing"
TAYLOR = "Taylor series of order 50 in the root of the overlap, 50 digits"
QUADRATURE = "energy integral by tanh-sinh quadrature, 50 digits"

CRADLE_3_SPRINGS = Reference(
    ("-0.13026169506452104705", "0.15022956943477408931", "0.98003212562974695774"), 19, MIDPOINT
)
CRADLE_3_HERTZ = Reference(
    ("-0.070952353651436871016", "0.076403039071206993021", "0.994549314580229878"), 18, MIDPOINT
)
CRADLE_3_CUBIC = Reference(
    ("-0.010396841805952597532", "0.010506083831367518745", "0.99989075797458507879"), 19, MIDPOINT
)
CRADLE_5_HERTZ = Reference(
    (
        "-0.071085017086094278231",
        "-0.030273764097076231762",
        "-0.014463629032065613681",
        "0.12704498606786918731",
        "0.98877742414736693637",
    ),
    18,
    MIDPOINT,
)
SPHERES = Reference(
    (
        "0.31176559562219855276950438937185351855",
        "-0.46321464679836530764653271530391169452",
        "0.68823440437780144723049561062814648145",
        "0.46321464679836530764653271530391169452",
    ),
    38,
    TAYLOR,
)
SPHERES_DAMPED = Reference(
    (
        "0.31831839230500605906278028086158339067",
        "-0.34394425458223763165360716371437010999",
        "0.68168160769499394093721971913841660933",
        "0.34394425458223763165360716371437010999",
    ),
    38,
    TAYLOR,
)
BALL = Reference(
    ("0.022757714217275922677232697718646344632", "2.7938412269385302195847474676144565823"), 38, QUADRATURE
)
ATOM_BOUND = Reference(
    ("2.0892637700104348133823191740944232869", "2.1528996491526921480499983593452551328"), 38, QUADRATURE
)
ATOM_ESCAPING = Reference(
    ("-1.381558431269189836961915661960494893", "3.8847517682586895582142787413698119125"), 38, QUADRATURE
)
