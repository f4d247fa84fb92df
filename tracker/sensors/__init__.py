"""Devices: the glove's link and clock, cameras, and checks of their images."""
