"""Where markers are expected in an image."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.messages import Array, IntArray


@dataclass(frozen=True, eq=False)
class DetectionHints:
    """Predicted markers of one image, in pixels as recorded.

    uv (n, 2); radius_px (n,) within which the marker certainly is; hue (n,) index into the
    profile's hues; size_px (n,) expected extent of a marker seen head-on, None where unknown.
    """

    uv: Array
    radius_px: Array
    hue: IntArray
    size_px: Array | None = None
