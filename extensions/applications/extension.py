"""Descriptors of the applications extension: a listener and four applications."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tracker.live.listeners import ListenedHand, Listener, ListenerKind

if TYPE_CHECKING:
    from extensions.applications.interface import Application


@dataclass(frozen=True)
class ApplicationKind:
    """Describes an application whose class is slow to import or requires further packages.

    ``load`` imports and returns the class, whose ``__init__`` takes the dataclass of its settings;
    ``extra`` is what pip installs if ``load`` raises ImportError. Those of a lower ``order`` are
    listed first.
    """

    name: str
    title: str
    load: Callable[[], type[Application]]
    extra: str = ""
    order: int = 100


def _listener(hand: ListenedHand) -> Listener:
    from extensions.applications.live import listener

    return listener(hand)


def _touch() -> type[Application]:
    from extensions.applications.touch.touch import Touch

    return Touch


def _arm() -> type[Application]:
    from extensions.applications.arm.arm import RobotArm

    return RobotArm


def _place() -> type[Application]:
    from extensions.applications.place.place import VirtualPlace

    return VirtualPlace


def _swarm() -> type[Application]:
    from extensions.applications.swarm.swarm import Swarm

    return Swarm


LISTENER = ListenerKind("applications", "Applications", _listener)
TOUCH = ApplicationKind("touch", "Virtual object to touch", _touch, order=10)
ARM = ApplicationKind("arm", "Robot arm", _arm, "glovetrack[robot]", order=20)
PLACE = ApplicationKind("place", "Virtual place", _place, order=30)
SWARM = ApplicationKind("swarm", "Drone swarm", _swarm, order=40)
