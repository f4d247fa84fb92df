"""Basics that every part uses, independent of hands: clock, errors, files, threads, settings."""
