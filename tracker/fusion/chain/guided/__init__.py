"""Calibration of the chain filter from poses that a wearer holds on request."""
