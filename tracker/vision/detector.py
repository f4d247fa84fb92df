"""Coloured blobs in one image: pixels of a hue, connected regions, and shape tests.

The requirements are those of Lee et al. 2021: HSV within the intervals of a profile; size for the
marker's distance, convexity and circularity. A foreshortened disc is an ellipse, which passes.
"""

from __future__ import annotations

import threading
from copy import copy
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.kernels.arrays import Int32Matrix
from tracker.messages import BlobFrame, Blobs, IntArray, RejectedBlobs, StereoFrame
from tracker.vision import search
from tracker.vision.cloth import cloth_around
from tracker.vision.colours import ColourProfile
from tracker.vision.components import Scan, run_buffer
from tracker.vision.hints import DetectionHints
from tracker.vision.hue_table import hue_table
from tracker.vision.shape_tests import (
    ExpectedBlobs,
    RegionLimits,
    Sorted,
    first_failure,
    parted,
    windows_around,
)
from tracker.vision.touching import missing, near_them, with_new, without_edges

Image = NDArray[np.uint8]
REASONS = (
    "size",
    "convexity",
    "circularity",
    "edge",
    "contrast",
    "cloth",
)  # in the order of `shape_tests`
NOWHERE = ExpectedBlobs(np.zeros((0, 2)), np.zeros(0), np.zeros(0, np.int64), np.zeros(0))
HIGHEST_MARK = 255
LARGE = 2.0  # times the largest blob: two touching ones are split, larger regions are background


@dataclass(frozen=True)
class DetectorParams:
    """Search parameters, and the distance range of markers without a prediction."""

    stride: int = 4  # of the seeds' grid; 1 scans every pixel
    hint_stride: int = 3  # around predicted markers, where only these regions are searched
    min_area_px: float = 6.0
    nearest: float = 0.15  # m
    farthest: float = 0.90  # m


class Detector:
    """A detector for one colour profile. Calls are independent of each other and may be concurrent.

    ``marker_size`` (m) and the camera's focal length ``fx`` (px) determine the range of blob sizes.
    """

    def __init__(
        self,
        profile: ColourProfile,
        marker_size: float = 0.012,
        fx: float = 640.0,
        params: DetectorParams | None = None,
    ) -> None:
        self.profile = profile
        self._table = hue_table(profile)
        self._scratch, self._part = _Scratch(), _Scratch()
        learned = profile.learned
        self._in_noise = learned is not None and learned.smoothing_px > 0
        self._set(params or DetectorParams(), marker_size * fx)

    def _set(self, params: DetectorParams, metre_px: float) -> None:
        self.params, self._metre_px = params, metre_px
        shape, learned = self.profile.shape, self.profile.learned
        low, high = shape.size[0], shape.size[1]
        shortest, longest = metre_px / params.farthest, metre_px / params.nearest
        self._limits = RegionLimits(
            low * shortest, high * longest, low, high, shape.convexity, shape.circularity,
            shape.contrast, learned.cloth if learned is not None else 0.0,
        )  # fmt: skip

    def with_params(self, params: DetectorParams) -> Detector:
        """Another detector for the same colours; both share the hue table."""
        other = copy(self)
        other._set(params, self._metre_px)
        return other

    def detect(
        self, image: Image, hints: DetectionHints | None = None
    ) -> tuple[Blobs, RejectedBlobs]:
        """Blobs of a BGR image (h, w, 3) uint8, and regions rejected by their shape.

        With ``hints`` only the regions around them are searched.
        """
        return self._find(self._denoised(image), hints)

    def detect_with_cloth(
        self, image: Image, hints: DetectionHints | None = None
    ) -> tuple[Blobs, RejectedBlobs]:
        """As `detect`, with the glove's cloth around the blobs if the profile includes it."""
        pixels = self._denoised(image)
        blobs, rejected = self._find(pixels, hints)
        if self.profile.learned is not None:
            blobs = replace(blobs, cloth=cloth_around(pixels, self._table, blobs))
        return blobs, rejected

    def _denoised(self, image: Image) -> Image:
        """The image, smoothed as for the learning of its colours."""
        pixels, learned = _checked(image), self.profile.learned
        if learned is not None and learned.smoothing_px:
            pixels = smoothed(pixels, learned.smoothing_px)
        return pixels

    def _find(self, pixels: Image, hints: DetectionHints | None) -> tuple[Blobs, RejectedBlobs]:
        height, width = pixels.shape[:2]
        extent = int(LARGE * self._limits.longest)
        visited, mark = self._scratch.visited(height, width, len(self.profile.hue_names))
        scan = Scan(pixels, self._table, visited, mark, self._scratch.runs(extent), extent)
        windows = self._windows(width, height, hints)
        rows = search.find_regions(scan, windows, self.params.min_area_px)
        found = Sorted(*parted(rows, first_failure(rows, self._limits, _expected(hints))))
        why = tuple(REASONS[k] for k in found.reason.tolist())
        blobs = Blobs(found.uv, found.size, found.hue, found.score)
        if hints is not None and self._in_noise:  # else 0.3 % more markers for twice the time
            blobs = self._with_touching(scan, blobs, hints)
        return blobs, RejectedBlobs(found.other_uv, found.other_hue, why)

    def _with_touching(self, whole: Scan, blobs: Blobs, hints: DetectionHints) -> Blobs:
        """Adds the predicted markers that were not found because they touch something of their own
        colour: regions that are separate without the pixels on edges."""
        missed = missing(hints, blobs, whole)
        if not len(missed.uv):
            return blobs
        cut, corner = without_edges(whole.image, missed)
        height, width = cut.shape[:2]
        visited, mark = self._part.visited(height, width, len(self.profile.hue_names))
        extent = int(LARGE * self._limits.longest)
        scan = Scan(cut, self._table, visited, mark, self._scratch.runs(extent), extent)
        there = replace(missed, uv=missed.uv - corner)
        windows = self._windows(width, height, near_them(there))
        rows = search.find_regions(scan, windows, self.params.min_area_px)
        found = Sorted(*parted(rows, first_failure(rows, self._limits, _expected(there))))
        return with_new(blobs, Blobs(found.uv + corner, found.size, found.hue, found.score), missed)

    def _windows(self, width: int, height: int, hints: DetectionHints | None) -> IntArray:
        """Rows (first and last column, first and last row, stride) of the regions to scan for
        seeds."""
        if hints is None:
            return np.array([[0, width - 1, 0, height - 1, self.params.stride]], np.int64)
        stride = self.params.hint_stride
        return windows_around(hints.uv, hints.radius_px, width, height, stride)


class _Scratch(threading.local):
    """Memory reused between calls: allocating it would take as long as the search."""

    def __init__(self) -> None:
        self._visited, self._mark = np.zeros((0, 0), np.uint8), 1
        self._runs, self._extent = run_buffer(0), 0

    def visited(self, height: int, width: int, hues: int) -> tuple[NDArray[np.uint8], int]:
        """(height, width) marks and a number above all of them, with room for ``hues`` more; valid
        until this thread's next call."""
        if self._visited.shape != (height, width):
            self._visited, self._mark = np.zeros((height, width), np.uint8), 1
        elif self._mark + hues > HIGHEST_MARK:
            self._visited.fill(0)
            self._mark = 1
        mark, self._mark = self._mark, self._mark + hues + 1
        return self._visited, mark

    def runs(self, extent: int) -> Int32Matrix:
        """`run_buffer` for at least this extent (px), valid until this thread's next call."""
        if extent > self._extent:
            self._runs, self._extent = run_buffer(extent), extent
        return self._runs


def detect_frame(
    detector: Detector,
    frame: StereoFrame,
    hints: tuple[DetectionHints, DetectionHints] | None = None,
) -> BlobFrame:
    """Both images of an exposure; a side without an image is None."""
    sides: list[Blobs | None] = []
    rejected: list[RejectedBlobs | None] = []
    for k, image in enumerate((frame.left, frame.right)):
        found = (
            None
            if image is None
            else detector.detect_with_cloth(image, hints[k] if hints else None)
        )
        sides.append(found[0] if found else None)
        rejected.append(found[1] if found else None)
    return BlobFrame(
        t=frame.t,
        t_arrival=frame.t_arrival,
        hue_names=detector.profile.hue_names,
        left=sides[0],
        right=sides[1],
        pose=frame.pose,
        rejected_left=rejected[0],
        rejected_right=rejected[1],
        index=frame.index,
    )


def smoothed(image: Image, width_px: int = 5) -> Image:
    """Denoises an image: a marker is much wider than the filter."""
    return np.asarray(cv2.GaussianBlur(image, (width_px, width_px), 0), np.uint8)


def _expected(hints: DetectionHints | None) -> ExpectedBlobs:
    """Expected sizes; empty where none is known."""
    if hints is None or hints.size_px is None:
        return NOWHERE
    return ExpectedBlobs(hints.uv, hints.radius_px, hints.hue, hints.size_px)


def _checked(image: Image) -> Image:
    if image.ndim != 3 or image.shape[2] != 3 or image.dtype != np.uint8:
        raise GlovetrackError(notice("image.format", shape=str(image.shape), type=image.dtype))
    return np.ascontiguousarray(image)
