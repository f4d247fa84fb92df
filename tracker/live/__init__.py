"""Threads and channels around one pipeline."""
