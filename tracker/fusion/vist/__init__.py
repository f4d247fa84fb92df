"""The paper's engine: one free IMU body per segment, tied by anatomy (Lee et al. 2021)."""
