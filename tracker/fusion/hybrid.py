"""The hybrids of Lemak et al. 2020 for the real glove: vision for the dorsum, IMUs for the fingers.

The dorsum's pose is estimated from its own markers and IMU by the chain filter; each finger's two
joints are estimated from that finger's two IMUs alone. No finger needs a marker.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.records import record
from tracker.fusion.chain.engine import ChainEngine, ChainSavedState
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.engine import Engine, ExpectedHand
from tracker.fusion.hybrid_params import HybridParams
from tracker.fusion.output.completion import ActiveSegments
from tracker.fusion.output.motion import JOINT_RATE_SD, Rates, linked_rates, moving
from tracker.fusion.output.output import HandOutput, Sensed
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.inertial.finger3d import (
    FingerEstimator3D,
    FingerSavedState,
    ImuPair,
    finger_geometry,
    finger_pairs,
)
from tracker.inertial.geometry3d import DorsumMotion
from tracker.messages import (
    RECENT,
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.online.imu_health import ImuHealth, ImuHealthSavedState
from tracker.vision.rig import StereoRig

GYRO_SD = 0.15  # rad/s per axis of a finger's rate: bias and mounting are not estimated
ANGLE_SD = 0.15  # rad, of a finger's joint from its IMUs alone
FINGER_SD = 0.01  # m of a finger's markers, from the finger's two IMUs alone
MAX_REPEAT = 20  # lost packets bridged by repeating the last readings


@record("hybrid.fingers", shapes={"joints": "3 3", "felt": "I"})
@dataclass(eq=False)
class FingersSavedState:
    """The state besides that of the estimators: joint rotations of each finger, and when (s) each
    IMU was last valid."""

    joints: list[tuple[Array, Array]]
    felt: Array
    last_t: float = np.nan


@record("hybrid", sized=True)
@dataclass(eq=False)
class HybridSavedState:
    """The complete state of a hybrid engine."""

    dorsum: ChainSavedState
    estimators: list[FingerSavedState]
    fingers: FingersSavedState
    health: ImuHealthSavedState


class HybridEngine(Engine):
    """The dorsum by the filter `chain`, the fingers by Lemak et al. 2020
    (doi:10.3390/computers9020040); ``variant`` names one of `tracker.inertial.finger3d`.

    Raises ConfigError for a glove without a dorsum IMU and dorsum markers.
    """

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        rig: StereoRig,
        chain: ChainParams,
        params: HybridParams,
        variant: str,
    ) -> None:
        root = hand.segments[0].name
        names = [i.segment for i in glove.imus]
        if root not in names or not any(m.segment == root for m in glove.markers):
            raise ConfigError(notice("engine.needs_root_imu", engine=variant, segment=root))
        self._hand, self._glove, self._params = hand, glove, params
        self._root = names.index(root)
        self._markers = np.array([m.id for m in glove.markers if m.segment == root])
        self._dorsum = ChainEngine(hand, _only(glove, root), rig, chain)
        self._layout = ChainLayout(hand, glove)
        self._output = HandOutput(self._layout)
        self._pairs = finger_pairs(hand, glove)
        self._rows = [tuple(names.index(s) for s in pair) for pair in self._pairs]
        self._health = ImuHealth(len(names))
        dt = 1.0 / params.rate_hz
        self._estimators = [
            FingerEstimator3D(finger_geometry(hand, glove, *p), dt, variant) for p in self._pairs
        ]
        self._fingers = FingersSavedState(
            [self._straight(pair) for pair in self._pairs],
            np.full(len(names), -np.inf),
        )

    def _straight(self, pair: Sequence[str]) -> tuple[Array, Array]:
        first, second = (self._hand.segments[self._hand.index[s]] for s in pair)
        return first.R_rest, second.R_rest

    def feed_imu(self, sample: ImuSample) -> Estimate:
        sample = self._health.check(sample)
        self._fingers.felt[sample.valid] = sample.t
        dorsum = self._dorsum.feed_imu(self._of_root(sample))
        if dorsum.tracking != Tracking.SEARCHING:
            self._update_fingers(sample, dorsum.segment_R[0])
        self._fingers.last_t = sample.t
        return self._moving(self._whole(dorsum, sample.t), dorsum, sample)

    def _moving(self, estimate: Estimate, dorsum: Estimate, sample: ImuSample) -> Estimate:
        """The estimate with the dorsum's motion, and finger rates from their IMUs."""
        if dorsum.motion is None:
            return estimate
        lay, at = self._layout, self._hand.keypoint_names.index("wrist")
        active = np.ascontiguousarray(lay.active)
        R, p = estimate.segment_R[active], estimate.segment_p[active]
        w, w_sd = np.zeros((len(R), 3)), np.full(len(R), GYRO_SD)
        w[0], w_sd[0] = R[0].T @ dorsum.motion.angular[at], dorsum.motion.angular_sd[at]
        for i in range(1, len(R)):
            j, a = lay.imu_of[i], lay.parent[i]
            if j >= 0 and sample.valid[j]:
                w[i] = self._glove.imus[j].R_BI @ sample.gyro[j]
            else:
                w[i], w_sd[i] = R[i].T @ R[a] @ w[a], np.hypot(w_sd[a], JOINT_RATE_SD)
        segments = ActiveSegments(R, p, np.ones((len(R), 3)))
        v, v_sd = dorsum.motion.linear[at].copy(), float(dorsum.motion.linear_sd[at])
        sd = v_sd, w_sd, np.full(len(R), ANGLE_SD)
        rates = Rates(*linked_rates(lay.parent, segments, v, w, *sd))
        return moving(self._output, estimate, segments, rates)

    def _of_root(self, sample: ImuSample) -> ImuSample:
        j = slice(self._root, self._root + 1)
        return replace(
            sample,
            accel=sample.accel[j].copy(),
            gyro=sample.gyro[j].copy(),
            valid=np.asarray(sample.valid)[j].copy(),
        )

    def _update_fingers(self, sample: ImuSample, R_GB: Array) -> None:
        if not sample.valid[self._root]:
            return
        R_BI = self._glove.imus[self._root].R_BI
        motion = DorsumMotion(
            R_GB,
            R_BI @ sample.gyro[self._root],
            R_BI @ sample.accel[self._root],
            self._glove.imus[self._root].position,
        )
        for k, rows in enumerate(self._rows):
            pair = self._readings(sample, rows)
            for _ in range(self._packets_since(sample.t)):
                joints = self._estimators[k].update(motion, pair)
            self._fingers.joints[k] = (joints.R_01, joints.R_12)

    def _packets_since(self, t: float) -> int:
        """Number of packets due since the last one; lost ones are bridged."""
        gap = (t - self._fingers.last_t) * self._params.rate_hz
        return 1 if not np.isfinite(gap) else int(np.clip(round(gap), 1, MAX_REPEAT))

    def _readings(self, sample: ImuSample, rows: Sequence[int]) -> ImuPair:
        """Both IMUs' readings in their segments' B; NaN where one is invalid."""
        gyro, accel = np.full((2, 3), np.nan), np.full((2, 3), np.nan)
        for k, j in enumerate(rows):
            if sample.valid[j]:
                R_BI = self._glove.imus[j].R_BI
                gyro[k], accel[k] = R_BI @ sample.gyro[j], R_BI @ sample.accel[j]
        return ImuPair(gyro, accel)

    def _whole(self, dorsum: Estimate, t: float) -> Estimate:
        """The dorsum's pose with the joints of all fingers attached."""
        lay, hand = self._layout, self._hand
        n = len(lay.active)
        R, p = np.empty((n, 3, 3)), np.empty((n, 3))
        R[0], p[0] = dorsum.segment_R[0], dorsum.segment_p[0]
        rotation = {lay.names.index(s): r for s, r in self._joint_rotations()}
        for i in range(1, n):
            a = lay.parent[i]
            R[i] = R[a] @ rotation.get(i, lay.R_rest[i])
            p[i] = p[a] + R[a] @ hand.segments[lay.active[i]].origin
        sd = np.full(n, dorsum.keypoint_sd[0])
        scale = np.ones((n, 3))
        sensed = Sensed(self._sensed(t), dorsum.tracking)
        return self._output.estimate(t, R, p, scale, sensed, sd)

    def _joint_rotations(self) -> list[tuple[str, Array]]:
        out: list[tuple[str, Array]] = []
        for pair, joints in zip(self._pairs, self._fingers.joints, strict=True):
            out += list(zip(pair, joints, strict=True))
        return out

    def _sensed(self, t: float) -> IntArray:
        out = np.zeros(len(self._layout.active), np.int64)
        out[self._layout.imu_segment[t - self._fingers.felt < RECENT]] = 1
        return out

    def feed_frame(self, frame: BlobFrame) -> None:
        if frame.unhidden is not None:
            frame = replace(frame, unhidden=frame.unhidden[:, self._markers])
        self._dorsum.feed_frame(frame)

    def take_results(self) -> list[FrameResult]:
        return [self._spread(r) for r in self._dorsum.take_results()]

    def _spread(self, result: FrameResult) -> FrameResult:
        """Maps rows of the dorsum's markers to those of the whole glove."""
        m = len(self._glove.markers)

        def wide(values: Any, empty: float) -> Any:
            out = np.full((m, *values.shape[1:]), empty, values.dtype)
            out[self._markers] = values
            return out

        return replace(
            result,
            predicted_left=wide(result.predicted_left, np.nan),
            predicted_right=wide(result.predicted_right, np.nan),
            predicted_cov=wide(result.predicted_cov, np.nan),
            visible=wide(result.visible, 0.0),
            match_left=wide(result.match_left, -1),
            match_right=wide(result.match_right, -1),
            residual=wide(result.residual, np.nan),
        )

    def predict(self, t: float) -> Estimate:
        return self._whole(self._dorsum.predict(t), t)

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """None: finger markers of the same hues exist too, so no position can be excluded."""
        return None

    def expected(self, t: float) -> ExpectedHand | None:
        """The predicted hand in an image of ``t`` not processed yet; None while its position is
        unknown."""
        dorsum = self._dorsum.expected(t)
        if dorsum is None:
            return None
        whole, glove = self._whole(dorsum.estimate, t), self._glove
        segment = glove.marker_segment(self._hand)
        turned = np.einsum("mij,mj->mi", whole.segment_R[segment], glove.marker_position)
        sd = np.hypot(dorsum.sd.max(initial=0.0), FINGER_SD * (segment != self._hand.root))
        return ExpectedHand(whole, whole.segment_p[segment] + turned, sd, np.arange(len(segment)))

    def calibration(self) -> Calibration:
        return self._dorsum.calibration()

    def get_state(self) -> HybridSavedState:
        """A copy of the complete state."""
        estimators = [e.saved for e in self._estimators]
        ours = copy.deepcopy((estimators, self._fingers, self._health.saved))
        return HybridSavedState(self._dorsum.get_state(), *ours)

    def set_state(self, state: HybridSavedState) -> None:
        """Continue from a `get_state`."""
        self._dorsum.set_state(state.dorsum)
        ours = copy.deepcopy((state.estimators, state.fingers, state.health))
        estimators, self._fingers, health = ours
        for estimator, saved in zip(self._estimators, estimators, strict=True):
            estimator.saved = saved
        self._health.restore(health)


def _only(glove: GloveModel, segment: str) -> GloveModel:
    """The part of a glove on one segment, with markers renumbered."""
    markers = [m for m in glove.markers if m.segment == segment]
    return replace(
        glove,
        imus=tuple(i for i in glove.imus if i.segment == segment),
        markers=tuple(replace(m, id=k) for k, m in enumerate(markers)),
    )
