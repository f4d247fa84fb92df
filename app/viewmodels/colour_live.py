"""Images and packets of the last seconds, for a fit of the colours to both."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.viewmodels.colour_fits import Fit, FitWork
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.notices import notice
from tracker.calibration.colours_fit import FoundHue
from tracker.messages import ImuSample, StereoFrame
from tracker.vision.colours import ColourProfile

if TYPE_CHECKING:
    from tracker.offline.colours_fit import SessionFit, WatchedGlove

MOST_IMAGES = 20  # pairs, 110 MB at 720p
ENOUGH = 10  # of them, minimum for a fit
APART = 0.1  # s, minimum interval between two of them
GAP = 0.5  # s without packets or images after which earlier ones are discarded
MOST_PACKETS = 4000


class LiveImages:
    """Collects while the panel is visible. A ``wanted`` fit starts when there are enough images."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self._frames: deque[StereoFrame] = deque(maxlen=MOST_IMAGES)
        self._packets: deque[ImuSample] = deque(maxlen=MOST_PACKETS)
        self.wanted = False

    def __len__(self) -> int:
        """Number of stored pairs of images."""
        return len(self._frames)

    @property
    def is_enough(self) -> bool:
        """Whether there are enough images for a fit."""
        return len(self._frames) >= ENOUGH

    def ask(self) -> None:
        """Request a fit as soon as there are enough images.

        Raises ConfigError without a glove and calibrated cameras.
        """
        if not self._setup.whole:
            raise ConfigError(notice("colours.live_needs"))
        self.wanted = True

    def watch(self, view: Snapshot) -> None:
        """Store the latest images and all packets received in the meantime."""
        self._take_packets(view)
        frame = view.frame
        if frame is None or (frame.left is None and frame.right is None):
            return  # one camera may be covered
        if self._frames and not 0 <= frame.t - self._frames[-1].t <= MOST_IMAGES * GAP:
            self._frames.clear()  # the replay position changed, or the panel was hidden
        if not self._frames or frame.t - self._frames[-1].t >= APART:
            self._frames.append(frame)

    def _take_packets(self, view: Snapshot) -> None:
        last = self._packets[-1].t if self._packets else float("-inf")
        if view.imu and view.imu[-1].t < last:
            self._forget()
            last = float("-inf")
        new = [p for p in view.imu if p.t > last]
        if new and self._packets and new[0].t - last > GAP:
            self._forget()
        self._packets.extend(new)

    def _forget(self) -> None:
        self._packets.clear()
        self._frames.clear()

    def fit(self, profile: ColourProfile, refuse: bool = True) -> FitWork:
        """The fit to the collected data, for another thread, which raises GlovetrackError if it is
        rejected; without ``refuse`` it then returns the unchanged profile."""
        self.wanted = False
        messages, setup = self._messages(), self._setup

        def work() -> Fit:
            try:
                return _of_session(_fitted(messages, setup, profile))
            except GlovetrackError:
                if refuse:
                    raise
                return profile, ()

        return work

    def after(self, picked: FitWork, before: ColourProfile) -> FitWork:
        """A fit that starts with ``picked``, learned from clicked pixels of one image, and improves
        it with the collected images, also starting from the colours ``before``; the result with the
        most reliable markers is used.

        Raises GlovetrackError in that thread if ``picked`` does.
        """
        if not (self._setup.whole and self.is_enough):
            return picked
        messages, setup = self._messages(), self._setup

        def work() -> Fit:
            from tracker.offline.colours_fit import check_messages  # deferred: loads SciPy

            best = picked()
            sure = check_messages(messages, _worn(setup), best[0]).sure
            for start in (best[0], before):
                try:
                    fit = _fitted(messages, setup, start)
                except GlovetrackError:
                    continue  # rejected: ``start`` itself may be good enough
                if fit.after.sure > sure:
                    best, sure = _of_session(fit), fit.after.sure
            return best

        return work

    def _messages(self) -> list[ImuSample | StereoFrame]:
        """In the order in which they are fed to the engine."""
        first = self._frames[0].t - GAP if self._frames else 0.0
        messages: list[ImuSample | StereoFrame] = [p for p in self._packets if p.t >= first]
        messages += self._frames
        messages.sort(key=lambda m: m.t_arrival)
        return messages


def _fitted(
    messages: list[ImuSample | StereoFrame], setup: EngineSetup, profile: ColourProfile
) -> SessionFit:
    from tracker.offline.colours_fit import fit_messages  # deferred: loads SciPy

    return fit_messages(messages, _worn(setup), profile)


def _worn(setup: EngineSetup) -> WatchedGlove:
    from tracker.offline.colours_fit import WatchedGlove  # deferred: loads SciPy

    return WatchedGlove(setup.hand, setup.glove, setup.camera.rig)


def _of_session(fit: SessionFit) -> Fit:
    """The result in the form of the other fits."""
    hues = [h for h in fit.profile.hues if fit.patches.get(h.name)]
    return fit.profile, tuple(FoundHue(h, fit.patches[h.name], 0) for h in hues)
