"""What leads a wearer through poses that the engine learns from, and tells the engine of them."""

from __future__ import annotations

from typing import Protocol


class PoseGuide(Protocol):
    """Poses are named as in `tracker.hand.poses.POSES`.

    ``leads``: whether a simulated wearer goes to what is shown.
    """

    @property
    def leads(self) -> bool: ...

    def show(self, pose: str) -> None:
        """A simulated wearer goes to this pose, or (empty) on as before; a real one sees it."""

    def show_gesture(self, gesture: str) -> None:
        """The same of a gesture of the conformance script, see `tracker.simulation.gestures`."""

    def hold(self, pose: str) -> None:
        """The pose is held from now on."""

    def let_go(self, pose: str, held: bool) -> None:
        """It is over; ``held``: the engine may learn from it."""


class HoldingEngine(Protocol):
    """The part of `tracker.live.runner.HandOfTracker` that hears of poses."""

    def hold(self, pose: str) -> None: ...

    def let_go(self, pose: str, held: bool) -> None: ...


class WearersGuide:
    """Of a real wearer, who looks at the screen."""

    leads = False

    def __init__(self, engine: HoldingEngine) -> None:
        self._engine = engine

    def show(self, pose: str) -> None:
        """The wearer sees it."""

    def show_gesture(self, gesture: str) -> None:
        """The wearer sees it."""

    def hold(self, pose: str) -> None:
        self._engine.hold(pose)

    def let_go(self, pose: str, held: bool) -> None:
        self._engine.let_go(pose, held)
