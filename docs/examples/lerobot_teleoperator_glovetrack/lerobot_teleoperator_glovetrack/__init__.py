"""Glovetrack as a teleoperator of LeRobot, which imports packages with this prefix."""

from .config_glovetrack import GlovetrackConfig
from .glovetrack import Glovetrack

__all__ = ["Glovetrack", "GlovetrackConfig"]
