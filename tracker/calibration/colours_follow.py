"""Adapts the colours to changes of white balance and exposure while the hand is tracked.

The colours of tracked markers are compared with those at the time of learning. If they have
changed, colours are learned again from the last images, tested on the newest image, and accepted if
they find as many of its markers and no more of the background. The decision depends on images and
detections only, so the same messages give the same colours.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from tracker.base.notices import notice
from tracker.calibration.colours_fit import Image
from tracker.calibration.colours_learn import ColourSamples, learn
from tracker.calibration.colours_sample import KnownMarkers, core_colours, known_sides, samples_of
from tracker.glove.model import GloveModel
from tracker.messages import Array, BlobFrame, FrameResult, StereoFrame, Tracking
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import Detector

FOLLOWED = notice("colours.followed")
"""Reports each new profile: the light has changed, or the initial colours were of another room or
of a hand in other shade."""

APART = 0.2  # s between two evaluated images
STORED, LEAST = 6, 3  # stored images: over a second, shade averages out
LEAST_MARKERS = 6  # matched, for an image to be used
TINT = 0.09  # ln of a channel relative to green: another light, beyond the effect of shade
BRIGHT = 0.35  # ln of all channels and hues together
FOUND_PX = 10.0  # from the position predicted before the image was evaluated
LIKELY = 0.6  # probability that a marker is visible
FEWER = 1  # markers per image that new colours may miss compared with the old ones
MORE_OF_THE_ROOM = 4  # additional background blobs per image that new colours may find


class ExpectedHues(NamedTuple):
    """An image, and the markers expected in it: uv (n, 2) px and the hue's name of each."""

    image: Image
    uv: Array
    hue: tuple[str, ...]


class Look(NamedTuple):
    """Both sides of an image with their known markers, those expected, and ln BGR (3,) of each
    hue's cloth."""

    sides: list[tuple[Image, KnownMarkers]]
    expected: list[ExpectedHues]
    tints: Mapping[str, Array]


class ColourFollower:
    """For one glove; ``marker_size`` (m) and ``fx`` (px) are the detector's."""

    def __init__(
        self, profile: ColourProfile, glove: GloveModel, marker_size: float, fx: float
    ) -> None:
        self.profile = profile
        self._glove, self._camera = glove, (marker_size, fx)
        self._looks: deque[Look] = deque(maxlen=STORED)
        self._reference: dict[str, Array] = {}
        self._due = -np.inf

    def is_due(self, t: float) -> bool:
        """Whether an image at ``t`` (s) is to be evaluated, so that others need not be decoded."""
        return t >= self._due or t < self._due - 10 * APART

    def take(self, profile: ColourProfile) -> None:
        """Continue with a profile that was changed elsewhere."""
        self.profile, self._reference = profile, {}
        self._looks.clear()

    def look(
        self, frame: StereoFrame, blobs: BlobFrame, result: FrameResult
    ) -> ColourProfile | None:
        """Processes an image and its result; returns a profile for the present light if the old one
        no longer fits."""
        matched = np.count_nonzero((result.match_left >= 0) | (result.match_right >= 0))
        if result.tracking != Tracking.TRACKING or matched < LEAST_MARKERS:
            return None
        self._due = frame.t + APART
        sides = known_sides(frame, blobs, result, self._glove)
        expected = _expected(frame, result, self._glove)
        self._looks.append(Look(sides, expected, core_colours(sides)))
        if len(self._looks) < LEAST:
            return None
        now = self._typical()
        if not self._reference:
            self._reference = now
        for name in now.keys() - self._reference.keys():
            self._reference[name] = now[name]
        if not self._has_moved(now):
            return None
        return self._learned(now)

    def _typical(self) -> dict[str, Array]:
        """Median over the stored images, of hues present in at least half of them."""
        out = {}
        for name in self.profile.hue_names:
            seen = [look.tints[name] for look in self._looks if name in look.tints]
            if 2 * len(seen) >= len(self._looks):
                out[name] = np.median(seen, axis=0)
        return out

    def _has_moved(self, now: Mapping[str, Array]) -> bool:
        """Whether the light differs from that at the time of learning, according to the cloth."""
        names = [name for name in now if name in self._reference]
        if len(names) < 2:
            return False
        gain = np.array([now[name] - self._reference[name] for name in names])
        tint = np.abs(np.median(gain - gain.mean(axis=1, keepdims=True), axis=0)).max()
        return bool(tint > TINT or abs(np.median(gain)) > BRIGHT)

    def _learned(self, now: dict[str, Array]) -> ColourProfile | None:
        """A new profile, if it is as good as the old one for the newest image."""
        if len(self._looks) < STORED:
            return None
        samples, names = ColourSamples.of(self.profile.hue_names), self.profile.hue_names
        for look in self._looks:
            for image, known in look.sides:
                samples.add(samples_of(image, known, names))
        self._reference = now  # even if rejected: tested again when the light changes
        new = learn(self.profile, samples)
        (was, room), (found, others) = (self._on_newest(p) for p in (self.profile, new))
        if found < was - FEWER or others > room + MORE_OF_THE_ROOM:
            return None
        self.profile = new
        return new

    def _on_newest(self, profile: ColourProfile) -> tuple[float, float]:
        """Expected markers of the newest image found with a profile, and other blobs, both per
        image."""
        detector, found, others = Detector(profile, *self._camera), 0, 0
        sides = self._looks[-1].expected
        for image, uv, hue in sides:
            blobs, _ = detector.detect(image)
            names = np.array(profile.hue_names)[blobs.hue]
            near = np.linalg.norm(uv[:, None] - blobs.uv[None], axis=2) < FOUND_PX
            own = near & (np.array(hue)[:, None] == names[None])
            found += int(own.any(axis=1).sum())
            others += len(blobs) - int(own.any(axis=0).sum())
        return found / max(len(sides), 1), others / max(len(sides), 1)


def _expected(frame: StereoFrame, result: FrameResult, glove: GloveModel) -> list[ExpectedHues]:
    """For each side that has an image."""
    out = []
    for image, uv in ((frame.left, result.predicted_left), (frame.right, result.predicted_right)):
        if image is not None:
            rows = np.flatnonzero(np.isfinite(uv).all(axis=1) & (result.visible >= LIKELY))
            out.append(
                ExpectedHues(image, uv[rows], tuple(glove.markers[int(m)].hue for m in rows))
            )
    return out
