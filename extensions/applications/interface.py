"""The interface of applications and their commands to devices."""

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
    """An event of an application: a name such as ``touch``, and its data as JSON values."""

    what: str
    data: Mapping[str, Value] = {}


class MotorCommand(NamedTuple):
    """Haptic feedback at a fingertip: ``strength`` 0..1 along the unit vector ``direction`` in the
    distal segment's frame B (x to the tip, z dorsal), the direction of the force on the skin."""

    tip: str
    strength: float
    direction: Vector3 = (0.0, 0.0, 1.0)
    axes: int = 1  # of the motors: 1 or 3


class JointCommand(NamedTuple):
    """Target ``angles`` (rad) of a robot's joints; ``grip`` 0 open to 1 closed."""

    robot: str
    names: tuple[str, ...]
    angles: tuple[float, ...]
    grip: float = 0.0
    stop: bool = False
    to: str = ""  # host:port


class PoseCommand(NamedTuple):
    """Target pose of a robot's gripper: p (3,) m and q (4,) xyzw, in its base's frame."""

    robot: str
    p: Vector3
    q: tuple[float, float, float, float]
    grip: float = 0.0
    stop: bool = False
    to: str = ""  # host:port


@dataclass(frozen=True, eq=False)
class VehicleCommand:
    """Targets of N vehicles at ``to`` (host:port): position ``p`` (N, 3) m in G and velocity ``v``
    (N, 3) m/s."""

    p: Array
    v: Array
    to: str


Command = MotorCommand | JointCommand | PoseCommand | VehicleCommand


@dataclass(frozen=True, eq=False)
class Step:
    """Result of one sample of the hand; unpacks as (drawing, events, commands)."""

    drawing: Drawing = ()
    events: Sequence[Happening] = field(default_factory=tuple)
    commands: Sequence[Command] = field(default_factory=tuple)

    def __iter__(self) -> Any:
        return iter((self.drawing, self.events, self.commands))


class Application(Protocol):
    """An application is created with its settings and receives one hand's samples in order.

    ``settings`` is a frozen dataclass that `tracker.base.config` can read (numbers, strings,
    booleans, tuples of numbers, with defaults); it may be replaced between two steps.
    ``between``: number of predicted samples after each measured one.
    An optional ``prepare(settings)`` is called before settings are replaced, in the thread of the
    caller: for slow work, and to reject settings (GlovetrackError).
    """

    name: ClassVar[str]
    title: ClassVar[str]
    between: ClassVar[int]
    settings: Any

    def step(self, hand: HandSample) -> Step:
        """Result of a sample. The same samples and settings give the same result, bit for bit."""


@dataclass(frozen=True)
class NoSettings:
    """Settings of an application without settings."""
