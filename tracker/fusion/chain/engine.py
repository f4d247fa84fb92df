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
        """The camera measures the heading."""
        return notice("pose_reset.done", side=self._side, joints_deg=joints_deg)


class ChainEngine(Engine):
    """Visual-inertial filter on a chain of segments; an `Engine`. One instance per hand.

    docs/chain.md derives it; numbers such as ``eq. 12`` in its parts are that page's. It goes on
    from Lee et al. 2021, doi:10.1126/scirobotics.abe1315, whose own filter is `VistEngine`.

    ``tape``, if any, records all operations of the filter. ``wearer`` is what is known of
    the wearer, and takes a user's commands about it.
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
        self._layout = ChainLayout(hand, glove)
        buffer, match = ImuBuffer(len(glove.imus)), params.match
        self._tracker = self._tracker_type(self._layout, rig, params, buffer, tape)
        self._timeline = Timeline(self._tracker, buffer, match.lost_after, match.max_frame_delay)
        self.wearer = self._tracker.wearer
        self.wearer.changed = self._timeline.rebuild_head
        self._pose_reset = PoseAlignment(self._tracker, self._layout)

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""
        state = self._timeline.feed_imu(sample)
        return self._estimate(state, sample.t, self._timeline.packet_at(sample.t))

    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen; processed once IMU data cover its exposure."""
        self._timeline.feed_frame(frame)

    def reset_pose(self) -> Notice:
        """The wearer holds the hand flat, the fingers straight ahead: align joints with that, and
        the heading where no camera measures it. Reports what was done."""
        if self.tracking == Tracking.SEARCHING:
            return warning("pose_reset.searching", side=self._layout.hand.side)
        refused = self._pose_reset.refusal()
        if refused is not None:
            return refused
        done = self._pose_reset.align()
        self._timeline.rebuild_head()
        return done

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

    def _estimate(self, state: ChainState, t: float, packet: ImuSample | None = None) -> Estimate:
        """The hand of a nominal state at ``t``; with motion where there is a packet of ``t``."""
        tracker = self._tracker
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
