"""Estimates as a Lab Streaming Layer outlet: float32 channels, NaN where lost.

Channels, labelled in the stream's header: per keypoint ``_x _y _z`` (m, G) and ``_state``, or per
OpenXR joint ``_x _y _z _qx _qy _qz _qw _radius`` (m, OpenXR's world) and ``_state``; per angle its
value (rad) and ``_state``; per gesture ``gesture_`` and its name, 0 to 1, and ``_shown``; then
``tracking``. Schema 2 adds ``seq``; per keypoint or joint ``_vx _vy _vz`` (m/s), ``_wx _wy _wz``
(rad/s), ``_v_sd`` and ``_w_sd``; per angle ``_sd``, ``_rate`` and ``_rate_sd``. States are the
numbers of `tracker.messages`. Stamps are the estimates' own instants on LSL's clock; the header's
``clock`` has one instant on that clock and since 1970.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np
import pylsl

from tracker.base.notices import Notice, failure, notice
from tracker.gestures.values import GESTURES
from tracker.hand.openxr import JOINTS
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.payload import FIRST, LATEST, check_schema, moving_points, openxr_of
from tracker.streaming.publisher import Names
from tracker.streaming.shared import Gestures

XYZ = ("x", "y", "z")
QUATERNION = ("qx", "qy", "qz", "qw")
LOCAL_ONLY = "[multicast]\nResolveScope = machine\n"
BUFFER_S = 10  # s of samples kept for a client that does not read


class LslPublisher:
    """An outlet ``Glovetrack right``. Found from this machine only, unless ``network``.

    liblsl cannot bind to loopback: it listens on all addresses, and ``network=False`` only keeps
    the outlet from being announced to other machines. A firewall has to do the rest.
    liblsl reads its settings once per process, at the first use: an outlet made after another part
    of the process used LSL follows the settings that part had.
    """

    def __init__(
        self,
        names: Names,
        network: bool = False,
        schema: int = LATEST,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        check_schema(schema)
        self._names, self._gestures, self._schema = names, names.recogniser(), schema
        if not network:
            pylsl.set_config_content(LOCAL_ONLY)
        pylsl.local_clock()  # the first call loads the settings, which takes 16 ms
        self._offset = pylsl.local_clock() - clock()
        self.name = notice("stream.outlet", stream="LSL", name=f"Glovetrack {names.side}")
        self._outlet: pylsl.StreamOutlet | None = pylsl.StreamOutlet(
            stream_info(names, schema, self._offset), max_buffered=BUFFER_S
        )

    def send(self, estimate: Estimate) -> None:
        if self._outlet is not None:
            row = sample(estimate, self._names, self._gestures, self._schema)
            self._outlet.push_sample(row, estimate.t + self._offset)

    def probe(self) -> Notice:
        """Whether a program reads the outlet; liblsl does not say how many do."""
        if self._outlet is not None and self._outlet.have_consumers():
            return notice("stream.test_read", stream=self.name)
        return failure("stream.test_no_client", stream=self.name)

    def close(self) -> None:
        self._outlet = None  # liblsl ends the outlet when its handle goes


def channels(names: Names, schema: int = LATEST) -> list[tuple[str, str]]:
    """Label and unit of every channel."""
    out: list[tuple[str, str]] = []
    points = JOINTS if names.openxr else names.keypoints
    for n in points:
        out += [(f"{n}_{axis}", "m") for axis in XYZ]
        if names.openxr:
            out += [(f"{n}_{q}", "") for q in QUATERNION] + [(f"{n}_radius", "m")]
        out.append((f"{n}_state", ""))
    for n in names.angles:
        out += [(n, "rad"), (f"{n}_state", "")]
    for n in GESTURES if names.hand is not None else ():
        out += [(f"gesture_{n}", ""), (f"gesture_{n}_shown", "")]
    out.append(("tracking", ""))
    if schema == FIRST:
        return out
    out.append(("seq", ""))
    for n in points:
        out += [(f"{n}_v{axis}", "m/s") for axis in XYZ] + [(f"{n}_w{a}", "rad/s") for a in XYZ]
        out += [(f"{n}_v_sd", "m/s"), (f"{n}_w_sd", "rad/s")]
    for n in names.angles:
        out += [(f"{n}_sd", "rad"), (f"{n}_rate", "rad/s"), (f"{n}_rate_sd", "rad/s")]
    return out


def sample(
    e: Estimate,
    names: Names,
    gestures: Gestures | None = None,
    schema: int = LATEST,
) -> list[float]:
    """One sample in the order of `channels`; NaN where lost. ``gestures`` is fed with it."""
    gestures = gestures or names.recogniser()
    angles = np.where(e.angle_state == Validity.LOST, np.nan, e.angles)
    return [
        *_points(e, names).ravel().tolist(),
        *np.column_stack([angles, e.angle_state]).ravel().tolist(),
        *_gestures(e, gestures),
        float(e.tracking),
        *([] if schema == FIRST else [float(e.seq), *_motion(e, names)]),
    ]


def _motion(e: Estimate, names: Names) -> list[float]:
    """Velocities of each keypoint or joint, then of each angle; NaN where lost or not known."""
    m, lost = e.motion, e.angle_state == Validity.LOST
    points = moving_points(e, names)
    if m is None or points is None:
        count = len(JOINTS) if names.openxr else len(names.keypoints)
        return [math.nan] * (8 * count + 3 * len(names.angles))
    rows = np.column_stack([points.linear, points.angular, points.linear_sd, points.angular_sd])
    angles = np.column_stack([m.angle_sd, m.angle_rate, m.angle_rate_sd])
    angles[lost] = np.nan
    return [*rows.ravel().tolist(), *angles.ravel().tolist()]


def _gestures(e: Estimate, gestures: Gestures | None) -> list[float]:
    """A value and whether it is shown, of each gesture."""
    if gestures is None:
        return []
    gestures.feed(e)
    return [x for n, v in gestures.values.items() for x in (v, float(n in gestures.active))]


def _points(e: Estimate, names: Names) -> Array:
    """A row per keypoint or OpenXR joint."""
    if names.openxr:
        x = openxr_of(e, names)
        return np.column_stack([x.position, x.orientation, x.radius, x.state])
    lost = (e.keypoint_state == Validity.LOST)[:, None]
    return np.column_stack([np.where(lost, np.nan, e.keypoints), e.keypoint_state])


def stream_info(names: Names, schema: int = LATEST, offset: float = 0.0) -> pylsl.StreamInfo:
    """The outlet's header with a label, unit and type per channel. ``offset``: s of LSL's clock at
    zero of the monotonic one."""
    listed = channels(names, schema)
    info = pylsl.StreamInfo(
        f"Glovetrack {names.side}",
        "MoCap",
        len(listed),
        pylsl.IRREGULAR_RATE,
        "float32",
        f"glovetrack-{names.side}",
    )
    node = info.desc().append_child("channels")
    for label, unit in listed:
        child = node.append_child("channel")
        child.append_child_value("label", label)
        child.append_child_value("unit", unit)
    unix_ns = names.wall_ns(0.0)
    if unix_ns is not None and schema != FIRST:
        clock = info.desc().append_child("clock")
        clock.append_child_value("lsl", repr(offset))
        clock.append_child_value("unix_ns", str(unix_ns))
    return info
