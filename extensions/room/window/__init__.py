"""Trackers of other systems in the window: their source, a test, and the alignment."""
