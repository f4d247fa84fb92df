"""Calibration of the wearer and of the sensors."""
