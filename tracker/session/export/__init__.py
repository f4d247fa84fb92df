"""Exports: a session in the formats of other programs."""
