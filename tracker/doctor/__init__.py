"""Checks of the computer and the devices, each with a verdict and a remedy."""
