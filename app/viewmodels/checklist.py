"""The set-up, step by step: done or not, why not, and the one command that helps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.viewmodels.calibration import SETTLED, calibration_view
from app.viewmodels.colours import seen_rows
from app.viewmodels.snapshot import Snapshot
from app.viewmodels.states import GOOD, IDLE, WARN, Look
from tracker.messages import Tracking

STILL_DPS = 8.0
"""A hand whose angular rates spread less than this counts as still (biases may be larger)."""


@dataclass(frozen=True)
class Step:
    """``command`` is a key of the window's commands, or empty where nothing is to be done."""

    name: str
    done: bool
    reason: str
    command: str = ""
    button: str = ""

    def look(self, reachable: bool) -> Look:
        if self.done:
            return GOOD
        return WARN if reachable else IDLE


def steps(view: Snapshot | None) -> list[Step]:
    """All steps in order; the first that is not done is the one to work on."""
    return [
        _glove(view),
        _samples(view),
        _camera(view),
        _stereo(view),
        _colours(view),
        _hand(view),
        _calibration(view),
    ]


def _glove(view: Snapshot | None) -> Step:
    name = "Glove found"
    if view is not None and len(view.imu) > 0:
        return Step(name, True, view.setup.glove.name)
    reason = "No glove answers. Plug it in, or try the demo."
    return Step(name, False, reason, "hardware", "Look again")


def _samples(view: Snapshot | None) -> Step:
    name = "All IMUs answer"
    if view is None or len(view.imu) == 0:
        return Step(name, False, "Waits for the glove.")
    valid = np.array([s.valid for s in list(view.imu)[-100:]]).mean(axis=0)
    silent = [n for n, v in zip(view.setup.glove.imu_names, valid, strict=True) if v < 0.5]
    if silent:
        return Step(name, False, f"Silent: {', '.join(silent)}.", "show_sensors", "Show sensors")
    return Step(name, True, f"{len(valid)} of {len(valid)}")


def _camera(view: Snapshot | None) -> Step:
    name = "Camera found"
    if view is not None and view.frame is not None:
        dark = [
            side
            for side, picture in (("left", view.frame.left), ("right", view.frame.right))
            if picture is None
        ]
        if not dark:
            return Step(name, True, "both pictures arrive")
        return Step(name, False, f"The {dark[0]} picture is missing.", "hardware", "Look again")
    return Step(name, False, "No pictures arrive.", "hardware", "Look again")


def _stereo(view: Snapshot | None) -> Step:
    name = "Camera calibrated"
    if view is None:
        return Step(name, False, "Show a printed board to both lenses.", "stereo", "Calibrate")
    baseline = view.setup.rig.baseline * 1000
    return Step(name, True, f"baseline {baseline:.1f} mm")


def _colours(view: Snapshot | None) -> Step:
    name = "Colours tuned"
    if view is None or view.blobs is None:
        return Step(name, False, "Waits for pictures.")
    rows = seen_rows(view, view.setup.profile)
    clashing = [r.name for r in rows if r.clash]
    if clashing:
        reason = f"The intervals of {' and '.join(clashing)} overlap."
        return Step(name, False, reason, "show_colours", "Tune colours")
    sides = [b for b in (view.blobs.left, view.blobs.right) if b is not None]
    found = {view.blobs.hue_names[h] for b in sides for h in b.hue.tolist()}
    if not found:
        return Step(name, False, "No marker is found.", "show_colours", "Tune colours")
    return Step(name, True, f"seen: {', '.join(n for n in view.blobs.hue_names if n in found)}")


def _hand(view: Snapshot | None) -> Step:
    name = "Hand in view"
    tracking = view.estimate.tracking if view is not None and view.estimate is not None else None
    if tracking == Tracking.TRACKING:
        return Step(name, True, "tracking")
    return Step(name, False, "Hold the hand flat, about 35 cm before the camera, for two seconds.")


def _calibration(view: Snapshot | None) -> Step:
    name = "Calibration settled"
    if view is None or view.calibration is None:
        return Step(name, False, "Waits for tracking.")
    shown = calibration_view(view.calibration)
    share = 0.0 if np.isnan(shown.convergence) else shown.convergence
    if share >= SETTLED:
        return Step(name, True, f"hand length {shown.hand_length}")
    reason = f"{100 * share:.0f} %. {shown.advice}"
    return Step(name, False, reason, "show_calibration", "Show")
