"""What a chain engine has learned of its wearer: shown, kept, taken along, refined."""

from __future__ import annotations

from collections.abc import Sequence

from tracker.fusion.chain.bundle.keyframes import keyframe_of
from tracker.fusion.chain.bundle.solver import Bundle, BundleWork, adopt
from tracker.fusion.chain.calibration import control
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.profile import WearerProfile, profile_of, wear
from tracker.fusion.chain.reports import calibration_of
from tracker.fusion.chain.start.start import Starter
from tracker.fusion.chain.state import ChainState
from tracker.fusion.time.lagged import LaggedEngine
from tracker.geometry.kernels import relative_rotations
from tracker.messages import Calibration, CameraPose, IntArray

AROUND = (-0.01, 0.0, 0.01)  # s: neighbours that give an angular acceleration


class CalibratedChain(LaggedEngine[ChainState]):
    """The part of `ChainEngine` that has to do with calibration."""

    _layout: ChainLayout
    _params: ChainParams
    _starter: Starter
    _held: WearerProfile | None  # the calibration while it is frozen
    _bundle: Bundle
    _work: BundleWork

    @property
    def layout(self) -> ChainLayout:
        return self._layout

    def calibration(self) -> Calibration:
        if self._held is not None:
            shown = control.with_held(self._state, self._layout, self._held)
            return calibration_of(self._layout, shown)
        return calibration_of(self._layout, self._state)

    @property
    def _known(self) -> WearerProfile | None:
        """What every new start begins with."""
        return self._starter.profile

    @_known.setter
    def _known(self, profile: WearerProfile | None) -> None:
        self._starter.profile = profile

    def profile(self) -> WearerProfile:
        """What has been learned of the wearer."""
        return self._held or profile_of(self._state, self._layout)

    def put_on(self, profile: WearerProfile) -> None:
        """Take what is known of the wearer, now and at each new start."""
        self._starter.profile = profile
        wear(self._state, self._layout, profile)
        self._keep_frozen()

    def reset_calibration(self, segments: Sequence[str] | None = None) -> None:
        """Forget what was learned of some segments, or (None) of all of them."""
        if self._held is not None:
            wear(self._state, self._layout, self._held)
        self._work = BundleWork()
        names = self._layout.names if segments is None else segments
        control.reset_calibration(self._state, self._layout, self._params.prior, names)
        known = segments is not None and self._starter.profile is not None
        self._starter.profile = profile_of(self._state, self._layout) if known else None
        self._keep_frozen()

    def freeze_calibration(self, on: bool) -> None:
        """Hold the calibration as it is now, or go on estimating it from there."""
        if not on and self._held is not None:
            wear(self._state, self._layout, self._held)
        self._held = profile_of(self._state, self._layout) if on else None
        self._keep_frozen()

    def _keep_frozen(self) -> None:
        """After a change of the calibration: hold the new one if it is frozen."""
        if self._held is not None:
            self._held = profile_of(self._state, self._layout)
            control.hold_calibration(self._state, self._layout)
        self._rebuild_head()

    def _calibrate(self, seen: tuple[SeenBlobs, ...], match: IntArray, pose: CameraPose) -> None:
        """Remember this posture if it is worth it, and go a step on with the keyframes' bundle."""
        if self._bundle.wants(self._work, self._state.t):
            relative = relative_rotations(self._state.R_GB, self._layout.parent)
            if self._bundle.lacks(self._work, relative):
                around = tuple(self._buffer.at(self._state.t + d) for d in AROUND)
                frame = keyframe_of(
                    self._state, seen, match, pose, around, relative, self._params.bundle
                )
                self._bundle.offer(self._work, frame)
        found = self._bundle.step(self._work, self._state)
        if found is not None:
            adopt(self._state, self._layout, found)
