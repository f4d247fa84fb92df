"""The methods of filling gaps. Quick to import."""

from __future__ import annotations

LINEAR, CUBIC, SMOOTH = "linear", "cubic", "smooth"
METHODS = (LINEAR, CUBIC, SMOOTH)
"""Straight lines and great arcs; with the speeds at both ends; the sensors, smoothed."""
