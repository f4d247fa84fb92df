"""Selects keyframes: images with many matched markers and postures as different as possible."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.params import BundleParams
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.state import ChainState
from tracker.fusion.time.imu_buffer import Around
from tracker.messages import Array, CameraPose, IntArray

MAX_RATE = 4.0  # rad/s: faster motion blurs the image and disturbs the accelerometers


@record("chain.keyframe", shapes={"p": "3", "R_GB": "A 3 3", "uv": "2 M 2", "relative": "a 3"})
@dataclass(frozen=True, eq=False)
class Keyframe:
    """One posture. p (3,), R_GB (A, 3, 3) as estimated by the filter; uv (2, M, 2) rectified px of
    the matched blobs, NaN elsewhere; packets 10 ms before, at and after the exposure."""

    p: Array
    R_GB: Array
    uv: Array
    pose: CameraPose
    packets: Around
    relative: Array  # (A - 1, 3) rotation vectors relative to the parents


@record("chain.keyframes", stored="kept")
@dataclass(eq=False)
class Keyframes:
    """At most ``BundleParams.keyframes`` keyframes; a new one replaces the most redundant one."""

    stored: list[Keyframe] = field(default_factory=list)

    def lacks(self, relative: Array, params: BundleParams) -> bool:
        """Whether a posture, as `Keyframe.relative`, differs from all stored ones."""
        apart = self._distances(relative)
        return not len(apart) or bool(apart.min() >= params.apart)

    def offer(self, frame: Keyframe, params: BundleParams) -> None:
        """Store ``frame`` if its posture is new."""
        if not self.lacks(frame.relative, params):
            return
        if len(self.stored) < params.keyframes:
            self.stored.append(frame)
            return
        apart = self._distances(frame.relative)
        between = np.array([self._distances(k.relative) for k in self.stored])
        np.fill_diagonal(between, np.inf)
        least = int(between.min(axis=1).argmin())
        if np.delete(apart, least).min() > between[least].min():
            self.stored[least] = frame

    def _distances(self, relative: Array) -> Array:
        """(k,) rad: root of the summed squares over all joints."""
        others = np.array([k.relative for k in self.stored]).reshape(
            len(self.stored), *relative.shape
        )
        return np.sqrt(np.sum((others - relative) ** 2, axis=(1, 2)))


def keyframe_of(
    state: ChainState,
    seen: tuple[SeenBlobs, ...],
    match: IntArray,
    pose: CameraPose,
    packets: Around,
    relative: Array,
    params: BundleParams,
) -> Keyframe | None:
    """The posture of ``state``, or None where too few markers are matched or the hand moves too
    fast."""
    if int(np.sum(match >= 0)) < params.least_blobs or np.abs(packets.now.gyro).max() > MAX_RATE:
        return None
    uv = np.full((2, match.shape[1], 2), np.nan)
    for c in range(2):
        hit = np.flatnonzero(match[c] >= 0)
        uv[c, hit] = seen[c].uv[match[c, hit]]
    return Keyframe(state.p.copy(), state.R_GB.copy(), uv, pose, packets, relative)
