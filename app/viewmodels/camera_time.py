"""How late the camera's images are stamped against the glove, in words."""

from __future__ import annotations

from tracker.messages import Status


def camera_time(status: Status | None) -> str:
    """The measured offset with its 2σ, and whether it is taken off."""
    v = status.values if status is not None else {}
    late_ms, sd_ms = v.get("camera_offset_ms"), v.get("camera_offset_sd_ms")
    if late_ms is None or sd_ms is None:
        return "not known yet: turn the hand"
    word = "late" if late_ms >= 0 else "early"
    applied = "corrected" if v.get("camera_offset_applied_ms", 0.0) else "not corrected"
    return f"{abs(late_ms):.1f} ± {2 * sd_ms:.1f} ms {word}, {applied}"
