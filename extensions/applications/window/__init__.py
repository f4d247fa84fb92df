"""The panel *Applications*."""
