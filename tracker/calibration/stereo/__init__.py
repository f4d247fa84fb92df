"""Stereo calibration with a printed board: views, coverage, solution, checks, verification."""
