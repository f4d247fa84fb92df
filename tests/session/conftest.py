"""A short synthetic session with known values."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from tracker.base.clock import ClockAnchor, seconds
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    BlobFrame,
    Blobs,
    Calibration,
    CameraPose,
    Cloth,
    Estimate,
    Event,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.session.description import SessionInfo
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.vision.rig import ideal_rig

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
ANCHOR = ClockAnchor(wall_ns=1_760_000_000_123_456_789, monotonic_ns=5_000_000_321)
START = seconds(ANCHOR.monotonic_ns)


@pytest.fixture(scope="session")
def session_info(hand: HandModel, glove: GloveModel) -> SessionInfo:
    return SessionInfo(
        hand=hand,
        glove=glove,
        hand_text=(RESOURCES / "hands" / "reference-right.toml").read_text(),
        glove_text=(RESOURCES / "gloves" / "vist-small.toml").read_text(),
        anchor=ANCHOR,
        rig=ideal_rig(64, 48),
        settings_text='engine = "chain"\n',
        participant="P 07",
        notes="ä note",
        simulated=True,
    )


def at(ms: float) -> float:
    """Session time of a millisecond after the start, an integer number of nanoseconds."""
    return seconds(ANCHOR.monotonic_ns + round(ms * 1e6))


class MessageMaker:
    """Messages with random content from one seed."""

    def __init__(self, info: SessionInfo, seed: int = 1) -> None:
        self.info, self.rng = info, np.random.default_rng(seed)

    def imu(self, ms: float, seq: int = -1, missing: int | None = None) -> ImuSample:
        n = len(self.info.glove.imus)
        accel, gyro = self.rng.normal(size=(2, n, 3))
        valid = np.ones(n, bool)
        if missing is not None:
            valid[missing] = False
            accel[missing] = gyro[missing] = np.nan
        device = seconds(round(ms * 1e3) * 1000) if seq >= 0 else np.nan
        return ImuSample(at(ms), at(ms + 3.2), device, seq, accel, gyro, valid)

    def blobs(self, n: int) -> Blobs:
        uv, size = self.rng.uniform(1, 60, (2, n, 2))
        hue, score = self.rng.integers(0, 3, n), self.rng.uniform(size=n)
        return Blobs(uv, size, hue, score, self.cloth() if n % 2 else None)

    def cloth(self) -> Cloth:
        """For an image of 640 by 480 px."""
        first, second = sorted(self.rng.integers(0, 590, 2).tolist())
        tile = np.r_[first : first + 9, 600 + second : 609 + second]
        bits, bright = self.rng.integers(-(2**63), 2**63 - 1, (2, len(tile)))
        return Cloth(40, 30, tile, bits, bright)

    def pose(self) -> CameraPose:
        return CameraPose(so3.exp(self.rng.normal(size=3)), self.rng.normal(size=3))

    def blob_frame(self, ms: float, index: int, moving: bool = False) -> BlobFrame:
        return BlobFrame(
            at(ms),
            at(ms + 21),
            self.info.hue_names,
            self.blobs(5),
            None if index % 5 == 4 else self.blobs(4),
            self.pose() if moving else None,
            index=index,
        )

    def image(self, ms: float, index: int) -> StereoFrame:
        left, right = self.rng.integers(0, 256, (2, 48, 64, 3), dtype=np.uint8)
        return StereoFrame(at(ms), at(ms + 12), left, right, index=index)

    def estimate(self, ms: float, lost: bool = False) -> Estimate:
        hand, glove = self.info.hand, self.info.glove
        angles = self.rng.uniform(0, 0.5, len(hand.joint_names))
        scale = np.ones((len(hand.segments), 3))
        R, p = hand.forward(angles, so3.exp(self.rng.normal(size=3)), self.rng.normal(size=3))
        keypoints = glove.keypoint_positions(hand, R, p, scale)
        q = so3.quat_from_matrix(R[glove.keypoint_segments(hand)])
        state = np.full(len(keypoints), int(Validity.MEASURED))
        angle_state = np.full(len(angles), int(Validity.INFERRED))
        if lost:
            state[3], keypoints[3], q[3] = Validity.LOST, np.nan, np.nan
            angle_state[2], angles[2] = Validity.LOST, np.nan
        tracking = Tracking.COASTING if lost else Tracking.TRACKING
        sd = self.rng.uniform(size=len(keypoints))
        return Estimate(at(ms), tracking, keypoints, q, state, sd, angles, angle_state, R, p)

    def calibration(self, ms: float) -> Calibration:
        rows = [self.rng.normal(size=(2, 3)) for _ in range(8)]
        rows[0][1, 1] = np.nan
        return Calibration(at(ms), ("dorsum", "index_proximal"), *rows, 0.183, 0.004)

    def stream(self, duration_ms: int, images: bool = True) -> Iterator[Message]:
        """A live run: 100 Hz packets, 50 Hz frames, in the order in which they are fed."""
        waiting: list[BlobFrame] = []
        for k in range(duration_ms // 10):
            ms = k * 10.0
            sample = self.imu(ms, seq=k, missing=2 if k % 7 == 3 else None)
            while waiting and waiting[0].t_arrival < sample.t_arrival:
                yield waiting.pop(0)
            yield sample
            yield self.estimate(ms, lost=k % 20 > 14)
            if k % 2 == 0:
                if images:
                    yield self.image(ms + 1, k // 2)
                waiting.append(self.blob_frame(ms + 1, k // 2))
        yield self.calibration(duration_ms - 10)
        yield Event(at(duration_ms - 5), "note", "grasp ✓", {"object": "cup", "n": 3})
        yield Status(at(duration_ms - 4), Tracking.TRACKING, {"imu_rate_hz": 99.9})


@pytest.fixture
def maker(session_info: SessionInfo) -> MessageMaker:
    return MessageMaker(session_info)


@pytest.fixture
def record(session_info: SessionInfo) -> Callable[..., Path]:
    """``record(path, messages)`` writes a session and returns its path."""

    def write(path: Path, messages: list[Message], **params: object) -> Path:
        params = {"images": "png", "sync": False, **params}
        with SessionRecorder(path, session_info, RecorderParams(**params)) as recorder:  # type: ignore[arg-type]
            for m in messages:
                recorder.write(m)
        return path

    return write
