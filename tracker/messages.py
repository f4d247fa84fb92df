"""What passes between stages. Each message is immutable and its arrays are read-only.

Messages are compared by identity: they hold arrays. Times are seconds of the host's monotonic
clock. ``freeze`` is called by the constructors, so a producer hands over an array it no longer
writes to.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.base.arrays import Array as Array
from tracker.base.arrays import IntArray as IntArray
from tracker.base.frozen_dict import FrozenDict
from tracker.base.notices import Notice
from tracker.base.records import record

EYES = ("left", "right")
"""The two cameras of a stereo camera, in the order of a pair of images."""


class Validity(IntEnum):
    """How far a joint or keypoint can be trusted."""

    LOST = 0
    INFERRED = 1  # synergy, rest pose, or nothing saw it lately
    MEASURED = 2  # an IMU or a marker saw it lately


RECENT = 0.5
"""s for which a part or a marker counts as seen after a sensor last saw it."""


@record("tracking")
class Tracking(IntEnum):
    """State of tracking as a whole."""

    SEARCHING = 0  # no pose yet
    TRACKING = 1  # markers are being matched
    COASTING = 2  # inertial only, position still bounded and useful
    LOST = 3  # position unknown; articulation may still be measured


@record("search")
class Search(IntEnum):
    """How far an image is searched for a hand that is not seen where it is expected."""

    NEAR = 0  # only where it is expected
    AGAIN = 1  # at an arbitrary position, bent according to its IMUs
    FULL = 2  # as if nothing were known of it, where that is needed


class _Frozen:
    """Makes every array field read-only when the message is built."""

    def __post_init__(self) -> None:
        kind: Any = type(self)  # mypy does not know that classes are hashable
        for name in _array_fields(kind):
            value = getattr(self, name)
            if isinstance(value, np.ndarray):
                value.setflags(write=False)


@cache
def _array_fields(kind: type) -> tuple[str, ...]:
    """Names of the fields that may be arrays, by their annotations."""
    fields = kind.__dataclass_fields__  # type: ignore[attr-defined]
    return tuple(name for name, its in fields.items() if "Array" in str(its.type))


@record("imu_sample", shapes={"accel": "n 3", "gyro": "n 3", "valid": "bool n", "temperature": "n"})
@dataclass(frozen=True, eq=False, slots=True)
class ImuSample(_Frozen):
    """One packet of a glove: all its IMUs at one instant, in the glove file's order.

    accel (n, 3) m/s² specific force and gyro (n, 3) rad/s, each in its IMU's frame I; rows of IMUs
    that did not answer are NaN and ``valid`` is False there. temperature (n,) °C if it was measured
    again since the packet before, NaN for IMUs that did not answer.
    """

    t: float  # estimated sampling instant
    t_arrival: float
    t_device: float  # the glove's own clock, unwrapped, s; NaN where unknown
    seq: int  # unwrapped packet number; -1 where unknown
    accel: Array
    gyro: Array
    valid: NDArray[np.bool_]
    temperature: Array | None = None


@record("camera_pose", shapes={"R_GC": "3 3", "p_GC": "3"})
@dataclass(frozen=True, eq=False, slots=True)
class CameraPose(_Frozen):
    """Pose of the left rectified camera in G: R_GC (3, 3), p_GC (3,)."""

    R_GC: Array
    p_GC: Array


@record("camera_motion", shapes={"v_G": "3", "w_G": "3"})
@dataclass(frozen=True, eq=False, slots=True)
class CameraMotion(_Frozen):
    """How the left rectified camera moves during an exposure: v_G (3,) m/s, w_G (3,) rad/s in G."""

    v_G: Array
    w_G: Array


@record("camera_imu_sample", shapes={"gyro": "3", "accel": "3"})
@dataclass(frozen=True, eq=False, slots=True)
class CameraImuSample(_Frozen):
    """The stereo camera's own IMU at one instant, in the left camera's frame C.

    gyro (3,) rad/s; accel (3,) m/s² specific force.
    """

    t: float
    t_arrival: float
    gyro: Array
    accel: Array


@record("wrist_pose", shapes={"p_GT": "3", "q_GT": "4", "p_BT": "3", "q_BT": "4"})
@dataclass(frozen=True, eq=False, slots=True)
class WristPose(_Frozen):
    """Pose in G of a tracker T that is fixed to the back of a hand, as another system measured it.

    p_GT (3,) m and q_GT (4,) xyzw; q_GT is NaN if the system measures positions alone. p_BT (3,) m
    and q_BT (4,) are the tracker's pose in the frame B of the hand's root segment. The variances
    are those of an axis, m² and rad².
    """

    t: float
    t_arrival: float
    side: str
    p_GT: Array
    q_GT: Array
    p_BT: Array
    q_BT: Array
    position_variance: float
    rotation_variance: float


@dataclass(frozen=True, eq=False, slots=True)
class StereoFrame(_Frozen):
    """One exposure of both cameras. Images are (h, w, 3) uint8 BGR; None where a camera is dark."""

    t: float  # exposure midpoint
    t_arrival: float
    left: NDArray[np.uint8] | None
    right: NDArray[np.uint8] | None
    pose: CameraPose | None = None  # of a moving camera; None: the rig's fixed pose
    index: int = -1


@record("cloth", shapes={"tile": "int n", "bits": "int n", "bright": "int n"})
@dataclass(frozen=True, eq=False, slots=True)
class Cloth(_Frozen):
    """Where an image shows the glove's own colours around its blobs, every second pixel.

    tile (n,) numbers of squares of 16 px, row by row, ``columns`` in each of ``rows``; bits (n,):
    bit 8 y + x is set where the pixel 2 x, 2 y of the tile has such a colour. In ``bright`` (n,),
    these bits are set where such a pixel is brighter than the cloth around it, which has the same
    texture in both images; None in recordings of earlier versions.
    """

    columns: int
    rows: int
    tile: IntArray
    bits: IntArray
    bright: IntArray | None = None


@record("blobs", shapes={"uv": "n 2", "size": "n 2", "hue": "int n", "score": "n"})
@dataclass(frozen=True, eq=False, slots=True)
class Blobs(_Frozen):
    """Coloured blobs found in one image, in pixels of the image as recorded.

    uv (n, 2) centroids, size (n, 2) extents, hue (n,) index into ``hue_names`` of the frame,
    score (n,) in 0..1. ``cloth`` is None where no image was searched, or with colours that do not
    know the glove's cloth.
    """

    uv: Array
    size: Array
    hue: IntArray
    score: Array
    cloth: Cloth | None = None

    @staticmethod
    def empty() -> Blobs:
        return Blobs(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0, np.int64), np.zeros(0))

    def __len__(self) -> int:
        return len(self.uv)


@record("rejected_blobs", shapes={"uv": "n 2", "hue": "int n"})
@dataclass(frozen=True, eq=False, slots=True)
class RejectedBlobs(_Frozen):
    """Blobs of the right hue and the wrong shape, for display: uv (n, 2), reason per row."""

    uv: Array
    hue: IntArray
    reason: tuple[str, ...]  # as `tracker.vision.detector.REASONS`

    @staticmethod
    def empty() -> RejectedBlobs:
        return RejectedBlobs(np.zeros((0, 2)), np.zeros(0, np.int64), ())


@record("blob_frame", shapes={"unhidden": "2 m"})
@dataclass(frozen=True, eq=False, slots=True)
class BlobFrame(_Frozen):
    """What the detector found in one stereo exposure. A side without an image is None.

    ``unhidden`` (2, M), where there is another hand: the factor by which that one, standing before
    them, lessens the probability that the left and the right camera see each marker of this one.
    ``search`` is how far a hand may be looked for: a search takes as long as ten images. ``motion``
    is that of a moving camera whose rows are exposed one after the other, or whose time stamps
    jitter. ``stamp_sd`` s is the standard deviation of ``t``; 0 where it is negligible.
    """

    t: float
    t_arrival: float
    hue_names: tuple[str, ...]
    left: Blobs | None
    right: Blobs | None
    pose: CameraPose | None = None
    rejected_left: RejectedBlobs | None = None
    rejected_right: RejectedBlobs | None = None
    index: int = -1
    unhidden: Array | None = None
    search: Search = Search.FULL
    motion: CameraMotion | None = None
    stamp_sd: float = 0.0


@record(
    "frame_result",
    shapes={
        "predicted_left": "m 2",
        "predicted_right": "m 2",
        "predicted_cov": "m 2 2",
        "visible": "m",
        "match_left": "int m",
        "match_right": "int m",
        "residual": "m 4",
        "row_shift": "2 m 2",
        "hues": "h h",
    },
)
@dataclass(frozen=True, eq=False, slots=True)
class FrameResult(_Frozen):
    """What the tracker made of one BlobFrame, for overlays and statistics.

    predicted_left/right (M, 2) px of each marker (raw image), NaN outside; predicted_cov (M, 2, 2)
    of the left image; visible (M,) prior probability; match_left/right (M,) blob index or -1;
    residual (M, 4) px (left u, v, right u, v), NaN where unmatched. ``another``: the hand was given
    up, since most of its patches were other markers than they seemed. ``row_shift`` (2, M, 2)
    rectified px of a rolling shutter: how far markers move in the left and the right image from the
    image's instant until their rows are exposed. ``hues`` (h, h), where many markers are missed:
    blobs at expected markers, by the marker's and by the blob's row among the glove's hues.
    """

    t: float
    tracking: Tracking
    predicted_left: Array
    predicted_right: Array
    predicted_cov: Array
    visible: Array
    match_left: IntArray
    match_right: IntArray
    residual: Array
    stereo_points: int  # markers matched in both images
    another: bool = False
    row_shift: Array | None = None
    hues: Array | None = None

    @staticmethod
    def nothing(t: float, tracking: Tracking, markers: int) -> FrameResult:
        """For an image in which no marker was expected or matched."""
        return FrameResult(
            t=t,
            tracking=tracking,
            predicted_left=np.full((markers, 2), np.nan),
            predicted_right=np.full((markers, 2), np.nan),
            predicted_cov=np.full((markers, 2, 2), np.nan),
            visible=np.zeros(markers),
            match_left=np.full(markers, -1, np.int64),
            match_right=np.full(markers, -1, np.int64),
            residual=np.full((markers, 4), np.nan),
            stereo_points=0,
        )


@dataclass(frozen=True, eq=False, slots=True)
class Motion(_Frozen):
    """How the hand of an `Estimate` moves, row by row as there; NaN where unknown.

    linear (K, 3) m/s of the keypoints and angular (K, 3) rad/s of the segments that start there,
    both in G; linear_sd, angular_sd (K,) are roots of the mean variance of their axes. angle_rate,
    angle_rate_sd (J,) rad/s; angle_sd (J,) rad, of the angles themselves.
    """

    linear: Array
    angular: Array
    linear_sd: Array
    angular_sd: Array
    angle_rate: Array
    angle_rate_sd: Array
    angle_sd: Array


@dataclass(frozen=True, eq=False, slots=True)
class Estimate(_Frozen):
    """The hand at one instant.

    keypoints (K, 3) m in G and keypoint_q (K, 4) xyzw of the segment that starts there, in the
    order of ``HandModel.keypoint_names`` then the glove's extra ones; NaN where lost.
    angles (J,) rad in the order of ``HandModel.joint_names``; NaN where lost. keypoint_sd (K,) m is
    the root of the mean variance of a keypoint. segment_R (S, 3, 3), segment_p (S, 3): R_GB, p_GB.
    ``motion`` is what an engine estimates at a packet; None in predictions and recordings. ``seq``
    numbers the estimates of a hand that are offered to an output; -1 elsewhere.
    """

    t: float
    tracking: Tracking
    keypoints: Array
    keypoint_q: Array
    keypoint_state: IntArray
    keypoint_sd: Array
    angles: Array
    angle_state: IntArray
    segment_R: Array
    segment_p: Array
    motion: Motion | None = None
    seq: int = -1


@dataclass(frozen=True, eq=False, slots=True)
class Calibration(_Frozen):
    """Estimated parameters with standard deviations, one row per segment with an IMU or marker.

    scale, scale_sd (S, 3) factors along B; mounting, mounting_sd (S, 3) rad, the rotation vector of
    the estimated q_BI against the glove file's; gyro_bias(+_sd) (S, 3) rad/s; accel_bias(+_sd)
    (S, 3) m/s². NaN where a segment has no such parameter.
    """

    t: float
    segments: tuple[str, ...]
    scale: Array
    scale_sd: Array
    mounting: Array
    mounting_sd: Array
    gyro_bias: Array
    gyro_bias_sd: Array
    accel_bias: Array
    accel_bias_sd: Array
    hand_length: float
    hand_length_sd: float

    @staticmethod
    def nothing(t: float, segments: Sequence[str]) -> Calibration:
        """For an engine that estimates no parameters."""
        rows = np.full((len(segments), 3), np.nan)
        eight = (rows, rows, rows, rows, rows, rows, rows, rows)
        return Calibration(t, tuple(segments), *eight, math.nan, math.nan)


@dataclass(frozen=True)
class Event:
    """Something worth a line in the log and in the session: a device, a recording, a note.

    ``text`` is the user's for a note, and English for what the program reports; that has a
    ``notice``, too, which readers render in their own language.
    """

    t: float
    kind: str  # "note", "device", "tracking", "recording", "error", "pulse", "gesture"
    text: str
    data: Mapping[str, object] = field(default_factory=FrozenDict)
    notice: Notice | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "data", FrozenDict(self.data))

    @staticmethod
    def of(t: float, kind: str, notice: Notice, data: Mapping[str, object] | None = None) -> Event:
        """What the program reports at ``t`` s."""
        return Event(t, kind, str(notice), data or {}, notice)

    @property
    def code(self) -> str:
        """The code of the notice; empty for a note, and in recordings of earlier versions."""
        return self.notice.code if self.notice is not None else ""


class Shed(IntEnum):
    """What is left out on a computer that is too slow (`Status` has it as ``load_shed``); each
    includes those before."""

    NOTHING = 0
    VIEW_RATE = 1
    OVERLAYS = 2
    WHOLE_SEARCHES = 3
    IMAGES = 4


@dataclass(frozen=True)
class Status:
    """Rates, latencies and losses at one instant; names are stable, see docs/architecture.md."""

    t: float
    tracking: Tracking
    values: Mapping[str, float]

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", FrozenDict(self.values))


@dataclass(frozen=True, eq=False)
class EngineState:
    """The state of an engine between two messages; from a recorded one, tracking can continue.

    ``t`` comes after the arrival of every message fed before, and is not later than any fed after.
    """

    t: float
    engine: str
    state: Any


@dataclass(frozen=True)
class RobotModel:
    """A robot hand that follows the wearer's: what it is. ``urdf`` is its description as ROS has
    it, ``settings`` JSON of how it is driven (extensions/robot/docs/robot.md)."""

    t: float
    name: str
    joint_names: tuple[str, ...]
    objects: tuple[str, ...]
    urdf: str
    settings: str


@dataclass(frozen=True, eq=False, slots=True)
class RobotState(_Frozen):
    """A robot hand after the estimate of ``t``, in the order of its `RobotModel`.

    command (n,) rad of the joints, joints (n,) rad their positions; palm (7,) and objects
    (m, 7) m and xyzw in the robot's world W (z up); force (5,) N on each fingertip, thumb first.
    ``holding``: it holds its pose, because the hand is lost. ``t_sent`` s: when the command left
    for the robot; NaN of one that a recording drives.
    """

    t: float
    name: str
    command: Array
    joints: Array
    palm: Array
    objects: Array
    force: Array
    engaged: bool
    holding: bool
    t_sent: float = math.nan


@dataclass(frozen=True, eq=False, slots=True)
class RobotMemory(_Frozen):
    """All that a robot's next step depends on, after the estimate of ``t``: values (k,)."""

    t: float
    name: str
    values: Array


Message = (
    ImuSample
    | CameraImuSample
    | WristPose
    | StereoFrame
    | BlobFrame
    | FrameResult
    | Estimate
    | Calibration
    | Event
    | Status
    | EngineState
    | RobotModel
    | RobotState
    | RobotMemory
)
