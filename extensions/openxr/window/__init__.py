"""The panel *OpenXR*."""
