"""Engines behind the window: the demo, devices, a replayed session."""
