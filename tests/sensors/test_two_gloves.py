"""A left and a right glove at once: found, distinguished, and streaming simultaneously."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
import pytest

from tracker.messages import ImuSample
from tracker.sensors.discovery import find_gloves
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.sensors.link_params import LinkState
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove

N = 2
TOLERANCE = 16 * 9.80665 / 32768  # m/s², one step of the wire


def marked(value: float) -> Iterator[ImuSample]:
    """Samples that identify their glove."""
    for k in range(100_000):
        t, yes = k / 100, np.ones(N, bool)
        yield ImuSample(t, t, t, k, np.full((N, 3), value), np.zeros((N, 3)), yes)


@pytest.fixture
def gloves() -> Iterator[tuple[SimulatedGlove, SimulatedGlove]]:
    t_0 = time.monotonic()
    both = tuple(
        SimulatedGlove(marked(value), N, t_0, GloveDeviceParams(glove_id=number))
        for number, value in ((11, 1.0), (22, 2.0))
    )
    yield both[0], both[1]
    for glove in both:
        glove.stop()


def test_both_are_found_and_distinguished(gloves) -> None:
    reports = find_gloves([str(g.path) for g in gloves], timeout=3.0)
    assert [r.hello.glove_id for r in reports if r.hello] == [11, 22]


def test_both_stream_and_one_continues_without_the_other(gloves) -> None:
    links = [GloveLink(serial_port(str(g.path)), N) for g in gloves]
    got: list[list[ImuSample]] = [[], []]

    def poll_until(enough: int, which: tuple[int, ...]) -> None:
        end = time.monotonic() + 10
        while any(len(got[i]) < enough for i in which):
            assert time.monotonic() < end
            for i, link in enumerate(links):
                got[i] += [m for m in link.poll(0.005) if isinstance(m, ImuSample)]

    poll_until(20, (0, 1))
    gloves[0].unplug()
    poll_until(len(got[1]) + 30, (1,))
    for samples, value in zip(got, (1.0, 2.0), strict=True):
        assert np.allclose([s.accel for s in samples], value, atol=TOLERANCE)
    assert links[0].state == LinkState.UNPLUGGED
    assert links[1].state == LinkState.STREAMING and links[1].figures.lost == 0
    for link in links:
        link.close()
