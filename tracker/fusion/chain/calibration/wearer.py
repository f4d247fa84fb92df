"""The wearer's calibration in a chain engine: output, storage, user commands, refinement."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from tracker.base.records import record
from tracker.fusion.chain.bundle.keyframes import keyframe_of
from tracker.fusion.chain.bundle.solver import (
    Bundle,
    BundleWork,
    SideInformation,
    adopt,
    resize_keyframes,
)
from tracker.fusion.chain.calibration import control
from tracker.fusion.chain.calibration.glove_check import GloveCheck
from tracker.fusion.chain.calibration.size import (
    distance_sd,
    size_index,
    size_sd,
    with_kept_size,
    with_min_size_sd,
)
from tracker.fusion.chain.calibration.size_by_motion import (
    LEAST_SD,
    SizeByMotion,
    SizeByMotionSavedState,
    resize,
    sized,
)
from tracker.fusion.chain.guided.learning import GuidedLearning
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile, profile_of, wear
from tracker.fusion.chain.recognition import Recognised, SeenImage
from tracker.fusion.chain.reports import calibration_of
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.geometry.kernels import relative_rotations
from tracker.messages import Array, Calibration, CameraPose
from tracker.vision.rig import StereoRig


@record("chain.wearer")
@dataclass(eq=False)
class WearerSavedState:
    """The part that changes."""

    held: WearerProfile | None = None  # calibration while it is frozen
    known: WearerProfile | None = None  # initial profile of every new start
    work: BundleWork = field(default_factory=BundleWork)
    by_motion: SizeByMotionSavedState = field(default_factory=SizeByMotionSavedState)


class WearerCalibration:
    """The calibration within a filter's state. The methods modify the given state."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, params: ChainParams) -> None:
        self._layout, self._params = layout, params
        self._bundle = Bundle(layout, rig, params)
        self.glove_check = GloveCheck(layout, rig, params)
        usual = initial_state(layout)
        usual.P = initial_covariance(layout, params.prior)
        self._population = profile_of(usual, layout)
        self._by_motion = SizeByMotion(layout)
        self.saved = WearerSavedState()

    @property
    def is_frozen(self) -> bool:
        """Whether the calibration is frozen."""
        return self.saved.held is not None

    @property
    def known_size_sd(self) -> float:
        """Relative uncertainty of the hand's length; infinite without a profile."""
        known = self.saved.known
        return size_sd(known, self._layout) if known is not None else float("inf")

    @property
    def distance_sd(self) -> float:
        """Relative uncertainty of the distance from one camera for lack of a known size."""
        known = self.saved.known
        return distance_sd(known, self._layout) if known is not None else float("inf")

    def shown(self, state: ChainState) -> Calibration:
        """The calibration as of ``state``."""
        held = self.saved.held
        if held is not None:
            state = control.with_held(state, self._layout, held)
        return calibration_of(self._layout, state)

    def profile(self, state: ChainState) -> WearerProfile:
        """The learned wearer profile."""
        return self.saved.held or profile_of(state, self._layout)

    def start_with(self, state: ChainState, recent: bool) -> WearerProfile | None:
        """The profile for a search of a lost hand: that of ``state`` if it was tracked ``recent``,
        else the initial one."""
        return profile_of(state, self._layout) if recent else self.saved.known

    # ---- a user's commands

    def apply_profile(self, state: ChainState, profile: WearerProfile) -> None:
        """Use a wearer profile, now and at each new start."""
        self.saved.known, self.saved.by_motion = profile, SizeByMotionSavedState()
        wear(state, self._layout, profile)
        self._keep_frozen(state)

    def reset(self, state: ChainState, segments: Sequence[str] | None) -> None:
        """Discard the calibration of some segments, or (None) of all of them. Raises ConfigError
        for a segment that is not estimated."""
        self._thaw(state)
        self.saved.work, self.saved.by_motion = BundleWork(), SizeByMotionSavedState()
        self.glove_check.restart()
        names = self._layout.names if segments is None else segments
        control.reset_calibration(state, self._layout, self._params.prior, names)
        if segments is None:
            self.saved.known = None
        elif self.saved.known is not None:  # the size in a state may be assumed, not measured
            rest, sd = profile_of(state, self._layout), self.known_size_sd
            self.saved.known = with_min_size_sd(rest, self._layout, sd)
        self._keep_frozen(state)

    def freeze(self, state: ChainState, on: bool) -> None:
        """Hold the present calibration, or resume estimating from it."""
        if not on:
            self._thaw(state)
        self.saved.held = profile_of(state, self._layout) if on else None
        self._keep_frozen(state)

    def _thaw(self, state: ChainState) -> None:
        """Restore the covariance that the calibration had when it was frozen."""
        if self.saved.held is not None:
            wear(state, self._layout, self.saved.held)

    def _keep_frozen(self, state: ChainState) -> None:
        """After a change of the calibration: freeze the new one if it is frozen."""
        if self.saved.held is not None:
            self.saved.held = profile_of(state, self._layout)
            control.hold_calibration(state, self._layout)

    # ---- while tracking

    def side_information(self, poses: GuidedLearning, one_camera: bool) -> SideInformation:
        """What is known besides images. ``one_camera``: only one has seen the hand since its start,
        so postures do not measure its size, which remains that of the start."""
        known = self.saved.known
        if one_camera:
            known = with_kept_size(known or self._population, self._layout)
        return SideInformation(poses, known)

    def begin(self, state: ChainState) -> None:
        """A new start: apply the frozen calibration."""
        if self.saved.held is not None:
            wear(state, self._layout, self.saved.held)
            control.hold_calibration(state, self._layout)

    def measure_size(
        self, state: ChainState, camera: CameraPose, place: Array | None, buffer: ImuBuffer
    ) -> bool:
        """Measures the size of a hand that one ``camera`` sees at ``place`` (3,) m, None where its
        image shows too little; returns whether it changed."""
        now = self.saved.by_motion
        if self.is_frozen or not self._by_motion.image(now, state, camera, place, buffer):
            return False
        factor = self._by_motion.complete(now, state, self.distance_sd)
        if factor is None:
            return False
        before = self.saved.known or self._population
        now.before = now.before or before
        index = factor * size_index(state.scale, self._layout)
        known = sized(now.before, self._layout, index, max(now.sd, LEAST_SD))
        scale = state.scale * known.scale / before.scale  # a ruler has measured the length already
        scale *= index / size_index(scale, self._layout)
        resize(state, camera, scale, factor)
        self.saved.known = known
        resize_keyframes(self.saved.work, factor, state.t)
        return True

    def refine(
        self,
        state: ChainState,
        image: SeenImage,
        found: Recognised,
        buffer: ImuBuffer,
        side: SideInformation,
    ) -> None:
        """Stores a suitable posture and performs one step of the keyframe bundle with the
        information besides images, unless the calibration is frozen."""
        if not self._params.bundle.enabled or self.is_frozen:
            return
        self._remember(state, image, found, buffer)
        self.glove_check.image(state, image, found, buffer, self.saved.known)
        solved = self._bundle.step(self.saved.work, state, side)
        if solved is not None:
            adopt(state, self._layout, solved)

    def _remember(
        self, state: ChainState, image: SeenImage, found: Recognised, buffer: ImuBuffer
    ) -> None:
        work = self.saved.work
        if not self._bundle.wants(work, state.t):
            return
        relative = relative_rotations(state.R_GB, self._layout.parent)
        around = buffer.around(state.t) if self._bundle.lacks(work, relative) else None
        if around is None:
            return
        frame = keyframe_of(
            state, image.blobs, found.match, image.pose, around, relative, self._params.bundle
        )
        self._bundle.offer(work, frame)
