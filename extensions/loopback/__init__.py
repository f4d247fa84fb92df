"""Measures the delay from a command to the glove to its light in an image, with real devices."""
