"""Colours adapt to white balance and exposure if that helps, and are otherwise unchanged."""

import dataclasses
from functools import lru_cache

import cv2
import numpy as np
import pytest

from tracker.calibration.colours_follow import APART, STORED, ColourFollower
from tracker.calibration.colours_learn import learn
from tracker.calibration.colours_sample import KnownMarkers, samples_of
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.messages import Array, BlobFrame, FrameResult, StereoFrame, Tracking
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector

FX, SIZE = 640.0, 0.012
EXTENT = 16.0  # px
FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
BGR = {
    "red": (35, 25, 160),
    "yellow": (25, 170, 190),
    "green": (40, 130, 30),
    "blue": (160, 70, 20),
}
CLOTH, ROOM = (45, 40, 38), (150, 165, 175)


def places(glove: GloveModel) -> Array:
    """(M, 2) px, a lattice of markers."""
    k = np.arange(len(glove.markers))
    return np.stack([200.0 + 40 * (k % 8), 150.0 + 40 * (k // 8)], axis=1)


def image(glove: GloveModel, gain: Array, seed: int) -> np.ndarray:
    """Discs of the glove's hues on dark cloth, with noise, in light of this gain of BGR."""
    out = np.full((480, 640, 3), ROOM, np.uint8)
    cv2.rectangle(out, (160, 110), (520, 370), CLOTH, -1)
    for uv, marker in zip(places(glove), glove.markers, strict=True):
        cv2.circle(
            out, tuple(int(x) for x in uv), int(EXTENT / 2), BGR[marker.hue], -1, cv2.LINE_AA
        )
    noisy = out * gain + np.random.default_rng(seed).normal(0, 3, out.shape)
    return np.clip(noisy, 0, 255).astype(np.uint8)


@lru_cache(maxsize=4)
def detector(profile: ColourProfile) -> Detector:
    return Detector(profile, SIZE, FX)


def exposure(
    glove: GloveModel, profile: ColourProfile, t: float, gain: Array
) -> tuple[StereoFrame, BlobFrame, FrameResult]:
    """A tracked image; the blobs are those found with ``profile``."""
    pictures = [image(glove, gain, round(1e3 * t) + side) for side in (0, 1)]
    sides, match = [], []
    for picture in pictures:
        blobs, _ = detector(profile).detect(picture)
        apart = np.linalg.norm(places(glove)[:, None] - blobs.uv[None], axis=2)
        near = apart.argmin(axis=1) if len(blobs) else np.zeros(len(glove.markers), int)
        found = apart.min(axis=1, initial=np.inf) < 4
        sides.append(blobs)
        match.append(np.where(found, near, -1))
    frame = StereoFrame(t, t, *pictures)
    nothing = FrameResult.nothing(t, Tracking.TRACKING, len(glove.markers))
    result = dataclasses.replace(
        nothing, match_left=match[0], match_right=match[1], predicted_left=places(glove),
        predicted_right=places(glove), visible=np.ones(len(glove.markers)),
    )  # fmt: skip
    return frame, BlobFrame(t, t, profile.hue_names, *sides), result


@pytest.fixture(scope="module")
def learned(glove: GloveModel) -> ColourProfile:
    """Colours learned in white light."""
    uv, size = places(glove), np.full((len(glove.markers), 2), EXTENT)
    known = KnownMarkers(uv, size, tuple(m.hue for m in glove.markers), uv)
    samples = samples_of(image(glove, np.ones(3), 0), known, FACTORY.hue_names)
    return learn(FACTORY, samples)


def followed(glove: GloveModel, start: ColourProfile, gains: Array) -> tuple[ColourProfile, int]:
    """Colours after images with each of the gains (n, 3), and the number of changes."""
    follower, changes = ColourFollower(start, glove, SIZE, FX), 0
    for k, gain in enumerate(gains):
        seen = exposure(glove, follower.profile, 10 + 1.01 * APART * k, gain)
        assert follower.is_due(seen[0].t)
        changes += follower.look(*seen) is not None
    return follower.profile, changes


def found(glove: GloveModel, profile: ColourProfile, gain: Array) -> int:
    """Number of markers found with a profile in this light."""
    _, _, result = exposure(glove, profile, 99.0, gain)
    return int(np.sum(result.match_left >= 0))


@pytest.mark.long
def test_colours_adapt_to_a_warm_lamp_that_is_turned_up(
    glove: GloveModel, learned: ColourProfile
) -> None:
    """Blue decreases to under half and red increases by a third over 3 s."""
    end = np.array([0.45, 1.0, 1.33])
    gains = end ** np.linspace(0, 1, 15)[:, None]
    profile, changes = followed(glove, learned, gains)
    assert changes >= 2
    assert found(glove, learned, end) < len(glove.markers)
    assert found(glove, profile, end) == len(glove.markers)


def test_colours_are_unchanged_in_constant_light(glove: GloveModel, learned: ColourProfile) -> None:
    profile, changes = followed(glove, learned, np.ones((STORED + 2, 3)))
    assert changes == 0
    assert profile is learned


def test_nothing_is_learned_without_tracking(glove: GloveModel, learned: ColourProfile) -> None:
    follower = ColourFollower(learned, glove, SIZE, FX)
    for k in range(STORED + 1):
        gain = np.array([1 - 0.08 * k, 1.0, 1.0])
        frame, blobs, result = exposure(glove, learned, 10 + 1.01 * APART * k, gain)
        lost = dataclasses.replace(result, tracking=Tracking.COASTING)
        assert follower.look(frame, blobs, lost) is None
