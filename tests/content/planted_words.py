"""Faults planted in the words, figures and translations of real problems: each changes one text of a problem that holds."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from corollary.problem.reader import read_problem
from corollary.problem.translation import faults, translation, translations
from corollary.verify.checked import Tally
from corollary.verify.words.check_words import check_words

HOME = Path(__file__).parents[2]
FOLDERS = (HOME / "problems", *sorted((HOME / "examples/banks").glob("*/src/*/problems")))


@dataclass(frozen=True)
class PlantedWords:
    """`old` becomes `new`, once, in a file; a complaint with `finds` in it must say so. `kind` names the sentence of a report."""

    kind: str
    file: str
    old: str
    new: str
    finds: str

    @property
    def name(self) -> str:
        return f"{self.kind}: {self.file}: {self.old} → {self.new}"


def _of(kind: str, *rows: tuple[str, str, str, str]) -> tuple[PlantedWords, ...]:
    return tuple(PlantedWords(kind, *row) for row in rows)


TYPED = "which is the printed value of"
WORDS = (
    *_of(
        "given typed as text",
        ("crate_on_a_lorry.md", "Later the lorry, at {{v}},", "Later the lorry, at 60 km/h,", TYPED),
        ("crate_on_a_lorry.md", "Later the lorry, at {{v}},", "Later the lorry, at 60,", TYPED),
        (
            "crate_on_a_lorry.md",
            "Later the lorry, at {{v}},",
            "Later the lorry, at sixty kilometres per hour,",
            TYPED,
        ),
        (
            "crate_on_a_lorry.md",
            "Later the lorry, at {{v}},",
            r"Later the lorry, at $60\,\mathrm{km/h}$,",
            TYPED,
        ),
        ("crate_on_a_lorry.md", "Later the lorry, at {{v}},", r"Later the lorry, at \SI{60}{km/h},", TYPED),
        ("crate_on_a_lorry.md", "Later the lorry, at {{v}},", "Later the lorry, at 16.7 m/s ({{v}}),", TYPED),
        ("crate_on_a_lorry.md", "A crate of mass {{m}}", "A 80-kg crate", TYPED),
        ("crate_on_a_lorry.md", "A crate of mass {{m}}", "A crate of mass 80", TYPED),
        ("crate_on_a_lorry.md", "friction is {{mu}}", "friction is 0.45", TYPED),
        ("crate_on_a_lorry.md", "What is the shortest way", "At 60 km/h, what is the shortest way", TYPED),
        ("crate_on_a_lorry.md", "- (A) forward", "- (A) forward, with a = 1.5 m/s^2", TYPED),
        ("crate_on_a_lorry.md", '"m = {{m}}"', '"m = 80 kg"', TYPED),
        ("crate_on_a_lorry.md", '"a = {{a}}"', '"1.5 m/s²"', TYPED),
        ("crate_on_a_lorry.md", "points=2 ", 'points=2 hint="Turn 60 km/h into m/s first." ', TYPED),
        (
            "crate_on_a_lorry.md",
            "Later the lorry, at {{v}},",
            r"Later the lorry, at $v = 70\,\text{km/h}$,",
            TYPED,
        ),
        ("ballistic_pendulum.md", "wooden block of mass {{mB}}", "wooden block of mass 1000 g", TYPED),
        ("ballistic_pendulum.md", "they are {{h}} higher", "they are 30 centimetres higher", TYPED),
        ("ballistic_pendulum.md", "they are {{h}} higher", "they are 0.30 m higher", TYPED),
        ("burning_rocket.md", "Its mass is {{m0}}, fuel", "Its mass is 1,000 kg, fuel", TYPED),
        ("burning_rocket.md", "speed of {{vrel}} *relative", "speed of 2 500 m/s *relative", TYPED),
        (
            "burning_rocket.md",
            "speed of {{vrel}} *relative",
            r"speed of $2.5\cdot 10^3$ m/s *relative",
            TYPED,
        ),
        ("burning_rocket.md", "alt: A rocket points", "alt: A rocket of 1000 kg points", TYPED),
        ("magnifying_glass.md", "focal length of {{f}}", "focal length of 6 cm", TYPED),
        ("restitution_of_a_ball.md", "after {{n|number}} bounces", "after 3 bounces", TYPED),
        ("bullet_and_block.de.md", "dort nach {{d}} zur Ruhe", "dort nach 10 cm ({{d}}) zur Ruhe", TYPED),
        (
            "bullet_and_block.de.md",
            "der Masse {{M}} geschossen",
            "der Masse 2,0 kg geschossen ({{M}})",
            TYPED,
        ),
        ("bullet_and_block.nb.md", "glidd {{d}} på den", "glidd ti centimeter ({{d}}) på den", TYPED),
    ),
    *_of(
        "given typed as text",
        ("spring_gun.md", "constant {{k}}", r"constant $k=320\,\frac{\mathrm N}{\mathrm m}$", TYPED),
        ("spring_gun.md", "constant {{k}}", "constant of 3.2 N/cm", TYPED),
        ("floating_wood.md", "density of {{rho}}", "density of 0.65 g/cm³", TYPED),
        ("ladder.md", "makes {{theta}}", "makes 65 degrees", TYPED),
        ("moons_of_a_planet.md", "needs {{T}}", "needs 1.8 days", TYPED),
    ),
    *_of(
        "holes exchanged",
        ("pressure_at_depth.md", "diameter of {{d}}, and", "diameter of {{h}}, and", "is it meant?"),
        ("ladder.md", "a mass of {{m}} leans", "a mass of {{M}} leans", "is it meant?"),
        ("leaking_barrel.md", "up to {{H}}", "up to {{y}}", "is it meant?"),
    ),
    *_of(
        "unit in the words",
        (
            "crate_on_a_lorry.md",
            "How large is the friction force on",
            "How large, in kN, is the friction force on",
            "asks for kN",
        ),
        (
            "crate_on_a_lorry.md",
            "the crate does not slip?",
            "the crate does not slip? Give the answer in centimetres.",
            "asks for centimetres",
        ),
        (
            "crate_on_a_lorry.md",
            "the crate does not slip?",
            "the crate does not slide (in km)?",
            "asks for km",
        ),
        (
            "pressure_at_depth.md",
            "What is the pressure in the water",
            "What is the pressure (in Pa) in the water",
            "asks for Pa",
        ),
        (
            "pressure_at_depth.md",
            "What net force presses on",
            "How many newtons press on",
            "asks for newtons",
        ),
        (
            "braking_a_wheel.md",
            "How long does it take until",
            "How many minutes does it take until",
            "asks for minutes",
        ),
        ("braking_a_wheel.md", "## Time {#b", "## Time in ms {#b", "asks for ms"),
        ("braking_a_wheel.md", "How much heat appears", "How much heat [kJ] appears", "asks for kJ"),
        (
            "weight_aloft.md",
            "How fast does the station fly?",
            r"How fast, in $\mathrm{m/s}$, does the station fly?",
            "asks for m/s",
        ),
        (
            "weight_aloft.md",
            "How long does it take for one orbit?",
            "How long does one orbit take? Express it in hours.",
            "asks for hours",
        ),
        (
            "ballistic_pendulum.md",
            "Which angle does the rope make with the vertical at the highest point?",
            "Which angle, in degrees, does the rope make?",
            "asks for degrees",
        ),
        (
            "elastic_with_b_at_rest.md",
            "Which fraction of the kinetic energy",
            "What percentage of the kinetic energy",
            "asks for a percentage",
        ),
        (
            "bullet_and_block.de.md",
            "Wie schnell war das Geschoss",
            "Wie schnell (in km/h) war das Geschoss",
            "asks for km/h",
        ),
        (
            "bullet_and_block.nb.md",
            "Hvor stor fart hadde",
            "Hvor stor fart i kilometer per time hadde",
            "asks for kilometer per time",
        ),
        (
            "bullet_and_block.md",
            "Use $g$ = {{g}}.",
            "Use $g$ = {{g}}. Give all energies in kJ.",
            "asks for kJ",
        ),
        (
            "burning_rocket.md",
            "What mass is left of it",
            "What mass, in tonnes, is left of it",
            "asks for tonnes",
        ),
        ("crate_on_a_lorry.md", "of mass {{m}} stands", "of mass {{m}} kg stands", "two units"),
        (
            "restitution_of_a_ball.md",
            "A ball of mass {{m}} has",
            "A ball of mass {{m|number}} g has",
            "the number is in",
        ),
    ),
    *_of(
        "holes exchanged",
        (
            "bullet_and_block.md",
            "A bullet of mass {{m}} is fired horizontally into a block of mass {{M}}",
            "A bullet of mass {{M}} is fired horizontally into a block of mass {{m}}",
            "exchange them",
        ),
        (
            "bullet_and_block.de.md",
            "Ein Geschoss der Masse {{m}} wird waagerecht in einen Klotz der Masse {{M}}",
            "Ein Geschoss der Masse {{M}} wird waagerecht in einen Klotz der Masse {{m}}",
            "exchange them",
        ),
        (
            "bullet_and_block.nb.md",
            "Et prosjektil med masse {{m}} skytes vannrett inn i en kloss med masse {{M}}",
            "Et prosjektil med masse {{M}} skytes vannrett inn i en kloss med masse {{m}}",
            "exchange them",
        ),
        (
            "bullet_and_block.de.md",
            "Gleitreibungszahl {{mu}} ist",
            "Gleitreibungszahl {{d}} ist",
            "holes {{mu}}",
        ),
        (
            "bullet_and_block.de.md",
            "dort nach {{d}} zur Ruhe",
            "dort nach {{d}}, also {{d}}, zur Ruhe",
            "2 times",
        ),
        (
            "bullet_and_block.de.md",
            "alt: Ein Geschoss der Masse {{m}}",
            "alt: Ein Geschoss der Masse {{M}}",
            "holes {{m}}",
        ),
        ("kicking_a_ball.de.md", "{{v}}", "{{w}}", "holes {{v}}"),
        ("snowball_on_ice.nb.md", "{{m}}", "{{M}}", "{{m}}"),
        ("ball_reflected_from_wall.de.md", "{{m}}", "{{v0}}", "{{m}}"),
        ("crate_on_a_lorry.md", "A crate of mass {{m}}", "A crate of mass {{a}}", "which hole is meant"),
    ),
    *_of(
        "label of the figure",
        (
            "ball_and_moving_wall.md",
            'arrow A by=vA,0 "v = {{vA}}"',
            'arrow A by=vA,0 "v = {{vB}}"',
            "figure, `arrow A",
        ),
        ("bullet_and_block.md", '"m = {{m}}"', '"m = {{M}}"', "shows the value of M"),
        ("bullet_and_block.md", '"M = {{M}}"', '"m = {{M}}"', "shows the value of M"),
        ("lifting_a_chain.md", '"y = {{y}}" right', '"L = {{L}}" right', "is drawn as y"),
        ("lifting_a_chain.md", '"y = {{y}}" right', '"y = {{L}}" right', "{{L}}"),
        ("lifting_a_chain.md", 'by=0,v0 blue "{{v0}}" left', 'by=0,v0 blue "v_0 = 2.0 m/s" left', TYPED),
        ("braking_at_a_light.md", 'by=v,0 "v = {{v}}"', 'by=v,0 "t = {{v}}"', "shows the value of v"),
        ("block_on_a_rough_incline.md", '"m = {{m}}"', '"m = {{mu}}"', "shows the value of mu"),
        ("ladder.md", 'between=0,theta "{{theta}}"', 'between=0,theta "65°"', TYPED),
        (
            "moons_of_a_planet.md",
            "ball P at=0,0 radius=a/5 outside",
            'ball P at=0,0 radius=a "{{b}}"',
            "is drawn as a",
        ),
        ("sign_on_a_rope.md", 'block A at=5,-2 "{{m}}"', 'block A at=5,-2 "14 kg"', TYPED),
    ),
    *_of(
        "arrow against the sign",
        ("ball_and_moving_wall.md", "arrow B by=vB,0", "arrow B by=1,0", "whatever the sign"),
        ("ball_and_moving_wall.md", "arrow B by=vB,0", "arrow B by=-vB,0", "axes"),
        ("absorbing_a_drop.md", "arrow b by=u,0", "arrow b by=-u,0", "axes"),
        ("absorbing_a_drop.md", "arrow b by=u,0", "arrow b by=1,0", "axes"),
        ("absorbing_a_drop.md", "arrow b by=u,0", "arrow b by=v,0", "is drawn as v"),
    ),
)
NOT_FOUND = (
    PlantedWords("hole without a noun", "pressure_at_depth.md", "{{h}} below", "{{d}} below", ""),
    PlantedWords(
        "another number", "braking_at_a_light.md", "straight street at {{v}}", "street at 51 km/h", ""
    ),
    PlantedWords("another word", "bullet_and_block.md", "stays in it", "flies through it", ""),
    PlantedWords(
        "direction in words", "ball_and_moving_wall.md", "flies to the right", "flies to the left", ""
    ),
)
"""What no check of words can know."""


def path_of(file: str) -> Path:
    """The file of a problem or of a translation, in whichever bank."""
    return next(path for folder in FOLDERS for path in sorted(folder.glob(f"*/{file}")))


def complaints_of(folder: Path, file: str, old: str = "", new: str = "") -> list[str]:
    """The complaints about the words of a problem, one of whose files (its own, or a translation) is changed."""
    source = path_of(file)
    stem = source.name.split(".")[0]
    place = folder / "problems" / "one"
    place.mkdir(parents=True)
    for each in source.parent.iterdir():
        if each.is_file() and (each.suffix != ".md" or each.name.split(".")[0] == stem):
            shutil.copy(each, place / each.name)
    path = place / file
    text = path.read_text(encoding="utf-8")
    if old not in text:
        raise LookupError(f"{file} has no {old!r}")
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    problem, tally = read_problem(place / f"{stem}.md"), Tally()
    check_words(problem, tally)
    for code in translations(problem.path):
        found = translation(problem, code)
        assert found is not None
        tally.complaints += [
            str(each)
            for each in faults(problem, found)
            if " of: " not in str(each) and "no `of`" not in str(each)
        ]
    return tally.complaints
