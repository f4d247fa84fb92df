"""The paper's engine: one free IMU body per segment, tied by anatomy (Lee et al. 2021)."""

from tracker.fusion.vist.engine import VistEngine
from tracker.fusion.vist.params import VistParams

__all__ = ["VistEngine", "VistParams"]
