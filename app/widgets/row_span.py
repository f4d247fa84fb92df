"""The part of a line that may touch a row of pixels, for curves and shapes over images."""

from __future__ import annotations

from tracker.kernels import kernel


@kernel(error_model="numpy", inline="always")
def row_span(
    ends: tuple[float, float, float, float], reach: float, v: float
) -> tuple[float, float]:
    """The least and the greatest u px of the line's points that are within ``reach`` px of the row
    ``v`` px; ``ends`` are u and v px of its start and of its end."""
    xa, ya, xb, yb = ends
    dx, dy = xb - xa, yb - ya
    low, high = min(xa, xb), max(xa, xb)
    if dy != 0.0:
        s0, s1 = (v - reach - ya) / dy, (v + reach - ya) / dy
        s0, s1 = min(s0, s1), max(s0, s1)
        s0, s1 = min(max(s0, 0.0), 1.0), min(max(s1, 0.0), 1.0)
        low, high = min(xa + s0 * dx, xa + s1 * dx), max(xa + s0 * dx, xa + s1 * dx)
    return low, high
