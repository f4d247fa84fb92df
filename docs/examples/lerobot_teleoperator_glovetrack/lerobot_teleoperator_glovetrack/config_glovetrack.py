"""What can be set, as ``--teleop.url=…`` on LeRobot's command lines."""

from dataclasses import dataclass

from lerobot.teleoperators.config import TeleoperatorConfig


@TeleoperatorConfig.register_subclass("glovetrack")
@dataclass(kw_only=True)
class GlovetrackConfig(TeleoperatorConfig):
    """``joints`` 0: angles alone; 26: OpenXR's joints too, from a stream with
    ``--stream-joints openxr``. ``feedback_url`` is the remote control's WebSocket; empty: none."""

    url: str = "ws://127.0.0.1:9751/"
    feedback_url: str = "ws://127.0.0.1:9762/"
    side: str = "right"
    joints: int = 0
    patience: float = 0.5  # s without an estimate after which the hand is not there
    connect_patience: float = 5.0  # s

    def __post_init__(self) -> None:
        if self.side not in ("left", "right"):
            raise ValueError(f"side is left or right, not {self.side!r}")
        if self.joints not in (0, 26):
            raise ValueError(f"joints is 0 or 26, not {self.joints}")
