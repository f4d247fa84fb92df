"""Glovetrack in ROS 2: a package for colcon, whose converters need no ROS."""
