"""Exports a session as a Motion-BIDS data set with two tracking systems: the estimated hand and the
recorded IMUs (bids-specification.readthedocs.io, Motion)."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tracker import __version__
from tracker.messages import Array
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.raw_imu import MARKS, RawImu, read_notes, read_raw_imu
from tracker.session.reader import SessionReader

VERSION = "1.10.0"
TASK = "movement"
_IMU = {"acc": ("ACCEL", "m/s^2"), "gyr": ("GYRO", "rad/s")}
_TYPES = ("POS", "ORNT", "JNTANG", "ACCEL", "GYRO", "MAGN", "VEL", "ANGACCEL", "LATENCY", "MISC")
"""Types of channels whose counts are stated, including zero."""


class MotionChannel(NamedTuple):
    """A column of a motion file, as described in ``_channels.tsv``."""

    name: str
    component: str
    type: str
    tracked_point: str
    units: str


Scan = tuple[str, str]
"""A motion file relative to its subject or session, and when it begins (UTC)."""


class System(NamedTuple):
    """A tracking system: values (N, C), one row per ``1 / rate`` s except in gaps; ``duration`` in
    s from the first row to the end of the last row's period."""

    name: str
    title: str
    rate: float
    channels: list[MotionChannel]
    values: Array
    duration: float


@dataclass(frozen=True)
class Entities:
    """What a recording is in a data set: labels of letters and digits; ``session`` and ``run`` may
    be empty and 0. ``description`` of the task."""

    subject: str
    session: str = ""
    task: str = TASK
    run: int = 0
    description: str = "Movement of a hand wearing a sensor glove"

    @property
    def folder(self) -> Path:
        """For the subject or the session, relative to the data set."""
        session = f"ses-{self.session}" if self.session else ""
        return Path(f"sub-{self.subject}", session)

    @property
    def above(self) -> str:
        """Name of the subject or the session, for files about all its recordings."""
        return f"sub-{self.subject}" + (f"_ses-{self.session}" if self.session else "")

    def stem(self, tracksys: str = "") -> str:
        """Name of a file of this recording up to its suffix."""
        system = f"_tracksys-{tracksys}" if tracksys else ""
        run = f"_run-{self.run:02}" if self.run else ""
        return f"{self.above}_task-{self.task}{system}{run}"


def export_bids(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write the data set to the new folder ``path``. Lost values are ``n/a``."""
    m = load_series(reader, options, even=True)
    who = "" if "participant" in options.anonymous else m.info.participant
    entities = Entities(re.sub(r"[^A-Za-z0-9]", "", who) or "01")
    scans = _add(reader, m, path, entities, options)
    write_scans(path, entities, scans)
    write_top(path, {entities.subject: m.info.side})
    return m


def add_recording(
    reader: SessionReader, path: Path, entities: Entities, options: ExportOptions
) -> list[Scan]:
    """Write the files of one recording into the data set at ``path``; returns its scans. To be
    completed by `write_scans` for each session, and `write_top`."""
    return _add(reader, load_series(reader, options, even=True), path, entities, options)


def _add(
    reader: SessionReader, m: EstimateSeries, path: Path, entities: Entities, options: ExportOptions
) -> list[Scan]:
    folder = path / entities.folder / "motion"
    folder.mkdir(parents=True, exist_ok=True)
    systems = [_hand(m, options.units or "m")]
    raw = read_raw_imu(reader, need=False)
    if len(raw) > 1:
        systems.append(_imu(raw, m))
    for system in systems:
        _write(folder / entities.stem(system.name), system, m, entities)
    if "notes" not in options.anonymous:
        _events(folder / f"{entities.stem()}_events", reader, m)
    when = datetime.fromtimestamp(int(m.stamp_ns[0]) * 1e-9, UTC).isoformat(timespec="microseconds")
    time = when.replace("+00:00", "Z") if "time" not in options.anonymous else "n/a"
    return [(f"motion/{entities.stem(s.name)}_motion.tsv", time) for s in systems]


def _hand(m: EstimateSeries, unit: str) -> System:
    channels, columns = [], []
    for k, point in enumerate(m.keypoint_names):
        for c, axis in enumerate("xyz"):
            channels.append(MotionChannel(f"{point}_POS_{axis}", axis, "POS", point, unit))
            columns.append(m.keypoints[:, k, c] * UNITS[unit])
        for c, axis in enumerate("xyzw"):
            name = f"{point}_ORNT_{axis}"
            channels.append(MotionChannel(name, f"quat_{axis}", "ORNT", point, "n/a"))
            columns.append(m.q[:, k, c])
    for j, name in enumerate(m.joint_names):
        channels.append(MotionChannel(name, "n/a", "JNTANG", name.rsplit("_", 1)[0], "rad"))
        columns.append(m.angles[:, j])
    values = np.array(columns).T
    return System("hand", "Glovetrack, fused hand", m.rate, channels, values, len(values) / m.rate)


def _imu(raw: RawImu, m: EstimateSeries) -> System:
    """All axes of all IMUs, and the latency of each packet relative to the hand's first row."""
    names, values = raw.channels()
    channels = [MotionChannel("latency", "n/a", "LATENCY", "n/a", "s")]
    for name in names:
        imu, what, axis = name.rsplit("_", 2)
        kind, unit = _IMU[what]
        channels.append(MotionChannel(name, axis, kind, imu, unit))
    latency = (raw.stamp_ns - (m.stamp_ns[0] + m.zero_ns)) * 1e-9
    table = np.column_stack([latency, values])
    duration = float(latency[-1] - latency[0]) + 1.0 / raw.rate
    return System("imu", "Glovetrack, inertial sensors", raw.rate, channels, table, duration)


def _write(stem: Path, system: System, m: EstimateSeries, entities: Entities) -> None:
    with Path(f"{stem}_motion.tsv").open("w", encoding="utf-8", newline="\n") as out:
        for row in system.values:
            out.write("\t".join("n/a" if np.isnan(v) else f"{v:.9g}" for v in row) + "\n")
    head = (*MotionChannel._fields, "sampling_frequency", "reference_frame")
    rate = f"{system.rate:.9g}"
    rows = [(*c, rate, _frame(c)) for c in system.channels]
    _table(Path(f"{stem}_channels.tsv"), head, rows)
    used = sorted({_frame(c) for c in system.channels} - {"n/a"})
    frames = {f: _FRAMES[f].format(axes=m.notes["axes_are"]) for f in used}
    reference = {"reference_frame": {"Description": "Frame of the axes", "Levels": frames}}
    _json(Path(f"{stem}_channels.json"), reference)
    types = [c.type for c in system.channels]
    counts = {f"{t}ChannelCount": types.count(t) for t in _TYPES}
    points = {c.tracked_point for c in system.channels} - {"n/a"}
    sidecar = {
        "TaskName": entities.task,
        "TaskDescription": entities.description,
        "SamplingFrequency": round(system.rate, 6),
        "SamplingFrequencyEffective": round(len(system.values) / system.duration, 6),
        "MotionChannelCount": len(types),
        **counts,
        "TrackedPointsCount": len(points),
        "TrackingSystemName": system.title,
        "RecordingType": "continuous",
        "RecordingDuration": round(system.duration, 6),
        "SoftwareVersions": f"Glovetrack {__version__}",
        "MissingValues": "n/a",
    }
    _json(Path(f"{stem}_motion.json"), sidecar)


_FRAMES = {
    "world": "World of the recording: {axes}. Quaternions are those of the bone that begins at the "
    "point: x along the bone to its tip, z out of the back of the hand.",
    "sensor": "The sensor's axes; accelerations are specific force.",
    "joint": "Abduction about z, then flexion about y, then twist about x of the turned axes; "
    "flexion is positive towards the palm.",
}


def _frame(c: MotionChannel) -> str:
    known = {"POS": "world", "ORNT": "world", "JNTANG": "joint", "LATENCY": "n/a"}
    return known.get(c.type, "sensor")


def write_top(
    path: Path,
    sides: Mapping[str, str],
    name: str = "Hand movement tracked with a sensor glove",
    more: str = "",
) -> None:
    """Write the files about the whole data set; ``sides``: the hand of each subject by label;
    ``more``: a paragraph of its README."""
    description = {
        "Name": name,
        "BIDSVersion": VERSION,
        "DatasetType": "raw",
        "GeneratedBy": [{"Name": "Glovetrack", "Version": __version__}],
    }
    _json(path / "dataset_description.json", description)
    text = (
        "Exported by Glovetrack. `tracksys-hand` contains the estimated hand, `tracksys-imu` the "
    )
    text += "measurements of the glove's inertial sensors.\n"
    (path / "README.md").write_text(text + (f"\n{more}\n" if more else ""), "utf-8")
    rows = [(f"sub-{subject}", side) for subject, side in sides.items()]
    _table(path / "participants.tsv", ("participant_id", "hand"), rows)
    columns = {"hand": {"Description": "Hand with the glove", "Levels": {

        "left": "left hand", "right": "right hand"}}}  # fmt: skip
    _json(path / "participants.json", columns)


def _events(stem: Path, reader: SessionReader, m: EstimateSeries) -> None:
    """Write notes with times in s from the hand's first row; without notes no file is written."""
    zero = int(m.stamp_ns[0]) + m.zero_ns
    rows = [
        (f"{(t - zero) * 1e-9:.6f}", "0", " ".join(text.split()) or "n/a")
        for t, text in sorted(read_notes(reader, MARKS))
    ]
    if rows:
        _table(stem.with_suffix(".tsv"), ("onset", "duration", "trial_type"), rows)
        columns = {"trial_type": {"Description": "Note of the experimenter"}}
        _json(stem.with_suffix(".json"), columns)


def write_scans(path: Path, entities: Entities, scans: Sequence[Scan]) -> None:
    """Write the list of all recordings of a subject's session."""
    name = f"{entities.above}_scans.tsv"
    _table(path / entities.folder / name, ("filename", "acq_time"), scans)


def _table(path: Path, head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> None:
    lines = ["\t".join(row) for row in (head, *rows)]
    path.write_text("\n".join(lines) + "\n", "utf-8")


def _json(path: Path, value: dict[str, Any]) -> None:
    path.write_text(json.dumps(value, indent=2) + "\n", "utf-8")
