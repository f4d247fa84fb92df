"""The colours panel."""
