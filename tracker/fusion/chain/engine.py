"""The chain engine: one root position, one orientation per segment, joints that hold exactly.

A `Timeline` puts packets and images in order and drives a `ChainTracker`, whose parts are the
filter (`filter`), recognition (`recognition`), the judgement of tracking (`tracking`), the
wearer's calibration (`calibration.wearer`) and what is shown (`shown`).
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field

import numpy as np

from tracker.base.notices import Notice, notice, warning
from tracker.base.records import record
from tracker.fusion.ablations.variants import check_variant
from tracker.fusion.chain.calibration.size import as_unsure
from tracker.fusion.chain.guided.events import GuidedSaid
from tracker.fusion.chain.guided.holds import Hold
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pose_reset import bends, is_flat
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.reports import with_unsure_size
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tape import Tape
from tracker.fusion.chain.tracker import ChainTracker, TrackerKept
from tracker.fusion.engine import Engine, ExpectedHand
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.fusion.time.timeline import Timeline, TimelineKept
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
class ChainKept:
    """All of a chain engine that changes."""

    timeline: TimelineKept[ChainState]
    tracker: TrackerKept
    holds: list[Hold] = field(default_factory=list)


class ChainEngine(Engine):
    """Visual-inertial filter on a chain of segments; an `Engine`. One instance per hand.

    docs/chain.md derives it; numbers such as ``eq. 12`` in its parts are that page's. It goes on
    from Lee et al. 2021, doi:10.1126/scirobotics.abe1315, whose own filter is `VistEngine`.

    ``tape``, if there is one, is told of all that the filter does. ``wearer`` is what is known of
    the wearer, and takes a user's commands about it.
    """

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        rig: StereoRig,
        params: ChainParams,
        tape: Tape | None = None,
    ) -> None:
        check_variant(params.guide, params.coupling)
        self._layout = ChainLayout(hand, glove)
        buffer = ImuBuffer(len(glove.imus))
        self._buffer = buffer
        self._tracker = self._make_tracker(rig, params, buffer, tape)
        match = params.match
        self._timeline = Timeline(self._tracker, buffer, match.lost_after, match.max_frame_delay)
        self.wearer = self._tracker.wearer
        self.wearer.changed = self._timeline.rebuild_head

    def _make_tracker(
        self, rig: StereoRig, params: ChainParams, buffer: ImuBuffer, tape: Tape | None
    ) -> ChainTracker:
        return ChainTracker(self._layout, rig, params, buffer, tape)

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""
        return self._of_packet(self._timeline.feed_imu(sample), sample.t)

    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen; processed once IMU data cover its exposure."""
        self._timeline.feed_frame(frame)

    def hear(self, said: GuidedSaid, t: float) -> None:
        """A guided pose begins or ends at ``t`` (s)."""
        self.wearer.hear(said, t)

    def reset_pose(self) -> Notice:
        """The wearer holds the hand flat, the fingers straight ahead: align joints with that, and
        the heading where no camera measures it. Reports what was done."""
        side, before = self._layout.hand.side, self._tracker.state
        if self.tracking == Tracking.SEARCHING:
            return warning("pose_reset.searching", side=side)
        refused = self._refuse_reset(before)
        if refused is not None:
            return refused
        bent = bends(before, self._layout)
        self._straighten()
        moved = np.linalg.norm(bends(self._tracker.state, self._layout) - bent, axis=1).max()
        done = self._reset_heading(float(np.rad2deg(moved)))
        self._timeline.rebuild_head()
        return done

    def _refuse_reset(self, state: ChainState) -> Notice | None:
        """Why the pose cannot be the one that is asked for; None where it can."""
        if is_flat(state, self._layout):
            return None
        return warning("pose_reset.bent", side=self._layout.hand.side)

    def _straighten(self) -> None:
        self._tracker.filter.straighten()

    def _reset_heading(self, joints_deg: float) -> Notice:
        """Reports the reset; here the camera measures the heading."""
        return notice("pose_reset.done", side=self._layout.hand.side, joints_deg=joints_deg)

    def take_results(self) -> list[FrameResult]:
        """What was made of images since the last call, oldest first."""
        return self._timeline.take_results()

    def predict(self, t: float) -> Estimate:
        """The hand at any instant near now. Moves nothing."""
        return self._estimate(self._timeline.head_at(t), t)

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """Markers expected in G (n, 3), their sd (n,) m and ids (n,); None while searching."""
        if self.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        return self._tracker.shown.markers(self._timeline.head_at(t))

    def expected(self, t: float) -> ExpectedHand | None:
        """The hand in an image of ``t`` that was not used yet; None while its place is unknown."""
        if self.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        past = self._timeline.past_at(t)
        return ExpectedHand(self._estimate(past, t), *self._tracker.shown.markers(past))

    def _estimate(self, state: ChainState, t: float) -> Estimate:
        return self._tracker.shown.estimate(state, t, self.tracking, self._tracker.state)

    def _of_packet(self, state: ChainState, t: float) -> Estimate:
        """As `_estimate`, with the motion where the packet of ``t`` was taken."""
        newest, tracker = self._buffer.newest, self._tracker
        packet = newest if newest is not None and newest.t == t else None
        return tracker.shown.estimate(state, t, self.tracking, tracker.state, packet)

    # ---- what there is

    @property
    def layout(self) -> ChainLayout:
        """Which row is what in states and profiles."""
        return self._layout

    @property
    def tracking(self) -> Tracking:
        """The state of tracking."""
        return self._tracker.tracking

    @property
    def heading_sd(self) -> float:
        """rad, of how the hand is turned about the vertical: without images it drifts. NaN while
        nothing is known of the hand."""
        if self.tracking == Tracking.SEARCHING:
            return float("nan")
        return self._tracker.confidence.heading_sd(self._tracker.state)

    @property
    def heading_drift_sd(self) -> float:
        """As `heading_sd`, while the camera does not see the hand; NaN otherwise."""
        return self.heading_sd if self.tracking == Tracking.LOST else float("nan")

    @property
    def newest(self) -> float | None:
        """Instant (s) of the newest packet that was taken."""
        return self._timeline.newest

    def catch_up(self) -> None:
        """Move the filter itself to the newest packet: no image will come any more."""
        if self.newest is not None and self.tracking != Tracking.SEARCHING:
            self._timeline.advance(self.newest)

    # ---- the wearer's calibration

    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty; what one camera looks at is as large as it
        was taken for at the start, whatever the images said since."""
        found, size_sd = self.wearer.shown(), self._tracker.size_sd
        return found if size_sd == 0.0 else with_unsure_size(found, size_sd)

    def profile(self) -> WearerProfile:
        """What has been learned of the wearer; what one camera looked at is as large as it was
        taken for at the start."""
        return as_unsure(self.wearer.profile(), self.layout, self._tracker.size_sd)

    def put_on(self, profile: WearerProfile) -> None:
        """Take what is known of the wearer, now and at each new start."""
        self.wearer.put_on(profile)

    # ---- saving

    def get_state(self) -> ChainKept:
        """A copy of everything that changes."""
        return copy.deepcopy(ChainKept(self._timeline.kept, self._tracker.kept, self.wearer.holds))

    def set_state(self, state: ChainKept) -> None:
        """Go on from `get_state`."""
        kept = copy.deepcopy(state)
        self._tracker.restore(kept.tracker)
        self.wearer.holds[:] = kept.holds
        self._timeline.restore(kept.timeline)
