"""Computes the content of each panel from messages; plain Python, without Qt."""
