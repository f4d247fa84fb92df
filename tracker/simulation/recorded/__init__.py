"""Real hand motion from files, fitted with our skeleton: Qualisys TSV, Leap, BVH."""

from tracker.simulation.recorded.load import load_motion

__all__ = ["load_motion"]
