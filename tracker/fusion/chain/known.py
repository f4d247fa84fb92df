"""A chain filter's knowledge of the wearer: from images, guided poses and a profile."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.calibration.size import with_min_distance_sd, with_min_size_sd
from tracker.fusion.chain.calibration.wearer import WearerCalibration, WearerSavedState
from tracker.fusion.chain.confidence import HandConfidence
from tracker.fusion.chain.distal import OWN, DistalSegments
from tracker.fusion.chain.filter import ChainFilter
from tracker.fusion.chain.guided.events import GuidedPoseEvent
from tracker.fusion.chain.guided.holds import Hold
from tracker.fusion.chain.guided.learning import GuidedLearning, GuidedSavedState
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.profile import WearerProfile, wear
from tracker.fusion.chain.recognition import Recognition
from tracker.fusion.chain.reports import with_size_uncertainty
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.tip_bends import TipBends
from tracker.messages import Array, Calibration
from tracker.vision.rig import StereoRig


@dataclass(frozen=True, eq=False)
class WearerSnapshot:
    """The knowledge of the wearer at one time, which can be restored."""

    profile: WearerProfile
    wearer: WearerSavedState
    guided: GuidedSavedState


class Shows(NamedTuple):
    """Components that depend on the wearer's own synergies."""

    hand: ShownHand
    recognition: Recognition
    tips: TipBends


class KnownWearer:
    """``shows`` is updated with the synergies; ``changed`` is called after each change that a user
    requested.

    ``calibration`` is what the filter estimates, ``guided`` what only guided poses determine.
    """

    def __init__(
        self,
        layout: ChainLayout,
        rig: StereoRig,
        params: ChainParams,
        filter_: ChainFilter,
        distal: DistalSegments,
        shows: Shows,
    ) -> None:
        self._layout, self._filter, self._distal, self._shows = layout, filter_, distal, shows
        self._listens = params.guided.enabled
        self.holds: list[Hold] = []
        self.calibration = WearerCalibration(layout, rig, params)
        self.guided = GuidedLearning(layout, distal, params.guided, self.holds)
        self.changed: Callable[[], None] = lambda: None

    # ---- guided poses

    def take_guided_pose(self, event: GuidedPoseEvent, t: float) -> None:
        """A guided pose begins or ends at ``t`` (s)."""
        holds = self.holds
        if holds and not np.isfinite(holds[-1].end):
            holds[-1].end = t
            holds[-1].held = event.held and not event.begins and event.pose == holds[-1].pose
        if event.begins:
            holds.append(Hold(event.pose, t))

    def learn(self) -> bool:
        """Learns from guided poses; returns whether something was learned in this call."""
        if self.calibration.is_frozen or not self._listens:
            return False
        learned = self.guided.step(self._filter)
        if learned:
            self.show()
        return learned

    def begun(self, known: WearerProfile | None) -> None:
        """The filter was initialized, with ``known`` as its only knowledge of the wearer."""
        self.calibration.begin(self._filter.state)
        if not self.calibration.is_frozen and known is self.calibration.saved.known:
            self.guided.again(self._filter)

    # ---- knowledge

    @property
    def synergies(self) -> tuple[Array, Array]:
        """The wearer's synergies: gains (k, 2) and lateral (S,) rad, as for `Completion.wear`."""
        own = self.guided.synergies
        return self._distal.gains(own), self._distal.lateral(own)

    @property
    def end_joints(self) -> dict[str, Array]:
        """By the names of the digits whose end joint is not sensed but has an estimated or
        adjustable synergy: covariance (3, 3) of its ratio, offset (rad) and lateral (rad)."""
        P, digits = self.guided.synergies.P, self._distal.digits
        return {
            d.name: P[OWN * k : OWN * (k + 1), OWN * k : OWN * (k + 1)]
            for k, d in enumerate(digits)
        }

    @property
    def is_learning(self) -> bool:
        """Whether a held pose is still being evaluated."""
        return self._listens and self.guided.saved.over < len(self.holds)

    def show(self) -> None:
        """Update the output with the wearer's own synergies, end joints as measured in images."""
        tips = self._shows.tips
        gains, lateral = tips.worn(*self.synergies)
        self._shows.hand.wear(gains, lateral)
        self._shows.hand.trust(*tips.trusted(self.guided.synergies))
        self._shows.recognition.wear(gains, lateral)

    def shown(self) -> Calibration:
        """Estimated parameters with their uncertainty."""
        return self.calibration.shown(self._filter.state)

    def profile(self) -> WearerProfile:
        """The learned profile, including synergies."""
        known = self.calibration.profile(self._filter.state)
        return replace(known, synergies=self.guided.saved.synergies)

    # ---- a user's commands

    def apply_profile(self, profile: WearerProfile) -> None:
        """Use a wearer profile, now and at each new start."""
        self.guided.apply_profile(profile.synergies)
        self.calibration.apply_profile(self._filter.state, profile)
        if not self.calibration.is_frozen:
            self._shows.hand.confidence.worn(self._filter.state)
        self.show()
        self.changed()

    def reset(self, segments: Sequence[str] | None = None) -> None:
        """Discard the calibration of some segments, or (None) of all of them. Raises ConfigError
        for a segment that is not estimated."""
        self.calibration.reset(self._filter.state, segments)
        if segments is None:
            self.guided.apply_profile(None)
            self.show()
        self.changed()

    def freeze(self, on: bool) -> None:
        """Hold the present calibration, or resume estimating from it."""
        self.calibration.freeze(self._filter.state, on)
        self.changed()

    def remembered(self) -> WearerSnapshot:
        """A copy of the present knowledge, for `restore_snapshot`."""
        calibration = self.calibration
        profile = calibration.profile(self._filter.state)
        return copy.deepcopy(WearerSnapshot(profile, calibration.saved, self.guided.saved))

    def restore_snapshot(self, before: WearerSnapshot) -> None:
        """Restores the knowledge ``before``; the pose is unchanged. Poses held since, including one
        in progress, are ignored."""
        before = copy.deepcopy(before)
        self.calibration.saved = before.wearer
        wear(self._filter.state, self._layout, before.profile)
        self.calibration.begin(self._filter.state)
        self.guided.saved = replace(before.guided, over=len(self.holds), samples=[])
        self.show()
        self.changed()


class ReportedWearer:
    """The wearer's calibration as it is reported: with one camera, its uncertainty includes that of
    the size, which is assumed at the start or measured by motion."""

    def __init__(
        self, layout: ChainLayout, wearer: KnownWearer, confidence: HandConfidence
    ) -> None:
        self._layout, self._wearer, self._confidence = layout, wearer, confidence

    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""
        found, size_sd = self._wearer.shown(), self._size_sd
        return found if size_sd == 0.0 else with_size_uncertainty(found, size_sd)

    def profile(self) -> WearerProfile:
        """The learned wearer profile."""
        learned = with_min_size_sd(self._wearer.profile(), self._layout, self._size_sd)
        distance_sd = self._confidence.size_sd(self._wearer.calibration.distance_sd)
        return with_min_distance_sd(learned, self._layout, distance_sd)

    @property
    def _size_sd(self) -> float:
        """Relative uncertainty of the hand's length for lack of a second camera; 0 with two."""
        return self._confidence.size_sd(self._wearer.calibration.known_size_sd)
