"""The text of a motor test's result."""

from __future__ import annotations

import numpy as np

from app.viewmodels.names import spoken
from app.words import local, tr
from tracker import GRAVITY
from tracker.calibration.motor_vibration import Vibration
from tracker.glove.model import GloveModel


def vibration_words(glove: GloveModel, channel: int, found: Vibration) -> str:
    """A line for the motor, and one for each IMU that it shakes, the most first."""
    lines = [tr("Motor {} shakes the IMUs (standard deviation):").format(channel + 1)]
    for j in np.argsort(-found.accel):
        values = (
            f"{local(found.accel[j] / GRAVITY):.3f}",
            f"{local(np.rad2deg(found.gyro[j])):.2f}",
        )
        lines.append(tr("{}: {} g, {} °/s").format(spoken(glove.imu_names[j]), *values))
    return "\n".join(lines)
