"""Glove files (TOML, schema 1)."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import numpy as np

from tracker.base.notices import notice
from tracker.base.toml_reader import TomlTable, read_text, read_toml
from tracker.geometry import so3
from tracker.glove.model import (
    GloveModel,
    Imu,
    ImuAxes,
    ImuDrift,
    ImuNoise,
    ImuVibration,
    Keypoint,
    Marker,
)
from tracker.hand.model import HandModel
from tracker.hand.names import KEYPOINTS

LARGEST_AXIS_ERROR = 0.1
"""For a correction of scale and axes: three times the data sheet's tolerance of an MPU-9250."""


def load_glove(path: Path, hand: HandModel) -> GloveModel:
    """Read a glove file for ``hand``. Raises FileError with file, key and line."""
    return parse_glove(read_text(Path(path)), hand, str(path))


def glove_hand_name(text: str, name: str = "glove.toml") -> str:
    """Name of the hand that a glove file's positions refer to."""
    return read_toml(text, name).text("hand")


def parse_glove(text: str, hand: HandModel, name: str = "glove.toml") -> GloveModel:
    """A glove from the text of its file; segments are those of ``hand``."""
    root = read_toml(text, name)
    if root.integer("schema") != 1:
        raise root.fail("schema", notice("toml.schema", expected=1))
    glove_name = root.text("name")
    side = root.text("side", among=("right", "left"))
    if side != hand.side:
        raise root.fail(
            "side", notice("glove.file_side", side=side, hand=hand.name, hand_side=hand.side)
        )
    hand_name = root.text("hand")
    imus = tuple(_imu(t, hand) for t in root.table_list("imu"))
    _distinct(root, "imu", [i.name for i in imus])
    _one_imu_each(root, [i.segment for i in imus])
    markers = tuple(_marker(t, hand) for t in root.table_list("marker"))
    _distinct(root, "marker", [str(m.id) for m in markers])
    if sorted(m.id for m in markers) != list(range(len(markers))):
        raise root.fail("marker", notice("toml.ids", last=len(markers) - 1))
    markers = tuple(sorted(markers, key=lambda m: m.id))
    keypoints = tuple(_keypoint(root, n, t, hand) for n, t in root.tables("keypoints").items())
    root.finish()
    return GloveModel(glove_name, side, hand_name, imus, markers, keypoints)


def _distinct(root: TomlTable, key: str, names: list[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            raise root.fail(key, notice("glove.file_twice", name=name))


def _one_imu_each(root: TomlTable, segments: list[str]) -> None:
    for segment in segments:
        if segments.count(segment) > 1:
            raise root.fail("imu", notice("glove.file_two_imus", segment=segment))


def _imu(t: TomlTable, hand: HandModel) -> Imu:
    imu = Imu(
        name=t.name("name"),
        segment=t.text("segment", among=hand.segment_names),
        position=t.vector("position", 3, limit=0.5),
        R_BI=so3.matrix_from_quat(t.unit("orientation_xyzw", 4)),
        noise=_noise(t.table("noise")) if t.has("noise") else None,
        drift=_drift(t.table("drift")) if t.has("drift") else None,
        axes=_axes(t.table("axes")) if t.has("axes") else None,
        vibration=_vibration(t.table("vibration")) if t.has("vibration") else None,
    )
    t.finish()
    return imu


def _noise(t: TomlTable) -> ImuNoise:
    noise = ImuNoise(
        gyro=t.number("gyro", low=0.0, high=1.0),
        accel=t.number("accel", low=0.0, high=10.0),
        gyro_bias=t.number("gyro_bias", 0.0, low=0.0, high=1.0),
        accel_bias=t.number("accel_bias", 0.0, low=0.0, high=10.0),
    )
    t.finish()
    return noise


def _drift(t: TomlTable) -> ImuDrift:
    drift = ImuDrift(*(t.vector(f.name, 3, limit=1.0) for f in fields(ImuDrift)))
    if min(drift.gyro_sd.min(), drift.accel_sd.min()) < 0:
        raise t.fail("gyro_sd", notice("glove.file_drift_sd"))
    t.finish()
    return drift


def _axes(t: TomlTable) -> ImuAxes:
    axes = ImuAxes(*(t.vector(f.name, 9).reshape(3, 3) for f in fields(ImuAxes)))
    for name, matrix in (("gyro", axes.gyro), ("accel", axes.accel)):
        if np.abs(matrix - np.eye(3)).max() > LARGEST_AXIS_ERROR:
            raise t.fail(name, notice("glove.file_axes", limit=LARGEST_AXIS_ERROR))
    t.finish()
    return axes


def _vibration(t: TomlTable) -> ImuVibration:
    motors = t.integer("motors")
    vibration = ImuVibration(*(t.vector(f.name, motors, limit=10.0) for f in fields(ImuVibration)))
    if motors and min(vibration.gyro.min(), vibration.accel.min()) < 0:
        raise t.fail("gyro", notice("glove.file_vibration"))
    t.finish()
    return vibration


def _marker(t: TomlTable, hand: HandModel) -> Marker:
    marker = Marker(
        id=t.integer("id"),
        hue=t.label("hue"),
        shape=t.text("shape", among=("circle", "square")),
        size=t.number("size", low=1e-3, high=0.1),
        segment=t.text("segment", among=hand.segment_names),
        position=t.vector("position", 3, limit=0.5),
        normal=t.unit("normal", 3),
    )
    t.finish()
    return marker


def _keypoint(root: TomlTable, name: str, t: TomlTable, hand: HandModel) -> Keypoint:
    if name in KEYPOINTS:
        raise root.fail("keypoints", notice("glove.file_name_taken", name=name))
    keypoint = Keypoint(
        name, t.text("segment", among=hand.segment_names), t.vector("position", 3, limit=0.5)
    )
    t.finish()
    return keypoint
