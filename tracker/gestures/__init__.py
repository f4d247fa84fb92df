"""Gestures of a tracked hand, in OpenXR's words: what it shows, when each begins and ends."""
