"""Gestures and bent fingers as the buttons of a controller."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tracker.base.notices import notice
from tracker.gestures.values import GESTURES
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.messages import Array, Estimate
from tracker.streaming.connection import StreamError
from tracker.streaming.publisher import Names
from tracker.streaming.shared import Gestures

CONTROLS = ("", *GESTURES)
"""Values of an option for a control."""
JOINT_NAMES = {
    finger: ("cmc", "mcp", "ip") if finger == "thumb" else ("mcp", "pip", "dip")
    for finger in CHAINS
}
MOST_SPLAY = math.radians(20.0)  # that OpenGloves' driver gives a splay of 1


@dataclass(frozen=True)
class ButtonGestures:
    """The gesture for each control; "" for none."""

    trigger: str = "pinch_index"
    grip: str = "grasp"
    a: str = "pinch_middle"
    b: str = "pinch_ring"

    def __post_init__(self) -> None:
        for name in (self.trigger, self.grip, self.a, self.b):
            if name and name not in GESTURES:
                known = ", ".join(GESTURES)
                raise StreamError(notice("vr.unknown_gesture", name=name, known=known))


@dataclass(frozen=True, eq=False)
class Controls:
    """What a controller reports: ``trigger`` and ``grip`` 0 to 1; flexion (5, 3) 0 to 1 of each
    digit's joints, base first, thumb first, and splay (5,) -1 to 1; NaN where lost."""

    trigger: float
    grip: float
    trigger_click: bool
    grip_click: bool
    a: bool
    b: bool
    flexion: Array
    splay: Array

    @property
    def curls(self) -> Array:
        """(5,) mean flexion of each digit; NaN where a joint is lost."""
        return np.asarray(self.flexion.mean(axis=1))


class ControlReader:
    """Controls from the estimates of one hand, in order."""

    def __init__(self, hand: HandModel, recogniser: Gestures, gestures: ButtonGestures) -> None:
        self._gestures, self._recogniser = gestures, recogniser
        at = hand.angle_index
        self._flexion = np.array(
            [[at[f"{f}_{j}_flexion"] for j in joints] for f, joints in JOINT_NAMES.items()]
        )
        self._low = np.maximum(hand.angle_limits[self._flexion, 0], 0.0)
        self._range = hand.angle_limits[self._flexion, 1] - self._low
        self._splay = [at[f"{f}_{'cmc' if f == 'thumb' else 'mcp'}_abduction"] for f in JOINT_NAMES]

    def read(self, e: Estimate) -> Controls:
        """What a controller in this hand would report."""
        self._recogniser.feed(e)
        values, shown = self._recogniser.values, self._recogniser.active
        g = self._gestures
        flexion = np.clip((e.angles[self._flexion] - self._low) / self._range, 0.0, 1.0)
        splay = np.clip(e.angles[self._splay] / MOST_SPLAY, -1.0, 1.0)
        return Controls(
            _value(values.get(g.trigger, 0.0)),
            _value(values.get(g.grip, 0.0)),
            g.trigger in shown,
            g.grip in shown,
            g.a in shown,
            g.b in shown,
            flexion,
            splay,
        )


def control_reader(names: Names, gestures: ButtonGestures) -> ControlReader:
    """For one output of a hand. Raises ValueError for names without a hand."""
    hand, recogniser = names.model, names.recogniser()
    assert recogniser is not None  # since there is a hand
    return ControlReader(hand, recogniser, gestures)


def _value(x: float) -> float:
    """A control whose gesture is lost is released."""
    return x if math.isfinite(x) else 0.0
