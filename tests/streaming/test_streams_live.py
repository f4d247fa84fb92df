"""Outputs attached to a live tracker on a simulated glove and camera."""

from __future__ import annotations

import json
import socket

import pytest

from tests.fixtures import RESOURCES
from tests.live.test_runner import Tape, live, run_to_the_end
from tracker.base.notices import Notice, warning
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.streaming.attach import attach
from tracker.streaming.publisher import Names
from tracker.streaming.udp import UdpPublisher
from tracker.vision.colours import load_profile


class Broken:
    """An output whose every message fails."""

    name = "broken"

    def send(self, estimate: Estimate) -> None:
        raise ConnectionResetError("the client is gone")

    def close(self) -> None:
        return


def datagrams(client: socket.socket) -> list[dict]:
    """All data waiting in the socket."""
    out = []
    client.setblocking(False)
    while True:
        try:
            out.append(json.loads(client.recv(65536)))
        except BlockingIOError:
            return out


@pytest.mark.long
def test_a_client_receives_the_recorded_states(hand: HandModel, glove: GloveModel) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=1.0), 1, fps=30)
    names, tape = Names.of(hand, glove), Tape()
    tracker, stream = live(sim, load_profile(RESOURCES / "colours" / "fabric-default.toml"), tape)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        client.bind(("127.0.0.1", 0))
        reported: list[Notice] = []
        udp = UdpPublisher(names, port=client.getsockname()[1])
        attached = attach(tracker.hand("right"), [Broken(), udp], report=reported.append)
        run_to_the_end(tracker, stream)
        tracker.stop()
        attached.close()
        read = datagrams(client)
    recorded = {m.t: m for m in tape.messages if isinstance(m, Estimate)}
    assert len(recorded) > 90, "the broken output did not hold up the tracker"
    assert reported == [warning("stream.failing", stream="broken", why="the client is gone")]
    assert [r["t"] for r in read] == sorted(recorded), "all of them, in order, none twice"
    for message in read:
        truth = recorded[message["t"]]
        for i, name in enumerate(names.keypoints):
            position = message["keypoints"][name]["position"]
            if position is None:
                assert truth.keypoint_state[i] == 0
            else:
                assert position == pytest.approx(truth.keypoints[i], abs=1e-6)
    assert any(m["tracking"] == "tracking" for m in read)
    assert attached.counts()[1].sent == len(read)
