"""Shared parts of dialogs that guide the wearer from pose to pose and show the result."""
