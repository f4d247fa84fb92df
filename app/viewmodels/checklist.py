"""The set-up, step by step: done or not, why not, and the one command that helps."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.engines.engine import one_camera
from app.engines.snapshot import Snapshot
from app.viewmodels.calibration import (
    SETTLED,
    by_one_camera,
    calibration_view,
    is_measured,
    right_camera_time,
)
from app.viewmodels.colours import seen_rows
from app.viewmodels.light import LightWatch
from app.viewmodels.names import spoken
from app.viewmodels.states import GOOD, IDLE, WARN, StateLook
from app.viewmodels.status import images_alone
from app.words import mark, told, tr
from tracker.messages import Tracking

BIAS_DPS = 0.6
"""°/s: gyros known better than this need no rest."""

CONTROLS = {
    "exposure": mark("exposure"),
    "gain": mark("gain"),
    "white_balance": mark("white balance"),
}


@dataclass(frozen=True)
class SetUpStep:
    """``command`` is a key of the window's commands, or empty where nothing is to be done."""

    name: str
    done: bool
    reason: str
    command: str = ""
    button: str = ""

    def look(self, reachable: bool) -> StateLook:
        if self.done:
            return GOOD
        return WARN if reachable else IDLE


def steps(
    view: Snapshot | None,
    calibration: str = "",
    hues_lately: Collection[str] | None = None,
    light: LightWatch | None = None,
) -> list[SetUpStep]:
    """All steps in order; the first that is not done is the one to work on.

    ``calibration`` is the chosen stereo calibration's path, for the time before devices are open;
    ``hues_lately`` are names of hues found in the last seconds, in the newest images unless told.
    ``light`` has read the images' light.
    """
    if view is not None and not (view.running or view.setup.player is not None):
        view = None  # stopped: nothing arrives
    return [
        _glove(view),
        _samples(view),
        _still(view),
        _camera(view),
        _stereo(view, calibration),
        _exposure(view),
        _light(view, light),
        _colours(view, hues_lately),
        _hand(view),
        _calibration(view),
    ]


def packets_arrive(view: Snapshot | None) -> bool:
    return view is not None and view.packets_arrive


def images_arrive(view: Snapshot | None) -> bool:
    return view is not None and view.images_arrive


# Sentences are written whole, not made of pieces: in other languages they bend with what is named.


def _glove(view: Snapshot | None) -> SetUpStep:
    name = tr("Glove found")
    if view is not None and packets_arrive(view):
        glove = view.setup.glove.name
        if view.setup.firmware_advice:
            advice = told(view.setup.firmware_advice)
            glove = f"{glove}. {advice} {tr('Set-up, Glove firmware writes it.')}"
        return SetUpStep(name, True, glove)
    if view is not None and len(view.imu) > 0:
        reason = tr("The glove was here and is silent. Is it plugged in?")
        return SetUpStep(name, False, reason, "hardware", tr("Look again"))
    if view is None:
        return SetUpStep(name, False, tr("Not connected."), "hardware", tr("Look for it"))
    reason = tr("No glove answers. Plug it in, or try the demo.")
    return SetUpStep(name, False, reason, "hardware", tr("Look again"))


def _samples(view: Snapshot | None) -> SetUpStep:
    name = tr("All IMUs answer")
    if view is None or not packets_arrive(view):
        return SetUpStep(
            name, False, tr("Waits for the glove."), "glove_setup", tr("Set up the glove")
        )
    valid = np.array([s.valid for s in list(view.imu)[-100:]]).mean(axis=0)
    names = [spoken(n) for n in view.setup.glove.imu_names]
    silent = [n for n, v in zip(names, valid, strict=True) if v < 0.5]
    if silent:
        return SetUpStep(
            name,
            False,
            tr("Silent: {}.").format(", ".join(silent)),
            "show_sensors",
            tr("Show sensors"),
        )
    return SetUpStep(name, True, tr("{} of {}").format(len(valid), len(valid)))


def _still(view: Snapshot | None) -> SetUpStep:
    """Either the hand lay still for a moment, or the filter has found the gyros' biases by now."""
    name = tr("Measured at rest")
    if view is None or view.calibration is None or not packets_arrive(view):
        return SetUpStep(name, False, tr("Waits for the glove."))
    sd = view.calibration.gyro_bias_sd
    if np.all(np.isnan(sd)):
        return SetUpStep(name, True, tr("this engine estimates no biases"))
    worst_dps = float(np.rad2deg(np.nanmax(sd)))
    if worst_dps <= BIAS_DPS:
        return SetUpStep(name, True, tr("gyros known to {:.1f} °/s").format(worst_dps))
    reason = tr("Lay the hand flat on the table for two seconds.")
    return SetUpStep(name, False, reason, "glove_setup", tr("Measure"))


def _camera(view: Snapshot | None) -> SetUpStep:
    name = tr("Camera found")
    if view is not None and view.frame is not None and not images_arrive(view):
        reason = tr("The camera was here and is silent. Is it plugged in?")
        return SetUpStep(name, False, reason, "hardware", tr("Look again"))
    if view is not None and view.frame is not None:
        if view.frame.left is not None and one_camera(view.setup, view.frame):
            return SetUpStep(name, True, tr("images of one camera arrive"))
        if view.frame.left is not None and view.frame.right is not None:
            return SetUpStep(name, True, right_camera_time(view.status) or tr("both images arrive"))
        if view.frame.left is None:
            reason = tr("The left image is missing.")
        else:
            reason = tr("The right image is missing.")
        return SetUpStep(name, False, reason, "hardware", tr("Look again"))
    if view is None:
        return SetUpStep(name, False, tr("Not connected."), "hardware", tr("Look for it"))
    if view.unfit is not None:
        return SetUpStep(name, False, told(view.unfit.why), "stereo", tr("Calibrate"))
    return SetUpStep(name, False, tr("No images arrive."), "hardware", tr("Look again"))


def _stereo(view: Snapshot | None, calibration: str) -> SetUpStep:
    name = tr("Camera calibrated")
    if view is None and calibration:
        return SetUpStep(name, True, Path(calibration).name)
    if view is None:
        return SetUpStep(
            name, False, tr("Show a printed board to the camera."), "stereo", tr("Calibrate")
        )
    if not view.setup.camera_calibrated:
        reason = tr("Show a printed board to the camera.")
        return SetUpStep(name, False, reason, "stereo", tr("Calibrate"))
    if view.setup.rig.one_camera:
        return SetUpStep(name, True, tr("one camera: distances are as sure as the hand's size"))
    baseline = view.setup.rig.baseline * 1000
    return SetUpStep(name, True, tr("baseline {:.1f} mm").format(baseline))


def _exposure(view: Snapshot | None) -> SetUpStep:
    """A camera that exposes by itself changes the markers' colours."""
    name = tr("Exposure locked")
    if view is None or not images_arrive(view):
        return SetUpStep(name, False, tr("Waits for images."))
    if view.setup.simulated or view.setup.player is not None:
        return SetUpStep(name, True, tr("it does not change here"))
    if view.setup.camera_controls is None:
        return SetUpStep(name, True, tr("this source has no exposure to be set"))
    controls = {c.name: c for c in view.setup.camera_controls.controls() if c.available}
    open_ones = [tr(CONTROLS[n]) for n, c in controls.items() if not c.locked and n != "gain"]
    if not controls:
        return SetUpStep(
            name, True, tr("this camera lets no program set it: keep the light as it is")
        )
    if open_ones:
        words = tr("The camera changes {} by itself.").format(", ".join(open_ones))
        return SetUpStep(name, False, words, "lock_camera", tr("Lock it now"))
    values = (f"{tr(CONTROLS[n])} {c.value:g}" for n, c in controls.items())
    return SetUpStep(name, True, ", ".join(values))


def _light(view: Snapshot | None, light: LightWatch | None) -> SetUpStep:
    """Lamp and exposure; what colours and the room cost is told, but can be lived with."""
    name = tr("Light")
    if light is None or light.reading is None or view is None or not images_arrive(view):
        return SetUpStep(name, False, tr("Waits for images."))
    advice = light.reading.advice
    words = told(advice[0].words) if advice else tr("the markers are clear")
    if light.reading.good:
        return SetUpStep(name, True, words)
    return SetUpStep(name, False, words, "show_colours", tr("Show"))


def hues_seen(view: Snapshot) -> set[str]:
    """Names of the hues that are found in the newest images."""
    if view.blobs is None:
        return set()
    sides = [b for b in (view.blobs.left, view.blobs.right) if b is not None]
    return {view.blobs.hue_names[h] for b in sides for h in b.hue.tolist()}


def _colours(view: Snapshot | None, lately: Collection[str] | None) -> SetUpStep:
    """Done when every hue of the glove is found, not only some."""
    name = tr("Colours tuned")
    if view is None or view.blobs is None or not images_arrive(view):
        return SetUpStep(name, False, tr("Waits for images."))
    rows = seen_rows(view, view.setup.profile)
    clashing = [spoken(r.name) for r in rows if r.clash]
    if clashing:
        reason = tr("The intervals of {} overlap.").format(", ".join(clashing))
        return SetUpStep(name, False, reason, "show_colours", tr("Tune colours"))
    found = hues_seen(view) if lately is None else set(lately)
    unseen = [spoken(n) for n in view.setup.glove.hues if n not in found]
    if not found:
        return SetUpStep(name, False, tr("No marker is found."), "show_colours", tr("Tune colours"))
    if unseen:
        reason = tr("Not seen: {}. Turn the hand, or tune the colours.").format(", ".join(unseen))
        return SetUpStep(name, False, reason, "show_colours", tr("Tune colours"))
    return SetUpStep(
        name, True, tr("seen: {}").format(", ".join(map(spoken, view.setup.glove.hues)))
    )


def _hand(view: Snapshot | None) -> SetUpStep:
    name = tr("Hand in view")
    tracking = view.estimate.tracking if view is not None and view.estimate is not None else None
    if not (packets_arrive(view) or images_arrive(view)):
        return SetUpStep(name, False, tr("Waits for glove and camera."))
    if tracking == Tracking.TRACKING:
        return SetUpStep(name, True, tr("tracking"))
    if view is not None and not view.setup.whole:
        return SetUpStep(name, False, tr("Needs glove and calibrated camera."))
    return SetUpStep(
        name, False, tr("Hold the hand flat, about 35 cm before the camera, for two seconds.")
    )


def _calibration(view: Snapshot | None) -> SetUpStep:
    name = tr("Calibration settled")
    if view is None or view.calibration is None:
        return SetUpStep(name, False, tr("Waits for tracking."))
    if view.status is not None and images_alone(view.status):
        return SetUpStep(name, False, tr("Waits for the glove."))
    alone = by_one_camera(view)
    shown = calibration_view(view.calibration, one_camera=alone)
    share = 0.0 if np.isnan(shown.convergence) else shown.convergence
    if share >= SETTLED:
        return SetUpStep(name, True, tr("hand length {}").format(shown.hand_length))
    reason = f"{100 * share:.0f} %. {shown.advice}"
    if view.setup.guide is not None and not (alone and not is_measured(view.calibration)):
        return SetUpStep(name, False, reason, "guided", tr("Hold poses"))
    return SetUpStep(name, False, reason, "show_calibration", tr("Show"))
