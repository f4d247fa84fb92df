"""Lamps that flicker are recognised in simulated images, and nothing else is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from tracker.glove import library
from tracker.online.flicker_watch import FlickerWatch
from tracker.simulation.camera_errors import IDEAL
from tracker.simulation.demo import DemoSpec, build
from tracker.simulation.flicker import Exposure, FlickerParams, brightened, row_gains
from tracker.simulation.stamps import JitteredStamps
from tracker.vision.rig import ideal_rig

SECONDS, READOUT, SHUTTER = 5.0, 0.018, 0.004
Image = np.ndarray


@pytest.fixture(scope="module")
def hand() -> list[Image]:
    """Images of a moving hand over a noisy wall, 1/30 s apart, in constant light."""
    rig = ideal_rig(320, 180)
    spec = DemoSpec(*library.texts(), seed=3, duration=3.0, camera_errors=IDEAL)
    sim = build(spec)
    sim.scene.rig = rig
    return [sim.renderer.images(0.2 + k / 30)[0].copy() for k in range(60)]


def seen(
    hand: list[Image], lamps: FlickerParams, rate: float, readout: float = READOUT
) -> Iterator[tuple[Image, float]]:
    """Images under these lamps, with stamps that jitter by 4 ms, of a camera of that rate."""
    stamps, exposure = JitteredStamps(0.004, 1), Exposure(SHUTTER, readout)
    for k in range(int(SECONDS * rate)):
        there = int(k * 30 / rate) % (2 * len(hand) - 2)
        image = hand[min(there, 2 * len(hand) - 2 - there)]
        t, out = k / rate, np.empty_like(image)
        brightened(image, row_gains(len(image), t, exposure, lamps).astype(np.float32), out)
        yield out, stamps.stamp(t)


def fed(images: Iterator[tuple[Image, float]]) -> FlickerWatch:
    watch = FlickerWatch()
    for k, (image, t) in enumerate(images):
        watch.look(image, t, k)
    return watch


@pytest.mark.parametrize("readout", [0.0, READOUT])
@pytest.mark.parametrize(("mains", "rate"), [(50.0, 30.0), (50.0, 60.0), (60.0, 50.0)])
def test_lamps_are_recognised_at_their_beat(
    hand: list[Image], mains: float, rate: float, readout: float
) -> None:
    lamps = FlickerParams(0.3, mains)
    watch = fed(seen(hand, lamps, rate, readout))
    assert [n.code for n in watch.notices.drain()] == ["camera.lamps_flicker"]
    assert watch.flicker is not None and watch.flicker.mains_hz == mains
    expected = 0.3 * np.sinc(2 * mains * SHUTTER) / 2.2
    assert watch.flicker.amplitude == pytest.approx(expected, rel=0.15)


@pytest.mark.parametrize("rate", [30.0, 60.0])
def test_static_bands_are_not_reported(hand: list[Image], rate: float) -> None:
    """60 Hz at 30 or 60 images per second: each row has the same light in all images."""
    lamps = FlickerParams(0.3, 60.0)
    gains = [row_gains(180, k / rate, Exposure(SHUTTER, READOUT), lamps) for k in range(9)]
    assert np.ptp(gains, axis=0).max() < 1e-9
    assert fed(seen(hand, lamps, rate)).notices.drain() == []


@pytest.mark.parametrize("rate", [30.0, 60.0])
def test_moving_hands_and_slow_changes_of_light_are_not_flicker(
    hand: list[Image], rate: float
) -> None:
    """A cloud, and steps of automatic exposure, four times a second."""
    watch = FlickerWatch()
    for k, (image, t) in enumerate(seen(hand, FlickerParams(0.0), rate)):
        cloud = 1.0 - 0.2 * np.sin(2 * np.pi * 0.7 * t)
        steps = 1.0 + 0.04 * (int(4 * t) % 3)
        watch.look(np.clip(image * cloud * steps, 0, 255).astype(np.uint8), t, k)
    assert watch.notices.drain() == [] and watch.flicker is None


def test_the_end_of_flicker_is_reported_and_missing_images_are_counted(hand: list[Image]) -> None:
    watch, lamps = FlickerWatch(), FlickerParams(0.4, 50.0)
    for k, (image, t) in enumerate(seen(hand, lamps, 30.0)):
        if k % 7 != 3:  # the camera counts those that are lost
            watch.look(image, t, k)
    assert watch.flicker is not None
    for k, (image, t) in enumerate(seen(hand, replace(lamps, depth=0.0), 30.0)):
        watch.look(image, 100.0 + t, 1000 + k)
    codes = [n.code for n in watch.notices.drain()]
    assert codes == ["camera.lamps_flicker", "camera.lamps_steady"]
