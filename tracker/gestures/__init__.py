"""Gestures of a tracked hand, in OpenXR's terms: their values, and when each begins and ends."""
