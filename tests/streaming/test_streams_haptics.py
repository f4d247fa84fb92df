"""The contact rule against a path through a sphere, and the glove link's own frames."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.messages import Estimate
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.protocol import Haptic
from tracker.streaming.haptics import ContactRule, HapticParams, HapticPublisher, Sphere
from tracker.streaming.publisher import Names

BALL = Sphere(np.array([0.3, 0.0, 0.1]), 0.03)


def on_x(x: float) -> np.ndarray:
    return BALL.center_G + [x, 0.0, 0.0]


def moved(e: Estimate, names: Names, tip: str, to: np.ndarray | None) -> Estimate:
    """The estimate with one keypoint moved, or lost."""
    points, state = np.array(e.keypoints), np.array(e.keypoint_state)
    i = names.keypoints.index(tip)
    points[i], state[i] = (np.nan, 0) if to is None else (to, 2)
    return replace(e, keypoints=points, keypoint_state=state)


def test_entering_triggers_once_and_leaving_needs_a_margin() -> None:
    rule = ContactRule([BALL], leave=0.005)
    path = [0.040, 0.031, 0.029, 0.0, 0.034, 0.029, 0.036, 0.029]
    is_new = [rule.entered("index_tip", on_x(x)) for x in path]
    assert is_new == [False, False, True, False, False, False, False, True]


def test_fingers_and_spheres_are_distinguished() -> None:
    other = Sphere(BALL.center_G + [0.05, 0, 0], 0.03)  # overlaps the first
    rule = ContactRule([BALL, other], leave=0.0)
    assert rule.entered("index_tip", on_x(0.0))
    assert rule.entered("index_tip", on_x(0.025)), "inside both: the second is new"
    assert rule.entered("thumb_tip", on_x(0.0)), "another finger"
    assert not ContactRule([], 0.0).entered("index_tip", on_x(0.0))


def test_a_lost_fingertip_neither_enters_nor_leaves(make_estimate, names: Names) -> None:
    calls: list[tuple[int, int, int]] = []
    out = HapticPublisher(names, [BALL], lambda *a: calls.append(a))
    e = make_estimate()
    inside = moved(e, names, "index_tip", on_x(0.0))
    lost = moved(e, names, "index_tip", None)
    for estimate in (lost, inside, lost, inside):
        out.send(estimate)
    assert calls == [(1, 200, 80)]


class Port:
    """A serial port that stores what is written."""

    timeout = 0.0
    in_waiting = 0

    def __init__(self) -> None:
        self.written = b""

    def read(self, count: int) -> bytes:
        return b""

    def write(self, data: bytes) -> int:
        self.written += data
        return len(data)

    def close(self) -> None:
        return


def test_contact_reaches_the_glove_as_a_haptic_frame(make_estimate, names: Names) -> None:
    port = Port()
    link = GloveLink(lambda: port, 7)
    link.poll(0.0)
    port.written = b""
    params = HapticParams(amplitude=90, duration_ms=300, motors={"thumb_tip": 5})
    out = HapticPublisher(names, [BALL], link.vibrate, params)
    out.send(moved(make_estimate(), names, "thumb_tip", on_x(0.01)))
    assert FrameDecoder().feed(port.written) == [Haptic(5, 90, 300)]


@pytest.mark.parametrize(
    "wrong",
    [
        {"amplitude": 256},
        {"duration_ms": 0},
        {"duration_ms": 70000},
        {"leave": -1.0},
        {"motors": {"thumb_tip": 256}},
    ],
)
def test_values_that_do_not_fit_a_frame_are_rejected(wrong: dict) -> None:
    with pytest.raises(ValueError, match=r"amplitude|leave"):
        HapticParams(**wrong)
