"""The panel *Robot hand* and the job that drives the robot's process."""
