"""Vibration from SteamVR: python-osc sends the messages of VMT's driver."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future
from typing import Any

import pytest
from pythonosc.udp_client import SimpleUDPClient

from tests.notices import raises
from tracker.hand.names import CHAINS
from tracker.streaming.connection import LOOPBACK, StreamError
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.registry import DOORS, open_door
from tracker.streaming.remote.request import Reply, Request


class Motors:
    def __init__(self) -> None:
        self.asked: list[Request] = []

    def answer(self, request: Request) -> Future[Reply]:
        self.asked.append(request)
        future: Future[Reply] = Future()
        future.set_result(Reply(True, request.do, "It vibrates."))
        return future


@pytest.fixture
def motors() -> Motors:
    return Motors()


def opened(motors: Motors, **options: Any) -> Door:
    kind = DOORS.get("vmt")
    assert kind.options().port == 39571
    return open_door(kind, kind.options(**({"port": 0} | options)), motors.answer)


@pytest.fixture
def door(motors: Motors) -> Iterator[Door]:
    out = opened(motors)
    yield out
    out.close()


def test_a_haptic_event_reaches_every_motor(motors: Motors, door: Door, wait_for) -> None:
    driver = SimpleUDPClient(LOOPBACK, door.port)
    driver.send_message("/VMT/Out/Haptic", [57, 160.0, 0.5, 0.1])
    wait_for(lambda: len(motors.asked) == 5)
    assert [r.finger for r in motors.asked] == list(CHAINS)
    assert {(r.do, r.side, r.amplitude, r.duration_ms) for r in motors.asked} == {
        ("vibrate", "right", 128, 100)
    }
    driver.send_message("/VMT/Out/Haptic", [56, 0.0, 2.0, 0.0])  # a pulse, too strong
    wait_for(lambda: len(motors.asked) == 10)
    assert (motors.asked[-1].side, motors.asked[-1].amplitude) == ("left", 255)
    assert motors.asked[-1].duration_ms == 20


def test_other_messages_and_devices_are_ignored(motors: Motors, door: Door, wait_for) -> None:
    driver = SimpleUDPClient(LOOPBACK, door.port)
    driver.send_message("/VMT/Out/Alive", ["0.15", "C:/VMT"])
    driver.send_message("/VMT/Out/Haptic", [3, 160.0, 0.5, 0.1])
    driver.send_message("/VMT/Out/Haptic", [57, 160.0, 0.0, 0.1])  # off
    driver.send_message("/VMT/Out/Haptic", [57, 160.0])
    driver._sock.sendto(b"rubbish", (LOOPBACK, door.port))
    wait_for(lambda: door.counts().refused == 2)
    assert motors.asked == []


def test_some_fingers_only(motors: Motors, wait_for) -> None:
    door = opened(motors, fingers="thumb, index", right=4)
    SimpleUDPClient(LOOPBACK, door.port).send_message("/VMT/Out/Haptic", [4, 1.0, 1.0, 9.0])
    wait_for(lambda: len(motors.asked) == 2)
    door.close()
    assert [r.finger for r in motors.asked] == ["thumb", "index"]
    assert motors.asked[0].duration_ms == 2000


def test_an_unknown_finger_is_refused(motors: Motors) -> None:
    with raises(StreamError, "vr.unknown_finger", name="toe"):
        opened(motors, fingers="toe")
