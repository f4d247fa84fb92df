"""Predicted markers in front of something of their own colour, or beside it.

Their pixels are connected with it, so the region has the wrong size or shape. In an image without
the pixels on edges, the marker is a region of its own.
"""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array, Blobs, IntArray
from tracker.vision.components import Scan
from tracker.vision.hints import DetectionHints

Image = NDArray[np.uint8]
SHARE = 0.5  # of a prediction's radius, within which a blob of its hue is taken for the marker
MIDDLE_PX = 4  # from a prediction, within which at least one pixel has a hue
APART_PX = 8.0  # from a blob of the same hue, below which a region is part of it
EDGE, EDGE_SPARE = 0.15, 1.2
"""An edge is where a channel varies by this share of the brightest one within 3 x 3 px, plus levels
for the noise of dark images."""
_SQUARE = np.ones((3, 3), np.uint8)


def missing(hints: DetectionHints, blobs: Blobs, scan: Scan) -> DetectionHints:
    """The predicted markers with no blob of their hue near them, on pixels where ``scan`` found a
    region of any hue. Most others are hidden."""
    found = _is_near(hints, blobs.uv, blobs.hue).any(axis=0)
    distance = np.linalg.norm(blobs.uv[:, None] - hints.uv[None], axis=2)
    found |= (distance <= APART_PX).any(axis=0)  # hidden behind another one
    missed = np.isfinite(hints.uv).all(axis=1) & (hints.hue >= 0) & ~found
    for k in np.flatnonzero(missed).tolist():
        u, v = (int(x) for x in np.clip(hints.uv[k], -MIDDLE_PX - 1, 1e6))
        rows = slice(max(v - MIDDLE_PX, 0), max(v + MIDDLE_PX + 1, 0))
        columns = slice(max(u - MIDDLE_PX, 0), max(u + MIDDLE_PX + 1, 0))
        missed[k] = (scan.visited[rows, columns] >= scan.mark).any()
    size = None if hints.size_px is None else hints.size_px[missed]
    return replace(
        hints,
        uv=hints.uv[missed],
        radius_px=hints.radius_px[missed],
        hue=hints.hue[missed],
        size_px=size,
    )


def without_edges(image: Image, hints: DetectionHints) -> tuple[Image, Array]:
    """The part of a BGR image around ``hints``, black on edges, and its first pixel (2,)."""
    height, width = image.shape[:2]
    reach = hints.radius_px[:, None]
    low = np.clip(np.floor((hints.uv - reach).min(axis=0)), 0, (width, height)).astype(int)
    high = np.clip(np.ceil((hints.uv + reach).max(axis=0)) + 1, 0, (width, height)).astype(int)
    part = np.ascontiguousarray(image[low[1] : high[1], low[0] : high[0]])
    if part.size:
        most = cv2.dilate(part, _SQUARE)
        change = _brightest(cv2.subtract(most, cv2.erode(part, _SQUARE)))
        limit = cv2.convertScaleAbs(_brightest(most), alpha=EDGE, beta=EDGE_SPARE)
        part = cv2.bitwise_and(part, part, mask=cv2.compare(change, limit, cv2.CMP_LE))
    return np.asarray(part, np.uint8), low.astype(float)


def near_them(hints: DetectionHints) -> DetectionHints:
    """``hints`` with the radius within which a blob is taken for the marker."""
    return replace(hints, radius_px=SHARE * hints.radius_px)


def with_new(blobs: Blobs, others: Blobs, missed: DetectionHints) -> Blobs:
    """``blobs``, and of the ``others`` those that are ``missed`` markers."""
    new = _is_near(missed, others.uv, others.hue).any(axis=1)
    if len(blobs) and len(others):
        d = np.linalg.norm(others.uv[:, None] - blobs.uv[None], axis=2)
        new &= ~((d <= APART_PX) & (others.hue[:, None] == blobs.hue[None])).any(axis=1)
    if not new.any():
        return blobs
    return replace(
        blobs,
        uv=np.concatenate([blobs.uv, others.uv[new]]),
        size=np.concatenate([blobs.size, others.size[new]]),
        hue=np.concatenate([blobs.hue, others.hue[new]]),
        score=np.concatenate([blobs.score, others.score[new]]),
    )


def _is_near(hints: DetectionHints, uv: Array, hue: IntArray) -> NDArray[np.bool_]:
    """(n, k) whether blobs at uv (n, 2) of a hue (n,) may be the k predicted markers."""
    d = np.linalg.norm(uv[:, None] - hints.uv[None], axis=2)
    near: NDArray[np.bool_] = (d <= SHARE * hints.radius_px) & (hue[:, None] == hints.hue)
    return near


def _brightest(image: Image) -> Image:
    """(h, w) maximum over the channels."""
    b, g, r = cv2.split(image)
    return np.asarray(cv2.max(cv2.max(b, g), r), np.uint8)
