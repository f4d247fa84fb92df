"""Two gloves with exchanged files are detected."""

from __future__ import annotations

from functools import partial

import pytest

from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.engine.side_watch import ExchangeWatch
from tracker.glove import library
from tracker.hand.names import SIDES
from tracker.messages import BlobFrame, ImuSample
from tracker.simulation.two_hands import GlovedHand, TwoHandsSimulation

GLOVES = {"left": "vist-small-left", "right": "vist-small"}


ENOUGH = 4.2  # s; this pair is recognised after 3.4 s, others after 3.6 to 7.4 s


@pytest.mark.long
@pytest.mark.parametrize("exchanged", [True, False])
def test_exchanged_gloves_are_reported_once(exchanged: bool) -> None:
    dressed = {side: GlovedHand(*library.load(name, "")) for side, name in GLOVES.items()}
    sim = TwoHandsSimulation(dressed, 2, 8.0, 15.0)
    make = {side: partial(Pipeline, *dressed[side], sim.rig) for side in SIDES}
    hands, reported = Hands(make), []
    watch = ExchangeWatch(hands, delay=0.3)
    taken_for = dict(zip(SIDES, reversed(SIDES) if exchanged else SIDES, strict=True))
    for side, message in sim.messages():
        if message.t > ENOUGH:
            break
        if isinstance(message, BlobFrame):
            hands.feed_frame(message)
            watch.frame(message)
        elif isinstance(message, ImuSample):
            own = taken_for[side]
            watch.packet(own, message, hands.feed_imu(own, message).tracking)
        reported += watch.notices.drain()
    assert [n.code for n in reported] == ["gloves.exchanged"] * exchanged
