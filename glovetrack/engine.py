"""The synchronous engine, for programs that feed messages of their own.

::

    from glovetrack.engine import Pipeline, Settings, load

    hand, glove = load("vist-small")
    pipeline = Pipeline(hand, glove, rig, Settings(engine="chain"))
    estimate = pipeline.feed_imu(sample)

The same messages in the same order give the same estimates, bit for bit.

A package adds an engine as an entry point of the group ``glovetrack.engines`` that names an
`EngineKind`; ``docs/examples/glovetrack-tilt-engine`` is one. Its `Engine` can then be chosen in
the window and by ``--engine``. Its settings and its state, a `record`, are in recordings.
"""

from tracker.base.errors import ConfigError
from tracker.base.records import record
from tracker.engine.kinds import ENGINES, Capabilities, EngineKind, settings_text
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.engine import Engine, ExpectedHand
from tracker.glove.library import load
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    BlobFrame,
    Blobs,
    Calibration,
    CameraImuSample,
    CameraPose,
    EngineState,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    StereoFrame,
    Tracking,
    Validity,
    WristPose,
)
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.vision.rig import StereoRig

__all__ = [
    "ENGINES",
    "BlobFrame",
    "Blobs",
    "Calibration",
    "CameraImuSample",
    "CameraPose",
    "Capabilities",
    "ConfigError",
    "Engine",
    "EngineKind",
    "EngineState",
    "Estimate",
    "Event",
    "ExpectedHand",
    "FrameResult",
    "GloveModel",
    "HandModel",
    "ImuSample",
    "Pipeline",
    "SessionReader",
    "SessionRecorder",
    "Settings",
    "StereoFrame",
    "StereoRig",
    "Tracking",
    "Validity",
    "WristPose",
    "load",
    "record",
    "settings_text",
]
