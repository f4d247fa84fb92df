"""Calibration from keyframes, in the background of the chain filter."""
