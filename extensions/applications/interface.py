"""What an application is, and what it may ask of devices."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple, Protocol

from extensions.applications.drawing import Drawing
from extensions.applications.hand import HandSample
from tracker.messages import Array

Value = float | int | str | bool | list[float]
Vector3 = tuple[float, float, float]


class Happening(NamedTuple):
    """Something worth an event: a word such as ``touch``, and its data in JSON's types."""

    what: str
    data: Mapping[str, Value] = {}


class MotorCommand(NamedTuple):
    """A fingertip is to feel something: ``strength`` 0..1, from ``direction``, of length 1, in the
    distal segment's frame B (x to the tip, z dorsal): the push that the skin is to feel."""

    tip: str
    strength: float
    direction: Vector3 = (0.0, 0.0, 1.0)
    axes: int = 1  # of the motors that are to make it felt: 1, or 3


class JointCommand(NamedTuple):
    """A robot's joints are to go to ``angles`` (rad); ``grip`` 0 open to 1 closed."""

    robot: str
    names: tuple[str, ...]
    angles: tuple[float, ...]
    grip: float = 0.0
    stop: bool = False
    to: str = ""  # host:port


class PoseCommand(NamedTuple):
    """A robot's hand is to go to p (3,) m and q (4,) xyzw, in its base's frame."""

    robot: str
    p: Vector3
    q: tuple[float, float, float, float]
    grip: float = 0.0
    stop: bool = False
    to: str = ""  # host:port


@dataclass(frozen=True, eq=False)
class VehicleCommand:
    """N vehicles at ``to`` (host:port) are to be at ``p`` (N, 3) m in G, moving with ``v`` (N, 3)
    m/s."""

    p: Array
    v: Array
    to: str


Command = MotorCommand | JointCommand | PoseCommand | VehicleCommand


@dataclass(frozen=True, eq=False)
class Step:
    """What one sample of the hand brings; unpacks as (drawing, events, commands)."""

    drawing: Drawing = ()
    events: Sequence[Happening] = field(default_factory=tuple)
    commands: Sequence[Command] = field(default_factory=tuple)

    def __iter__(self) -> Any:
        return iter((self.drawing, self.events, self.commands))


class Application(Protocol):
    """Made with its settings; fed with one hand's samples in order.

    ``settings`` is a frozen dataclass that `tracker.base.config` can read (numbers, texts,
    booleans, tuples of numbers, with defaults); another one may be put in its place between two
    steps.
    ``between``: how many foretold samples it wants after each measured one.
    Where the class has a ``prepare(settings)``, it is called before other settings take the place,
    in the thread of the one who sets: for what takes long, and to refuse it (GlovetrackError).
    """

    name: ClassVar[str]
    title: ClassVar[str]
    between: ClassVar[int]
    settings: Any

    def step(self, hand: HandSample) -> Step:
        """What this sample brings. The same samples and settings bring the same, bit for bit."""


@dataclass(frozen=True)
class NoSettings:
    """Of an application that has none."""
