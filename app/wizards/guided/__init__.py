"""Guided calibration: poses that the wearer holds on request."""
