"""The teleoperator for LeRobot on a live stream.

LeRobot itself is not installed (it requires PyTorch): the parts the example uses are stand-ins in
the documented form of its version 0.4.4.
"""

from __future__ import annotations

import dataclasses
import importlib
import sys
import threading
from abc import ABC, abstractmethod
from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")

from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.streaming.publisher import OPENXR, Names
from tracker.streaming.remote.doors import WebSocketDoor
from tracker.streaming.remote.request import Reply, Request
from tracker.streaming.websocket import WebSocketPublisher

EXAMPLE = Path(__file__).parents[2] / "docs" / "examples" / "lerobot_teleoperator_glovetrack"
NAME = EXAMPLE.name


class Teleoperator(ABC):
    """The abstract methods of lerobot.teleoperators.teleoperator.Teleoperator."""

    def __init__(self, config: Any) -> None:
        self.id = config.id

    def __str__(self) -> str:
        return f"{self.id} {type(self).__name__}"

    @property
    @abstractmethod
    def action_features(self) -> dict: ...

    @property
    @abstractmethod
    def feedback_features(self) -> dict: ...

    @property
    @abstractmethod
    def is_connected(self) -> bool: ...

    @property
    @abstractmethod
    def is_calibrated(self) -> bool: ...

    @abstractmethod
    def connect(self, calibrate: bool = True) -> None: ...

    @abstractmethod
    def calibrate(self) -> None: ...

    @abstractmethod
    def configure(self) -> None: ...

    @abstractmethod
    def get_action(self) -> dict: ...

    @abstractmethod
    def send_feedback(self, feedback: dict) -> None: ...

    @abstractmethod
    def disconnect(self) -> None: ...


@dataclasses.dataclass(kw_only=True)
class TeleoperatorConfig:
    id: str | None = None
    calibration_dir: Path | None = None
    registered = {}  # noqa: RUF012

    @classmethod
    def register_subclass(cls, name: str):
        def keep(kind: type) -> type:
            cls.registered[name] = kind
            return kind

        return keep


class DeviceNotConnectedError(ConnectionError):
    pass


class DeviceAlreadyConnectedError(ConnectionError):
    pass


@pytest.fixture
def package(monkeypatch: pytest.MonkeyPatch) -> Iterator[ModuleType]:
    """Imported by its name, as by LeRobot."""
    parts = {
        "lerobot": {},
        "lerobot.teleoperators": {},
        "lerobot.teleoperators.config": {"TeleoperatorConfig": TeleoperatorConfig},
        "lerobot.teleoperators.teleoperator": {"Teleoperator": Teleoperator},
        "lerobot.utils": {},
        "lerobot.utils.errors": {
            "DeviceNotConnectedError": DeviceNotConnectedError,
            "DeviceAlreadyConnectedError": DeviceAlreadyConnectedError,
        },
    }
    for name, content in parts.items():
        module = ModuleType(name)
        module.__dict__.update(content)
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.syspath_prepend(str(EXAMPLE))
    yield importlib.import_module(NAME)
    for name in [n for n in sys.modules if n.startswith(NAME)]:
        monkeypatch.delitem(sys.modules, name)


class Sending:
    """Sends one estimate repeatedly, like a tracked hand, until it is stopped."""

    def __init__(self, server: WebSocketPublisher, estimate) -> None:
        self.estimate = estimate
        self._ending = threading.Event()
        self._server = server
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self) -> None:
        while not self._ending.wait(0.01):
            self._server.send(self.estimate)

    def end(self) -> None:
        self._ending.set()
        self._thread.join()


@pytest.fixture
def stream(hand, glove, make_estimate) -> Iterator[tuple[Sending, WebSocketPublisher]]:
    server = WebSocketPublisher(Names.of(hand, glove, OPENXR), port=0)
    sending = Sending(server, make_estimate(angles={"index_pip_flexion": 0.7}))
    yield sending, server
    sending.end()
    server.close()


@pytest.fixture
def remote() -> Iterator[tuple[list[Request], WebSocketDoor]]:
    asked: list[Request] = []

    def answer(request: Request) -> Future[Reply]:
        asked.append(request)
        future: Future[Reply] = Future()
        future.set_result(Reply(True, request.do, "Done.", id=request.id))
        return future

    door = WebSocketDoor(answer, "127.0.0.1", 0)
    yield asked, door
    door.close()


@pytest.fixture
def teleoperator(package, stream, remote) -> Iterator[Any]:
    config = package.GlovetrackConfig(
        url=f"ws://127.0.0.1:{stream[1].port}/",
        feedback_url=f"ws://127.0.0.1:{remote[1].port}/",
        joints=26,
    )
    out = package.Glovetrack(config)
    yield out
    out.disconnect()


def test_its_names_are_those_of_hand_and_openxr(package, teleoperator, hand) -> None:
    features = list(teleoperator.action_features)
    assert set(features[: len(hand.joint_names)]) == {f"{n}.pos" for n in hand.joint_names}
    assert [f.split(".")[0] for f in features[len(hand.joint_names) :: 7]] == list(JOINTS)
    assert TeleoperatorConfig.registered["glovetrack"] is package.GlovetrackConfig
    assert package.Glovetrack.config_class is package.GlovetrackConfig
    with pytest.raises(ValueError, match="side"):
        package.GlovetrackConfig(side="both")


def test_an_action_is_the_streamed_hand_and_retains_lost_values(
    teleoperator, stream, make_estimate, hand, glove, wait_for
) -> None:
    teleoperator.connect()
    assert teleoperator.is_connected
    action = teleoperator.get_action()
    assert action.keys() == teleoperator.action_features.keys()
    assert action["index_pip_flexion.pos"] == pytest.approx(0.7)
    names = glove.keypoint_names(hand)
    xr = to_openxr(stream[0].estimate, names, joint_radii(hand))
    tip = JOINTS.index("index_tip")
    pose = [action[f"index_tip.{c}"] for c in ("x", "y", "z", "qx", "qy", "qz", "qw")]
    assert pose == pytest.approx([*xr.position[tip], *xr.orientation[tip]], abs=1e-6)
    stream[0].estimate = make_estimate(
        lost=("index_tip", "index_pip_flexion"), angles={"index_mcp_flexion": 0.4}
    )
    wait_for(lambda: teleoperator.get_action()["index_mcp_flexion.pos"] == pytest.approx(0.4))
    after = teleoperator.get_action()
    assert after["index_pip_flexion.pos"] == pytest.approx(0.7)
    assert after["index_tip.x"] == action["index_tip.x"]


def test_an_interrupted_stream_gives_no_action(teleoperator, stream, wait_for) -> None:
    teleoperator.config.patience = 5.0
    teleoperator.connect()
    assert teleoperator.get_action()
    stream[0].end()
    teleoperator.config.patience = 0.05

    def silent() -> bool:
        try:
            teleoperator.get_action()
        except ConnectionError as error:
            return "no estimate since" in str(error)
        return False

    wait_for(silent)
    stream[1].close()
    wait_for(lambda: not teleoperator.is_connected)
    with pytest.raises(DeviceNotConnectedError):
        teleoperator.get_action()


def test_feedback_moves_the_gloves_motors(teleoperator, remote, wait_for) -> None:
    with pytest.raises(DeviceNotConnectedError):
        teleoperator.send_feedback({})
    teleoperator.connect()
    with pytest.raises(DeviceAlreadyConnectedError):
        teleoperator.connect()
    teleoperator.send_feedback({"index.vibration": 0.5, "thumb.vibration": 0.0, "other": 1.0})
    teleoperator.send_feedback({"little.vibration": 3.0})
    wait_for(lambda: len(remote[0]) == 2)
    assert [(r.do, r.finger, r.amplitude) for r in remote[0]] == [
        ("vibrate", "index", 128),
        ("vibrate", "little", 255),
    ]


def test_a_hand_of_the_other_side_is_reported(package, stream) -> None:
    config = package.GlovetrackConfig(
        url=f"ws://127.0.0.1:{stream[1].port}/", feedback_url="", side="left", connect_patience=0.3
    )
    teleoperator = package.Glovetrack(config)
    with pytest.raises(ConnectionError, match="left"):
        teleoperator.connect()
    assert not teleoperator.is_connected
