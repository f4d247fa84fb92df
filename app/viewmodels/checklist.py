"""The set-up checklist: state of each step, the reason, and the command that helps."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

import numpy as np

from app.engines.snapshot import Snapshot
from app.viewmodels.calibration import (
    SETTLED,
    calibration_view,
    has_one_camera,
    is_measured,
    right_camera_time,
)
from app.viewmodels.colours import seen_rows
from app.viewmodels.light import LightWatch
from app.viewmodels.names import display_name
from app.viewmodels.set_up_steps import (
    SettledSteps,
    SetUpStep,
    images_arrive,
    packets_arrive,
)
from app.viewmodels.status import images_alone
from app.words import local, mark, notice_text, tr
from tracker.messages import Tracking

BIAS_DPS = 0.6
"""°/s: if the gyroscope biases are known better than this, no measurement at rest is needed."""
BIAS_LEFT_DPS = 2 * BIAS_DPS
"""°/s: uncertainty above which measured biases are out of date."""
CALIBRATION_LEFT = 0.5
"""Convergence below which a settled calibration is open again, after a reset."""
FEW_MISSED = 1 / 3
"""Share of the markers in an image that may be missed, for example at its edge and at grazing
angles."""
MOST_MISSED = 1 / 2
"""Share of missed markers above which the colours are not tuned."""

CONTROLS = {
    "exposure": mark("exposure"),
    "gain": mark("gain"),
    "white_balance": mark("white balance"),
}


def steps(
    view: Snapshot | None,
    calibration: str = "",
    recent_hues: Collection[str] | None = None,
    light: LightWatch | None = None,
    settled: SettledSteps | None = None,
) -> list[SetUpStep]:
    """All steps in order; the first one that does not pass is the next to work on.

    ``calibration`` is the path of the selected stereo calibration, used before devices are open;
    ``recent_hues`` are names of hues detected in the last seconds (default: in the newest images).
    ``light``: measurements of the images' light. ``settled``: stores which steps were done before.
    """
    if view is not None and not (view.running or view.setup.player is not None):
        view = None  # stopped: no data arrive
    settled = settled if settled is not None else SettledSteps()
    settled.follow(view)
    found = {
        "glove": _glove(view),
        "samples": _samples(view),
        "still": _still(view, BIAS_LEFT_DPS if "still" in settled else BIAS_DPS),
        "camera": _camera(view),
        "stereo": _stereo(view, calibration),
        "exposure": _exposure(view),
        "light": _light(view, light),
        "colours": _colours(view, recent_hues, light),
        "hand": _hand(view, "hand" in settled),
        "calibration": _calibration(
            view, CALIBRATION_LEFT if "calibration" in settled else SETTLED
        ),
    }
    return [settled.take(key, step) for key, step in found.items()]


# Sentences are complete texts, not composed of parts, since other languages inflect the parts.


def _glove(view: Snapshot | None) -> SetUpStep:
    name = tr("Glove found")
    if view is not None and packets_arrive(view):
        glove = view.setup.glove.name
        available = view.setup.connection.firmware_advice
        if available is not None:
            advice = notice_text(available)
            glove = f"{glove}. {advice} {tr('Update it under Set-up, Glove firmware.')}"
        return SetUpStep(name, True, glove)
    if view is not None and len(view.imu) > 0:
        reason = tr("The glove does not respond. Is it plugged in?")
        return SetUpStep(name, False, reason, "hardware", tr("Search again"))
    if view is None:
        return SetUpStep(name, False, tr("Not connected."), "hardware", tr("Search"))
    reason = tr("No glove found. Plug it in, or try the demo.")
    return SetUpStep(name, False, reason, "hardware", tr("Search again"))


def _samples(view: Snapshot | None) -> SetUpStep:
    name = tr("All IMUs respond")
    if view is None or not packets_arrive(view):
        return SetUpStep(
            name, False, tr("Waiting for the glove."), "glove_setup", tr("Set up the glove")
        )
    valid = np.array([s.valid for s in list(view.imu)[-100:]]).mean(axis=0)
    names = [display_name(n) for n in view.setup.glove.imu_names]
    silent = [n for n, v in zip(names, valid, strict=True) if v < 0.5]
    if silent:
        return SetUpStep(
            name,
            False,
            tr("Not responding: {}.").format(", ".join(silent)),
            "show_sensors",
            tr("Show sensors"),
        )
    return SetUpStep(name, True, tr("{} of {}").format(len(valid), len(valid)))


def _still(view: Snapshot | None, most_dps: float) -> SetUpStep:
    """Done if the hand was at rest for a moment, or if the filter has estimated the gyroscope
    biases with standard deviations of at most ``most_dps`` (°/s)."""
    name = tr("Measured at rest")
    if view is None or view.calibration is None or not packets_arrive(view):
        return SetUpStep(name, False, tr("Waiting for the glove."), waits=True)
    sd = view.calibration.gyro_bias_sd
    if np.all(np.isnan(sd)):
        return SetUpStep(name, True, tr("this engine does not estimate biases"))
    worst_dps = float(np.rad2deg(np.nanmax(sd)))
    if worst_dps <= most_dps:
        return SetUpStep(
            name, True, tr("gyroscope biases known to {:.1f} °/s").format(local(worst_dps))
        )
    reason = tr("Lay the hand flat on the table for two seconds.")
    return SetUpStep(name, False, reason, "glove_setup", tr("Measure"))


def _camera(view: Snapshot | None) -> SetUpStep:
    name = tr("Camera found")
    if view is not None and view.frame is not None and not images_arrive(view):
        reason = tr("The camera does not respond. Is it plugged in?")
        return SetUpStep(name, False, reason, "hardware", tr("Search again"))
    if view is not None and view.frame is not None:
        if view.frame.left is not None and view.setup.camera.is_single(view.frame):
            return SetUpStep(name, True, tr("images of one camera arrive"))
        if view.frame.left is not None and view.frame.right is not None:
            return SetUpStep(name, True, right_camera_time(view.status) or tr("both images arrive"))
        if view.frame.left is None:
            reason = tr("The left image is missing.")
        else:
            reason = tr("The right image is missing.")
        return SetUpStep(name, False, reason, "hardware", tr("Search again"))
    if view is None:
        return SetUpStep(name, False, tr("Not connected."), "hardware", tr("Search"))
    if view.unfit is not None:
        return SetUpStep(name, False, notice_text(view.unfit.why), "stereo", tr("Calibrate"))
    return SetUpStep(name, False, tr("No images arrive."), "hardware", tr("Search again"))


def _stereo(view: Snapshot | None, calibration: str) -> SetUpStep:
    name = tr("Camera calibrated")
    if view is None and calibration:
        return SetUpStep(name, True, Path(calibration).name)
    if view is None:
        return SetUpStep(
            name, False, tr("Show a printed board to the camera."), "stereo", tr("Calibrate")
        )
    if not view.setup.camera.calibrated:
        reason = tr("Show a printed board to the camera.")
        return SetUpStep(name, False, reason, "stereo", tr("Calibrate"))
    if view.setup.camera.rig.one_camera:
        return SetUpStep(
            name, True, tr("one camera: distances are only as accurate as the hand size")
        )
    baseline = view.setup.camera.rig.baseline * 1000
    return SetUpStep(name, True, tr("baseline {:.1f} mm").format(local(baseline)))


def _exposure(view: Snapshot | None) -> SetUpStep:
    """Automatic exposure changes the markers' colours. A lock is done only if the camera confirms
    it."""
    name = tr("Exposure locked")
    if view is None or not images_arrive(view):
        return SetUpStep(name, False, tr("Waiting for images."), waits=True)
    if view.setup.simulated or view.setup.player is not None:
        return SetUpStep(name, True, tr("fixed"))
    if view.setup.camera.controls is None:
        words = tr(
            "Cannot be verified: this source has no exposure control. Fix the exposure at the "
            "source itself."
        )
        return SetUpStep(name, False, words, check=True)
    controls = {c.name: c for c in view.setup.camera.controls.controls() if c.available}
    open_ones = [tr(CONTROLS[n]) for n, c in controls.items() if c.is_open and n != "gain"]
    unsure = [tr(CONTROLS[n]) for n, c in controls.items() if c.is_unverified]
    if not controls:
        words = tr("Cannot be verified: this camera has no controls. Keep the light constant.")
        return SetUpStep(name, False, words, check=True)
    if open_ones:
        words = tr("The camera changes {} automatically.").format(", ".join(open_ones))
        return SetUpStep(name, False, words, "lock_camera", tr("Lock it now"))
    if "exposure" not in controls:  # as of a ZED: white balance alone can be locked
        words = tr(
            "Cannot be verified: this camera has no exposure control and may change its exposure "
            "automatically. Keep the light constant."
        )
        return SetUpStep(name, False, words, "camera_setup", tr("Show"), check=True)
    if unsure:
        words = tr("Cannot be verified: the camera does not confirm {}.").format(", ".join(unsure))
        return SetUpStep(name, False, words, "camera_setup", tr("Show"), check=True)
    values = (f"{tr(CONTROLS[n])} {local(c.value):g}" for n, c in controls.items())
    return SetUpStep(name, True, ", ".join(values))


def _light(view: Snapshot | None, light: LightWatch | None) -> SetUpStep:
    """Lamp and exposure must be good; background colours and missed markers are to be checked."""
    name = tr("Light")
    if view is None or not images_arrive(view):
        return SetUpStep(name, False, tr("Waiting for images."), waits=True)
    if light is None or light.reading is None:
        return SetUpStep(name, False, tr("Measuring the light…"), waits=True)
    reading = light.reading
    few = _missed(light) <= FEW_MISSED
    advice = [a for a in reading.advice if not (few and a.kind == "missed")]
    if not advice:
        return SetUpStep(name, True, tr("the markers are clearly visible"))
    hand = [a for a in advice if a.kind == "hand"]
    if hand and reading.good:
        return SetUpStep(name, False, notice_text(hand[0].notice), waits=True)
    words = notice_text(advice[0].notice)
    return SetUpStep(name, False, words, "show_colours", tr("Show"), check=reading.good)


def _missed(light: LightWatch | None) -> float:
    """Share of the markers in the image that are missed; 0 without visible markers."""
    reading = light.reading if light is not None else None
    if reading is None or len(reading.uv) == 0:
        return 0.0
    return len(reading.missed) / len(reading.uv)


def hues_seen(view: Snapshot) -> set[str]:
    """Names of the hues detected in the newest images."""
    if view.blobs is None:
        return set()
    sides = [b for b in (view.blobs.left, view.blobs.right) if b is not None]
    return {view.blobs.hue_names[h] for b in sides for h in b.hue.tolist()}


def _colours(
    view: Snapshot | None, recent: Collection[str] | None, light: LightWatch | None
) -> SetUpStep:
    """Done if every hue of the glove and most markers are detected."""
    name = tr("Colours tuned")
    if view is None or not images_arrive(view):
        return SetUpStep(name, False, tr("Waiting for images."), waits=True)
    if view.blobs is None:
        return SetUpStep(name, False, tr("Searching for markers…"), waits=True)
    tune = ("show_colours", tr("Tune colours"))
    rows = seen_rows(view, view.setup.profile)
    clashing = [display_name(r.name) for r in rows if r.clash]
    if clashing:
        reason = tr("The ranges of {} overlap.").format(", ".join(clashing))
        return SetUpStep(name, False, reason, *tune)
    found = hues_seen(view) if recent is None else set(recent)
    unseen = [display_name(n) for n in view.setup.glove.hues if n not in found]
    away = _tracking(view) != Tracking.TRACKING  # a hand out of view shows no markers
    if not found:
        return SetUpStep(name, False, tr("No markers found."), *tune, waits=away)
    if unseen:
        reason = tr("Not seen: {}. Turn the hand, or tune the colours.").format(", ".join(unseen))
        return SetUpStep(name, False, reason, *tune, waits=away)
    if light is not None and light.reading is not None and _missed(light) > MOST_MISSED:
        missed, there = len(light.reading.missed), len(light.reading.uv)
        reason = tr("{} of {} markers are not found with these colours.").format(missed, there)
        return SetUpStep(name, False, reason, *tune)
    return SetUpStep(
        name, True, tr("seen: {}").format(", ".join(map(display_name, view.setup.glove.hues)))
    )


def _tracking(view: Snapshot | None) -> Tracking | None:
    return view.estimate.tracking if view is not None and view.estimate is not None else None


def _hand(view: Snapshot | None, before: bool) -> SetUpStep:
    """``before``: it was tracked since its devices were connected."""
    name = tr("Hand in view")
    if not (packets_arrive(view) or images_arrive(view)):
        return SetUpStep(name, False, tr("Waiting for glove and camera."), waits=True)
    if _tracking(view) == Tracking.TRACKING:
        return SetUpStep(name, True, tr("tracking"))
    if view is not None and not view.setup.whole:
        return SetUpStep(name, False, tr("Needs glove and calibrated camera."))
    if before:
        return SetUpStep(name, False, tr("The hand was tracked but is not in view now."))
    return SetUpStep(
        name, False, tr("Hold the hand flat, about 35 cm in front of the camera, for two seconds.")
    )


def _calibration(view: Snapshot | None, least: float) -> SetUpStep:
    """``least``: convergence from which on it is settled."""
    name = tr("Calibration settled")
    if view is None or view.calibration is None:
        return SetUpStep(name, False, tr("Waiting for tracking."))
    if view.status is not None and images_alone(view.status):
        return SetUpStep(name, False, tr("Waiting for the glove."), waits=True)
    alone = has_one_camera(view)
    shown = calibration_view(view.calibration, one_camera=alone)
    share = 0.0 if np.isnan(shown.convergence) else shown.convergence
    if share >= least:
        return SetUpStep(name, True, tr("hand length {}").format(shown.hand_length))
    reason = f"{100 * share:.0f} %. {shown.advice}"
    if view.setup.live is not None and not (alone and not is_measured(view.calibration)):
        return SetUpStep(name, False, reason, "guided", tr("Hold poses"))
    return SetUpStep(name, False, reason, "show_calibration", tr("Show"))
