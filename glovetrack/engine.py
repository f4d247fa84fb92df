"""The synchronous engine, for programs that feed messages of their own.

::

    from glovetrack.engine import Pipeline, Settings, load

    hand, glove = load("vist-small")
    pipeline = Pipeline(hand, glove, rig, Settings(engine="chain"))
    estimate = pipeline.feed_imu(sample)

The same messages in the same order give the same estimates, bit for bit.
"""

from tracker.engine.kinds import ENGINES
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove.library import load
from tracker.messages import (
    BlobFrame,
    Blobs,
    CameraImuSample,
    CameraPose,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.vision.rig import StereoRig

__all__ = [
    "ENGINES",
    "BlobFrame",
    "Blobs",
    "CameraImuSample",
    "CameraPose",
    "Estimate",
    "Event",
    "FrameResult",
    "ImuSample",
    "Pipeline",
    "SessionReader",
    "SessionRecorder",
    "Settings",
    "StereoFrame",
    "StereoRig",
    "Tracking",
    "Validity",
    "load",
]
