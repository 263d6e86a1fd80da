"""Between two stations: three motions one after the other."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, without_time, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(d, v, a, b):
    s, r, t, u, w, T = unknowns(
        "s r t u w T", t="time of speeding up", u="time of braking", w="time at the highest speed"
    )
    return derivation(
        step(
            s,
            "The tram starts from rest.",
            without_time(v, v_0=0, a=a, s=s),
            answers="a",
            mistakes=[
                mistake(
                    "You let it have its highest speed from the start; in the mean it has half of it.",
                    wrong("s = v^2/a"),
                ),
                mistake("Here it speeds up; you took the braking.", wrong("v^2 = 2*b*s")),
            ],
        ),
        step(
            r,
            "It comes to rest.",
            without_time(0, v_0=v, a=-b, s=r),
            answers="b",
            mistakes=[
                mistake(
                    "You let it have its highest speed to the end; in the mean it has half of it.",
                    wrong("r = v^2/b"),
                ),
                mistake("The tram brakes otherwise than it speeds up.", wrong("v^2 = 2*a*r")),
            ],
        ),
        step(t, "How long it speeds up.", law("Velocity", "v = a*t")),
        step(u, "How long it brakes.", law("Velocity", "v = b*u", u=u)),
        step(
            w, "What lies between is done at the highest speed.", law("Constant velocity", "d - s - r = v*w")
        ),
        step(
            T,
            "All three times together.",
            law("Time", "T = t + w + u"),
            answers="c",
            mistakes=[
                mistake("You let the tram do all the way at its highest speed.", wrong("T = d/v")),
                mistake(
                    "The ways of speeding up and braking are part of the distance; do not cover them twice.",
                    wrong("T = t + d/v + u"),
                ),
                mistake("That is only the middle part.", wrong("T = w")),
            ],
            check="Each change of speed costs half of its time, compared with a tram that never slows down.",
        ),
    )


def scene(d, v, a, b, answer):
    """A force that is switched: three scenes, each begun where the last one ended."""
    start = Scene((Body(1.0, (0.0,), (0.0,)),), (ForceFunction(0, lambda t, x, u: (a,)),), until=v / a)
    t = answer["c"] - v / a - v / b
    steady = Scene((Body(1.0, (answer["a"],), (v,)),), (), until=t)
    end = Scene(
        (Body(1.0, (d - answer["b"],), (v,)),), (ForceFunction(0, lambda t, x, u: (-b,)),), until=v / b
    )
    return [
        simulate(start, trajectory=(answer["a"],), velocities=(v,)),
        simulate(steady, trajectory=(d - answer["b"],)),
        simulate(end, trajectory=(d,)),
    ]
