"""Glovetrack as a teleoperator of LeRobot, which imports packages of this name by itself."""

from .config_glovetrack import GlovetrackConfig
from .glovetrack import Glovetrack

__all__ = ["Glovetrack", "GlovetrackConfig"]
