"""Devices: the glove's link and clock, cameras, and simulated ones that behave as badly."""
