"""Printed sheets for building a glove: markers at true scale, wiring, calibration board."""
