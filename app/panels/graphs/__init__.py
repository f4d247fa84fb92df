"""Graphs of any signals."""
