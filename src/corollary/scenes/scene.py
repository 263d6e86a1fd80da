"""A scene: bodies, the forces between them, and until when it is watched; and what a force has to say of itself.

A state is a row of numbers: all places, then all velocities, body after body.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from enum import Flag

from corollary.scenes.body import Body, Constraint, Rub, State, nothing_moves
from corollary.scenes.run import BadSetting
from corollary.scenes.validation import is_own, refuse_misfits, refuse_parts, refuse_unsupported


class Conserves(Flag):
    """What a force leaves as it is: the momentum of all bodies together, the sum of kinetic and potential energy."""

    NOTHING = 0
    MOMENTUM = 1
    ENERGY = 2


@dataclass(frozen=True, slots=True)
class Event:
    """Where the law of motion changes: `value` of a state (smooth) changes its sign.

    A step ends just beyond. With `turn`, which gives the new velocity of `body`, the event acts in no time at all where `value` falls
    through zero. Where `value` is a speed (m/s), its sign says nothing of what is too slow to be told from rest.
    """

    value: Callable[[State], float]
    body: int = -1
    turn: Callable[[State], Sequence[float]] | None = None
    of_speed: bool = False


Pushes = Iterable[tuple[int, Sequence[float]]]
"""Forces (N, by components), each with the place in the scene of the body it acts on."""


class Force(ABC):
    """What acts on the bodies of a scene: one file each, and nothing else has to know it. All numbers are SI.

    Only `act` must be written. A force with a potential says so by `potential` and `conserves`: the energy is then watched along
    the way. A force that changes abruptly says where by `events`.
    """

    @abstractmethod
    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """The force (N, by components) on each body it acts on; a body may be named several times.

        `since` is the state with which the present step began: a force that is switched by an event asks there whether it acts, and
        so keeps its form through the step. `masses` (kg) are those of this moment.
        """

    def fits(self, scene: Scene) -> None:
        """Raises BadSetting where its numbers are against the physics, or it does not fit the scene; asked once, as that is made."""
        return

    def potential(self, scene: Scene, state: State) -> float:
        """The potential energy (J), none unless a force has one; its zero is the force's own choice."""
        return 0.0

    def events(self, scene: Scene) -> Iterable[Event]:
        """Everything that begins or ends at a place or a velocity."""
        return ()

    def act_at(
        self, scene: Scene, time: float, state: State, masses: Sequence[float], since: State
    ) -> Pushes:
        """The same for a force that depends on the time (s), too; this is what is asked for."""
        return self.act(scene, state, masses, since)

    def accelerations(self, scene: Scene, time: float, state: State, since: State) -> Iterator[float]:
        """What it does to each component of a velocity (m/s^2); looked at where it `may_be_brief`."""
        masses = [body.mass for body in scene.bodies]
        for i, newtons in self.act_at(scene, time, state, masses, since):
            if not math.isinf(masses[i]):
                yield from (newton / masses[i] for newton in newtons)

    def constraints(self, scene: Scene) -> Iterable[Constraint]:
        """What it holds: rods, strings, walls."""
        return ()

    def rubs(self, scene: Scene, held: Sequence[Constraint]) -> Iterable[Rub]:
        """Where it rubs, if there is dry friction in it; `held` are its own constraints."""
        return ()

    @property
    def may_be_brief(self) -> bool:
        """Whether it may act for much shorter than anything else happens: steps that feel nothing of it are then searched for it.

        The laws of this package do not; anybody else's may.
        """
        return is_own(self)

    @property
    def is_smooth(self) -> bool:
        """Whether it is known beforehand to change no faster than its scene lasts: then no step is searched for it."""
        return False

    @property
    def conserves(self) -> Conserves:
        return Conserves.NOTHING

    @property
    def bodies(self) -> tuple[int, ...]:
        """The bodies it names by their places in the scene; none for a force that acts on all."""
        return ()

    @property
    def mass_rates(self) -> tuple[tuple[int, float], ...]:
        """How fast (kg/s) it changes the mass of which body."""
        return ()

    @property
    def rubs_surfaces(self) -> bool:
        """Whether it makes bodies spin."""
        return False

    @property
    def does_no_work_at_rest(self) -> bool:
        """Whether it takes no energy while nothing hits and nothing slips, though it does when something does."""
        return False

    @property
    def edge(self) -> float:
        """The distance (m) from the origin beyond which it does nothing."""
        return math.inf


@dataclass(frozen=True, slots=True)
class ForceOnOne(Force, ABC):
    """On one body, by its place in the scene."""

    body: int

    @property
    def bodies(self) -> tuple[int, ...]:
        return (self.body,)


@dataclass(frozen=True, slots=True)
class ForceBetween(Force, ABC):
    """Between two bodies at the `ends`, by their places in the scene."""

    ends: tuple[int, int]

    @property
    def bodies(self) -> tuple[int, ...]:
        return self.ends


class ContactForce(Force, ABC):
    """A force between two bodies that overlap; a scene with no other force ends when nothing touches and nothing will."""

    def serves(self, scene: Scene) -> Collection[tuple[int, int]]:
        """The pairs of bodies it acts between, of which something moves one: those of its own choice, or all that no other contact has chosen."""
        mine = self.between_bodies
        if mine is not None:
            chosen = [(min(pair), max(pair)) for pair in mine]
            return [(a, b) for a, b in chosen if not nothing_moves(scene.bodies[a], scene.bodies[b])]
        others = {(min(pair), max(pair)) for other in scene.contacts for pair in other.between_bodies or ()}
        return [pair for pair in pairs(scene) if pair not in others]

    @property
    def between_bodies(self) -> tuple[tuple[int, int], ...] | None:
        """The pairs of bodies it is chosen for; none when it acts between any."""
        return None

    @abstractmethod
    def between(self, scene: Scene, state: State, a: int, b: int) -> list[float]:
        """The force (N) on b of its touch with a; a feels the opposite.

        Asked only while they touch; trial steps may reach a little out of it, where the force is to go on without a jump.
        """

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        for a, b in self.serves(scene):
            if overlap(scene, state, a, b)[0] > 0.0:
                yield from opposite(a, b, self.between(scene, state, a, b))


@dataclass(frozen=True, slots=True)
class Scene:
    """`until` is a time in s; without it the scene ends when nothing touches and nothing will.

    Two bodies with radii that overlap although no contact acts between them are refused while the scene runs, unless `passes` names
    them. Raises BadSetting when bodies and forces do not fit together.
    """

    bodies: tuple[Body, ...]
    forces: tuple[Force, ...]
    until: float | None = None
    name: str = "scene"
    passes: tuple[tuple[int, int], ...] = ()
    spins: bool = field(init=False, repr=False, compare=False, default=False)
    """Whether anything spins or can be made to: the state then has a spin for each body at its end."""
    axes: int = field(init=False, repr=False, compare=False, default=1)
    """How many components places and velocities have."""

    def __post_init__(self) -> None:
        refuse_parts(self, Force)
        axes = {len(vector) for body in self.bodies for vector in (body.place, body.velocity)}
        if axes not in ({1}, {2}):
            raise BadSetting(
                f"{self.name}: places and velocities of all bodies need one component each, or two each."
            )
        object.__setattr__(self, "axes", len(self.bodies[0].place))
        rubbed = any(force.rubs_surfaces for force in self.forces)
        turned = any(b.spin or (rubbed and not math.isinf(b.resists_spin)) for b in self.bodies)
        object.__setattr__(self, "spins", self.axes == 2 and turned)
        refuse_misfits(self, start_of(self))
        refuse_unsupported(self, start_of(self))

    @property
    def walls_at_rest(self) -> bool:
        """Whether no body of infinite mass moves; one that does would do work."""
        return not any(math.isinf(body.mass) and any(body.velocity) for body in self.bodies)

    @property
    def contacts(self) -> tuple[ContactForce, ...]:
        """The forces that act only while bodies touch."""
        return tuple(force for force in self.forces if isinstance(force, ContactForce))

    @property
    def conserves(self) -> Conserves:
        """What all forces together leave as it is; a moving wall or a wall at all is not looked at."""
        conserved = Conserves.MOMENTUM | Conserves.ENERGY
        for force in self.forces:
            conserved &= force.conserves
        return conserved


def start_of(scene: Scene) -> list[float]:
    """The state at time zero."""
    places = [x for body in scene.bodies for x in body.place]
    velocities = [v for body in scene.bodies for v in body.velocity]
    return places + velocities + ([body.spin for body in scene.bodies] if scene.spins else [])


def place(scene: Scene, state: State, i: int) -> State:
    return state[scene.axes * i : scene.axes * (i + 1)]


def velocity(scene: Scene, state: State, i: int) -> State:
    start = scene.axes * (len(scene.bodies) + i)
    return state[start : start + scene.axes]


def spin(scene: Scene, state: State, i: int) -> float:
    """The spin (rad/s) of a body; zero where nothing spins."""
    return state[2 * scene.axes * len(scene.bodies) + i] if scene.spins else 0.0


def unit_row(scene: Scene, i: int, direction: Sequence[float], spin: float = 0.0) -> list[float]:
    """A row over the generalized velocity: the velocity of one body along a direction, and its spin times an arm (m)."""
    count = len(scene.bodies)
    row = [0.0] * (count * (scene.axes + scene.spins))
    row[scene.axes * i : scene.axes * (i + 1)] = direction
    if scene.spins:
        row[scene.axes * count + i] = spin
    return row


def seen_from(scene: Scene, state: State, a: int, b: int) -> tuple[list[float], list[float]]:
    """Place and velocity of body b seen from body a."""
    n, count = scene.axes, scene.axes * len(scene.bodies)
    i, j = n * a, n * b
    if n == 2:  # written out: this is where most of the time of a composed scene goes
        u, v = count + i, count + j
        apart = [state[j] - state[i], state[j + 1] - state[i + 1]]
        return apart, [state[v] - state[u], state[v + 1] - state[u + 1]]
    return [state[j] - state[i]], [state[count + j] - state[count + i]]


def overlap(scene: Scene, state: State, a: int, b: int) -> tuple[float, float]:
    """How deep two bodies are in each other, and how fast that grows."""
    apart, relative = seen_from(scene, state, a, b)
    distance = math.hypot(*apart)
    growing = -sum(x * v for x, v in zip(apart, relative, strict=True)) / distance if distance else 0.0
    return scene.bodies[a].radius + scene.bodies[b].radius - distance, growing


def pairs(scene: Scene) -> Iterator[tuple[int, int]]:
    """Every two bodies that can touch, and of which something moves one."""
    for a, first in enumerate(scene.bodies):
        for b, second in enumerate(scene.bodies[a + 1 :], start=a + 1):
            if first.radius + second.radius > 0.0 and not nothing_moves(first, second):
                yield a, b


def opposite(a: int, b: int, on_b: Sequence[float]) -> tuple[tuple[int, Sequence[float]], ...]:
    """A force on b and, by Newton's third law, its opposite on a."""
    return (b, on_b), (a, [-f for f in on_b])
