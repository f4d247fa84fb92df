"""What every connection has: this computer's own address, and the error of one that fails.

Apart from publishers, which bring half of the engine along, so that a command starts at once.
"""

from __future__ import annotations

from tracker.base.errors import GlovetrackError

LOOPBACK = "127.0.0.1"


class StreamError(GlovetrackError):
    """A stream cannot be opened or has failed."""
