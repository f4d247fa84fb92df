"""Graphs of any signals, side by side."""
