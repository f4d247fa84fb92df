"""Delay: IMU packets kept, images that come late."""
