"""State and curves of the IMUs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from app.viewmodels.states import BAD, GOOD, IDLE, WARN, StateLook
from app.words import local, mark, tr
from tracker.messages import ImuSample, Status
from tracker.sensors.serial_line import GOOD_LATENCY_MS

LINK_WORDS = {
    "link_cobs_errors": mark("Frames with invalid byte stuffing (COBS)"),
    "link_crc_errors": mark("Frames with a wrong checksum (CRC)"),
    "link_length_errors": mark("Frames of the wrong length"),
    "link_other_errors": mark("Frames of an unknown type or of excessive length"),
    "link_reopened": mark("Times the port was reopened"),
    "glove_resets": mark("Restarts of the glove"),
    "glove_clock_jumps": mark("Jumps of the glove's clock"),
    "glove_dropped": mark("Packets the glove had no time to send"),
    "glove_skew_ppm": mark("Skew of the host's clock against the glove's, ppm"),
    "link_latency_ms": mark("Latency timer of the USB adapter, ms"),
}
"""Display names of counters of the status."""
LINK_ERRORS = tuple(key for key in LINK_WORDS if key.endswith("_errors"))


@dataclass(frozen=True)
class ImuState:
    name: str
    look: StateLook
    text: str


def imu_states(
    names: tuple[str, ...], samples: Sequence[ImuSample], running: bool
) -> list[ImuState]:
    """State of each IMU over the last second: responding, with gaps, or not responding."""
    if not samples or not running:
        return [ImuState(n, IDLE, tr("no samples")) for n in names]
    now = samples[-1].t
    recent = takewhile(lambda sample: sample.t >= now - 1.0, reversed(samples))
    valid = np.array([s.valid for s in recent]).mean(axis=0)
    return [_state(name, float(share)) for name, share in zip(names, valid, strict=True)]


def _state(name: str, share: float) -> ImuState:
    if share > 0.99:
        return ImuState(name, GOOD, tr("responding"))
    if share > 0:
        return ImuState(name, WARN, tr("{:.0f} % missing").format(100 * (1 - share)))
    return ImuState(name, BAD, tr("not responding"))


def jitter_ms(samples: Sequence[ImuSample]) -> float:
    """Standard deviation of the arrival intervals, ms; NaN below three samples."""
    if len(samples) < 3:
        return float("nan")
    arrivals = np.array([s.t_arrival for s in samples[-100:]])
    return float(1000 * np.diff(arrivals).std())


def glove_figures(status: Status | None, samples: Sequence[ImuSample]) -> list[str]:
    """Statistics of the link: rate, loss, jitter, battery, temperature, as far as they are
    known."""
    v = status.values if status is not None else {}
    lost, jitter = v.get("imu_lost"), jitter_ms(samples)
    figures = (
        _figure(v.get("imu_rate_hz"), "{:.1f} Hz"),
        _figure(lost, tr("{:.0f} packet lost") if lost == 1 else tr("{:.0f} packets lost")),
        _figure(jitter, tr("jitter {:.1f} ms")),
        _figure(v.get("battery_v"), _battery_pattern(v)),
        _figure(v.get("temperature_c"), "{:.1f} °C"),
        *_link_figures(v),
    )
    return [f for f in figures if f]


def _battery_pattern(values: Mapping[str, float]) -> str:
    if values.get("battery_low"):
        return tr("⚠ battery low: {:.2f} V")
    return tr("battery {:.2f} V")


def _link_figures(values: Mapping[str, float]) -> list[str]:
    """Errors of the line and the glove's clock; empty without errors."""
    counts = (
        (
            sum(values.get(key, 0.0) for key in LINK_ERRORS),
            tr("1 frame damaged"),
            tr("{} frames damaged"),
        ),
        (
            values.get("glove_dropped", 0.0),
            tr("1 packet dropped by the glove"),
            tr("{} packets dropped by the glove"),
        ),
        (values.get("glove_resets", 0.0), tr("1 restart"), tr("{} restarts")),
        (values.get("link_reopened", 0.0), tr("1 reconnection"), tr("{} reconnections")),
        (
            values.get("glove_clock_jumps", 0.0),
            tr("1 clock jump"),
            tr("{} clock jumps"),
        ),
    )
    latency = values.get("link_latency_ms")
    waits = tr("adapter latency {:.0f} ms")
    if latency is not None and latency > GOOD_LATENCY_MS:
        waits = tr("⚠ adapter latency {:.0f} ms")
    return [
        *(_counted(*count) for count in counts if count[0]),
        _figure(values.get("glove_skew_ppm"), tr("clock {:+.0f} ppm")),
        _figure(latency, waits),
    ]


def _counted(count: float, one: str, many: str) -> str:
    return one if round(count) == 1 else many.format(round(count))


def link_tip(status: Status | None) -> str:
    """All counters of the link by name, for diagnosis."""
    v = status.values if status is not None else {}
    lines = [f"{tr(words)}: {local(v[key]):g}" for key, words in LINK_WORDS.items() if key in v]
    return "\n".join(lines)


def _figure(value: float | None, pattern: str) -> str:
    return "" if value is None or not np.isfinite(value) else pattern.format(local(value))


def finger_angles(joint_names: Sequence[str]) -> dict[str, list[int]]:
    """Columns of each finger's angles, in the order of ``joint_names``."""
    out: dict[str, list[int]] = {}
    for column, name in enumerate(joint_names):
        out.setdefault(name.split("_")[0], []).append(column)
    return out
