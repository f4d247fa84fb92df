"""Persistent data: settings, colours, wearers, images."""
