"""The chain engine: one root position, one orientation per segment, rigidly connected joints.

A `Timeline` orders packets and images by time and drives a `ChainTracker`, whose parts are the
filter (`filter`), recognition (`recognition`), the tracking state (`tracking`), the wearer's
calibration (`calibration.wearer`) and the output (`shown`).
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any

import numpy as np

from tracker.base.notices import Notice, notice, warning
from tracker.base.records import record
from tracker.fusion.ablations.variants import check_variant
from tracker.fusion.chain.bundle.solver import BundleWork
from tracker.fusion.chain.guided.holds import Hold, ReducedRows
from tracker.fusion.chain.guided.learning import CALIBRATION
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, PriorParams
from tracker.fusion.chain.pose_reset import bends, is_flat
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tape import Tape
from tracker.fusion.chain.tracker import ChainTracker, TrackerSavedState
from tracker.fusion.engine import Engine, ExpectedHand
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.fusion.time.timeline import Timeline, TimelineSavedState
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.vision.rig import StereoRig


@record("chain", sized=True)
@dataclass(eq=False)
class ChainSavedState:
    """The complete state of a chain engine."""

    timeline: TimelineSavedState[ChainState]
    tracker: TrackerSavedState
    holds: list[Hold] = field(default_factory=list)


class PoseAlignment:
    """Aligns the joints with a flat hand that the wearer holds, fingers straight ahead."""

    def __init__(self, tracker: ChainTracker, layout: ChainLayout) -> None:
        self._tracker, self._layout = tracker, layout
        self._side = layout.hand.side

    def refusal(self) -> Notice | None:
        """Returns why the hand cannot be in that pose; None where it can."""
        if is_flat(self._tracker.state, self._layout):
            return None
        return warning("pose_reset.bent", side=self._side)

    def align(self) -> Notice:
        """Corrects the joints, and the heading where no camera measures it."""
        bent = bends(self._tracker.state, self._layout)
        self._straighten()
        moved = np.linalg.norm(bends(self._tracker.state, self._layout) - bent, axis=1).max()
        return self._align_heading(float(np.rad2deg(moved)))

    def _straighten(self) -> None:
        self._tracker.filter.straighten()

    def _align_heading(self, joints_deg: float) -> Notice:
        """Does nothing: the camera measures the heading."""
        return notice("pose_reset.done", side=self._side, joints_deg=joints_deg)


class WearerEngine(Engine):
    """The part of an engine that learns the wearer: a `wearer_learning.LearnsWearer`.

    ``wearer`` holds the wearer's calibration and executes the user's commands on it.
    """

    def __init__(self, layout: ChainLayout, tracker: ChainTracker) -> None:
        self._layout, self._reported = layout, tracker.reported
        self.wearer = tracker.wearer

    @property
    def layout(self) -> ChainLayout:
        """The rows of states and profiles."""
        return self._layout

    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""
        return self._reported.calibration()

    def profile(self) -> WearerProfile:
        """The learned wearer profile."""
        return self._reported.profile()

    def apply_profile(self, profile: WearerProfile) -> None:
        """Use a wearer profile, now and at each new start."""
        self.wearer.apply_profile(profile)


class ChainEngine(WearerEngine):
    """Visual-inertial filter on a chain of segments; an `Engine`. One instance per hand.

    docs/chain.md derives it; numbers such as ``eq. 12`` in its parts refer to that page. It extends
    Lee et al. 2021, doi:10.1126/scirobotics.abe1315, whose own filter is `VistEngine`.

    ``tape``, if given, records all operations of the filter.
    """

    _tracker_type: type[ChainTracker] = ChainTracker

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        rig: StereoRig,
        params: ChainParams,
        tape: Tape | None = None,
    ) -> None:
        check_variant(params.guide, params.coupling)
        layout, self._prior = ChainLayout(hand, glove), params.prior
        buffer, match = ImuBuffer(len(glove.imus)), params.match
        self._tracker = self._tracker_type(layout, rig, params, buffer, tape)
        super().__init__(layout, self._tracker)
        self._timeline = Timeline(self._tracker, buffer, match.lost_after, match.max_frame_delay)
        self.wearer.changed = self._timeline.rebuild_head
        self._pose_reset = PoseAlignment(self._tracker, self._layout)

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Process a packet; returns the hand at the packet's time."""
        state = self._timeline.feed_imu(sample)
        return self._estimate(state, sample.t, self._timeline.packet_at(sample.t))

    def feed_frame(self, frame: BlobFrame) -> None:
        """Queue an image; it is processed once IMU data cover its exposure."""
        self._timeline.feed_frame(frame)

    def set_vibration(self, gyro: float, accel: float) -> None:
        """Raises the noise of the IMUs."""
        self._tracker.filter.set_vibration(gyro, accel)

    def reset_pose(self) -> Notice:
        """Aligns the joints with a hand that the wearer holds flat, the fingers straight ahead, and
        the heading where no camera measures it. Returns a notice of the result."""
        if self.tracking == Tracking.SEARCHING:
            return warning("pose_reset.searching", side=self._layout.hand.side)
        refused = self._pose_reset.refusal()
        if refused is not None:
            return refused
        done = self._pose_reset.align()
        self._timeline.rebuild_head()
        return done

    def drain_notices(self) -> list[Notice]:
        """Notices since the last call: of a glove that does not match its file."""
        return self.wearer.calibration.glove_check.notices.drain()

    def take_results(self) -> list[FrameResult]:
        """The results of the images since the last call, oldest first."""
        return self._timeline.take_results()

    def predict(self, t: float) -> Estimate:
        """The hand at any time close to the present. Changes nothing."""
        return self._estimate(self._timeline.head_at(t), t)

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """Markers expected in G (n, 3), their sd (n,) m and ids (n,); None while searching."""
        if self.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        return self._tracker.shown.markers(self._timeline.head_at(t))

    def expected(self, t: float) -> ExpectedHand | None:
        """The predicted hand in an image of ``t`` not processed yet; None while its position is
        unknown."""
        if self.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        past = self._timeline.past_at(t)
        return ExpectedHand(self._estimate(past, t), *self._tracker.shown.markers(past))

    def _estimate(self, state: ChainState, t: float, packet: ImuSample | None = None) -> Estimate:
        """The hand of a nominal state at ``t``; with its motion where ``packet`` is of ``t``."""
        tracker = self._tracker
        return tracker.shown.estimate(state, t, self.tracking, tracker.state, packet)

    # ---- properties

    @property
    def tracker(self) -> ChainTracker:
        """The tracker of the one hand, for measurements of it."""
        return self._tracker

    @property
    def tracking(self) -> Tracking:
        """The state of tracking."""
        return self._tracker.tracking

    @property
    def heading_sd(self) -> float:
        """rad, standard deviation of the rotation about the vertical, which drifts without images.
        NaN while the hand is unknown."""
        if self.tracking == Tracking.SEARCHING:
            return float("nan")
        return self._tracker.confidence.heading_sd(self._tracker.state)

    @property
    def heading_drift_sd(self) -> float:
        """As `heading_sd`, while the camera does not see the hand; NaN otherwise."""
        return self.heading_sd if self.tracking == Tracking.LOST else float("nan")

    @property
    def newest(self) -> float | None:
        """Time (s) of the newest accepted packet."""
        return self._timeline.newest

    def catch_up(self) -> None:
        """Move the filter itself to the newest packet: no more images will arrive."""
        if self.newest is not None and self.tracking != Tracking.SEARCHING:
            self._timeline.advance(self.newest)

    # ---- saving

    def get_state(self) -> ChainSavedState:
        """A copy of the complete state."""
        return copy.deepcopy(
            ChainSavedState(self._timeline.saved, self._tracker.saved, self.wearer.holds)
        )

    def set_state(self, state: ChainSavedState) -> None:
        """Continue from a `get_state`."""
        saved = copy.deepcopy(state)
        complete_axes(saved, self._layout, self._prior)
        self._tracker.restore(saved.tracker)
        self.wearer.calibration.glove_check.restart()
        self.wearer.holds[:] = saved.holds
        self._timeline.restore(saved.timeline)


# ---- states of recordings made before the values of fixed axes were estimated
#
# They continue as if nothing about the axes had been learned: with the files' values and the
# initial uncertainty, independent of everything else. A keyframe solution in progress is started
# again.


def complete_axes(saved: Any, layout: ChainLayout, prior: PriorParams) -> None:
    """Adds the values of fixed axes to all parts of ``saved`` that lack them, in place."""
    if layout.fixed_axes:
        variance = np.diag(initial_covariance(layout, prior))[layout.blocks.axis :].copy()
        _complete(saved, variance)


def _complete(part: Any, variance: Array) -> None:
    if isinstance(part, ChainState | WearerProfile):
        _complete_state(part, variance)
    elif isinstance(part, ReducedRows):
        _complete_rows(part, len(variance))
    elif isinstance(part, list | tuple):
        for inside in part:
            _complete(inside, variance)
    elif is_dataclass(part):
        if isinstance(part, BundleWork):
            _start_again(part)
        for field in fields(part):
            _complete(getattr(part, field.name), variance)


def _complete_state(part: ChainState | WearerProfile, variance: Array) -> None:
    if len(part.axis):
        return
    k = len(variance)
    object.__setattr__(part, "axis", np.zeros(k))  # a profile is frozen
    if len(part.P):
        P = np.zeros((len(part.P) + k, len(part.P) + k))
        P[:-k, :-k], P[-k:, -k:] = part.P, np.diag(variance)
        object.__setattr__(part, "P", P)


def _complete_rows(rows: ReducedRows, k: int) -> None:
    if len(rows.calibration) < len(CALIBRATION):
        rows.H = np.column_stack([rows.H, np.zeros((len(rows.H), k))])
        rows.calibration = [*rows.calibration, np.zeros(k)]


def _start_again(work: BundleWork) -> None:
    if work.calibration is not None and not len(work.calibration.axis):
        fresh = replace(BundleWork(), asked_at=work.asked_at, next_at=work.next_at)
        for name in ("calibration", "frames", "p", "R_GB", "back", "sweep", "N", "g"):
            setattr(work, name, getattr(fresh, name))
