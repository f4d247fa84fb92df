"""Live streams from a program of one's own: UDP, WebSocket, OSC, LSL, Foxglove."""

from tracker.streaming.attach import attach
from tracker.streaming.params import StreamParams, open_publishers

__all__ = ["StreamParams", "attach", "open_publishers"]
