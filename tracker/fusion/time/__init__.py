"""Delay compensation: buffered IMU packets, late images."""
