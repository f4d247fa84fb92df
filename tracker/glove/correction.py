"""Corrects packets by what was measured of the glove's IMUs: axes, and drift with temperature."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.glove.model import GloveModel
from tracker.messages import Array, ImuSample

ROOM_C = 25.0
"""Temperature at which nothing is subtracted, °C; also assumed before the first measurement."""


class ImuCorrection:
    """For one glove, by its file. Packets of a glove without measurements are unchanged.

    ``celsius`` (n,) are the last temperatures, empty before the first: part of the saved state.
    """

    def __init__(self, glove: GloveModel) -> None:
        zero, eye = np.zeros(3), np.eye(3)
        drifts, axes = [i.drift for i in glove.imus], [i.axes for i in glove.imus]
        self._has_drift, self._has_axes = any(drifts), any(axes)
        shape = (len(glove.imus), 3)
        self._gyro_slope = np.reshape([d.gyro if d else zero for d in drifts], shape)
        self._accel_slope = np.reshape([d.accel if d else zero for d in drifts], shape)
        self._gyro = np.reshape([a.gyro if a else eye for a in axes], (*shape, 3))
        self._accel = np.reshape([a.accel if a else eye for a in axes], (*shape, 3))
        self.celsius: Array = np.empty(0)

    def corrected(self, sample: ImuSample) -> ImuSample:
        """The packet without the errors that are known, and without temperatures."""
        if sample.temperature is not None:
            self._remember(sample.temperature)
            sample = replace(sample, temperature=None)
        if not (self._has_axes or (self._has_drift and len(self.celsius))):
            return sample
        accel, gyro = sample.accel, sample.gyro
        if self._has_drift and len(self.celsius):
            warmer = (self.celsius - ROOM_C)[:, None]
            accel, gyro = accel - self._accel_slope * warmer, gyro - self._gyro_slope * warmer
        if self._has_axes:
            accel = np.einsum("nij,nj->ni", self._accel, accel)
            gyro = np.einsum("nij,nj->ni", self._gyro, gyro)
        return replace(sample, accel=accel, gyro=gyro)

    def _remember(self, celsius: Array) -> None:
        """An IMU that did not answer is assumed to be as warm as before."""
        before = self.celsius if len(self.celsius) else np.full(len(celsius), ROOM_C)
        self.celsius = np.where(np.isfinite(celsius), celsius, before)
