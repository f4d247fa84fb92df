"""Fits of a colour profile, to be run in another thread."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.viewmodels.colour_images import Image
from app.viewmodels.names import display_name
from app.words import tr
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.calibration.colours_fit import FoundHue
from tracker.calibration.colours_fit_markers import MarkerSamples, seen_sides
from tracker.calibration.colours_image import learn_image
from tracker.calibration.colours_learn import ColourSamples, learn
from tracker.calibration.colours_sample import KnownMarkers, known_sides, samples_of
from tracker.messages import Tracking
from tracker.vision.colours import ColourProfile

Fit = tuple[ColourProfile, tuple[FoundHue, ...]]
FitWork = Callable[[], Fit]
LEARNED_IMAGES = 12  # pairs, 66 MB at 720p
LEARNED_APART = 0.25  # s between two of them


def image_fit(image: Image | None, profile: ColourProfile, setup: EngineSetup) -> FitWork:
    """Fit to one image of the glove, without knowledge of the hand.

    Raises ConfigError without an image.
    """
    if image is None:
        raise ConfigError(notice("window.no_image_to_fit"))
    size, fx = float(setup.glove.marker_size.mean()), setup.camera.rig.fx
    return lambda: learn_image(image, profile, size, fx)


class MarkerWatch:
    """Collects colours of tracked markers while the panel is visible."""

    def __init__(self, setup: EngineSetup) -> None:
        self._glove = setup.glove
        self._samples = MarkerSamples(setup.glove, setup.profile.hue_names)
        self._images: deque[list[tuple[Image, KnownMarkers]]] = deque(maxlen=LEARNED_IMAGES)
        self._image_due = float("-inf")
        self._last = float("-inf")

    def watch(self, view: Snapshot) -> None:
        """Store the markers that are tracked in this exposure, for a later fit."""
        result, blobs, frame = view.result, view.blobs, view.frame
        if result is None or result.tracking != Tracking.TRACKING or blobs is None or frame is None:
            return
        if frame.t == self._last:
            return
        self._last = frame.t
        if not frame.t < self._image_due <= frame.t + LEARNED_APART:
            self._image_due = frame.t + LEARNED_APART
            self._images.append(known_sides(frame, blobs, result, self._glove))
        sides = seen_sides(frame.left, frame.right, (blobs.left, blobs.right), result)
        self._samples.take(sides, result.visible)

    def fit(self, profile: ColourProfile) -> FitWork:
        """Fit to the collected markers. Raises ConfigError if there are none."""
        if len(self._samples) == 0:
            raise ConfigError(notice("window.no_markers_to_fit"))
        taken, images = self._samples.copy(), list(self._images)
        return lambda: _learned(taken, images, profile)


def _learned(
    taken: MarkerSamples, images: list[list[tuple[Image, KnownMarkers]]], profile: ColourProfile
) -> Fit:
    """Ranges around the markers' colours, and learned colours of the markers, the glove and the
    background."""
    fitted, found = taken.fit(profile)
    samples = ColourSamples.of(profile.hue_names)
    for image, known in (side for sides in images for side in sides):
        samples.add(samples_of(image, known, profile.hue_names))
    return learn(fitted, samples), found


def fit_text(found: Sequence[FoundHue], profile: ColourProfile) -> str:
    """The result of a fit for each hue."""
    if not found:
        return tr("Nothing was fitted: no patches of these colours were found.")
    one, more = tr("{} (1 patch)"), tr("{} ({} patches)")
    fitted = ", ".join(
        (one if f.patches == 1 else more).format(display_name(f.range.name), f.patches)
        for f in found
    )
    kept = [
        display_name(h.name) for h in profile.hues if h.name not in {f.range.name for f in found}
    ]
    if not kept:
        return tr("Fitted {}.").format(fitted)
    return tr("Fitted {}. Not changed: {} (too few patches visible).").format(
        fitted, ", ".join(kept)
    )
