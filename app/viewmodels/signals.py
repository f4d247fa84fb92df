"""The signals that curves can show: their names, units and columns.

A signal is one column of the rows that `app.viewmodels.signal_rows` computes from messages. Its key
is stable, since the settings contain it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.gestures import WORDS as GESTURE_WORDS
from app.viewmodels.names import display_name
from app.words import mark, tr
from tracker import GRAVITY
from tracker.gestures.values import GESTURES

AXES = ("x", "y", "z")
DEGREES = float(np.rad2deg(1.0))
MM = 1000.0


class SignalSource(Enum):
    """The messages that a signal is computed from; the value is part of its key."""

    IMU = "imu"
    HAND = "hand"
    GESTURES = "gestures"
    IMAGES = "images"
    STATUS = "status"


class SignalMeasure(Enum):
    """The quantity computed from a column: itself, the norm of a vector, or the norm of its
    derivative."""

    VALUE = "value"
    NORM = "norm"
    SPEED = "speed"
    RATE = "rate"  # derivative of a number


@dataclass(frozen=True)
class Signal:
    """``path``: labels in the tree, from the hand to the signal; ``label``: name in a legend.

    ``index``: position in the column's row; ``factor`` converts from SI to ``unit``.
    """

    side: str
    source: SignalSource
    name: str
    path: tuple[str, ...]
    label: str
    column: str
    index: tuple[int, ...] = ()
    unit: str = ""
    factor: float = 1.0
    measure: SignalMeasure = SignalMeasure.VALUE

    @property
    def key(self) -> str:
        """As stored in the settings."""
        return f"{self.side}/{self.source.value}/{self.name}"


STATUS_WORDS = {
    "imu_rate_hz": mark("packets per second"),
    "frame_rate_hz": mark("images per second"),
    "estimate_rate_hz": mark("estimates per second"),
    "latency_total_ms": mark("latency, image to estimate"),
    "latency_imu_ms": mark("latency, packet to estimate"),
    "latency_detect_ms": mark("search of both images"),
    "latency_filter_ms": mark("engine step"),
    "latency_screen_ms": mark("latency, sample to screen"),
    "latency_stream_ms": mark("latency, sample to streams"),
    "imu_lost": mark("packets lost"),
    "frames_dropped": mark("images dropped"),
    "images_missed": mark("share of images missed"),
    "load_shed": mark("overload level"),
    "battery_v": mark("battery voltage"),
    "temperature_c": mark("temperature of the glove"),
    "camera_offset_ms": mark("delay of the camera"),
    "glove_skew_ppm": mark("clock skew of the glove"),
    "link_latency_ms": mark("latency timer of the USB adapter"),
    "stereo_points": mark("markers in both images"),
    "heading_sd_deg": mark("uncertainty of the heading"),
}
"""Display names of status values; others are listed by their key."""
STATUS_UNITS = {"hz": "Hz", "ms": "ms", "v": "V", "c": "°C", "ppm": "ppm", "deg": "°", "px": "px"}
"""By the last word of a value's name."""


def signals(setup: EngineSetup, figures: Iterable[str] = ()) -> list[Signal]:
    """All signals of the hands of ``setup``; ``figures`` are the names of the status values."""
    hands = sorted(setup.hands, key=lambda hand: hand.side)
    out: list[Signal] = []
    for hand in hands:
        prefix = f"{_side(hand.side)} " if len(hands) > 1 else ""
        for signal in _of_hand(hand, figures):
            out.append(signal if not prefix else _prefixed(signal, prefix))
    return out


def _prefixed(signal: Signal, prefix: str) -> Signal:
    return Signal(**{**vars(signal), "label": prefix + signal.label})


def _side(side: str) -> str:
    return tr("left") if side == "left" else tr("right")


def _of_hand(setup: EngineSetup, figures: Iterable[str]) -> list[Signal]:
    found = [*_imus(setup), *_angles(setup), *_keypoints(setup), *_gestures(setup)]
    return [*found, *_images(setup), *_status(setup, figures)]


def _hand_word(setup: EngineSetup) -> str:
    return tr("Left hand") if setup.side == "left" else tr("Right hand")


def imu_signals(side: str, imu: int, name: str, hand: str = "") -> list[Signal]:
    """Angular rate and acceleration of one IMU: x, y, z and norm of each."""
    kinds = (
        ("gyro", tr("angular rate"), "°/s", DEGREES),
        ("accel", tr("acceleration"), "g", 1 / GRAVITY),
    )
    out = []
    for column, word, unit, factor in kinds:
        for k, axis in enumerate((*AXES, tr("norm"))):
            is_norm = k == len(AXES)
            out.append(
                Signal(
                    side=side,
                    source=SignalSource.IMU,
                    name=f"{name}/{column}/{'norm' if is_norm else axis}",
                    path=(hand, tr("IMUs"), display_name(name), word, axis),
                    label=f"{display_name(name)} {word} {axis}",
                    column=column,
                    index=(imu,) if is_norm else (imu, k),
                    unit=unit,
                    factor=factor,
                    measure=SignalMeasure.NORM if is_norm else SignalMeasure.VALUE,
                )
            )
    return out


def _imus(setup: EngineSetup) -> list[Signal]:
    hand, out = _hand_word(setup), []
    for i, name in enumerate(setup.glove.imu_names):
        out += imu_signals(setup.side, i, name, hand)
    return out


def angle_signal(side: str, column: int, name: str, hand: str = "", speed: bool = False) -> Signal:
    """A joint angle in degrees, or its change per second."""
    first, _, rest = name.partition("_")
    group = tr("Joint speeds") if speed else tr("Joint angles")
    label = f"{display_name(name)} {tr('speed')}" if speed else display_name(name)
    return Signal(
        side=side,
        source=SignalSource.HAND,
        name=f"{'speed' if speed else 'angle'}/{name}",
        path=(hand, group, display_name(first), display_name(rest)),
        label=label,
        column="angles",
        index=(column,),
        unit="°/s" if speed else "°",
        factor=DEGREES,
        measure=SignalMeasure.RATE if speed else SignalMeasure.VALUE,
    )


def _angles(setup: EngineSetup) -> list[Signal]:
    hand, names = _hand_word(setup), list(enumerate(setup.hand.joint_names))
    return [
        angle_signal(setup.side, j, n, hand, speed) for speed in (False, True) for j, n in names
    ]


def _keypoints(setup: EngineSetup) -> list[Signal]:
    hand, out = _hand_word(setup), []
    for k, name in enumerate(setup.glove.keypoint_names(setup.hand)):
        kinds = [
            *(
                (axis, axis, "points", (k, i), "mm", SignalMeasure.VALUE)
                for i, axis in enumerate(AXES)
            ),
            ("speed", tr("speed"), "points", (k,), "mm/s", SignalMeasure.SPEED),
            ("sd", tr("standard deviation"), "sd", (k,), "mm", SignalMeasure.VALUE),
        ]
        out += [
            Signal(
                side=setup.side,
                source=SignalSource.HAND,
                name=f"point/{name}/{own}",
                path=(hand, tr("Keypoints"), display_name(name), word),
                label=f"{display_name(name)} {word}",
                column=column,
                index=index,
                unit=unit,
                factor=MM,
                measure=measure,
            )
            for own, word, column, index, unit, measure in kinds
        ]
    return out


def _gestures(setup: EngineSetup) -> list[Signal]:
    hand = _hand_word(setup)
    return [
        Signal(
            side=setup.side,
            source=SignalSource.GESTURES,
            name=name,
            path=(hand, tr("Gestures"), tr(GESTURE_WORDS[name])),
            label=tr(GESTURE_WORDS[name]),
            column=name,
            unit="%",
            factor=100.0,
        )
        for name in GESTURES
    ]


def _images(setup: EngineSetup) -> list[Signal]:
    """Replays have no predictions: their residuals are those of the recorded estimates."""
    if not setup.camera.present:
        return []
    of = tr("of the estimate") if setup.player is not None else tr("of the prediction")
    rows = (
        ("blobs_left", tr("blobs, left"), ""),
        ("blobs_right", tr("blobs, right"), ""),
        ("matched_left", tr("matched markers, left"), ""),
        ("matched_right", tr("matched markers, right"), ""),
        ("matched_both", tr("matched markers, both images"), ""),
        ("residual_left", tr("residual {}, left (RMS)").format(of), "px"),
        ("residual_right", tr("residual {}, right (RMS)").format(of), "px"),
    )
    hand = _hand_word(setup)
    return [
        Signal(setup.side, SignalSource.IMAGES, n, (hand, tr("Images"), word), word, n, unit=unit)
        for n, word, unit in rows
    ]


def _status(setup: EngineSetup, figures: Iterable[str]) -> list[Signal]:
    hand, group = _hand_word(setup), tr("Rates, latency and battery")
    known = [n for n in STATUS_WORDS if n in set(figures)]
    others = sorted(set(figures) - set(known))
    tracking = tr("tracking state (0 to 3)")
    out = [
        Signal(
            setup.side, SignalSource.HAND, "tracking", (hand, group, tracking), tracking, "state"
        )
    ]
    for name in (*known, *others):
        word = tr(STATUS_WORDS[name]) if name in STATUS_WORDS else name
        unit = STATUS_UNITS.get(name.rsplit("_", 1)[-1], "")
        path = (hand, group, word)
        out.append(Signal(setup.side, SignalSource.STATUS, name, path, word, name, unit=unit))
    return out


def matches(signal: Signal, words: Sequence[str]) -> bool:
    """Whether each of ``words`` (case-folded) occurs in the path or label of a signal."""
    text = " ".join(signal.path).casefold()
    return all(word in text for word in words)
