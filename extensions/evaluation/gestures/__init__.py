"""Gestures of simulated people, against what they were asked to hold."""
