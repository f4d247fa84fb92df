"""A step of the set-up: done, to be checked or open; done steps remain done."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.viewmodels.states import GOOD, IDLE, WARN, StateLook
from app.words import tr

LASTING = {
    "still": ("glove",),
    "light": ("camera",),
    "colours": ("camera",),
    "hand": ("glove", "camera"),
    "calibration": ("glove",),
}
"""Steps whose state fluctuates, and the devices whose loss reopens them."""
LOST_AFTER = 3.0
"""s without packets or images after which a device counts as lost; a loaded computer may miss
some."""
MEASURED = ("still", "calibration")
"""Steps with a measured value and a lower limit below which they are open again."""


@dataclass(frozen=True)
class SetUpStep:
    """``command`` is a key of the window's commands; empty if there is nothing to do.

    A step is done, or it works but should be checked (``check``), or it is open. An open step
    ``waits`` if the current data do not show whether it is done.
    """

    name: str
    done: bool
    reason: str
    command: str = ""
    button: str = ""
    check: bool = False
    waits: bool = False

    @property
    def passes(self) -> bool:
        """Whether the user can continue with the next step."""
        return self.done or self.check

    def look(self, reachable: bool) -> StateLook:
        if self.done:
            return GOOD
        return WARN if reachable or self.check else IDLE


class SettledSteps:
    """Keeps done steps from being reopened until a device that they need is lost."""

    def __init__(self) -> None:
        self._setup: EngineSetup | None = None
        self._done: dict[str, SetUpStep] = {}

    def __contains__(self, key: str) -> bool:
        return key in self._done

    def follow(self, view: Snapshot | None) -> None:
        """Discard steps of other devices and of devices that were lost."""
        setup = view.setup if view is not None else None
        same = (
            self._setup is not None and setup is not None and self._setup.tracked is setup.tracked
        )
        self._done = {
            key: step
            for key, step in self._done.items()
            if same and not any(is_lost(view, device) for device in LASTING[key])
        }
        self._setup = setup

    def take(self, key: str, step: SetUpStep) -> SetUpStep:
        """The displayed state of a step: once done, it is to be checked rather than open."""
        if key not in LASTING:
            return step
        if step.done:
            self._done[key] = step
        elif step.waits and key in self._done:
            return self._done[key]
        elif key in self._done and key not in MEASURED:
            return replace(step, check=True)
        elif key in MEASURED:
            self._done.pop(key, None)
        return step


def summary(shown: Collection[SetUpStep]) -> str:
    """Progress of the set-up in a few words."""
    done, check = sum(s.done for s in shown), sum(s.check for s in shown)
    if done + check < len(shown):
        return tr("{} of {} done").format(done, len(shown))
    return tr("Ready, {} to check").format(check) if check else tr("Ready")


def packets_arrive(view: Snapshot | None) -> bool:
    return view is not None and view.packets_arrive


def images_arrive(view: Snapshot | None) -> bool:
    return view is not None and view.images_arrive


def is_lost(view: Snapshot | None, device: str) -> bool:
    """Whether the "glove" or the "camera" has not sent for `LOST_AFTER`, or never has."""
    if view is None:
        return True
    if device == "glove":
        last = view.imu[-1].t_arrival if len(view.imu) > 0 else None
    else:
        last = view.frame.t_arrival if view.frame is not None else None
    if last is None:
        return True
    live = view.setup.player is None and view.status is not None
    return live and view.status is not None and view.status.t - last > LOST_AFTER
