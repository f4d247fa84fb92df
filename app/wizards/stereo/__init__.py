"""Calibration of the stereo camera from a printed board."""
