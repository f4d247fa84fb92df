"""Widgets that are independent of hand tracking."""
