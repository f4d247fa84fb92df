"""The paper's engine: one free IMU body per segment, connected by anatomy (Lee et al. 2021)."""
