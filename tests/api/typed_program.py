"""A program that uses the public names, checked by mypy together with the product (`make lint`).

It is not run. `assert_type` is an error where a type is lost, and so is an ignored error that does
not occur (``warn_unused_ignores``).
"""

from collections.abc import Mapping
from typing import assert_type

import numpy as np
from numpy.typing import NDArray

import glovetrack
from glovetrack.applications import HandSample as HandSample
from glovetrack.applications import Step as Step
from glovetrack.cameras import CameraDriver as CameraDriver
from glovetrack.cameras import Pair as Pair
from glovetrack.engine import Pipeline as Pipeline
from glovetrack.engine import Settings as Settings
from glovetrack.engine import load as load
from glovetrack.recording import Recording
from glovetrack.streams import StreamKind as StreamKind
from glovetrack.streams import StreamSettings as StreamSettings

rec = glovetrack.open("session.mcap")
assert_type(rec.keypoints["index_tip"], np.ndarray)
assert_type(rec.imu("dorsum").gyro, NDArray[np.float64])
assert_type(rec.track(engine="vist"), Recording)
with glovetrack.LiveTracker.simulated() as live:
    for estimate in live:
        assert_type(estimate.sd, Mapping[str, float])
glovetrack.nothing  # type: ignore[attr-defined]  # noqa: B018
