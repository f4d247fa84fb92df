"""All values of the connected devices as a tree: whether they can be changed, and whether the
device has confirmed them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any

import numpy as np
import tomli_w

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.viewmodels.names import display_name
from app.words import local, mark, tr
from tracker.base.toml_reader import parse_toml
from tracker.messages import Calibration
from tracker.sensors.camera_controls import Control, Locks
from tracker.sensors.camera_fixed import FixedSetting
from tracker.sensors.glove_report import GloveReport
from tracker.sensors.imu_watch import ImuReport

Value = str | float | int | bool | None
AUTOMATIC = "automatic"
"""The value of a control that the camera sets automatically."""
CONTROLS = {
    "exposure": mark("Exposure"),
    "gain": mark("Gain"),
    "white_balance": mark("White balance"),
}
RATE_TOLERANCE = (
    0.05  # relative difference of a measured rate from the requested one that is accepted
)
NOT_REPORTED = mark("not reported")
LINK_STATES = {
    "unplugged": mark("unplugged"),
    "greeting": mark("waiting for the glove's description"),
    "streaming": mark("receiving packets"),
    "silent": mark("no packets"),
}
"""Texts by the value of a `LinkState`."""


class Confirmed(Enum):
    """How well it is known that a value is that of the device."""

    REPORTED = mark("reported by the device")
    MEASURED = mark("measured")
    FILE = mark("from a file")
    TAKEN = mark("confirmed by the device")
    REFUSED = mark("not confirmed by the device")
    WAITING = mark("not confirmed yet")
    UNKNOWN = NOT_REPORTED


@dataclass(frozen=True)
class DeviceValue:
    """``path``: labels in the tree, from the device to the value. A value that can be changed has
    either all its ``choices`` or ``limits`` (minimum, maximum, step)."""

    key: str
    path: tuple[str, ...]
    value: Value
    unit: str = ""
    confirmed: Confirmed = Confirmed.REPORTED
    changeable: bool = False
    choices: tuple[Value, ...] = ()
    limits: tuple[float, float, float] | None = None
    detail: str = ""

    @property
    def text(self) -> str:
        """The value with its unit."""
        return value_text(self.value, self.unit)


def value_text(value: Value, unit: str = "") -> str:
    """A value as shown in the tree."""
    if value is None or value == "":
        return tr(NOT_REPORTED)
    if isinstance(value, bool):
        return tr("yes") if value else tr("no")
    if value == AUTOMATIC:
        return tr("automatic")
    text = f"{local(value):.4g}" if isinstance(value, float) else str(value)
    return f"{text} {unit}".rstrip()


def device_values(view: Snapshot, requested: Mapping[str, Value]) -> list[DeviceValue]:
    """All values of all devices; ``requested`` are applied changes, by key."""
    out: list[DeviceValue] = []
    for hand in sorted(view.setup.hands, key=lambda h: h.side):
        look = next((v for v in view.hands if v.setup.side == hand.side), view)
        out += _glove(hand, look)
    return [*out, *_camera(view, requested)]


def _entry(
    prefix: str, device: str, group: str, name: str, word: str, value: Value, **more: Any
) -> DeviceValue:
    path = (device, group, word) if group else (device, word)
    unknown = value is None or value == ""
    if unknown and "confirmed" not in more:
        more["confirmed"] = Confirmed.UNKNOWN
    return DeviceValue(f"{prefix}.{name}", path, value, **more)


REPORTED_OF_IMU = ("answers", "chip", "selftest", "temperature_c")
"""Rows of an IMU that the glove reports itself; the others are measured by this program."""
SELFTESTS = (
    mark("passed"),
    mark("not run"),
    mark("accelerometer failed"),
    mark("gyroscope failed"),
    mark("accelerometer and gyroscope failed"),
)
"""What `ImuReport.selftest` may be, for translation."""


def glove_device(side: str) -> str:
    """The key of a glove in the tree."""
    return tr("Left glove") if side == "left" else tr("Right glove")


def _glove(setup: EngineSetup, view: Snapshot) -> list[DeviceValue]:
    prefix, device = f"glove_{setup.side}", glove_device(setup.side)
    report = setup.connection.device.report() if setup.connection.device is not None else None
    out = [
        _entry(
            prefix, device, "", "file", tr("Glove file"), setup.glove.name, confirmed=Confirmed.FILE
        )
    ]
    if report is not None:
        out += [*_link(prefix, device, report), *_chip(prefix, device, report)]
        out += _motors(prefix, device, report)
    elif view.status is not None:
        battery = view.status.values.get("battery_v")
        out.append(_entry(prefix, device, "", "battery_v", tr("Battery"), battery, unit="V"))
    for j, name in enumerate(setup.glove.imu_names):
        out += _imu(prefix, device, j, name, report, view.calibration)
    return out


def _link(prefix: str, device: str, r: GloveReport) -> list[DeviceValue]:
    group, usb = tr("Connection"), r.adapter
    latency = "" if r.latency_ms is not None else tr("Only FTDI adapters on Linux report it.")
    rows: list[tuple[str, str, Value, str]] = [
        ("port", tr("Port"), r.port, ""),
        ("state", tr("State"), tr(LINK_STATES[r.state]), ""),
        ("baud", tr("Speed"), r.baud, "baud"),
        ("adapter", tr("USB adapter"), f"{usb.vid:04x}:{usb.pid:04x}" if usb else None, ""),
        ("adapter_serial", tr("Adapter's serial number"), usb.serial_number if usb else None, ""),
        ("latency_timer_ms", tr("Latency timer"), r.latency_ms, "ms"),
        ("clock_skew_ppm", tr("Clock skew"), r.skew_ppm, "ppm"),
    ]
    return [
        _entry(
            prefix, device, group, name, word, value, unit=unit,
            detail=latency if name == "latency_timer_ms" else "",
        )
        for name, word, value, unit in rows
    ]  # fmt: skip


def _chip(prefix: str, device: str, r: GloveReport) -> list[DeviceValue]:
    group = tr("Glove")
    battery = r.battery_mV / 1000 if r.battery_mV is not None else None
    temperature = r.temperature_cC / 100 if r.temperature_cC is not None else None
    firmware = ".".join(map(str, r.firmware)) if r.firmware else None
    rows: list[tuple[str, str, Value, str]] = [
        ("serial_number", tr("Serial number"), r.glove_id, ""),
        ("firmware", tr("Firmware"), firmware, ""),
        ("protocol", tr("Protocol version"), r.protocol, ""),
        ("gyro_range_dps", tr("Range of angular rate"), r.gyro_range_dps, "°/s"),
        ("accel_range_g", tr("Range of acceleration"), r.accel_range_g, "g"),
        ("battery_v", tr("Battery"), battery, "V"),
        ("temperature_c", tr("Temperature"), temperature, "°C"),
    ]
    found = [_entry(prefix, device, group, n, w, v, unit=u) for n, w, v, u in rows]
    measured = round(r.rate_hz, 2) if r.rate_hz is not None else None
    rate = _entry(
        prefix, device, group, "rate_hz", tr("Sample rate"), r.requested_rate_hz,
        unit="Hz", changeable=True, choices=r.rates_hz, confirmed=rate_state(r),
        detail=tr("measured {}").format(value_text(measured, "Hz")),
    )  # fmt: skip
    own = _entry(
        prefix, device, group, "measured_rate_hz", tr("Measured sample rate"), measured,
        unit="Hz", confirmed=Confirmed.MEASURED if measured else Confirmed.UNKNOWN,
    )  # fmt: skip
    return [*found, rate, own]


def rate_state(r: GloveReport) -> Confirmed:
    """The protocol does not acknowledge RATE: the time stamps of the packets show the rate."""
    if r.rate_hz is None:
        return Confirmed.WAITING
    taken = abs(r.rate_hz / r.requested_rate_hz - 1) <= RATE_TOLERANCE
    return Confirmed.TAKEN if taken else Confirmed.REFUSED


def _motors(prefix: str, device: str, r: GloveReport) -> list[DeviceValue]:
    group = tr("Motors")
    count = _entry(prefix, device, group, "motors", tr("Number"), r.motors)
    runs = [
        DeviceValue(
            f"{prefix}.motor_{k}", (device, group, tr("Motor {}").format(k + 1)), None,
            confirmed=Confirmed.UNKNOWN,
            detail=tr("The protocol does not report whether a motor runs."),
        )
        for k in range(r.motors)
    ]  # fmt: skip
    return [count, *runs]


def _imu(
    prefix: str,
    device: str,
    j: int,
    name: str,
    report: GloveReport | None,
    calibration: Calibration | None,
) -> list[DeviceValue]:
    group, word = tr("IMUs"), display_name(name)
    answers = report.imu_ok[j] if report is not None and j < len(report.imu_ok) else None
    rows: list[tuple[str, str, Value, str, Confirmed | None]] = [
        ("answers", tr("Responding"), answers, "", None),
        *_imu_report(report.imus[j] if report is not None and j < len(report.imus) else None),
        ("gyro_bias", tr("Bias of angular rate"), _bias(calibration, name, "gyro"), "°/s", None),
        ("accel_bias", tr("Bias of acceleration"), _bias(calibration, name, "accel"), "m/s²", None),
    ]
    out = []
    for own, text, value, unit, _ in rows:
        known = Confirmed.UNKNOWN if value is None else Confirmed.REPORTED
        confirmed = known if own in REPORTED_OF_IMU or value is None else Confirmed.MEASURED
        path = (device, group, word, text)
        out.append(DeviceValue(f"{prefix}.{name}_{own}", path, value, unit, confirmed))
    return out


def _imu_report(
    imu: ImuReport | None,
) -> list[tuple[str, str, Value, str, Confirmed | None]]:
    """The glove's report on an IMU, and a summary of its packets."""
    if imu is None:
        return []
    celsius = imu.temperature_cC / 100 if imu.temperature_cC is not None else None
    return [
        ("chip", tr("Chip"), imu.chip or None, "", None),
        ("selftest", tr("Self-test"), tr(imu.selftest) if imu.selftest else None, "", None),
        ("temperature_c", tr("Temperature"), celsius, "°C", None),
        ("saturated", tr("Saturated samples"), imu.saturated, "", None),
        ("stuck", tr("Stuck axes"), ", ".join(imu.stuck) or tr("none"), "", None),
    ]


def _bias(calibration: Calibration | None, segment: str, kind: str) -> str | None:
    """x, y, z ± sd of the estimated bias; None if it is not estimated."""
    if calibration is None or segment not in calibration.segments:
        return None
    row = calibration.segments.index(segment)
    bias, sd = (
        getattr(calibration, f"{kind}_bias")[row],
        getattr(calibration, f"{kind}_bias_sd")[row],
    )
    if not np.isfinite(bias).all():
        return None
    if kind == "gyro":
        bias, sd = np.rad2deg(bias), np.rad2deg(sd)
    return ", ".join(f"{local(b):.2f} ± {local(s):.2f}" for b, s in zip(bias, sd, strict=True))


def _camera(view: Snapshot, requested: Mapping[str, Value]) -> list[DeviceValue]:
    setup = view.setup
    if not setup.camera.present:
        return []
    prefix, device = "camera", tr("Camera")
    controls = setup.camera.controls
    out = [_entry(prefix, device, "", "name", tr("Name"), setup.camera.name)]
    image = view.frame.left if view.frame is not None else None
    size = f"{image.shape[1]} × {image.shape[0]}" if image is not None else None
    rate = view.status.values.get("frame_rate_hz") if view.status is not None else None
    requested_rate = setup.camera.device.fps if setup.camera.device is not None else None
    calibration = setup.camera.calibration_file or (
        tr("in the recording") if setup.player is not None and setup.camera.calibrated else None
    )
    measured = Confirmed.MEASURED if rate is not None else Confirmed.UNKNOWN
    out += [
        _entry(prefix, device, "", "image_size", tr("Size of one image"), size, unit="px"),
        _entry(prefix, device, "", "granted_fps", tr("Negotiated rate"), requested_rate, unit="Hz"),
        _entry(prefix, device, "", "fps", tr("Rate measured"), rate, unit="Hz", confirmed=measured),
        _entry(
            prefix, device, "", "calibration", tr("Calibration"), calibration,
            confirmed=Confirmed.FILE if calibration else Confirmed.UNKNOWN,
        ),
    ]  # fmt: skip
    for k, report in enumerate(controls.reports() if controls is not None else ()):
        own, group = f"device_{k + 1}_", tr("Device {}").format(k + 1)
        rows: list[tuple[str, str, Value]] = [
            ("path", tr("Path"), report.path),
            ("serial_number", tr("Serial number"), report.serial_number),
            ("pixel_format", tr("Pixel format"), report.pixel_format),
            ("size", tr("Negotiated size"), f"{report.width} × {report.height}"),
            ("driver", tr("Driver"), report.backend),
        ]
        out += [_entry(prefix, device, group, own + n, w, v) for n, w, v in rows]
    return [
        *out,
        *(_control(c, requested) for c in (controls.controls() if controls is not None else ())),
        *(_fixed(s) for s in (controls.fixed() if controls is not None else ())),
    ]


def _fixed(setting: FixedSetting) -> DeviceValue:
    """A setting that the program makes itself."""
    words = {
        "power_line": tr("Power-line frequency"),
        "autofocus": tr("Autofocus"),
        "zoom": tr("Digital zoom"),
        "mirror": tr("Mirrored"),
        "flip": tr("Upside down"),
    }
    value: Value = bool(setting.found)
    if setting.name == "zoom":
        value = setting.found
    elif setting.name == "power_line":
        value = {0: tr("off"), 1: "50 Hz", 2: "60 Hz"}.get(setting.found, AUTOMATIC)
    return DeviceValue(
        f"camera.{setting.name}",
        (tr("Camera"), tr("Controls"), words[setting.name]),
        value,
        confirmed=Confirmed.TAKEN if setting.is_verified else Confirmed.REFUSED,
    )


def _control(control: Control, requested: Mapping[str, Value]) -> DeviceValue:
    key = f"camera.{control.name}"
    wanted = requested.get(key)
    value: Value = control.value if control.locked else AUTOMATIC
    confirmed = Confirmed.TAKEN if control.locked else Confirmed.REPORTED
    if control.is_unverified:
        confirmed = Confirmed.REFUSED
    if wanted is not None and wanted != value:
        value, confirmed = wanted, Confirmed.REFUSED
    limits, detail = None, tr("limits not reported")
    if control.limits is not None:
        least, greatest, step, default = control.limits
        limits = (least, greatest, step)
        shown = [f"{local(value):g}" for value in (least, greatest, default)]
        detail = tr("{} to {}, default {}").format(*shown)
    if not control.locked and control.available:
        detail = f"{tr('now {}').format(f'{local(control.value):g}')}; {detail}"
    return DeviceValue(
        key, (tr("Camera"), tr("Controls"), tr(CONTROLS[control.name])),
        value if control.available else None,
        confirmed=confirmed if control.available else Confirmed.UNKNOWN,
        changeable=control.available, choices=(AUTOMATIC,), limits=limits, detail=detail,
    )  # fmt: skip


def locks_of(values: Iterable[DeviceValue], edits: Mapping[str, Value]) -> Locks:
    """The camera locks, including ``edits``."""
    wanted: dict[str, float | None] = {}
    for value in values:
        device, _, name = value.key.partition(".")
        if device == "camera" and name in CONTROLS:
            now = edits.get(value.key, value.value)
            wanted[name] = float(now) if isinstance(now, float | int) else None
    return Locks(**wanted)


def is_allowed(value: DeviceValue, wanted: Value) -> bool:
    """Whether a value can be changed to ``wanted``."""
    if not value.changeable:
        return False
    if wanted in value.choices:
        return True
    if value.choices != (AUTOMATIC,) or isinstance(wanted, bool | str) or wanted is None:
        return False
    return value.limits is None or value.limits[0] <= wanted <= value.limits[1]


# --- files


def to_file(values: Sequence[DeviceValue]) -> str:
    """TOML with a table for each device and a key for each known value."""
    tables: dict[str, dict[str, Any]] = {}
    for value in values:
        device, _, name = value.key.partition(".")
        if value.value is not None and value.value != "":
            tables.setdefault(device, {})[name] = value.value
    return tomli_w.dumps(tables)


@dataclass(frozen=True)
class DeviceDifference:
    """A value of a file that differs from the device's; ``now`` is None if the device has none."""

    key: str
    name: str
    stored: Value
    now: Value
    can_apply: bool


LIVE = ("battery_v", "temperature_c", "state", "fps", "measured_rate_hz", "clock_skew_ppm")
"""Measurements that change continuously and are not settings."""


def differences(text: str, name: str, values: Sequence[DeviceValue]) -> list[DeviceDifference]:
    """Differences between a file and ``values``. Raises FileError for an invalid file."""
    known = {value.key: value for value in values}
    out = []
    for device, table in parse_toml(text, name).items():
        for own, stored in table.items() if isinstance(table, dict) else ():
            key = f"{device}.{own}"
            value = known.get(key)
            if own in LIVE or own.endswith("_bias"):
                continue
            now = value.value if value is not None else None
            if now != stored:
                words = " – ".join(value.path) if value is not None else key
                fits = value is not None and is_allowed(value, stored)
                out.append(DeviceDifference(key, words, stored, now, fits))
    return out


def is_motor(value: DeviceValue) -> bool:
    """Whether the value is a motor that can be run."""
    return value.key.partition(".")[2].startswith("motor_")


def motor_of(key: str) -> tuple[str, int]:
    """Side and channel of a motor's key."""
    device, _, name = key.partition(".")
    return device.removeprefix("glove_"), int(name.removeprefix("motor_"))


def report_of(found: Sequence[DeviceDifference], name: str) -> str:
    """The differences of a file as sentences."""
    if not found:
        return tr("{} matches the current device settings.").format(name)
    changed = [d for d in found if d.can_apply]
    lines = [tr("{}: {} differences, {} to be applied.").format(name, len(found), len(changed))]
    for d in found:
        word = tr("will be applied") if d.can_apply else tr("cannot be changed")
        line = tr("{}: {} in the file, {} now ({})")
        lines.append(line.format(d.name, value_text(d.stored), value_text(d.now), word))
    return "\n".join(lines)
