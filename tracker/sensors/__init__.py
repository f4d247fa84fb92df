"""Devices: the glove's link and clock, cameras, what watches their images."""
