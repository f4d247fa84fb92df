"""Learns colours from one image of the glove alone, when no packets determine the hand's posture.

A glove shows many small patches of its hues close together on uniform cloth. Of several wide
profiles, for neutral, warmer and cooler light, the one that finds most of such a cluster is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import cv2
import numpy as np

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.calibration.colours_fit import FoundHue, Image, fit_samples, parted
from tracker.calibration.colours_learn import ColourSamples, learn, wide_profiles
from tracker.calibration.colours_sample import KnownMarkers, core_pixels, denoised, samples_of
from tracker.messages import Array, Blobs, IntArray
from tracker.vision.colours import ColourProfile, HueRange
from tracker.vision.detector import Detector

NEAR = 5.0  # extents of a blob, within which its neighbours are counted
HAND = 11.0  # extents, from the centre of a hand to its farthest marker
LIKE = 1.6  # maximum ratio of the extents of one glove's markers
SAME = 4.0  # px, distance of two detections of one patch
LEAST_PATCHES, LEAST_HUES = 8, 2
PICKED_PX = 5.0  # around the selected pixel
POINTED_PX = 10.0  # from the selected pixel to the centre of its marker
MUCH_MORE = 1.5  # times the other blobs
PICKED_CONTRAST = 0.1  # required of patches similar to the selected ones


def learn_image(
    image: Image, profile: ColourProfile, marker_size: float, fx: float
) -> tuple[ColourProfile, tuple[FoundHue, ...]]:
    """A profile learned from a BGR image of the glove; ``marker_size`` m, ``fx`` px of the camera.

    Raises GlovetrackError unless a glove is clearly visible.
    """
    best, crowd = Blobs.empty(), np.zeros(0, np.int64)
    smooth = denoised(image)
    for wide in wide_profiles(profile):
        blobs, _ = Detector(wide, marker_size, fx).detect(smooth)
        rows = glove_of(blobs)
        if len(rows) > len(crowd):
            best, crowd = blobs, rows
    if len(crowd) < LEAST_PATCHES or len(set(best.hue[crowd].tolist())) < LEAST_HUES:
        raise GlovetrackError(notice("colours.no_glove_seen"))
    names = profile.hue_names
    hue = tuple(names[k] for k in best.hue[crowd])
    known = KnownMarkers(best.uv[crowd], best.size[crowd], hue, best.uv[crowd])
    samples = samples_of(image, known, names)
    fitted = replace(learn(profile, samples), shape=profile.shape)  # too few pixels for new limits
    _refuse_worse(image, (profile, fitted), (marker_size, fx), best.uv[crowd])
    found = [
        FoundHue(h, samples.patches[h.name], len(samples.pixels(h.name)))
        for h in fitted.hues
        if samples.is_enough(h.name)
    ]
    return fitted, tuple(found)


class Pick(NamedTuple):
    """A selected marker: the BGR image, uv (2,) px of its centre, and its hue's name."""

    image: Image
    uv: Array
    hue: str


def learn_picked(
    picks: Sequence[Pick], profile: ColourProfile, marker_size: float, fx: float
) -> tuple[ColourProfile, tuple[FoundHue, ...]]:
    """A profile learned from one selected marker of each hue, and from similar ones on the same
    glove; ``marker_size`` m, ``fx`` px.

    Raises GlovetrackError if no marker of a hue was selected, no glove is visible around them, or
    the previous colours are better.
    """
    ranges = {p.hue: _around(p) for p in picks}
    missing = [name for name in profile.hue_names if name not in ranges]
    if missing:
        raise GlovetrackError(notice("colours.points_missing", hues=missing))
    hues = parted(tuple(ranges[name] for name in profile.hue_names))
    shape = replace(profile.shape, contrast=min(profile.shape.contrast, PICKED_CONTRAST))
    start = replace(profile, hues=hues, shape=shape, learned=None)
    detector, samples = Detector(start, marker_size, fx), ColourSamples.of(profile.hue_names)
    most = 0
    for image in _distinct(picks):
        blobs, _ = detector.detect(denoised(image))
        rows = glove_of(blobs)
        most = max(most, len(rows))
        hue = tuple(profile.hue_names[k] for k in blobs.hue[rows])
        known = KnownMarkers(blobs.uv[rows], blobs.size[rows], hue, blobs.uv[rows])
        samples.add(samples_of(image, known, profile.hue_names))
    if most < LEAST_PATCHES:
        raise GlovetrackError(notice("colours.only_points_learned"))
    fitted = learn(replace(profile, hues=hues), samples)
    _refuse_worse_picked(picks, (profile, fitted), (marker_size, fx))
    return fitted, tuple(
        FoundHue(h, samples.patches[h.name], len(samples.pixels(h.name)))
        for h in fitted.hues
        if samples.patches[h.name]
    )


def _around(pick: Pick) -> HueRange:
    """The range of the selected cloth."""
    pixels = core_pixels(denoised(pick.image), pick.uv, PICKED_PX)
    hsv = np.asarray(cv2.cvtColor(pixels[None], cv2.COLOR_BGR2HSV), np.uint8)[0]
    return fit_samples(pick.hue, hsv)


def _refuse_worse_picked(
    picks: Sequence[Pick],
    profiles: tuple[ColourProfile, ColourProfile],
    camera: tuple[float, float],
) -> None:
    """Raises GlovetrackError if the second profile finds fewer of the selected markers than the
    first, or as many and far more other blobs."""
    (was, other), (now, others) = (_of_picks(Detector(p, *camera), picks) for p in profiles)
    if now < was or (now == was and others > MUCH_MORE * other):
        raise GlovetrackError(
            notice(
                "colours.learned_worse",
                found=now,
                picked=len(picks),
                others=others,
                found_before=was,
                others_before=other,
            )
        )


def _of_picks(detector: Detector, picks: Sequence[Pick]) -> tuple[int, int]:
    """Number of selected markers found in their hue, and of other blobs."""
    names, shown, blobs = detector.profile.hue_names, 0, 0
    for image in _distinct(picks):
        found, _ = detector.detect(image)
        blobs += len(found)
        for pick in (p for p in picks if p.image is image):
            apart = np.linalg.norm(found.uv - pick.uv, axis=1)
            shown += bool(np.any((found.hue == names.index(pick.hue)) & (apart < POINTED_PX)))
    return shown, blobs - shown


def _distinct(picks: Sequence[Pick]) -> list[Image]:
    """Each image once."""
    return list({id(p.image): p.image for p in picks}.values())


def _refuse_worse(
    image: Image,
    profiles: tuple[ColourProfile, ColourProfile],
    camera: tuple[float, float],
    glove: Array,
) -> None:
    """Raises GlovetrackError if the second profile finds fewer patches of the ``glove`` (n, 2) px
    than the first, or as many and more of the background."""
    (was, other), (now, others) = (_on_glove(Detector(p, *camera), image, glove) for p in profiles)
    if now < was or (now == was and others > other + 1):
        raise GlovetrackError(
            notice(
                "colours.fitted_worse",
                found=now,
                others=others,
                found_before=was,
                others_before=other,
            )
        )


def _on_glove(detector: Detector, image: Image, glove: Array) -> tuple[int, int]:
    """Number of blobs at these positions (n, 2) px, and of others."""
    blobs, _ = detector.detect(image)
    apart = np.linalg.norm(blobs.uv[:, None] - glove[None], axis=2)
    there = int(np.count_nonzero(apart.min(axis=1, initial=np.inf) < SAME))
    return there, len(blobs) - there


def glove_of(blobs: Blobs) -> IntArray:
    """Rows of the blobs that form the densest cluster of patches of similar size."""
    if len(blobs) == 0:
        return np.zeros(0, np.int64)
    extent = blobs.size.max(axis=1)
    apart = np.linalg.norm(blobs.uv[:, None] - blobs.uv[None], axis=2)
    ratio = np.maximum(extent[:, None] / extent[None], extent[None] / extent[:, None])
    alike = (apart < NEAR * extent[:, None]) & (ratio < LIKE)
    seed = int(np.argmax(alike.sum(axis=1)))
    middle = np.median(blobs.uv[alike[seed]], axis=0)
    size = float(np.median(extent[alike[seed]]))
    inside = np.linalg.norm(blobs.uv - middle, axis=1) < HAND * size
    return np.flatnonzero(inside & (alike.sum(axis=1) >= 3))
