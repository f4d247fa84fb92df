"""What watches devices while tracking runs: clocks, rig, camera tilt, IMUs."""
