"""The swarm: steered by a scripted hand, stopped by walls, followed by vehicles that reply."""

from __future__ import annotations

import select
import socket
import time

import numpy as np
import pytest

from extensions.applications.drawing import Line, Points
from extensions.applications.interface import VehicleCommand
from extensions.applications.runner import ApplicationRunner
from extensions.applications.swarm.flight import Drones, FlightParams, _steer, ball, fly, meets
from extensions.applications.swarm.simulated_vehicles import STEP, Fleet, VehicleSimulator
from extensions.applications.swarm.swarm import Swarm
from extensions.applications.swarm.vehicles import VehicleSink
from extensions.applications.tests.hands import GLOVE, HAND, datas, estimates, outcomes, words
from tests.notices import raises
from tracker.base.errors import DeviceError
from tracker.simulation.scripted import Key

MIDDLE = (0.27, 0.0, 0.1)
SWARM = {"drones": 60, "place": list(MIDDLE)}


def drones_of(outcome) -> np.ndarray:
    return np.concatenate([d.points for d in outcome.drawing if isinstance(d, Points)])


def palm_for(point, gesture: str) -> tuple[float, float, float]:
    """The palm's position for which the gesture's pinch point, or the hand's middle, is at a
    point."""
    ahead = {"pinch_index": (0.039, 0.026, -0.077), "grasp": (0.054, 0.038, -0.068)}
    dx = ahead.get(gesture, (0.05, 0.0, 0.0))
    return tuple(float(a - b) for a, b in zip(point, dx, strict=True))


def test_a_pinch_drags_the_formation_and_it_arrives() -> None:
    here = palm_for(MIDDLE, "pinch_index")
    there = (here[0], here[1] + 0.08, here[2])
    keys = [
        Key(0.0, "relaxed", here),
        Key(0.6, "pinch_index", here),
        Key(0.9, "pinch_index", here),
        Key(1.8, "pinch_index", there),
        Key(2.2, "pinch_index", there),
        Key(2.6, "relaxed", there),
        Key(3.0, "relaxed", (0.0, 0.0, 0.3)),
    ]
    found = outcomes("swarm", keys, **SWARM)
    (dragged,) = datas(found, "dragged")[:1]
    assert dragged["by"] == pytest.approx([0.0, 0.08, 0.0], abs=0.012)
    moved = drones_of(found[-1]).mean(axis=0) - MIDDLE
    assert moved == pytest.approx([0.0, 0.08, 0.0], abs=0.02)


def test_fingers_nudge_the_formation_away() -> None:
    start = (0.05, 0.0, 0.1)
    keys = [Key(0.0, "point", start), Key(1.5, "point", (0.15, 0.0, 0.1)), Key(2.0, "point", start)]
    found = outcomes("swarm", keys, **SWARM)
    assert "nudge" in words(found)
    moved = drones_of(found[-1]).mean(axis=0) - MIDDLE
    assert moved[0] > 0.01


def test_an_open_palm_splits_it_and_a_fist_makes_it_one() -> None:
    x = MIDDLE[0] - 0.05
    up, down = (x, 0.0, 0.28), (x, 0.0, -0.1)
    edge = (90.0, 0.0, 0.0)
    keys = [
        Key(0.0, "open_palm", up, edge),
        Key(1.5, "open_palm", down, edge),
        Key(2.0, "relaxed", down, edge),
        Key(2.5, "thumb_up", down, edge),
        Key(3.0, "fist", down, edge),
        Key(3.3, "fist", down, edge),
    ]
    found = outcomes("swarm", keys, **SWARM)
    reported = words(found)
    assert reported.index("split") < reported.index("merge")
    (split,) = datas(found, "split")
    assert sum(split["drones"]) == 60
    assert min(split["drones"]) > 15
    at_split = next(
        i for i, o in enumerate(found) if any(e.data["what"] == "split" for e in o.events)
    )
    groups = [d for d in found[at_split + 80].drawing if isinstance(d, Points)]
    assert len(groups) == 2
    gap = abs(groups[0].points[:, 1].mean() - groups[1].points[:, 1].mean())
    assert gap > 0.06


def test_a_grasp_stretches_it() -> None:
    beside = (MIDDLE[0], MIDDLE[1] + 0.05, MIDDLE[2])
    here = palm_for(beside, "grasp")
    there = (here[0], here[1] + 0.06, here[2])
    keys = [
        Key(0.0, "relaxed", here),
        Key(0.8, "grasp", here),
        Key(1.2, "grasp", here),
        Key(2.0, "grasp", there),
        Key(2.2, "grasp", there),
        Key(2.5, "relaxed", there),
    ]
    found = outcomes("swarm", keys, **SWARM)
    (stretched,) = datas(found, "stretched")
    gripped = [o.hand.pinch_point("middle") - MIDDLE for o in found if o.hand.shows("grasp")]
    arm, pulled = gripped[0], gripped[-1]  # from the formation's middle to the hand
    assert arm == pytest.approx([0.0, 0.05, 0.0], abs=0.02)
    assert stretched["factor"] == pytest.approx(pulled @ arm / (arm @ arm))
    assert pulled - arm == pytest.approx([0.0, 0.06, 0.0], abs=0.01)


def swept_wall() -> list[Key]:
    """A flat hand sweeps down next to the formation, then pulls it towards the wall."""
    x, y = MIDDLE[0] - 0.05, 0.17
    grab = palm_for(MIDDLE, "pinch_index")
    far = (grab[0], grab[1] + 0.3, grab[2])
    return [
        Key(0.0, "open_palm", (x, y, 0.25), (0.0, 0.0, 0.0)),
        Key(0.3, "open_palm", (x, y, 0.25), (0.0, 0.0, 0.0)),
        Key(1.3, "open_palm", (x, y, -0.05), (0.0, 0.0, 0.0)),
        Key(1.7, "relaxed", (x, y, -0.05)),
        Key(2.2, "relaxed", grab),
        Key(2.6, "pinch_index", grab),
        Key(2.8, "pinch_index", grab),
        Key(3.4, "pinch_index", far),
        Key(4.0, "pinch_index", far),
        Key(4.3, "relaxed", far),
    ]


@pytest.mark.long
def test_a_swept_palm_leaves_a_wall_that_no_drone_crosses() -> None:
    runner = ApplicationRunner("swarm", HAND, GLOVE, SWARM)
    swarm = runner.application
    assert isinstance(swarm, Swarm)
    some, before, walls, found = np.zeros(3), np.empty((0, 3)), swarm.walls, []
    for estimate in estimates(swept_wall()):
        (outcome,) = runner.feed(estimate)
        found.append(outcome)
        now = drones_of(outcome)
        for i in range(len(before)):
            step = np.ascontiguousarray(now[i] - before[i])
            assert not meets(before, i, step, 1.0, walls, some)
        before, walls = now, swarm.walls
    (wall,) = datas(found, "wall")
    assert wall["area_cm2"] > 200
    assert datas(found, "dragged")[0]["by"][1] > 0.2  # it was pulled there
    assert len([d for d in found[-1].drawing if isinstance(d, Line)]) == 1


def test_hundreds_fly_and_nothing_depends_on_their_order() -> None:
    """Each drone's new position depends only on the old positions."""
    slots = ball(300, 0.02)
    rng = np.random.default_rng(4)
    p, v = slots + rng.normal(0, 0.01, slots.shape), rng.normal(0, 0.1, slots.shape)
    fingers, walls = (
        np.array([[0.02, 0.0, 0.0]]),
        np.array([[[0.05, -1, -1], [0.05, 1, -1], [0.05, 0, 1.0]]]),
    )
    params = FlightParams()
    one, pushed = fly(Drones(p, v), slots, fingers, walls, 0.01, params)
    turned = rng.permutation(300)
    other, _ = fly(Drones(p[turned], v[turned]), slots[turned], fingers, walls, 0.01, params)
    assert other.p == pytest.approx(one.p[turned], abs=1e-12)
    assert (np.linalg.norm(pushed, axis=1) > 0).any()
    assert ((one.p[:, 0] < 0.05) == (p[:, 0] < 0.05)).all()


def test_slots_are_as_far_apart_as_was_asked() -> None:
    slots = ball(200, 0.02)
    away = np.linalg.norm(slots[:, None] - slots, axis=2)
    np.fill_diagonal(away, np.inf)
    assert np.median(away.min(axis=1)) == pytest.approx(0.02, rel=0.5)
    alone = Drones(np.array([[0.0, 0, 0]]), np.zeros((1, 3)))
    after, pushed = Drones(np.zeros((1, 3)), np.zeros((1, 3))), np.zeros((1, 3))
    _steer(
        alone, np.array([[0.1, 0.0, 0.0]]), np.empty((0, 3)), FlightParams(), 0.01, after, pushed
    )
    assert after.v[0] == pytest.approx([0.01 * 60.0 * 0.1, 0.0, 0.0])


def test_a_fleet_moves_to_its_target_within_its_speed_limit() -> None:
    fleet = Fleet(3)
    fleet.wanted_p[1] = [10.0, -5.0, 3.0]
    fastest = 0.0
    for _ in range(500):
        fleet.fly(STEP)
        fastest = max(fastest, float(np.linalg.norm(fleet.v, axis=1).max()))
    assert fleet.p[1] == pytest.approx([10.0, -5.0, 3.0], abs=0.05)
    assert fleet.p[0] == pytest.approx([0.0, 0.0, 0.0])
    assert fastest <= 15.0


def test_vehicles_get_20_targets_a_second_whatever_the_samples_jitter() -> None:
    """Over UDP, from samples every 10 ms that are up to 2 ms early or late."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.bind(("127.0.0.1", 0))
    receiver.settimeout(60)
    command = VehicleCommand(
        np.ones((1, 3)), np.zeros((1, 3)), f"127.0.0.1:{receiver.getsockname()[1]}"
    )
    sink, rng = VehicleSink(), np.random.default_rng(7)
    times = 5.0 + 0.01 * np.arange(1000) + rng.uniform(-0.002, 0.002, 1000)
    after_pause = times + 60.0
    try:
        received = 0
        for t in (*times, *after_pause):
            sink.take([command], float(t))
            if sink._sequence > received:
                receiver.recv(1000)
                received += 1
    finally:
        sink.close()
        receiver.close()
    assert received == sink._sequence == pytest.approx(2 * 10 * 20, abs=2)


def test_vehicles_over_udp_take_targets_and_answer() -> None:
    """300 of them: more than one MAVLink network holds."""
    simulator = VehicleSimulator(300, 24550)
    sink = VehicleSink()
    try:
        p = np.tile([1.0, 2.0, 3.0], (300, 1)) + np.arange(300)[:, None] * 0.01
        command = VehicleCommand(p, np.zeros_like(p), f"127.0.0.1:{simulator.port}")
        t, until = 0.0, time.monotonic() + 60
        while not (sink.answered.all() and len(sink.answered) and sink.error < 0.05):
            sink.take([command], t)
            t += 0.05
            assert sink._socket is not None
            answers, _, _ = select.select([sink._socket], [], [], 10)
            assert answers and time.monotonic() < until, (sink.answered.sum(), sink.error)
    finally:
        sink.close()
        simulator.close()
    with raises(DeviceError, "swarm.address"):
        VehicleSink().take([VehicleCommand(p, p, "somewhere")], 0.0)
