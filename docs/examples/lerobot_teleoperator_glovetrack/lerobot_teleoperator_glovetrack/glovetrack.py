"""The teleoperator: the newest estimate as an action, feedback to the glove's motors."""

from __future__ import annotations

import contextlib
import json
import threading
import time
from typing import Any

from lerobot.teleoperators.teleoperator import Teleoperator
from lerobot.utils.errors import DeviceAlreadyConnectedError, DeviceNotConnectedError
from websockets.exceptions import WebSocketException
from websockets.sync.client import ClientConnection, connect

from .config_glovetrack import GlovetrackConfig

FINGERS = ("thumb", "index", "middle", "ring", "little")
ANGLES = (
    *(f"thumb_cmc_{angle}" for angle in ("abduction", "flexion", "twist")),
    *(f"thumb_{angle}" for angle in ("mcp_abduction", "mcp_flexion", "ip_flexion")),
    *(
        f"{finger}_{angle}"
        for finger in FINGERS[1:]
        for angle in ("mcp_abduction", "mcp_flexion", "pip_flexion", "dip_flexion")
    ),
)
PARTS = ("metacarpal", "proximal", "intermediate", "distal", "tip")
JOINTS = (
    "palm",
    "wrist",
    *(f"thumb_{part}" for part in PARTS if part != "intermediate"),
    *(f"{finger}_{part}" for finger in FINGERS[1:] for part in PARTS),
)
POSE = ("x", "y", "z", "qx", "qy", "qz", "qw")
STRONGEST, PULSE_MS = 255, 100


class Glovetrack(Teleoperator):
    """Reads Glovetrack's WebSocket in a thread of its own; `get_action` never waits."""

    config_class = GlovetrackConfig
    name = "glovetrack"

    def __init__(self, config: GlovetrackConfig) -> None:
        super().__init__(config)
        self.config = config
        self._stream: ClientConnection | None = None
        self._remote: ClientConnection | None = None
        self._opened = contextlib.ExitStack()
        self._thread: threading.Thread | None = None
        self._lock = threading.Condition()
        self._action = dict.fromkeys(self._names(), 0.0)
        self._newest = 0.0  # when the last estimate came, s of the monotonic clock

    def _names(self) -> list[str]:
        angles = [f"{angle}.pos" for angle in ANGLES]
        if not self.config.joints:
            return angles
        return angles + [f"{joint}.{c}" for joint in JOINTS for c in POSE]

    # --- what LeRobot asks

    @property
    def action_features(self) -> dict[str, type]:
        """Angles (rad), then the joints' poses (m and quaternions xyzw) where asked for."""
        return dict.fromkeys(self._names(), float)

    @property
    def feedback_features(self) -> dict[str, type]:
        return {f"{finger}.vibration": float for finger in FINGERS}

    @property
    def is_connected(self) -> bool:
        return self._thread is not None and self._thread.is_alive()

    @property
    def is_calibrated(self) -> bool:
        return True

    def calibrate(self) -> None:
        """Glovetrack does that while it tracks."""

    def configure(self) -> None:
        """Nothing: Glovetrack's own window has it all."""

    def connect(self, calibrate: bool = True) -> None:
        """Wait for the first estimate."""
        if self.is_connected:
            raise DeviceAlreadyConnectedError(f"{self} is connected already.")
        patience = self.config.connect_patience
        opened = self._opened.enter_context
        self._stream = opened(connect(self.config.url, open_timeout=patience))
        if self.config.feedback_url:
            with contextlib.suppress(OSError):  # without it the glove does not vibrate
                self._remote = opened(connect(self.config.feedback_url, open_timeout=patience))
        self._thread = threading.Thread(target=self._read, name="glovetrack", daemon=True)
        self._thread.start()
        with self._lock:
            if not self._lock.wait_for(lambda: self._newest > 0, patience):
                self.disconnect()
                raise ConnectionError(
                    f"{self.config.url} streams no {self.config.side} hand"
                    + (" with OpenXR's joints." if self.config.joints else ".")
                )

    def get_action(self) -> dict[str, float]:
        if not self.is_connected:
            raise DeviceNotConnectedError(f"{self} is not connected.")
        with self._lock:
            silent = time.monotonic() - self._newest
            if silent > self.config.patience:
                raise ConnectionError(f"{self} has no estimate since {silent:.1f} s.")
            return dict(self._action)

    def send_feedback(self, feedback: dict[str, Any]) -> None:
        """``index.vibration`` and so on, 0 to 1; what is 0 is not sent."""
        if not self.is_connected:
            raise DeviceNotConnectedError(f"{self} is not connected.")
        for name, value in feedback.items():
            strength = round(STRONGEST * min(max(float(value), 0.0), 1.0))
            if self._remote is not None and strength and name in self.feedback_features:
                finger = name.removesuffix(".vibration")
                asked = {"do": "vibrate", "finger": finger, "amplitude": strength,
                         "duration_ms": PULSE_MS}  # fmt: skip
                self._remote.send(json.dumps(asked))

    def disconnect(self) -> None:
        self._opened.close()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(2.0)
        self._stream = self._remote = self._thread = None
        self._newest = 0.0

    # --- the stream

    def _read(self) -> None:
        stream = self._stream
        assert stream is not None
        with contextlib.suppress(WebSocketException, OSError):
            for text in stream:
                self._take(json.loads(text))

    def _take(self, estimate: dict[str, Any]) -> None:
        """What is lost is null and keeps its last value, zero before it was ever known."""
        if estimate["side"] != self.config.side:
            return
        known: dict[str, float | None] = {
            f"{name}.pos": angle["value"] for name, angle in estimate["angles"].items()
        }
        if self.config.joints:
            if "joints" not in estimate:
                return
            for name, joint in estimate["joints"].items():
                place, turn = joint["position"], joint["orientation_xyzw"]
                pose = [None] * len(POSE) if place is None else [*place, *turn]
                known |= {f"{name}.{c}": v for c, v in zip(POSE, pose, strict=True)}
        with self._lock:
            before = self._action
            found = {name: known.get(name) for name in before}
            self._action = {n: before[n] if v is None else v for n, v in found.items()}
            self._newest = time.monotonic()
            self._lock.notify_all()
