"""Descriptors of the applications extension: a listener and four applications."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tracker.base.registry import deferred
from tracker.live.listeners import RemoteListenerKind

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


LISTENER = RemoteListenerKind(
    "applications",
    "Applications",
    deferred("extensions.applications.live:listener"),
    proxy=deferred("extensions.applications.live:ApplicationProxy"),
)
TOUCH = ApplicationKind(
    "touch",
    "Virtual object to touch",
    deferred("extensions.applications.touch.touch:Touch").load,
    order=10,
)
ARM = ApplicationKind(
    "arm",
    "Robot arm",
    deferred("extensions.applications.arm.arm:RobotArm").load,
    "glovetrack[robot]",
    order=20,
)
PLACE = ApplicationKind(
    "place",
    "Virtual place",
    deferred("extensions.applications.place.place:VirtualPlace").load,
    order=30,
)
SWARM = ApplicationKind(
    "swarm", "Drone swarm", deferred("extensions.applications.swarm.swarm:Swarm").load, order=40
)
