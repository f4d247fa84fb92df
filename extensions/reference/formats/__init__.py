"""Readers of the files that motion-capture systems write."""
