"""Glovetrack in ROS 2."""
