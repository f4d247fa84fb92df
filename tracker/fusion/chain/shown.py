"""Estimates of the whole hand from the state of a chain filter."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.fusion.chain.ahead import ahead_variance, velocity_variance
from tracker.fusion.chain.confidence import MEASURED_SD, HandConfidence
from tracker.fusion.chain.distal import DistalSegments, Synergies
from tracker.fusion.chain.kinematics import marker_positions, segment_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import NoiseParams
from tracker.fusion.chain.propagate import rates_now
from tracker.fusion.chain.state import ChainState
from tracker.fusion.output.completion import ActiveSegments, Completion
from tracker.fusion.output.measured_fingers import MeasuredFingers
from tracker.fusion.output.motion import Rates, linked_rates, motion_of
from tracker.fusion.output.output import (
    INFERRED,
    MEASURED,
    EstimateFields,
    HandOutput,
    Sensed,
)
from tracker.fusion.time.timeline import HAND_SPEED, behind_variance
from tracker.geometry.kernels import cross3
from tracker.messages import Array, Estimate, ImuSample, IntArray, Motion, Tracking

RATE_LASTS = 0.4  # s for which a gyroscope's error persists: mainly scale and moving cloth


class ShownHand:
    """Makes estimates for one hand with one glove."""

    def __init__(self, layout: ChainLayout, noise: NoiseParams, distal: DistalSegments) -> None:
        self._layout, self._noise = layout, noise
        self.confidence = HandConfidence(layout, distal)
        ends = self.confidence.ends
        self._output = HandOutput(layout, ends.driven, ends.palm.keypoint)
        self._fingers: MeasuredFingers | None = None

    @property
    def complete(self) -> Completion:
        """Completes the displayed hand from the estimated segments."""
        return self._output.complete

    def wear(self, gains: Array, lateral: Array) -> None:
        """Sets a wearer's own synergies, as `Completion.wear`."""
        self._output.complete.wear(gains, lateral)

    def trust(self, own: Synergies, posture: Array) -> None:
        """Sets the covariance of the end joints to that of these synergies plus (d,) rad."""
        self.confidence.ends.trust(own, posture)

    def show_fingers(self, fingers: MeasuredFingers | None) -> None:
        """Sets the fingers that were measured in images; None if there are none."""
        self._fingers = fingers
        angles, origin = fingers.placed() if fingers is not None else ({}, {})
        self._output.complete.measure(angles, origin)

    # ---- messages

    def estimate(
        self,
        state: ChainState,
        t: float,
        tracking: Tracking,
        past: ChainState,
        packet: ImuSample | None = None,
    ) -> Estimate:
        """The hand of a nominal state at ``t``, propagated from ``past``; with its motion where
        ``packet`` contains the IMU readings at ``t``."""
        ahead = ahead_variance(past, self._layout, self._noise, max(t - past.t, 0.0))
        sure = self.confidence
        variance = sure.tip_sd**2 + ahead + behind_variance(state.t, t) + sure.doubt_variance(t)
        active, sensed = self._active(state), sure.sensed(t, tracking)
        found = self._output.fields(*active, sensed, np.sqrt(variance))
        if found is None:
            return self._output.nothing(t)
        if self._fingers is not None:
            found = self._fingers.judged(found, self._output.keypoints, t, float(variance[0]))
        found = found._replace(state=inferred(found.state, found.sd, sure.saved.most_sd))
        motion = None if packet is None else self._motion(t, found, active, state, past, packet)
        return Estimate(t, tracking, *found, motion)

    def estimate_of(self, state: ChainState, t: float, sensed: Sensed, sd: Array) -> Estimate:
        """The hand of a nominal state; sd (A + d + k,) m are as of
        `EndDeviations`."""
        active = self._active(state)
        return self._output.estimate(t, *active, sensed, sd)

    def _active(self, state: ChainState) -> ActiveSegments:
        return ActiveSegments(state.R_GB, segment_positions(state, self._layout), state.scale3())

    def _motion(
        self,
        t: float,
        found: EstimateFields,
        active: ActiveSegments,
        state: ChainState,
        past: ChainState,
        packet: ImuSample,
    ) -> Motion:
        """The motion of the hand ``found`` at ``t`` from the IMUs and the state's velocity."""
        lay = self._layout
        v_sd, gyro_sd = self._velocity_sd(past, t, packet), self._noise.gyro / RATE_LASTS**0.5
        w, w_sd, turn_sd = rates_now(
            lay.drive, lay.blocks, state.R_GB, state.imus, past.P, packet.gyro, packet.valid,
            gyro_sd,
        )  # fmt: skip
        v = state.v + state.R_GB[0] @ cross3(w[0], state.R_GB[0].T @ (active.p[0] - state.p))
        rates = Rates(*linked_rates(lay.parent, active, v, w, v_sd, w_sd, turn_sd))
        return motion_of(self._output, found, active, rates)

    def _velocity_sd(self, past: ChainState, t: float, packet: ImuSample) -> float:
        """m/s per axis, of the root's IMU at ``t``, propagated from ``past``."""
        accel, tau = packet.accel[self._layout.imu_of[0]], max(t - past.t, 0.0)
        variance = velocity_variance(past, self._layout, self._noise, tau, accel)
        if self.confidence.is_doubted:
            variance += HAND_SPEED**2
        return float(np.sqrt(variance))

    def markers(self, state: ChainState) -> tuple[Array, Array, IntArray]:
        """Markers of a nominal state in G (M, 3), their sd (M,) m and ids (M,)."""
        p_G = marker_positions(state, self._layout)
        return p_G, self.confidence.tip_sd[self._layout.marker_segment], np.arange(len(p_G))


def mark_inferred(estimate: Estimate, most_sd: float = MEASURED_SD) -> Estimate:
    """Marks points with an sd above ``most_sd`` (m) as inferred, even if sensed recently."""
    state = inferred(estimate.keypoint_state, estimate.keypoint_sd, most_sd)
    return estimate if state is estimate.keypoint_state else replace(estimate, keypoint_state=state)


def inferred(state: IntArray, sd: Array, most_sd: float) -> IntArray:
    """``state`` (K,) with the points of an sd (K,) above ``most_sd``, m, marked as inferred."""
    unsure = (sd > most_sd) & (state == MEASURED)
    return np.where(unsure, INFERRED, state) if unsure.any() else state
