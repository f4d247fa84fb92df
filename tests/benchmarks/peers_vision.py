"""What anybody would write for blobs with OpenCV: the peer that detection is measured against."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array, IntArray
from tracker.vision.colours import ColourProfile, HueRange

Image = NDArray[np.uint8]
MIN_AREA_PX = 6.0


class PlainOpenCv:
    """cvtColor, inRange per hue, morphological opening, findContours, shape tests, moments."""

    def __init__(self, profile: ColourProfile, extent_px: tuple[float, float]) -> None:
        self._profile, self._extent = profile, extent_px
        self._kernel = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))

    def detect(self, image: Image) -> tuple[Array, IntArray]:
        """Centroids (n, 2) px and hues (n,)."""
        hsv = cv2.cvtColor(image, cv2.COLOR_BGR2HSV)
        uv: list[tuple[float, float]] = []
        hues: list[int] = []
        for k, hue in enumerate(self._profile.hues):
            mask = cv2.morphologyEx(_in_range(hsv, hue), cv2.MORPH_OPEN, self._kernel)
            contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
            for contour in contours:
                if (centre := self._centre(contour)) is not None:
                    uv.append(centre)
                    hues.append(k)
        return np.array(uv, float).reshape(-1, 2), np.array(hues, np.int64)

    def _centre(self, contour: NDArray[np.int32]) -> tuple[float, float] | None:
        area = cv2.contourArea(contour)
        if area < MIN_AREA_PX:
            return None
        shape = self._profile.shape
        low, high = shape.size
        extent = max(cv2.boundingRect(contour)[2:])
        if not low * self._extent[0] <= extent <= high * self._extent[1]:
            return None
        if area < shape.convexity * cv2.contourArea(cv2.convexHull(contour)):
            return None
        if 4 * np.pi * area < shape.circularity * cv2.arcLength(contour, True) ** 2:
            return None
        m = cv2.moments(contour)
        return m["m10"] / m["m00"], m["m01"] / m["m00"]


def _in_range(hsv: Image, hue: HueRange) -> Image:
    (h0, h1), (s0, s1), (v0, v1) = hue.hue, hue.saturation, hue.value
    if h0 <= h1:
        return np.asarray(cv2.inRange(hsv, (h0, s0, v0), (h1, s1, v1)), np.uint8)
    low = cv2.inRange(hsv, (h0, s0, v0), (179, s1, v1))
    high = cv2.inRange(hsv, (0, s0, v0), (h1, s1, v1))
    return np.asarray(cv2.bitwise_or(low, high), np.uint8)
