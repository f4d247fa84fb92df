"""Monitoring of devices during tracking: clocks, rig, camera tilt, IMUs."""
